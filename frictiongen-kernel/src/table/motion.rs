//! The contact's motion from tables; the masses' by the exact formulas.

use super::compiled::{Compiled, Tabled};
use crate::errors::NotContinuous;
use crate::modal_sum::search::Effort;
use crate::number::complex::Complex;
use crate::number::phase::wrapped;
use crate::number::scalar::Float;
use crate::response::motion::Largest;
use crate::response::{Continuous, MotionOf, ProvidesMotion};

/// What amplitude and phase of the contact follow from at any β.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactTable<S> {
    /// β_lim.
    pub limit: S,
    /// a = β_lim·U/|V|, the share of the velocity part at the limit.
    pub quadrature: S,
    /// g = β_lim·G/|V|, the share of the displacement part at the limit; 0 without damping.
    pub displacement: S,
    /// |V|.
    pub excitation: S,
    /// arg V.
    pub direction: S,
}

impl<S: Float> ContactTable<S> {
    /// Of an undamped chain: β_lim and a·sgn V from a table, V with its sign.
    #[inline]
    #[must_use]
    pub fn undamped([limit, quadrature]: [S; 2], excitation: S) -> Self {
        let zero = S::constant(0.0);
        let negative = excitation < zero;
        Self {
            limit,
            quadrature: if negative { -quadrature } else { quadrature },
            displacement: zero,
            excitation: excitation.abs(),
            direction: if negative { S::pi() } else { zero },
        }
    }

    /// Of a damped chain: β_lim, a, g, arg V and |V| from a table.
    #[inline]
    #[must_use]
    pub fn tabled([limit, quadrature, displacement, direction, excitation]: [S; 5]) -> Self {
        Self::damped([limit, quadrature, displacement, direction], excitation)
    }

    /// Of a chain with undamped modes among damped ones, where |V| may have poles: β_lim, a, g and arg V from a table.
    #[inline]
    #[must_use]
    pub fn damped([limit, quadrature, displacement, direction]: [S; 4], excitation: S) -> Self {
        Self {
            limit,
            quadrature,
            displacement,
            excitation,
            direction,
        }
    }

    /// √((1 − ρ²) + ρ²(1 − a²)) with ρ = β/β_lim: the in-phase part over |V|.
    #[inline]
    fn in_phase(&self, share: S) -> S {
        let one = S::constant(1.0);
        let quadrature = share * self.quadrature;
        // Negative within the accuracy of the limit alone, where its size is as good as 0.
        ((one - quadrature) * (one + quadrature)).abs().sqrt()
    }

    /// Z, the amplitude of the contact's relative motion (2.21, 5.35, 7.20).
    #[inline]
    #[must_use]
    pub fn amplitude(&self, beta: S) -> S {
        let share = beta / self.limit;
        self.excitation * (self.in_phase(share) - share * self.displacement)
    }

    /// φ, the lag of the contact's relative motion behind the excitation, in (−π, π] (5.38, 7.21).
    #[inline]
    #[must_use]
    pub fn phase(&self, beta: S) -> S {
        let share = beta / self.limit;
        let lag = (-(share * self.quadrature)).atan2(self.in_phase(share)) - self.direction;
        wrapped(wrapped(lag))
    }
}

/// A scene with tables of its contact's motion.
pub trait TabledMotion: Tabled + ProvidesMotion {
    /// The motion, with a method for each mass.
    type Moving: From<Moving<Self>>;

    /// The contact's motion within the domain; none where only the exact formulas keep the accuracy.
    fn tabled_contact(&self, r: Self::Scalar) -> Option<ContactTable<Self::Scalar>>;
}

impl<T: TabledMotion> Compiled<T> {
    /// The continuous motion at the friction ratio β = F/P, where the tabled limits admit it.
    ///
    /// # Errors
    /// [`NotContinuous`] says which regime it is instead, or that an undamped resonance is unbounded at this β, or
    /// that β is out of the domain.
    pub fn motion(&self, beta: T::Scalar) -> Result<T::Moving, NotContinuous> {
        let mut table = None;
        if !self.is_within() {
            // The exact formulas have their own admission.
            let beta = self.checked(beta)?;
            self.exact().admitted(beta)?;
        } else {
            // One lookup for the admission and for the motion.
            table = self.scene().tabled_contact(self.frequency_ratio());
            let limit = match table {
                Some(table) => table.limit,
                None => self.continuous_limit(),
            };
            let unbounded = self.scene().numbers().unbounded;
            let is_bounded = !unbounded.contains(&self.frequency_ratio());
            if !(self.is_admitted(beta, limit) && is_bounded) {
                return Err(self.refused(beta, limit));
            }
        }
        let at = self.clone();
        Ok(Moving { at, beta, table }.into())
    }

    /// Why there is no continuous motion within the tables' range.
    #[cold]
    fn refused(&self, beta: T::Scalar, limit: T::Scalar) -> NotContinuous {
        if let Err(error) = self.checked(beta) {
            error.into()
        } else if self.is_admitted(beta, limit) {
            NotContinuous::Unbounded
        } else if self.slides(beta) {
            NotContinuous::StickSlip
        } else {
            NotContinuous::Stuck
        }
    }
}

/// The continuous motion at one frequency ratio and one friction ratio, of a scene with tables.
#[derive(Clone, Copy, Debug)]
pub struct Moving<T: TabledMotion> {
    at: Compiled<T>,
    beta: T::Scalar,
    /// Amplitude and phase of the contact at any β; none where the exact formulas answer.
    table: Option<ContactTable<T::Scalar>>,
}

impl<T: TabledMotion> Moving<T> {
    /// The scene at the frequency of this motion.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &Compiled<T> {
        &self.at
    }

    /// The same motion by the exact formulas.
    #[must_use]
    pub fn exact(&self) -> Continuous<T> {
        self.at.exact().closed_form(self.beta)
    }

    /// The relative motion in the contact, from the tables.
    #[inline]
    #[must_use]
    pub fn contact(&self) -> SteadyContact<T> {
        SteadyContact {
            moving: self.clone(),
        }
    }

    /// The motion of a mass, by its place in the description, by the exact formulas; rest if there is no such mass.
    #[must_use]
    pub fn mass(&self, mass: usize) -> MotionOf<T> {
        self.exact().mass(mass)
    }

    /// The same; none if there is no such mass, or the scene does not provide its motion.
    #[must_use]
    pub fn mass_at(&self, mass: usize) -> Option<MotionOf<T>> {
        self.exact().mass_at(mass)
    }
}

/// The relative motion in the contact: amplitude and phase from tables, the rest by the exact formulas.
#[derive(Clone, Copy, Debug)]
pub struct SteadyContact<T: TabledMotion> {
    moving: Moving<T>,
}

impl<T: TabledMotion> SteadyContact<T> {
    /// The same motion by the exact formulas.
    #[must_use]
    pub fn exact(&self) -> MotionOf<T> {
        self.moving.exact().contact()
    }

    /// Amplitude and phase, without a search.
    #[must_use]
    pub fn largest(&self) -> Largest<T::Scalar> {
        let beta = self.moving.beta;
        match self.moving.table {
            Some(table) => Largest {
                amplitude: table.amplitude(beta),
                phase: table.phase(beta),
                effort: Effort::Bounded(0),
            },
            None => self.exact().largest(),
        }
    }

    /// The maximum of |z̄| over the period (P/k₁; for base motion Y).
    #[inline]
    #[must_use]
    pub fn amplitude(&self) -> T::Scalar {
        match self.moving.table {
            Some(table) => table.amplitude(self.moving.beta),
            None => self.exact().amplitude(),
        }
    }

    /// The estimate 5.50, 7.33: of the contact it is the amplitude.
    #[inline]
    #[must_use]
    pub fn amplitude_monoharmonic(&self) -> T::Scalar {
        self.amplitude()
    }

    /// The lag of the maximum behind the excitation's, rad, in (−π, π].
    #[inline]
    #[must_use]
    pub fn phase(&self) -> T::Scalar {
        match self.moving.table {
            Some(table) => table.phase(self.moving.beta),
            None => self.exact().phase(),
        }
    }

    /// z̄ at τ, counted from a maximum of the contact's relative motion.
    #[must_use]
    pub fn displacement(&self, tau: T::Scalar) -> T::Scalar {
        self.exact().displacement(tau)
    }

    /// dz̄/dτ at τ, counted from a maximum of the contact's relative motion.
    #[must_use]
    pub fn velocity(&self, tau: T::Scalar) -> T::Scalar {
        self.exact().velocity(tau)
    }

    /// Z_n, with z̄ = Re Σ Z_n e^{inτ_e} and τ_e from a maximum of the excitation.
    #[must_use]
    pub fn harmonic(&self, n: u32) -> Complex<T::Scalar> {
        self.exact().harmonic(n)
    }
}

//! Motion of the contact from tables, and motions of the masses from the exact formulas.

use super::compiled::{Compiled, Tabled};
use crate::errors::NotContinuous;
use crate::modal_sum::search::Effort;
use crate::number::complex::Complex;
use crate::number::phase::wrapped;
use crate::number::scalar::Float;
use crate::response::motion::Largest;
use crate::response::{Continuous, MotionOf, ProvidesMotion};

/// Values at one r from which amplitude and phase of the contact follow at any β.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactTable<S> {
    /// Continuous limit β_lim.
    pub limit: S,
    /// a = β_lim·U/|V|, the contribution of the velocity term at the limit.
    pub quadrature: S,
    /// g = β_lim·G/|V|, the contribution of the displacement term at the limit; 0 without damping.
    pub displacement: S,
    /// Modulus |V| of the response of the relative motion to the excitation, without friction.
    pub excitation: S,
    /// Argument arg V of the same response, rad.
    pub direction: S,
}

impl<S: Float> ContactTable<S> {
    /// Creates the values of an undamped chain. β_lim and a·sgn V come from a table, and V has its sign.
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

    /// Creates the values of a damped chain. β_lim, a, g, arg V and |V| come from a table.
    #[inline]
    #[must_use]
    pub fn tabled([limit, quadrature, displacement, direction, excitation]: [S; 5]) -> Self {
        Self::damped([limit, quadrature, displacement, direction], excitation)
    }

    /// Creates the values of a chain with undamped modes among damped ones, where |V| may have poles. β_lim, a, g and
    /// arg V come from a table.
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

    /// Returns √((1 − ρ²) + ρ²(1 − a²)) with ρ = β/β_lim, the in-phase term over |V|.
    #[inline]
    fn in_phase(&self, share: S) -> S {
        let one = S::constant(1.0);
        let quadrature = share * self.quadrature;
        // The product is negative only for β within the accuracy of the limit. It is then 0 within that accuracy.
        ((one - quadrature) * (one + quadrature)).abs().sqrt()
    }

    /// Returns Z, the amplitude of the contact's relative motion (2.21, 5.35, 7.20).
    #[inline]
    #[must_use]
    pub fn amplitude(&self, beta: S) -> S {
        let share = beta / self.limit;
        self.excitation * (self.in_phase(share) - share * self.displacement)
    }

    /// Returns φ, the lag of the contact's relative motion behind the excitation, in (−π, π] (5.38, 7.21).
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
    /// Motion type with one method per mass.
    type Moving: From<Moving<Self>>;

    /// Returns the contact's motion within the domain; `None` where only the exact formulas reach the declared
    /// accuracy.
    fn tabled_contact(&self, r: Self::Scalar) -> Option<ContactTable<Self::Scalar>>;
}

impl<T: TabledMotion> Compiled<T> {
    /// Returns the continuous motion at the friction ratio β = F/P, where the table's limits admit it.
    ///
    /// # Errors
    /// [`NotContinuous`] names the regime if the motion is not continuous. It also reports an undamped resonance that
    /// is unbounded at this β, and a β outside the domain.
    pub fn motion(&self, beta: T::Scalar) -> Result<T::Moving, NotContinuous> {
        let mut table = None;
        if !self.is_within() {
            // The exact formulas check β against their own limits.
            let beta = self.checked(beta).map_err(|_| NotContinuous::OutOfDomain)?;
            self.exact().admitted(beta)?;
        } else {
            // One lookup serves the check and the motion.
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

    /// Returns the reason why there is no continuous motion within the tables' range.
    #[cold]
    fn refused(&self, beta: T::Scalar, limit: T::Scalar) -> NotContinuous {
        if self.checked(beta).is_err() {
            NotContinuous::OutOfDomain
        } else if self.is_admitted(beta, limit) {
            NotContinuous::Unbounded
        } else if self.slides(beta) {
            NotContinuous::StickSlip
        } else {
            NotContinuous::Stuck
        }
    }
}

/// Continuous motion of a [`TabledMotion`] scene at one frequency ratio and one friction ratio.
#[derive(Clone, Copy, Debug)]
pub struct Moving<T: TabledMotion> {
    at: Compiled<T>,
    beta: T::Scalar,
    /// Amplitude and phase of the contact at any β; `None` where the exact formulas answer.
    table: Option<ContactTable<T::Scalar>>,
}

impl<T: TabledMotion> Moving<T> {
    /// Returns the scene at the frequency of this motion.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &Compiled<T> {
        &self.at
    }

    /// Returns the same motion from the exact formulas.
    #[must_use]
    pub fn exact(&self) -> Continuous<T> {
        self.at.exact().closed_form(self.beta)
    }

    /// Returns the relative motion of the contact, from the tables.
    #[inline]
    #[must_use]
    pub fn contact(&self) -> SteadyContact<T> {
        SteadyContact {
            moving: self.clone(),
        }
    }

    /// Returns the motion of a mass, given by its index in the description, from the exact formulas. Returns a motion
    /// at rest if the scene has no such mass.
    #[must_use]
    pub fn mass(&self, mass: usize) -> MotionOf<T> {
        self.exact().mass(mass)
    }

    /// Returns the motion of a mass as [`mass`](Self::mass) does, but `None` if the scene has no such mass or does not
    /// provide its motion.
    #[must_use]
    pub fn mass_at(&self, mass: usize) -> Option<MotionOf<T>> {
        self.exact().mass_at(mass)
    }
}

/// Relative motion of the contact, with amplitude and phase from tables and all other results from the exact formulas.
#[derive(Clone, Copy, Debug)]
pub struct SteadyContact<T: TabledMotion> {
    moving: Moving<T>,
}

impl<T: TabledMotion> SteadyContact<T> {
    /// Returns the same motion from the exact formulas.
    #[must_use]
    pub fn exact(&self) -> MotionOf<T> {
        self.moving.exact().contact()
    }

    /// Returns amplitude and phase, from the tables without a search.
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

    /// Returns the maximum of |z̄| over the period (P/k₁; for base motion Y).
    #[inline]
    #[must_use]
    pub fn amplitude(&self) -> T::Scalar {
        match self.moving.table {
            Some(table) => table.amplitude(self.moving.beta),
            None => self.exact().amplitude(),
        }
    }

    /// Returns the monoharmonic estimate (5.50), (7.33). For the contact it equals the amplitude.
    #[inline]
    #[must_use]
    pub fn amplitude_monoharmonic(&self) -> T::Scalar {
        self.amplitude()
    }

    /// Returns the lag of the motion's maximum behind the excitation's maximum, rad, in (−π, π].
    #[inline]
    #[must_use]
    pub fn phase(&self) -> T::Scalar {
        match self.moving.table {
            Some(table) => table.phase(self.moving.beta),
            None => self.exact().phase(),
        }
    }

    /// Returns z̄ at τ, counted from a maximum of the contact's relative motion.
    #[must_use]
    pub fn displacement(&self, tau: T::Scalar) -> T::Scalar {
        self.exact().displacement(tau)
    }

    /// Returns dz̄/dτ at τ, counted from a maximum of the contact's relative motion.
    #[must_use]
    pub fn velocity(&self, tau: T::Scalar) -> T::Scalar {
        self.exact().velocity(tau)
    }

    /// Returns Z_n, with z̄ = Re Σ Z_n e^{inτ_e} and τ_e counted from a maximum of the excitation.
    #[must_use]
    pub fn harmonic(&self, n: u32) -> Complex<T::Scalar> {
        self.exact().harmonic(n)
    }
}

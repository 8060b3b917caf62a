//! Continuous motion of a scene with tables. The motion of the contact comes from the tables, and the motion of each
//! mass from the exact formulas.

use super::compiled::{Compiled, Tabled};
use crate::errors::NotContinuous;
use crate::modal_sum::search::Effort;
use crate::number::complex::Complex;
use crate::number::phase::wrapped;
use crate::number::scalar::Float;
use crate::response::motion::Largest;
use crate::response::{Continuous, MotionOf, ProvidesMotion};

/// Numbers from the tables at one frequency ratio. With these numbers the code computes the amplitude and the phase of
/// the contact at any friction ratio β.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactTable<S> {
    /// Limit of continuous motion β_lim at this frequency ratio.
    pub limit: S,
    /// a = β_lim·U/|V|. β_lim·U is the velocity of the contact that friction with β = β_lim causes at a reversal. |V|
    /// is the amplitude of the contact without friction.
    pub quadrature: S,
    /// g = β_lim·G/|V|. β_lim·G is the displacement of the contact that friction with β = β_lim causes at a reversal.
    /// |V| is the amplitude of the contact without friction. Without damping g is 0.
    pub displacement: S,
    /// Amplitude |V| of the contact's relative motion without friction.
    pub excitation: S,
    /// Argument arg V of the contact's relative motion without friction, in rad.
    pub direction: S,
}

impl<S: Float> ContactTable<S> {
    /// Creates the table values of an undamped chain from β_lim, a·sgn V and V. V is the response of the contact
    /// without friction. In an undamped chain V is real, and its sign replaces the phase. a is the field `quadrature`.
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

    /// Creates the table values of a damped chain from β_lim, a, g, arg V and |V|, which all come from a table. V is
    /// the response of the contact without friction, a is the field `quadrature`, and g is the field `displacement`.
    #[inline]
    #[must_use]
    pub fn tabled([limit, quadrature, displacement, direction, excitation]: [S; 5]) -> Self {
        Self::damped([limit, quadrature, displacement, direction], excitation)
    }

    /// Creates the table values of a chain with both undamped and damped modes. β_lim, a, g and arg V come from a
    /// table, where a is the field `quadrature` and g the field `displacement`. `excitation` is |V|, the amplitude of
    /// the contact without friction. |V| has poles at the undamped resonances.
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

    /// Returns √(1 − ρ²a²), the in-phase term of the contact's motion divided by |V|. |V| is the amplitude of the
    /// contact without friction, and a is β_lim·U/|V|. The argument `share` is ρ = β/β_lim.
    #[inline]
    fn in_phase(&self, share: S) -> S {
        let one = S::constant(1.0);
        let quadrature = share * self.quadrature;
        // The product is negative only if β exceeds the tabulated β_lim by less than the accuracy of the table. The
        // exact product is then 0 within this accuracy.
        ((one - quadrature) * (one + quadrature)).abs().sqrt()
    }

    /// Returns Z, the amplitude of the contact's relative motion at the friction ratio β (2.21, 5.35, 7.20), in units
    /// of P/k₁ (of the base amplitude Y for base motion).
    #[inline]
    #[must_use]
    pub fn amplitude(&self, beta: S) -> S {
        let share = beta / self.limit;
        self.excitation * (self.in_phase(share) - share * self.displacement)
    }

    /// Returns φ, the lag of the contact's relative motion behind the excitation at the friction ratio β, in rad, in
    /// (−π, π] (5.38, 7.21).
    #[inline]
    #[must_use]
    pub fn phase(&self, beta: S) -> S {
        let share = beta / self.limit;
        let lag = (-(share * self.quadrature)).atan2(self.in_phase(share)) - self.direction;
        wrapped(wrapped(lag))
    }
}

/// A scene that has a table of the contact's continuous motion.
pub trait TabledMotion: Tabled + ProvidesMotion {
    /// Type that `motion` returns. In emitted code this type has one method for each mass.
    type Moving: From<Moving<Self>>;

    /// Returns the table values of the contact at the frequency ratio r, which must be within the domain of the tables.
    /// Returns `None` if only the exact formulas have the declared accuracy.
    fn tabled_contact(&self, r: Self::Scalar) -> Option<ContactTable<Self::Scalar>>;
}

impl<T: TabledMotion> Compiled<T> {
    /// Returns the continuous motion at the friction ratio β = F/P. The motion exists if β is below the limits from the
    /// tables.
    ///
    /// # Errors
    /// [`NotContinuous`] with the regime if the motion is not continuous. Also [`NotContinuous`] if r is an undamped
    /// resonance at which this β does not bound the amplitude, and for a β outside the domain.
    pub fn motion(&self, beta: T::Scalar) -> Result<T::Moving, NotContinuous> {
        let mut table = None;
        if !self.is_within() {
            // The exact formulas compare β with the exact limits, and not with the limits from the tables.
            let beta = self.checked(beta).map_err(|_| NotContinuous::OutOfDomain)?;
            self.exact().admitted(beta)?;
        } else {
            // The code reads the table once, for the check of β and for the motion.
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

    /// Returns the reason why the scene has no continuous motion at the friction ratio β. r must be within the range of
    /// the tables.
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

/// Continuous motion of a scene with tables ([`TabledMotion`]) at one frequency ratio and one friction ratio.
#[derive(Clone, Copy, Debug)]
pub struct Moving<T: TabledMotion> {
    at: Compiled<T>,
    beta: T::Scalar,
    /// Table values of the contact at this frequency ratio. `None` if the exact formulas compute the motion.
    table: Option<ContactTable<T::Scalar>>,
}

impl<T: TabledMotion> Moving<T> {
    /// Returns the scene at the frequency ratio of this motion.
    #[inline]
    #[must_use]
    pub fn at(&self) -> &Compiled<T> {
        &self.at
    }

    /// Returns the continuous motion from the exact formulas, at the same frequency ratio and friction ratio.
    #[must_use]
    pub fn exact(&self) -> Continuous<T> {
        self.at.exact().closed_form(self.beta)
    }

    /// Returns the relative motion of the contact. Its amplitude and phase come from the tables.
    #[inline]
    #[must_use]
    pub fn contact(&self) -> SteadyContact<T> {
        SteadyContact {
            moving: self.clone(),
        }
    }

    /// Returns the motion of a mass from the exact formulas. `mass` is the index of the mass in the scene description.
    /// If the scene has no mass with this index, the result is a motion at rest.
    #[must_use]
    pub fn mass(&self, mass: usize) -> MotionOf<T> {
        self.exact().mass(mass)
    }

    /// Returns the motion of a mass from the exact formulas. Returns `None` if the scene has no mass with this index or
    /// does not provide the motion of this mass.
    #[must_use]
    pub fn mass_at(&self, mass: usize) -> Option<MotionOf<T>> {
        self.exact().mass_at(mass)
    }
}

/// Relative motion of the contact. Its amplitude and phase come from the tables, and all other results from the exact
/// formulas.
#[derive(Clone, Copy, Debug)]
pub struct SteadyContact<T: TabledMotion> {
    moving: Moving<T>,
}

impl<T: TabledMotion> SteadyContact<T> {
    /// Returns the relative motion of the contact from the exact formulas, at the same frequency ratio and friction
    /// ratio.
    #[must_use]
    pub fn exact(&self) -> MotionOf<T> {
        self.moving.exact().contact()
    }

    /// Returns the amplitude and the phase of the contact from the tables, without a search.
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

    /// Returns the largest absolute relative displacement |z̄| of the contact in a period, in units of P/k₁ (of the
    /// base amplitude Y for base motion).
    #[inline]
    #[must_use]
    pub fn amplitude(&self) -> T::Scalar {
        match self.moving.table {
            Some(table) => table.amplitude(self.moving.beta),
            None => self.exact().amplitude(),
        }
    }

    /// Returns the monoharmonic estimate of the contact's amplitude (5.50), (7.33). For the contact the estimate is
    /// equal to the exact amplitude.
    #[inline]
    #[must_use]
    pub fn amplitude_monoharmonic(&self) -> T::Scalar {
        self.amplitude()
    }

    /// Returns the lag of the contact's relative motion behind the excitation, in rad, in (−π, π].
    #[inline]
    #[must_use]
    pub fn phase(&self) -> T::Scalar {
        match self.moving.table {
            Some(table) => table.phase(self.moving.beta),
            None => self.exact().phase(),
        }
    }

    /// Returns the relative displacement z̄ of the contact at the phase τ in rad. z̄ has its maximum at τ = 0.
    #[must_use]
    pub fn displacement(&self, tau: T::Scalar) -> T::Scalar {
        self.exact().displacement(tau)
    }

    /// Returns the relative velocity dz̄/dτ of the contact at the phase τ in rad. z̄ has its maximum at τ = 0.
    #[must_use]
    pub fn velocity(&self, tau: T::Scalar) -> T::Scalar {
        self.exact().velocity(tau)
    }

    /// Returns Z_n, the complex amplitude of harmonic n of the contact's relative motion. The harmonics are defined by
    /// z̄ = Re Σ Z_n e^{inτ_e}, where the phase τ_e is 0 at a maximum of the excitation.
    #[must_use]
    pub fn harmonic(&self, n: u32) -> Complex<T::Scalar> {
        self.exact().harmonic(n)
    }
}

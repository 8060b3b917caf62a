//! Continuous motion of a scene with tables. The tables give the motion of the contact, and the exact formulas give the
//! motion of each mass.

use super::compiled::{Compiled, Tabled};
use crate::errors::NotContinuous;
use crate::modal_sum::search::Effort;
use crate::number::complex::Complex;
use crate::number::phase::wrapped;
use crate::number::scalar::Float;
use crate::response::motion::Largest;
use crate::response::{Continuous, MotionOf, ProvidesMotion};

/// Numbers from the tables at one frequency ratio. These numbers give the amplitude and the phase of the contact at any
/// β.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactTable<S> {
    /// Limit β_lim of continuous motion.
    pub limit: S,
    /// a = β_lim·U/|V|. β_lim·U is the velocity that friction at β_lim gives the contact at a reversal. |V| is the
    /// amplitude of the contact without friction.
    pub quadrature: S,
    /// g = β_lim·G/|V|. β_lim·G is the displacement that friction at β_lim gives the contact at a reversal. |V| is the
    /// amplitude of the contact without friction. Without damping g is 0.
    pub displacement: S,
    /// Modulus |V| of the relative motion that the excitation causes without friction.
    pub excitation: S,
    /// Argument arg V of the relative motion that the excitation causes without friction, in rad.
    pub direction: S,
}

impl<S: Float> ContactTable<S> {
    /// Creates the table values of an undamped chain from β_lim, a·sgn V and V, where V is the response of the contact
    /// without friction. V is real in an undamped chain, with a sign instead of a phase.
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

    /// Creates the table values of a damped chain from β_lim, a, g, arg V and |V|, all of which come from a table. V is
    /// the response of the contact without friction.
    #[inline]
    #[must_use]
    pub fn tabled([limit, quadrature, displacement, direction, excitation]: [S; 5]) -> Self {
        Self::damped([limit, quadrature, displacement, direction], excitation)
    }

    /// Creates the table values of a chain with both undamped and damped modes. β_lim, a, g and arg V come from a
    /// table. `excitation` is |V|, the amplitude of the contact without friction, which has poles at the undamped
    /// resonances.
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

    /// Returns √((1 − ρ²) + ρ²(1 − a²)) with a = β_lim·U/|V|, the in-phase term of the contact's motion divided by |V|,
    /// the amplitude without friction. `share` is ρ = β/β_lim.
    #[inline]
    fn in_phase(&self, share: S) -> S {
        let one = S::constant(1.0);
        let quadrature = share * self.quadrature;
        // The product is negative only if β exceeds the tabulated β_lim, within the accuracy of the table. The exact
        // product is then 0 within the same accuracy.
        ((one - quadrature) * (one + quadrature)).abs().sqrt()
    }

    /// Returns Z, the amplitude of the contact's relative motion at β (2.21, 5.35, 7.20), in units of P/k₁ (of Y for
    /// base motion).
    #[inline]
    #[must_use]
    pub fn amplitude(&self, beta: S) -> S {
        let share = beta / self.limit;
        self.excitation * (self.in_phase(share) - share * self.displacement)
    }

    /// Returns φ, the lag of the contact's relative motion behind the excitation, in rad, in (−π, π] (5.38, 7.21).
    #[inline]
    #[must_use]
    pub fn phase(&self, beta: S) -> S {
        let share = beta / self.limit;
        let lag = (-(share * self.quadrature)).atan2(self.in_phase(share)) - self.direction;
        wrapped(wrapped(lag))
    }
}

/// A scene that has a table of the continuous motion of the contact.
pub trait TabledMotion: Tabled + ProvidesMotion {
    /// Type that `motion` returns. In emitted code this type has one method for each mass.
    type Moving: From<Moving<Self>>;

    /// Returns the table values of the contact at r, which must be within the domain. Returns `None` if only the exact
    /// formulas reach the declared accuracy.
    fn tabled_contact(&self, r: Self::Scalar) -> Option<ContactTable<Self::Scalar>>;
}

impl<T: TabledMotion> Compiled<T> {
    /// Returns the continuous motion at the friction ratio β = F/P, if β is below the limits in the tables.
    ///
    /// # Errors
    /// [`NotContinuous`] names the regime if the motion is not continuous. The error also reports an undamped resonance
    /// that is unbounded at this β, and a β outside the domain.
    pub fn motion(&self, beta: T::Scalar) -> Result<T::Moving, NotContinuous> {
        let mut table = None;
        if !self.is_within() {
            // The exact formulas check β against their own limits.
            let beta = self.checked(beta).map_err(|_| NotContinuous::OutOfDomain)?;
            self.exact().admitted(beta)?;
        } else {
            // One lookup in the table serves both the check of β and the motion.
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

    /// Returns the reason why the scene has no continuous motion at this β, for r within the range of the tables.
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
    /// Table values of the contact at this r. `None` if the exact formulas compute the motion.
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

    /// Returns the relative motion of the contact, whose amplitude and phase come from the tables.
    #[inline]
    #[must_use]
    pub fn contact(&self) -> SteadyContact<T> {
        SteadyContact {
            moving: self.clone(),
        }
    }

    /// Returns the motion of a mass, given by its index in the description, from the exact formulas. Returns a motion
    /// at rest if the scene has no mass with this index.
    #[must_use]
    pub fn mass(&self, mass: usize) -> MotionOf<T> {
        self.exact().mass(mass)
    }

    /// Returns the motion of a mass as [`mass`](Self::mass) does. Returns `None` if the scene has no mass with this
    /// index or does not provide the motion of this mass.
    #[must_use]
    pub fn mass_at(&self, mass: usize) -> Option<MotionOf<T>> {
        self.exact().mass_at(mass)
    }
}

/// Relative motion of the contact. The tables give its amplitude and phase, and the exact formulas give all other
/// results.
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

    /// Returns the amplitude and the phase of the contact, from the tables without a search.
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

    /// Returns the maximum of |z̄| in the period, in units of P/k₁ (of Y for base motion).
    #[inline]
    #[must_use]
    pub fn amplitude(&self) -> T::Scalar {
        match self.moving.table {
            Some(table) => table.amplitude(self.moving.beta),
            None => self.exact().amplitude(),
        }
    }

    /// Returns the monoharmonic estimate of the amplitude (5.50), (7.33). For the contact the estimate equals the
    /// amplitude.
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

    /// Returns the relative displacement z̄ at the phase τ. At τ = 0, z̄ has its maximum.
    #[must_use]
    pub fn displacement(&self, tau: T::Scalar) -> T::Scalar {
        self.exact().displacement(tau)
    }

    /// Returns the relative velocity dz̄/dτ at the phase τ. At τ = 0, z̄ has its maximum.
    #[must_use]
    pub fn velocity(&self, tau: T::Scalar) -> T::Scalar {
        self.exact().velocity(tau)
    }

    /// Returns Z_n, the complex amplitude of harmonic n, defined by z̄ = Re Σ Z_n e^{inτ_e}. The phase τ_e is 0 at a
    /// maximum of the excitation.
    #[must_use]
    pub fn harmonic(&self, n: u32) -> Complex<T::Scalar> {
        self.exact().harmonic(n)
    }
}

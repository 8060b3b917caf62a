//! Internal traits of the kernel's types: scenes at one frequency ratio, and motions of such scenes. The kernel
//! computes the results by exact formulas or from tables.
//!
//! The types of emitted scenes and of a `System` deref to one of the kernel's types. One implementation of each public
//! trait therefore serves all types.

use crate::steady::{Of, Steady};
use crate::{Complex, NoOrbit, NotContinuous, OutOfDomain, Regime, StuckResonance};
use core::ops::Deref;
use frictiongen_kernel::Float;
use frictiongen_kernel::contact::regime::Limits;
use frictiongen_kernel::orbit::ProvidesOrbit;
use frictiongen_kernel::response::{At, Continuous, ProvidesMotion, ProvidesStuck, Scene, Stuck};
use frictiongen_kernel::table::{Compiled, Moving, Sticking, Tabled, TabledMotion, TabledStuck};

/// A scene of the kernel at one frequency ratio that provides the limits and the regime.
pub trait Limited {
    type Scalar: Float;

    fn continuous_limit(&self) -> Self::Scalar;
    fn continuous_limit_without_search(&self) -> Self::Scalar;
    fn continuous_limit_per_mode(&self) -> Self::Scalar;
    fn sliding_limit(&self) -> Self::Scalar;
    fn limits(&self) -> Limits<Self::Scalar>;
    fn regime(&self, beta: Self::Scalar) -> Result<Regime, OutOfDomain>;
    fn margin(&self, beta: Self::Scalar) -> Result<Self::Scalar, OutOfDomain>;
}

macro_rules! limited {
    ($type:ident of $scene:ident) => {
        impl<T: $scene> Limited for $type<T> {
            type Scalar = T::Scalar;

            fn continuous_limit(&self) -> T::Scalar {
                $type::continuous_limit(self)
            }
            fn continuous_limit_without_search(&self) -> T::Scalar {
                $type::continuous_limit_without_search(self)
            }
            fn continuous_limit_per_mode(&self) -> T::Scalar {
                $type::continuous_limit_per_mode(self)
            }
            fn sliding_limit(&self) -> T::Scalar {
                $type::sliding_limit(self)
            }
            fn limits(&self) -> Limits<T::Scalar> {
                $type::limits(self)
            }
            fn regime(&self, beta: T::Scalar) -> Result<Regime, OutOfDomain> {
                $type::regime(self, beta)
            }
            fn margin(&self, beta: T::Scalar) -> Result<T::Scalar, OutOfDomain> {
                $type::margin(self, beta)
            }
        }
    };
}

limited!(At of Scene);
limited!(Compiled of Tabled);

/// A scene of the kernel at one frequency ratio that provides exact continuous motions.
pub trait Moved: Limited {
    type Motion;

    fn motion(&self, beta: Self::Scalar) -> Result<Self::Motion, NotContinuous>;
}

impl<T: ProvidesMotion> Moved for At<T> {
    type Motion = T::Motion;

    fn motion(&self, beta: T::Scalar) -> Result<T::Motion, NotContinuous> {
        At::motion(self, beta)
    }
}

impl<T: TabledMotion> Moved for Compiled<T> {
    type Motion = T::Moving;

    fn motion(&self, beta: T::Scalar) -> Result<T::Moving, NotContinuous> {
        Compiled::motion(self, beta)
    }
}

/// A motion of the kernel that provides the separate motions of the contact and of each mass.
pub trait InParts {
    type Scalar: Float;

    fn ask<A>(
        &self,
        of: Of,
        question: impl FnOnce(&dyn Steady<Scalar = Self::Scalar>) -> A,
    ) -> Option<A>;
}

macro_rules! in_parts {
    ($type:ident of $scene:ident) => {
        impl<T: $scene> InParts for $type<T> {
            type Scalar = T::Scalar;

            fn ask<A>(
                &self,
                of: Of,
                question: impl FnOnce(&dyn Steady<Scalar = T::Scalar>) -> A,
            ) -> Option<A> {
                match of {
                    Of::Contact => Some(question(&self.contact())),
                    Of::Mass(index) => Some(question(&self.mass_at(index)?)),
                    _ => None,
                }
            }
        }
    };
}

in_parts!(Continuous of ProvidesMotion);
in_parts!(Moving of TabledMotion);

/// A scene of the kernel at one frequency ratio that provides the response while the contact is stuck.
pub trait HeldStill: Limited {
    fn stuck_mass(&self, index: usize) -> Result<Option<Complex<Self::Scalar>>, StuckResonance>;
}

impl<T: ProvidesStuck> HeldStill for At<T>
where
    T::Stuck: Deref<Target = Stuck<T>>,
{
    fn stuck_mass(&self, index: usize) -> Result<Option<Complex<T::Scalar>>, StuckResonance> {
        Ok(At::stuck(self)?.mass_at(index))
    }
}

impl<T: TabledStuck> HeldStill for Compiled<T>
where
    T::Sticking: Deref<Target = Sticking<T>>,
{
    fn stuck_mass(&self, index: usize) -> Result<Option<Complex<T::Scalar>>, StuckResonance> {
        Ok(Compiled::stuck(self)?.mass_at(index))
    }
}

/// A scene of the kernel at one frequency ratio that provides steady states in any regime.
pub trait Settles: Limited {
    type Orbit;

    fn orbit(&self, beta: Self::Scalar) -> Result<Self::Orbit, NoOrbit>;
    fn orbit_or_last_cycles(&self, beta: Self::Scalar) -> Result<Self::Orbit, NoOrbit>;
}

macro_rules! settles {
    ($type:ident of $($scene:ident)+) => {
        impl<T: ProvidesOrbit $(+ $scene)+> Settles for $type<T> {
            type Orbit = T::Orbit;

            fn orbit(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
                $type::orbit(self, beta)
            }
            fn orbit_or_last_cycles(&self, beta: T::Scalar) -> Result<T::Orbit, NoOrbit> {
                $type::orbit_or_last_cycles(self, beta)
            }
        }
    };
}

settles!(At of Scene);
settles!(Compiled of Tabled);

//! Items that emitted code imports, and items that are the same in every emitted scene.

pub mod locals;
pub mod missing;
mod shapes;

// A user's constant may have the name of a local variable in emitted code. The functions of `locals` hide such
// constants.
pub use crate::Complex;
pub use crate::Scalar;
pub use crate::contact::regime::Limits;
pub use crate::contact::sums::{Chain, ContactAt, ModeAt};
pub use crate::errors::{NoOrbit, OutOfDomain};
pub use crate::modal_sum::wave::Wave;
pub use crate::motion::{Dynamics, HeldMode, Lines, Part};
pub use crate::orbit::{FixedOrbit, FixedOrbitMotion, Orbit, ProvidesOrbit, Start};
pub use crate::oscillator::decay::{Damped, Decay, Undamped};
pub use crate::oscillator::mode::{Kind, Mode, ModeResponse};
pub use crate::response::coefficients::{Friction, Fundamental, ModalCoefficients};
pub use crate::response::motion::{Motion, mass_wave, motion_wave};
pub use crate::response::{
    At, Continuous, Ends, MotionOf, Numbers, ProvidesMotion, ProvidesStuck, Scene, Stuck,
};
pub use crate::simulation::{FixedLinesSimulation, FixedSimulation, Moment, Segment, Simulation};
pub use crate::stepper::{
    Channel, FixedStepper, FixedStore, FixedTables, HeldLoad, HeldRow, HeldStep, Input, MassNow,
    ModeStep, Pace, Row, Sample, StepScene, Stepped, Stepper, Units,
};
pub use crate::table::{
    Compiled, ContactTable, Domain, Factor, HeldResponse, Moving, Piece, Quotient, Root,
    SteadyContact, Sticking, Table, Tabled, TabledMotion, TabledStuck, Transfer,
};
pub use core::convert::From;
pub use core::iter::{IntoIterator, Iterator};
pub use core::option::Option::{self, None, Some};
pub use core::primitive::{bool, f32, f64, usize};
pub use core::result::Result::{self, Err, Ok};
pub use locals::*;
pub use shapes::transposed;

/// Implements `Clone`, `Debug`, `From` and `Deref` for an emitted type that wraps a type of this crate. By `Deref`, the
/// emitted type has all methods of the wrapped type.
#[doc(hidden)]
#[macro_export]
macro_rules! wraps {
    ($type:ident, $target:ident of $scene:ident, Copy) => {
        impl ::core::marker::Copy for $type {}
        $crate::wraps!(@ $type, $crate::response::$target<$scene>);
    };
    ($type:ident, $target:ident of tabled $scene:ident, Copy) => {
        impl ::core::marker::Copy for $type {}
        $crate::wraps!(@ $type, $crate::table::$target<$scene>);
    };
    ($type:ident, $target:ident of $scalar:ident, $($size:literal),*) => {
        $crate::wraps!(@ $type, $crate::emitted::$target<$scalar, $($size),*>);
    };
    (@ $type:ident, $target:ty) => {
        impl ::core::clone::Clone for $type {
            #[inline]
            fn clone(&self) -> Self {
                Self(::core::clone::Clone::clone(&self.0))
            }
        }

        impl ::core::fmt::Debug for $type {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                f.debug_tuple(::core::stringify!($type)).field(&self.0).finish()
            }
        }

        impl ::core::convert::From<$target> for $type {
            #[inline]
            fn from(inner: $target) -> Self {
                Self(inner)
            }
        }

        impl ::core::ops::Deref for $type {
            type Target = $target;

            #[inline]
            fn deref(&self) -> &Self::Target {
                &self.0
            }
        }
    };
}

//! Items that emitted code imports, and items that are the same in every emitted scene.

pub mod check;
pub mod locals;
pub mod missing;
#[cfg(feature = "serde")]
pub mod written;

// A constant of the user may have the name of a local variable in emitted code. The functions of `locals` hide such a
// constant.
pub use crate::Complex;
pub use crate::Scalar;
pub use crate::contact::regime::Limits;
pub use crate::contact::sums::{Chain, ContactAt, ModeAt};
pub use crate::errors::{NoOrbit, OutOfDomain};
pub use crate::modal_sum::wave::Wave;
pub use crate::motion::{Dynamics, ElasticChain, HeldMode, Lines, Part};
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
    Channel, DeclaredStepper, FixedStepper, FixedStore, FixedTables, HeldLoad, HeldRow, HeldStep,
    Input, MassNow, ModeStep, Pace, Row, Sample, StepScene, Stepped, Stepper, Units,
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

/// Transposes a matrix, given as an array of rows, at compile time. Emitted code has its mode shapes as one row per mode,
/// and needs one row per mass.
#[doc(hidden)]
#[must_use]
#[allow(clippy::indexing_slicing, reason = "at compile time")]
pub const fn transposed<S: Copy, const ROWS: usize, const COLUMNS: usize>(
    rows: &[[S; COLUMNS]; ROWS],
) -> [[S; ROWS]; COLUMNS] {
    const { assert!(0 < ROWS && 0 < COLUMNS, "a table of something") };
    let mut columns = [[rows[0][0]; ROWS]; COLUMNS];
    let mut row = 0;
    while row < ROWS {
        let mut column = 0;
        while column < COLUMNS {
            columns[column][row] = rows[row][column];
            column += 1;
        }
        row += 1;
    }
    columns
}

/// Writes those items of the trait `Scene` that are the same in every emitted scene. The scene must have the constants
/// `NUMBERS` and `MODES` and the function `functions`.
///
/// The frequency stage computes the functions of all modes and of the contact at one frequency ratio r. A scene with
/// its own frequency stage (`in passes`) needs no `functions`. In a damped scene, `functions` has a constant
/// parameter, which is true if the function must compute the modal sum G.
#[doc(hidden)]
#[macro_export]
macro_rules! scene_items {
    ($scalar:ident, damped, $modes:literal) => {
        $crate::scene_items!(@ $scalar, $crate::emitted::Damped<$scalar>, $modes);
        $crate::scene_items!(@ $scalar, functions::<true, false>);
    };
    ($scalar:ident, undamped, $modes:literal) => {
        $crate::scene_items!(@ $scalar, $crate::emitted::Undamped, $modes);
        $crate::scene_items!(@ $scalar, functions);
    };
    ($scalar:ident, damped, $modes:literal, in passes) => {
        $crate::scene_items!(@ $scalar, $crate::emitted::Damped<$scalar>, $modes);
    };
    ($scalar:ident, undamped, $modes:literal, in passes) => {
        $crate::scene_items!(@ $scalar, $crate::emitted::Undamped, $modes);
    };
    (@ $scalar:ident, $decay:ty, $modes:literal) => {
        type Scalar = $scalar;
        type Decay = $decay;
        type Modes = [$crate::emitted::ModeAt<$scalar>; $modes];
        type Waves = [$crate::emitted::Wave<$scalar, $decay>; $modes];

        #[inline]
        fn numbers(&self) -> $crate::emitted::Numbers<'static, $scalar> {
            Self::NUMBERS
        }

        /// Returns working space with one entry for each mode, which the searches and a motion fill.
        #[inline]
        fn idle(&self) -> Self::Waves {
            Self::MODES.map(|mode| $crate::emitted::Wave::idle(&mode))
        }

        /// Copies the response and damping functions of the modes, so that a motion can own the copy.
        #[inline]
        fn kept(modes: &Self::Modes) -> Self::Modes {
            *modes
        }
    };
    (@ $scalar:ident, functions$(::<$all:literal, $but_g:literal>)?) => {
        /// Returns the contact's sums over all modes at 1/r, and the functions of each mode.
        #[inline]
        fn frequency_stage(
            &self,
            inverse_r: $scalar,
        ) -> ($crate::emitted::ContactAt<$scalar>, Self::Modes) {
            Self::functions$(::<$all>)?(inverse_r)
        }

        /// Returns the contact's sums over all modes at 1/r without the sum G. Only a motion needs G.
        #[inline]
        fn contact_without_g(&self, inverse_r: $scalar) -> $crate::emitted::ContactAt<$scalar> {
            Self::functions$(::<$but_g>)?(inverse_r).0
        }
    };
}

/// Writes the functions of an emitted scene that take a frequency ratio. The type `At` computes results from the
/// formulas, and `Compiled` from the tables of a declared accuracy.
#[doc(hidden)]
#[macro_export]
macro_rules! scene_functions {
    ($type:ident, $at:ident, $scalar:ident, At) => {
        impl $type {
            /// Evaluates the scene at the frequency ratio r = ω√(m₁/k₁).
            ///
            /// # Errors
            /// `OutOfDomain` for NaN and negative r.  At r = 0 and r = ∞ the limits take their limiting values.
            ///
            /// Worst case: one division, and the operations of the frequency stage (all sums over the modes at one r).
            #[inline]
            pub fn at(r: $scalar) -> ::core::result::Result<$at, $crate::errors::OutOfDomain> {
                $crate::response::At::new(Self, r).map(::core::convert::From::from)
            }
        }
        $crate::scene_functions!(@ $type, $scalar, At);
    };
    ($type:ident, $at:ident, $scalar:ident, Compiled) => {
        impl $type {
            /// Evaluates the scene at the frequency ratio r = ω√(m₁/k₁), to the declared accuracy.
            ///
            /// # Errors
            /// `OutOfDomain` for NaN and negative r. An r outside the declared range gives the same error, unless the
            /// scene declares `beyond: exact`.
            ///
            /// Worst case: comparisons of r with its range.  If the scene declares `beyond: exact` and r is outside
            /// the range: the operations of the frequency stage (all sums over the modes at one r).
            #[inline]
            pub fn at(r: $scalar) -> ::core::result::Result<$at, $crate::errors::OutOfDomain> {
                $crate::table::Compiled::new(Self, r).map(::core::convert::From::from)
            }
        }
        $crate::scene_functions!(@ $type, $scalar, Compiled);
    };
    (@ $type:ident, $scalar:ident, $of:ident) => {
        impl $type {
            /// Returns an upper bound on β_lim and the exact β*_lim, without a search. The bound is |V|/√(U² + (H_c +
            /// μm*/r²)²) (5.64), which leaves out the velocity constraint S. β*_lim is |V|/(μ|H|) (6.11, 6.27, 6.33).
            /// V is the response of the contact to the load, U its damping function, and H its receptance. H_c +
            /// μm*/r² is the break-away term.
            ///
            /// # Errors
            /// `OutOfDomain` for NaN and negative r.  At r = 0 and r = ∞ the limits take their limiting values.
            ///
            /// Worst case: the operations of the frequency stage (all sums over the modes at one r) without the sum G,
            /// and those of the formulas of the limits. If masses may act as an absorber: a second frequency stage
            /// with another sum over the modes.
            #[inline]
            pub fn limits_without_search(
                r: $scalar,
            ) -> ::core::result::Result<$crate::contact::regime::Limits<$scalar>, $crate::errors::OutOfDomain>
            {
                $crate::response::At::limits_without_search(&Self, r)
            }

            /// Computes the limits β_lim and β*_lim at each frequency ratio of a slice, and writes them to two slices
            /// of the same length.
            ///
            /// # Errors
            /// `OutOfDomain` if the slices have different lengths. Both result slices are then unchanged. At the first
            /// r for which `at` fails, the function stops and returns the error of `at`. The result slices then
            /// contain the limits for the frequency ratios before that r.
            ///
            /// Worst case: for each r the work of `at` and `limits`.
            pub fn limits_into(
                rs: &[$scalar],
                continuous: &mut [$scalar],
                sliding: &mut [$scalar],
            ) -> ::core::result::Result<(), $crate::errors::OutOfDomain> {
                $crate::emitted::$of::limits_into(Self, rs, continuous, sliding)
            }
        }
    };
}

/// Expands to nothing, because the feature `serde` is off. With the feature, `written.rs` defines this macro.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! written {
    ($name:ident, $($field:ident),*) => {};
}

/// Implements `Clone`, `Debug`, `From` and `Deref` for an emitted type that wraps a type of this crate. Through
/// `Deref`, the emitted type has all methods of the wrapped type.
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
    ($type:ident, $target:ident of elastic $scalar:ident, $($size:literal),*) => {
        $crate::wraps!(
            @ $type,
            $crate::emitted::$target<$scalar, $($size),*, $crate::emitted::ElasticChain<$scalar>>
        );
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

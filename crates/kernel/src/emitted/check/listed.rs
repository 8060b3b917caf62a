//! Lists the numbers of emitted constants, in the order of their fields.

use crate::contact::sums::Chain;
use crate::motion::{Dynamics, HeldMode};
use crate::number::dd::Dd;
use crate::number::scalar::{Float, Scalar};
use crate::oscillator::mode::{Kind, Mode};
use crate::response::{Ends, Numbers};
use crate::stepper::{
    Channel, FixedTables, HeldLoad, HeldRow, HeldStep, Input, ModeStep, Pace, Row, StepScene, Units,
};
use crate::table::{Domain, Factor, HeldResponse, Piece, Quotient, Root, Table, Transfer};

/// A constant of emitted code that can list its numbers. The code generator lists the same numbers in a more precise
/// number type, and computes the known checksum from them.
pub trait Listed<S> {
    /// Calls `see` with each number of the constant, in the order of the fields.
    fn list(&self, see: &mut impl FnMut(S));
}

macro_rules! numbers {
    ($($number:ty)*) => {
        $(impl Listed<$number> for $number {
            fn list(&self, see: &mut impl FnMut(Self)) {
                see(*self);
            }
        })*
    };
}

numbers!(f32 f64 Dd);

/// Lists a whole number as four words of 16 bits. Every number type represents such a word exactly.
fn list_words<S: Scalar>(number: u64, see: &mut impl FnMut(S)) {
    for word in number.to_le_bytes().as_chunks::<2>().0 {
        see(S::constant(f64::from(u16::from_le_bytes(*word))));
    }
}

macro_rules! whole_numbers {
    ($($number:ty)*) => {
        $(impl<S: Float> Listed<S> for $number {
            fn list(&self, see: &mut impl FnMut(S)) {
                list_words(u64::from(*self), see);
            }
        })*
    };
}

whole_numbers!(bool u8 u16 u32 u64);

impl<S: Float> Listed<S> for usize {
    fn list(&self, see: &mut impl FnMut(S)) {
        list_words(u64::try_from(*self).unwrap_or(u64::MAX), see);
    }
}

impl<S: Float> Listed<S> for Kind {
    fn list(&self, see: &mut impl FnMut(S)) {
        let number: u8 = match self {
            Self::Undamped => 0,
            Self::Light => 1,
            Self::Heavy => 2,
            Self::Critical => 3,
            Self::Over => 4,
        };
        number.list(see);
    }
}

impl<S: Float> Listed<S> for Input {
    fn list(&self, see: &mut impl FnMut(S)) {
        (*self == Self::Linear).list(see);
    }
}

impl<S: Float, T: Listed<S> + ?Sized> Listed<S> for &T {
    fn list(&self, see: &mut impl FnMut(S)) {
        (**self).list(see);
    }
}

impl<S: Float, T: Listed<S>> Listed<S> for [T] {
    fn list(&self, see: &mut impl FnMut(S)) {
        for one in self {
            one.list(see);
        }
    }
}

impl<S: Float, T: Listed<S>, const N: usize> Listed<S> for [T; N] {
    fn list(&self, see: &mut impl FnMut(S)) {
        self.as_slice().list(see);
    }
}

impl<S: Float, T: Listed<S>, U: Listed<S>> Listed<S> for (T, U) {
    fn list(&self, see: &mut impl FnMut(S)) {
        self.0.list(see);
        self.1.list(see);
    }
}

impl<S: Float, T: Listed<S>> Listed<S> for Option<T> {
    fn list(&self, see: &mut impl FnMut(S)) {
        self.is_some().list(see);
        if let Some(one) = self {
            one.list(see);
        }
    }
}

/// Implements [`Listed`] for structures, field by field.
macro_rules! fields {
    ($([$($generic:tt)*] $type:ty: $($field:ident)*;)*) => {
        $(impl<S: Float + Listed<S>, $($generic)*> Listed<S> for $type {
            fn list(&self, see: &mut impl FnMut(S)) {
                $(Listed::<S>::list(&self.$field, see);)*
            }
        })*
    };
}

fields! {
    [] Mode<S>: kind in_contact resonance zeta q q_defect load contact residue contact_squared static_residue;
    [] Chain<S>: damped on_moving_base inverse_mass stiction;
    [] Ends<S>: sliding_at_rest continuous_at_infinity sliding_at_infinity;
    // `modes` and `chain` have separate checksums.
    [] Numbers<'_, S>: ends rubbing absorbs unbounded invisible;
    [] HeldMode<S>: kind frequency zeta q force inverse;
    [] Dynamics<'_, S>: modes held participations shapes weights rubbing;
    [] Units<S>: stiffness rate support;
    // `dynamics` has a separate checksum.
    [] StepScene<'_, S>: units on_base forces input law;
    [] Pace<S>: step parts span rate terms receptance drag;
    [const D: usize] Row<S, D>: state drive;
    [const D: usize] HeldRow<S, D>: state drive;
    [const D: usize] ModeStep<S, D>: angle zeta per_force contact turn moments;
    [const D: usize] HeldStep<S, D>: angle zeta force from_base moments turns;
    [] HeldLoad<S>: drive reach;
    [] Channel<S>: acceleration lift;
    [const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize]
        FixedTables<S, D, MODES, HELD, INPUTS>: pace modes held loads held_loads channels;
    [const F: usize, const C: usize] Piece<S, F, C>: from origin coefficients;
    [B: Listed<S>, const F: usize, const C: usize] Table<'_, S, B, F, C>: low density halvings buckets pieces;
    [] Quotient<'_, S>: gain squared numerator denominator;
    [] Transfer<'_, S>: gain numerator denominator;
    [] Domain<S>: r beta exact_beyond always_continuous never_stuck;
}

impl<S: Float + Listed<S>> Listed<S> for Factor<S> {
    fn list(&self, see: &mut impl FnMut(S)) {
        match *self {
            Self::Zero { at, rest } => [at, rest].list(see),
            Self::Pair {
                at,
                rest,
                off,
                least,
            } => [at, rest, off, least].list(see),
            Self::Real { off } => off.list(see),
        }
    }
}

impl<S: Float + Listed<S>> Listed<S> for Root<S> {
    fn list(&self, see: &mut impl FnMut(S)) {
        match *self {
            Self::Pair {
                at,
                rest,
                off,
                rate,
            } => [at, rest, off, rate].list(see),
            Self::Real { rate } => rate.list(see),
        }
    }
}

impl<S: Float + Listed<S>> Listed<S> for HeldResponse<'_, S> {
    fn list(&self, see: &mut impl FnMut(S)) {
        match self {
            Self::Fixed(amplitude) => amplitude.list(see),
            Self::Undamped(quotient) => quotient.list(see),
            Self::Damped(transfer) => transfer.list(see),
        }
    }
}

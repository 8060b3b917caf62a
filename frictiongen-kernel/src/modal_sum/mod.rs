//! Sums of modal motions over a half period, with their evaluation, bounds and search.
//!
//! [`wave`] has one mode's term, and the sum with its derivatives. `mass_controlled` has the modes far below the
//! excitation, which need another form. [`search`] finds the largest value of a sum with a guarantee that it misses
//! none. The modules above this one form the sums.

pub(crate) mod mass_controlled;
pub mod search;
pub mod wave;

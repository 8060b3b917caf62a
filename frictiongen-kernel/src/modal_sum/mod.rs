//! Sums of modal motions over a half period, as something to evaluate, to bound and to search.
//!
//! [`wave`] has a mode's part and the sum with bounds on its derivatives; `mass_controlled` the modes far below the
//! excitation, which need another form; [`search`] finds the largest value of a sum, and steps over none.  Where a sum
//! comes from, the rooms above know.

pub(crate) mod mass_controlled;
pub mod search;
pub mod wave;

//! Evaluates the sum of modal motions in a half period of the excitation, bounds this sum and finds its largest value.
//!
//! [`wave`] has the term of one mode, and the sum of all terms with its derivatives. `mass_controlled` has other
//! formulas for modes that resonate far below the excitation frequency. [`search`] finds the largest value of a sum,
//! and proves that no larger value exists. The modules `contact` and `response` build the sums.

pub(crate) mod mass_controlled;
pub mod search;
pub mod wave;

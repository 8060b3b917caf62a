//! The scalar functions: arguments whose results are known exactly, and what only double-double has to keep. The
//! program `tables` of `generated-tests` compares every function with a budget of its error.

mod double_double;
mod exact;

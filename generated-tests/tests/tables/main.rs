//! Tests of declared accuracies, their tables, and the error budget of every kernel function.

mod budgets;
mod declared;

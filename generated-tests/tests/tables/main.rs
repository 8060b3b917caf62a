//! Tests of declared accuracies, of their tables, and of the error budget of every kernel function.

mod budgets;
mod declared;

//! Tests of declared accuracies and their tables, and of the error budget of every kernel function.

mod budgets;
mod declared;

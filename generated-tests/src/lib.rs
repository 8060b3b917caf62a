//! Scenes whose emitted code is compiled here, compared with its snapshot, and run; and the
//! reference values that emitted solvers and the run-time system are checked against.

pub mod data;
pub mod reference;
pub mod scenes;
pub mod shown;

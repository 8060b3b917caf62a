//! Compares natural frequencies and mode shapes with nalgebra and faer. The comparison is `tests/eigensolvers.rs`.

//! Natural frequencies and mode shapes against nalgebra and faer: `tests/eigensolvers.rs`.

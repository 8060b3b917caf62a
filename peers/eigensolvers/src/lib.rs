//! Natural frequencies and mode shapes compared with nalgebra and faer: `tests/eigensolvers.rs`.

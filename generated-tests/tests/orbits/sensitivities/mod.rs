//! Compares every derivative from dual numbers with central differences in double-double.

mod answers;
mod differences;
mod orbits;
mod physical;
mod scene;
mod single;

//! Every derivative that dual numbers give, against central differences in double-double.

mod answers;
mod differences;
mod orbits;
mod physical;
mod scene;
mod single;

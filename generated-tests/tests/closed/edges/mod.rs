//! Digits at the edges: of the regimes, of damping, of sub-harmonics, of vanishing residues, of widely
//! spread and of nearly equal frequencies.

mod condition;
mod continuity;
mod frequencies;
mod linear;
mod nearly_equal;
mod regimes;
mod scenes;

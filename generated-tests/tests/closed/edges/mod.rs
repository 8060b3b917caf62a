//! Tests the accuracy at extremes: at the limits of the regimes, at extreme damping, at subharmonics, with vanishing
//! residues, and with natural frequencies that are far apart or nearly equal.

mod condition;
mod continuity;
mod frequencies;
mod linear;
mod nearly_equal;
mod regimes;
mod scenes;

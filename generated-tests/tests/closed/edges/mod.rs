//! Tests of accuracy at extremes: at the limits of the regimes, of damping and of subharmonics, with vanishing
//! residues, and with widely spread or nearly equal frequencies.

mod condition;
mod continuity;
mod frequencies;
mod linear;
mod nearly_equal;
mod regimes;
mod scenes;

//! Tests at extremes: regimes at and next to the limits, and natural frequencies that are far apart. `orbits/backward`
//! tests the accuracy of answers near poles and subharmonics, and at extreme damping.

mod frequencies;
mod regimes;
mod scenes;

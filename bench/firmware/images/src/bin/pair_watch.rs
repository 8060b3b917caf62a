//! 2DOF f32, watching: friction from 64 samples of base and mass.
#![no_std]
#![no_main]

images::image!(watched_friction INPUTS_SINGLE);

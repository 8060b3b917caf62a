//! 2DOF f32: limits, every motion, stuck response.
#![no_std]
#![no_main]

images::image!(pair_limits INPUTS_SINGLE, pair_contact INPUTS_SINGLE, pair_displacement INPUTS_SINGLE, pair_amplitude INPUTS_SINGLE, pair_harmonic INPUTS_SINGLE, pair_stuck INPUTS_SINGLE);

//! Damped 5DOF f32: limits, every motion, stuck response.
#![no_std]
#![no_main]

images::image!(five_without_search INPUTS_SINGLE, five_limits INPUTS_SINGLE, five_contact INPUTS_SINGLE, five_displacement INPUTS_SINGLE, five_amplitude INPUTS_SINGLE, five_stuck INPUTS_SINGLE);

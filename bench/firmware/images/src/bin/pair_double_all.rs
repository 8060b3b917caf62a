//! 2DOF f64: limits, every motion, stuck response.
#![no_std]
#![no_main]

images::image!(double_without_search INPUTS, double_limits INPUTS, double_contact INPUTS, double_displacement INPUTS, double_amplitude INPUTS, double_stuck INPUTS);

//! SDOF f32: limits, every motion, stuck response.
#![no_std]
#![no_main]

images::image!(sdof_without_search INPUTS_SINGLE, sdof_limits INPUTS_SINGLE, sdof_contact INPUTS_SINGLE, sdof_displacement INPUTS_SINGLE, sdof_stuck INPUTS_SINGLE);

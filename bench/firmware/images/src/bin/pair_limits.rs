//! 2DOF f32, `provide: [limits]`: the exact limits, and those without search.
#![no_std]
#![no_main]

images::image!(least_without_search INPUTS_SINGLE, least_limits INPUTS_SINGLE);

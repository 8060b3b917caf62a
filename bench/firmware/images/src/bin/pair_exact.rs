//! 2DOF f32, `provide: [limits]`: the exact limits alone, beside `pair_tabled`.
#![no_std]
#![no_main]

images::image!(least_limits INPUTS_SINGLE);

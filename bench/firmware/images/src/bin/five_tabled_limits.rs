//! Damped 5DOF f32, `provide: [limits]`, `accuracy: 1e-4`: the limits from tables.
#![no_std]
#![no_main]

images::image!(tabled_five_limits INPUTS_SINGLE);

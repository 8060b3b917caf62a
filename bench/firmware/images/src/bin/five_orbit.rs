//! Damped 5DOF f32, `provide: [orbit]`: the steady state with its stops.
#![no_std]
#![no_main]

images::image!(stopping_five INPUTS_SINGLE);

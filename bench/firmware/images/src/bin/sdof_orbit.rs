//! SDOF f32, `provide: [orbit]`: the steady state with its stops.
#![no_std]
#![no_main]

images::image!(stopping_sdof INPUTS_SINGLE);

//! SDOF f32 with an elastic contact, `provide: [orbit]`: the steady state.
#![no_std]
#![no_main]

images::image!(elastic_sdof INPUTS_SINGLE);

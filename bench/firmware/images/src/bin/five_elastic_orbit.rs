//! 5DOF damped f32 with an elastic contact, `provide: [orbit]`: the steady state.
#![no_std]
#![no_main]

images::image!(elastic_five INPUTS_SINGLE);

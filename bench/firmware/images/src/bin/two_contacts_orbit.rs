//! 2DOF damped f32 with an elastic and a rigid contact, `provide: [orbit]`: the steady state.
#![no_std]
#![no_main]

images::image!(joined_orbit INPUTS_SINGLE);

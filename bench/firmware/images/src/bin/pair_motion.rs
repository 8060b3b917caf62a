//! 2DOF f32, `provide: [motion(upper)]`: displacement and velocity of one mass.
#![no_std]
#![no_main]

images::image!(least_motion INPUTS_SINGLE);

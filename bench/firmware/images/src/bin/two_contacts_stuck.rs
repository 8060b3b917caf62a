//! 2DOF damped f32 with an elastic and a rigid contact, `provide: [stuck]`: friction from which no contact slides.
#![no_std]
#![no_main]

images::image!(joined_stuck INPUTS_SINGLE);

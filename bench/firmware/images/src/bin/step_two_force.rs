//! Stepper, 2 masses f32, undamped, force held.
#![no_std]
#![no_main]

images::stepping!(two_force);

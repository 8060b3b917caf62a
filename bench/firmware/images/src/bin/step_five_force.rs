//! Stepper, 5 masses f32, undamped, force held.
#![no_std]
#![no_main]

images::stepping!(five_force);

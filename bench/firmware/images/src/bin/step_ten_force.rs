//! Stepper, 10 masses f32, undamped, force held.
#![no_std]
#![no_main]

images::stepping!(ten_force);

//! Stepper, 2 masses f32, two rigid contacts, undamped, force held.
#![no_std]
#![no_main]

images::stepping!(two_rigid);

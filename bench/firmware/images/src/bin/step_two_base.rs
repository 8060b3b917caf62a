//! Stepper, 2 masses f32, damped, on a moving base, linear.
#![no_std]
#![no_main]

images::stepping!(two_base);

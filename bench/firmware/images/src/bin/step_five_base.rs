//! Stepper, 5 masses f32, damped, on a moving base, linear.
#![no_std]
#![no_main]

images::stepping!(five_base);

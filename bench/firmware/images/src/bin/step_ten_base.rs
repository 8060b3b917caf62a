//! Stepper, 10 masses f32, damped, on a moving base, linear.
#![no_std]
#![no_main]

images::stepping!(ten_base);

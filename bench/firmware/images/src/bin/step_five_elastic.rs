//! Stepper, 5 masses f32, damped, elastic contact, on a moving base, linear.
#![no_std]
#![no_main]

images::stepping!(five_elastic);

//! Stepper, 2 masses f32, damped, elastic contact, on a moving base, linear.
#![no_std]
#![no_main]

images::stepping!(two_elastic);

//! Stepper, 2 masses f32, a rigid contact and a dashpot, damped, on a moving base, linear.
#![no_std]
#![no_main]

images::stepping!(one_dashpot);

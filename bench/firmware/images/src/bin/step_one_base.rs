//! Stepper, 1 mass f32, damped, on a moving base, linear.
#![no_std]
#![no_main]

images::stepping!(one_base);

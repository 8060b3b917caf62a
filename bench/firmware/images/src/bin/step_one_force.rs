//! Stepper, 1 mass f32, undamped, force held.
#![no_std]
#![no_main]

images::stepping!(one_force);

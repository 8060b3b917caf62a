//! Stepper, 1 mass f32, undamped, elastic contact, force held.
#![no_std]
#![no_main]

images::stepping!(one_elastic);

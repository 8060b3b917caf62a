//! Stepper, 2 masses f32, an elastic and a rigid contact, force held.
#![no_std]
#![no_main]

images::stepping!(two_contacts);

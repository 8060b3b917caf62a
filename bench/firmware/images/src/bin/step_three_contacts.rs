//! Stepper, 2 masses f32, three contacts, undamped, force held.
#![no_std]
#![no_main]

images::stepping!(three_contacts);

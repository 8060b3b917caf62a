//! Stepper, 2 masses f32, two elastic contacts, undamped, force held.
#![no_std]
#![no_main]

images::stepping!(elastic_contacts);

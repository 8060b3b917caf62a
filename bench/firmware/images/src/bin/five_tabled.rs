//! Damped 5DOF f32, `accuracy: 1e-4`: limits and the contact's amplitude from tables.
#![no_std]
#![no_main]

images::image!(tabled_five_contact INPUTS_SINGLE);

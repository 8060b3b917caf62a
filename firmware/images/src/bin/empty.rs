//! No call: what every image has.
#![no_std]
#![no_main]

images::image!();

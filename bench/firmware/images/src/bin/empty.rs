//! An image without any call. It contains only what every image has.
#![no_std]
#![no_main]

images::image!();

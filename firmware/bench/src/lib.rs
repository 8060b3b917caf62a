//! What both programs measure with.
#![no_std]

pub mod stack;
pub mod timer;

//! Measures the instructions and the stack of a call on the emulated processor.
#![no_std]

pub mod stack;
pub mod timer;

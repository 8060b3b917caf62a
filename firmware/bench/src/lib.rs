//! Measuring tools of both programs.
#![no_std]

pub mod stack;
pub mod timer;

//! Saves steppers as images on the emulated processor, and continues from the images.
#![no_std]
#![no_main]

use core::panic::PanicInfo;
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use scenes::steps::images::report;

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}

#[entry]
fn main() -> ! {
    let ended = report(&mut |line| hprintln!("{}", line));
    if ended.is_err() {
        hprintln!("WRONG: a stepper refused its input");
    }
    loop {
        debug::exit(debug::EXIT_SUCCESS);
    }
}

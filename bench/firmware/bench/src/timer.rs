//! Counts the instructions of a call, with a timer that counts emulated time.

use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;

/// Number of timer ticks that [`INSTRUCTIONS`] instructions take. The timer counts at 25 MHz, and the emulator takes
/// 64 ns for an instruction. Eight ticks are therefore five instructions.
pub const TICKS: u64 = 8;
/// Number of instructions that take [`TICKS`] ticks of the timer.
pub const INSTRUCTIONS: u64 = 5;
/// Number of different values of the 24-bit timer.
const RANGE: u64 = 1 << 24;

/// Number of overflows of the timer since the start of the measurement.
static TURNS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    TURNS.store(TURNS.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
}

/// Starts the timer and its interrupt, which counts overflows.
pub fn set_up(timer: &mut SYST) {
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(0x00ff_ffff);
    timer.enable_interrupt();
    timer.enable_counter();
}

/// Returns the number of timer ticks that a call takes.
#[inline(always)]
pub fn ticks(timer: &mut SYST, run: impl FnOnce()) -> u64 {
    // Writing to the counter reloads it without an interrupt.
    timer.clear_current();
    TURNS.store(0, Ordering::Relaxed);
    let start = u64::from(SYST::get_current());
    run();
    let end = u64::from(SYST::get_current());
    // The timer counts down.
    u64::from(TURNS.load(Ordering::Relaxed)) * RANGE + start - end
}

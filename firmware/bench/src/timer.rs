//! Number of instructions, from a timer that counts emulated time.

use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;

/// Ticks in [`INSTRUCTIONS`] instructions. The timer counts at 25 MHz and the emulator takes 64 ns for an instruction,
/// so eight ticks are five instructions.
pub const TICKS: u64 = 8;
/// Instructions in [`TICKS`] ticks.
pub const INSTRUCTIONS: u64 = 5;
/// Number of values of the 24-bit timer.
const RANGE: u64 = 1 << 24;

/// Number of overflows of the timer.
static TURNS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    TURNS.store(TURNS.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
}

/// Starts the timer.
pub fn set_up(timer: &mut SYST) {
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(0x00ff_ffff);
    timer.enable_interrupt();
    timer.enable_counter();
}

/// Returns the ticks that a call takes.
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

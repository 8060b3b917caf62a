//! Instructions, from a timer that counts emulated time.

use core::sync::atomic::{AtomicU32, Ordering};
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;

/// The timer counts 25 MHz while the emulator runs an instruction in 64 ns: eight ticks for five.
pub const TICKS: u64 = 8;
/// See [`TICKS`].
pub const INSTRUCTIONS: u64 = 5;
/// The timer's 24 bits.
const RANGE: u64 = 1 << 24;

/// How often the timer has run through.
static TURNS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    TURNS.store(TURNS.load(Ordering::Relaxed) + 1, Ordering::Relaxed);
}

/// Starts it.
pub fn set_up(timer: &mut SYST) {
    timer.set_clock_source(SystClkSource::Core);
    timer.set_reload(0x00ff_ffff);
    timer.enable_interrupt();
    timer.enable_counter();
}

/// How many ticks this takes.
#[inline(always)]
pub fn ticks(timer: &mut SYST, run: impl FnOnce()) -> u64 {
    // A write reloads the counter without an interrupt.
    timer.clear_current();
    TURNS.store(0, Ordering::Relaxed);
    let start = u64::from(SYST::get_current());
    run();
    let end = u64::from(SYST::get_current());
    // The timer counts down.
    u64::from(TURNS.load(Ordering::Relaxed)) * RANGE + start - end
}

//! How much stack a call needs: painted below the stack pointer, read back afterwards.

use core::arch::asm;

/// More than any call needs.
const PAINTED: usize = 64 * 1024;
const PAINT: u32 = 0xa5a5_5a5a;

fn pointer() -> usize {
    let pointer: usize;
    // SAFETY: reads a register.
    unsafe { asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags)) };
    pointer
}

/// The bytes of stack below this function's own frame that the call has written.
pub fn depth(call: impl FnOnce()) -> usize {
    depth_within(PAINTED, call)
}

/// The same of a call that is known to need less than this.
#[inline(never)]
pub fn depth_within(painted: usize, call: impl FnOnce()) -> usize {
    let top = pointer() & !3;
    let bottom = top - painted;
    let mut at = bottom;
    while at < top {
        // SAFETY: below the stack pointer, inside the 4 MiB of RAM, nothing is alive.
        unsafe { core::ptr::write_volatile(at as *mut u32, PAINT) };
        at += 4;
    }
    call();
    let mut at = bottom;
    // SAFETY: the same memory.
    while at < top && unsafe { core::ptr::read_volatile(at as *const u32) } == PAINT {
        at += 4;
    }
    top - at
}

//! Stack of a call: the memory below the stack pointer is painted, and read back afterwards.

use core::arch::asm;

/// Number of bytes that are painted, more than any call needs.
const PAINTED: usize = 64 * 1024;
const PAINT: u32 = 0xa5a5_5a5a;

fn pointer() -> usize {
    let pointer: usize;
    // SAFETY: reads a register only.
    unsafe { asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags)) };
    pointer
}

/// Returns the number of bytes below this function's own frame that the call has written.
pub fn depth(call: impl FnOnce()) -> usize {
    depth_within(PAINTED, call)
}

/// Does the same as [`depth`], for a call that is known to need less than `painted` bytes.
#[inline(never)]
pub fn depth_within(painted: usize, call: impl FnOnce()) -> usize {
    let top = pointer() & !3;
    let bottom = top - painted;
    let mut at = bottom;
    while at < top {
        // SAFETY: the memory below the stack pointer is inside the 4 MiB of RAM, and nothing there is in use.
        unsafe { core::ptr::write_volatile(at as *mut u32, PAINT) };
        at += 4;
    }
    call();
    let mut at = bottom;
    // SAFETY: the same memory as above.
    while at < top && unsafe { core::ptr::read_volatile(at as *const u32) } == PAINT {
        at += 4;
    }
    top - at
}

//! Measures the stack of a call: fills the memory below the stack pointer with a pattern, and reads it back after the
//! call.

use core::arch::asm;

/// Number of bytes below the stack pointer that are filled with the pattern. No call needs as many.
const PAINTED: usize = 64 * 1024;
const PAINT: u32 = 0xa5a5_5a5a;

fn pointer() -> usize {
    let pointer: usize;
    // SAFETY: reads a register only.
    unsafe { asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack, preserves_flags)) };
    pointer
}

/// Runs a call and returns the number of bytes that it has written below the frame of this function.
pub fn depth(call: impl FnOnce()) -> usize {
    depth_within(PAINTED, call)
}

/// Measures a call as [`depth`] does, but fills only `painted` bytes. The call must need fewer bytes of stack.
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
    // SAFETY: the loop above has written this memory.
    while at < top && unsafe { core::ptr::read_volatile(at as *const u32) } == PAINT {
        at += 4;
    }
    top - at
}

//! The functions that the browser calls: they give memory for a question, and its answer.
//!
//! This file alone may contain unsafe code, which here is only the names of the functions. The page has one thread
//! for each instance, so that the calls never overlap.
#![allow(
    unsafe_code,
    reason = "the browser finds a function by its unmangled name"
)]

use std::cell::RefCell;

thread_local! {
    /// The text of the question. After a call of [`ask`] it is the text of the answer.
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Provides memory for a question of `length` bytes and returns its address. The page writes the question into this
/// memory.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    TEXT.with_borrow_mut(|text| {
        text.clear();
        text.resize(length, 0);
        text.as_mut_ptr()
    })
}

/// Answers the question and returns the length of the answer in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn ask() -> usize {
    let question = TEXT.with_borrow_mut(std::mem::take);
    let answer = crate::answer(&String::from_utf8_lossy(&question));
    TEXT.with_borrow_mut(|text| {
        *text = answer.into_bytes();
        text.len()
    })
}

/// Returns the address of the answer.  It is valid until the next call of [`room`] or [`ask`].
#[unsafe(no_mangle)]
pub extern "C" fn told() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}

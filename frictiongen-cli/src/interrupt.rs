//! Ctrl-C in the middle of a long computation: what is done is kept.

use std::sync::atomic::{AtomicBool, Ordering};

static PRESSED: AtomicBool = AtomicBool::new(false);

/// From now on Ctrl-C is noted; a second one ends the program.
pub fn watch() {
    // Where signals cannot be caught, or are already, Ctrl-C ends the program as ever.
    let _ = ctrlc::set_handler(|| {
        if PRESSED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
}

/// Whether it was pressed.
pub fn pressed() -> bool {
    PRESSED.load(Ordering::Relaxed)
}

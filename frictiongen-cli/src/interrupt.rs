//! Handles Ctrl-C during a long computation, so that finished results are kept.

use std::sync::atomic::{AtomicBool, Ordering};

static PRESSED: AtomicBool = AtomicBool::new(false);

/// Starts to record Ctrl-C. A second Ctrl-C ends the program.
pub fn watch() {
    // If signals cannot be caught, or already are, Ctrl-C ends the program as usual.
    let _ = ctrlc::set_handler(|| {
        if PRESSED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
}

/// Returns whether Ctrl-C was pressed.
pub fn pressed() -> bool {
    PRESSED.load(Ordering::Relaxed)
}

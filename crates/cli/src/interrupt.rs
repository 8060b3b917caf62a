//! Handles Ctrl-C during a long computation, so that the program can print the finished results.

use crate::failure::Failure;
use std::sync::atomic::{AtomicBool, Ordering};

static PRESSED: AtomicBool = AtomicBool::new(false);

/// Starts to watch for Ctrl-C. The first Ctrl-C requests the end of the computation. The second Ctrl-C ends the
/// program.
pub fn watch() {
    // If the program cannot catch the signal, or already catches it, Ctrl-C ends the program as usual.
    let _ = ctrlc::set_handler(|| {
        if PRESSED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
}

/// Returns true if the user has pressed Ctrl-C.
pub fn pressed() -> bool {
    PRESSED.load(Ordering::Relaxed)
}

/// Returns the failure of a search that the user stopped by Ctrl-C. The command has already printed the best result so
/// far.
pub fn search_stopped() -> Failure {
    Failure::new("stopped: the search did not end, and the friction is the best so far")
}

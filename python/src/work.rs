//! Runs computations without Python's global lock, and stops them at Ctrl-C.

use crate::errors::defect;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, Thread};
use std::time::Duration;

/// Longest delay between Ctrl-C and the reaction of the program.
const PATIENCE: Duration = Duration::from_millis(50);

/// Notifies the waiting thread when the work ends, even by a panic.
struct Bell<'a> {
    done: &'a AtomicBool,
    waiting: Thread,
}

impl Drop for Bell<'_> {
    fn drop(&mut self) {
        self.done.store(true, Ordering::Release);
        self.waiting.unpark();
    }
}

/// Request to stop the work.
pub struct Stop(AtomicBool);

impl Stop {
    /// Returns true if no stop was requested.
    pub fn goes_on(&self) -> bool {
        !self.0.load(Ordering::Relaxed)
    }
}

/// Runs `work` on a thread of its own without Python's global lock, and returns the result. Ctrl-C requests a stop. If
/// `work` does not check for the request, it runs to its end, and the function raises the interrupt afterwards.
pub fn without_lock<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop(AtomicBool::new(false));
    let done = AtomicBool::new(false);
    let bell = Bell {
        done: &done,
        waiting: thread::current(),
    };
    thread::scope(|scope| {
        let worker = scope.spawn(|| {
            let _bell = bell;
            work(&stop)
        });
        let mut interrupt = Ok(());
        while !done.load(Ordering::Acquire) {
            py.detach(|| thread::park_timeout(PATIENCE));
            if interrupt.is_ok() {
                interrupt = py.check_signals();
                stop.0.fetch_or(interrupt.is_err(), Ordering::Relaxed);
            }
        }
        let result = py.detach(|| worker.join());
        interrupt?;
        result.map_err(|_| {
            defect("a computation ended without a result: please report this with the description")
        })
    })
}

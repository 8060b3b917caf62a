//! Computes without Python's lock, and listens to Ctrl-C meanwhile.

use crate::errors::defect;
use pyo3::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::thread::{self, Thread};
use std::time::Duration;

/// How long Ctrl-C may wait.
const PATIENCE: Duration = Duration::from_millis(50);

/// Wakes whoever waits, whether the work ends well or not.
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

/// Whether somebody wants the work to stop.
pub struct Stop(AtomicBool);

impl Stop {
    /// Whether it is to go on.
    pub fn goes_on(&self) -> bool {
        !self.0.load(Ordering::Relaxed)
    }
}

/// The result of some work, done on a thread of its own while other threads may run Python.  Ctrl-C tells the work to
/// stop; work that does not ask goes on to its end, and then the interrupt is raised.
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

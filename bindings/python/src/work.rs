//! Runs computations without Python's global lock. If the user presses Ctrl-C, the module stops a computation, or
//! returns before the computation has ended.

use crate::errors::{defect, domain};
use pyo3::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

/// Longest time after Ctrl-C until the program notices the interrupt.
const PATIENCE: Duration = Duration::from_millis(50);

/// Flag by which one thread requests that the work on another thread stops.
pub struct Stop(AtomicBool);

impl Stop {
    /// Returns true as long as no stop was requested.
    pub fn goes_on(&self) -> bool {
        !self.0.load(Ordering::Relaxed)
    }
}

/// Runs `work` on a thread of its own, without Python's global lock, and returns the result. Ctrl-C requests a stop,
/// and the function raises the interrupt when `work` has ended. For this reason `work` must check for the request a few
/// times a second. [`left_at_interrupt`] is for computations that cannot check.
pub fn without_lock<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop(AtomicBool::new(false));
    let (sender, receiver) = mpsc::sync_channel(1);
    let stop = &stop;
    thread::scope(|scope| {
        let worker = scope.spawn(move || sender.send(work(stop)));
        let result = receive(py, stop, receiver);
        // After an interrupt, this call waits until the work has noticed the request and ended.
        let _ = py.detach(|| worker.join());
        result
    })
}

/// Runs `work` on a thread of its own without Python's global lock, and returns the result. At Ctrl-C the function
/// requests a stop and raises the interrupt immediately. The thread then continues until `work` has checked for the
/// request or has ended, and drops the result. For this reason `work` must own its arguments and change nothing that
/// others see.
pub fn left_at_interrupt<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&Stop) -> T + Send + 'static,
) -> PyResult<T> {
    let stop = Arc::new(Stop(AtomicBool::new(false)));
    let heard = Arc::clone(&stop);
    let (sender, receiver) = mpsc::sync_channel(1);
    let started = thread::Builder::new().spawn(move || {
        // After an interrupt no thread receives the result, so the send may fail.
        let _ = sender.send(work(&heard));
    });
    started.map_err(|error| domain(format_args!("no thread for the computation: {error}")))?;
    receive(py, &stop, receiver)
}

/// Waits for the result of a computation on another thread. At Ctrl-C the function requests a stop and raises the
/// interrupt.
fn receive<T: Send>(py: Python<'_>, stop: &Stop, mut receiver: Receiver<T>) -> PyResult<T> {
    loop {
        let results = &mut receiver;
        match py.detach(move || results.recv_timeout(PATIENCE)) {
            Ok(result) => return Ok(result),
            Err(RecvTimeoutError::Timeout) => {
                let interrupt = py.check_signals();
                stop.0.fetch_or(interrupt.is_err(), Ordering::Relaxed);
                interrupt?;
            }
            // The channel is closed without a result, because the computation has panicked.
            Err(RecvTimeoutError::Disconnected) => {
                return Err(defect(
                    "a computation ended without a result: please report this with the description",
                ));
            }
        }
    }
}

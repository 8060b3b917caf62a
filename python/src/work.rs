//! Runs computations without Python's global lock, and stops or leaves them if the user presses Ctrl-C.

use crate::errors::{defect, domain};
use pyo3::prelude::*;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

/// Longest delay between Ctrl-C and the check for it.
const PATIENCE: Duration = Duration::from_millis(50);

/// Flag by which one thread asks the work on another thread to stop.
pub struct Stop(AtomicBool);

impl Stop {
    /// Returns true as long as no stop was requested.
    pub fn goes_on(&self) -> bool {
        !self.0.load(Ordering::Relaxed)
    }
}

/// Runs `work` on a thread of its own, without Python's global lock, and returns the result. Ctrl-C requests a stop.
/// The function raises the interrupt when `work` has ended, so `work` must check for the request a few times a
/// second. [`left_at_interrupt`] is for computations that cannot check.
pub fn without_lock<T: Send>(py: Python<'_>, work: impl FnOnce(&Stop) -> T + Send) -> PyResult<T> {
    let stop = Stop(AtomicBool::new(false));
    let (sender, receiver) = mpsc::sync_channel(1);
    let stop = &stop;
    thread::scope(|scope| {
        let worker = scope.spawn(move || sender.send(work(stop)));
        let result = receive(py, stop, receiver);
        // After an interrupt the work ends as soon as it has checked for the request.
        let _ = py.detach(|| worker.join());
        result
    })
}

/// Runs `work` on a thread of its own without Python's global lock, and returns the result. At Ctrl-C the function
/// raises the interrupt immediately and requests a stop. The thread then runs on until `work` has checked for the
/// request or has ended, and drops the result. So `work` must own its arguments and change nothing that others see.
pub fn left_at_interrupt<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&Stop) -> T + Send + 'static,
) -> PyResult<T> {
    let stop = Arc::new(Stop(AtomicBool::new(false)));
    let heard = Arc::clone(&stop);
    let (sender, receiver) = mpsc::sync_channel(1);
    let started = thread::Builder::new().spawn(move || {
        // After an interrupt nobody receives the result.
        let _ = sender.send(work(&heard));
    });
    started.map_err(|error| domain(format_args!("no thread for the computation: {error}")))?;
    receive(py, &stop, receiver)
}

/// Waits for the result of a computation on another thread. Ctrl-C requests a stop, and the function then raises the
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
            // The computation has panicked.
            Err(RecvTimeoutError::Disconnected) => {
                return Err(defect(
                    "a computation ended without a result: please report this with the description",
                ));
            }
        }
    }
}

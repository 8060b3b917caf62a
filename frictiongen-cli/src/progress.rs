//! Shows the progress of a long run on standard error, if that is a terminal.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// Time from the start of the run to the first message.
const PATIENCE: Duration = Duration::from_secs(2);
/// Time between two messages.
const PACE: Duration = Duration::from_millis(200);

/// The progress of a run, as it is printed.
pub struct Progress {
    total: usize,
    done: usize,
    what: &'static str,
    next: Option<Instant>,
    shown: bool,
}

impl Progress {
    /// Starts the progress of a run over `total` items. Messages call the items `what`.
    pub fn new(total: usize, what: &'static str) -> Self {
        // If the output goes to the same terminal, its lines already show the progress.
        let watched = io::stderr().is_terminal() && !io::stdout().is_terminal();
        Self {
            total,
            done: 0,
            what,
            next: watched.then(|| Instant::now() + PATIENCE),
            shown: false,
        }
    }

    /// Counts one more item as done.
    pub fn step(&mut self) {
        self.reach(self.done + 1);
    }

    /// Sets the number of items done.
    pub fn reach(&mut self, done: usize) {
        self.done = done;
        let Some(next) = self.next else { return };
        let now = Instant::now();
        if now >= next {
            self.next = Some(now + PACE);
            self.shown = true;
            let percent = self.done.saturating_mul(100) / self.total.max(1);
            say(&format!(
                "\rfrictiongen: {percent:>3} % of {} {}",
                self.total, self.what
            ));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if self.shown {
            say("\r\x1b[K");
        }
    }
}

/// Writes a text to standard error.
pub fn say(text: &str) {
    let mut stderr = io::stderr().lock();
    // If standard error cannot be written, the computation continues.
    let _ = stderr.write_all(text.as_bytes());
    let _ = stderr.flush();
}

//! Tells how far a long run is, on standard error, if a person looks at it.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// How long a run is before it tells.
const PATIENCE: Duration = Duration::from_secs(2);
/// How often it tells.
const PACE: Duration = Duration::from_millis(200);

/// How far a run is.
pub struct Progress {
    total: usize,
    done: usize,
    what: &'static str,
    next: Option<Instant>,
    shown: bool,
}

impl Progress {
    /// Of a run over so many points, or whatever they are.
    pub fn new(total: usize, what: &'static str) -> Self {
        // With the output on the same terminal, the lines themselves tell.
        let watched = io::stderr().is_terminal() && !io::stdout().is_terminal();
        Self {
            total,
            done: 0,
            what,
            next: watched.then(|| Instant::now() + PATIENCE),
            shown: false,
        }
    }

    /// One more point is done.
    pub fn step(&mut self) {
        self.reach(self.done + 1);
    }

    /// So many are done.
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

/// Writes a text on standard error.
pub fn say(text: &str) {
    let mut stderr = io::stderr().lock();
    // A message that standard error does not take must not stop the work.
    let _ = stderr.write_all(text.as_bytes());
    let _ = stderr.flush();
}

//! Prints the progress and the remaining time of a long run on standard error, if standard error is a terminal.

use std::io::{self, IsTerminal, Write};
use std::time::{Duration, Instant};

/// Time from the start of a run to the first message about its progress.
const PATIENCE: Duration = Duration::from_secs(1);
/// Time between two messages about the progress.
const PACE: Duration = Duration::from_millis(200);

/// The progress of a run, for messages to the user.
pub struct Progress {
    /// Number of items of the run. `None` for a search, whose length is unknown.
    total: Option<usize>,
    done: usize,
    what: &'static str,
    start: Instant,
    next: Option<Instant>,
    shown: bool,
}

impl Progress {
    /// Starts the progress of a run that prints its results one by one. The run has `total` items, with the name `what`
    /// in the messages.
    pub fn new(total: usize, what: &'static str) -> Self {
        // If the output goes to the same terminal, the printed results already show the progress.
        Self::seen(Some(total), what, !io::stdout().is_terminal())
    }

    /// Starts the progress of a run that prints no results before its end. The run has `total` items, with the name
    /// `what` in the messages.
    pub fn silent(total: usize, what: &'static str) -> Self {
        Self::seen(Some(total), what, true)
    }

    /// Starts the progress of a search whose length is unknown. Its messages state the time since the start.
    pub fn search() -> Self {
        Self::seen(None, "", true)
    }

    fn seen(total: Option<usize>, what: &'static str, needed: bool) -> Self {
        let start = Instant::now();
        let watched = needed && io::stderr().is_terminal();
        Self {
            total,
            done: 0,
            what,
            start,
            next: watched.then(|| start + PATIENCE),
            shown: false,
        }
    }

    /// Adds 1 to the number of finished items of the run.
    pub fn step(&mut self) {
        self.reach(self.done + 1);
    }

    /// Sets the number of finished items of the run to `done`.
    pub fn reach(&mut self, done: usize) {
        self.done = self.done.max(done);
        let Some(next) = self.next else { return };
        let now = Instant::now();
        if now >= next {
            self.next = Some(now + PACE);
            self.shown = true;
            let passed = now - self.start;
            let line = match self.total {
                Some(total) => line(self.done, total, self.what, passed),
                None => searching(passed),
            };
            say(&format!("\r\x1b[K{line}"));
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

/// Returns the message of a run that has finished `done` items after the time `passed`.
fn line(done: usize, total: usize, what: &str, passed: Duration) -> String {
    let percent = done.saturating_mul(100) / total.max(1);
    let mut line = format!("frictiongen: {percent:>3} % of {total} {what}");
    if 0 < done && done < total {
        let left = passed.as_secs_f64() * (total - done) as f64 / done as f64;
        line += &format!(", {} left", spell(left));
    }
    line
}

/// Returns the message of a search that has run for the time `passed`.
fn searching(passed: Duration) -> String {
    let passed = spell(passed.as_secs_f64());
    format!("frictiongen: searching for {passed}; Ctrl-C keeps the best friction so far")
}

/// Formats a time in seconds with one or two units.
fn spell(seconds: f64) -> String {
    let whole = seconds.ceil() as u64;
    match (whole / 3600, whole / 60 % 60, whole % 60) {
        (0, 0, seconds) => format!("{seconds} s"),
        (0, minutes, seconds) => format!("{minutes} min {seconds} s"),
        (hours, minutes, _) => format!("{hours} h {minutes} min"),
    }
}

/// Writes a message to standard error.
pub fn say(text: &str) {
    let mut stderr = io::stderr().lock();
    // If standard error cannot be written, the computation continues.
    let _ = stderr.write_all(text.as_bytes());
    let _ = stderr.flush();
}

#[cfg(test)]
mod tests {
    use super::{line, searching, spell};
    use std::time::Duration;

    #[test]
    fn the_remaining_time_is_that_of_the_remaining_items() {
        let after = |done, seconds| line(done, 40, "points", Duration::from_secs(seconds));
        assert_eq!(after(0, 2), "frictiongen:   0 % of 40 points");
        assert_eq!(after(10, 5), "frictiongen:  25 % of 40 points, 15 s left");
        assert_eq!(after(40, 9), "frictiongen: 100 % of 40 points");
        assert_eq!(
            line(1, 0, "points", Duration::ZERO),
            "frictiongen: 100 % of 0 points"
        );
    }

    #[test]
    fn a_search_says_how_long_it_has_run() {
        assert_eq!(
            searching(Duration::from_secs(61)),
            "frictiongen: searching for 1 min 1 s; Ctrl-C keeps the best friction so far"
        );
    }

    #[test]
    fn times_have_their_units() {
        for (seconds, text) in [
            (0.2, "1 s"),
            (59.0, "59 s"),
            (61.5, "1 min 2 s"),
            (3599.0, "59 min 59 s"),
            (7500.0, "2 h 5 min"),
        ] {
            assert_eq!(spell(seconds), text);
        }
    }
}

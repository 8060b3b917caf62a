//! Measures the time of a call in ns. All jobs take turns in each round, and the result is a median and a minimum
//! over the rounds.

use std::time::Instant;

/// Shortest time of a pass, in s. A shorter pass is repeated within its round until it takes this time.
const SHORTEST: f64 = 2e-4;
/// Longest time of a pass, in s. A longer pass gets fewer points, but not fewer than `FEWEST_POINTS`.
const LONGEST: f64 = 0.05;
const FEWEST_POINTS: usize = 8;

/// A function that is timed. A pass calls it at its first `points` points, and a round has `passes` passes.
pub struct Job<'a> {
    run: Box<dyn FnMut(usize) + 'a>,
    points: usize,
    passes: usize,
    times: Vec<f64>,
}

/// Time of one call, from all rounds, in ns.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    /// Median over the rounds, ns.
    pub median: f64,
    /// Shortest time of a round, ns.
    pub least: f64,
}

impl<'a> Job<'a> {
    /// Creates a job that calls `run` for at most `points` points in a pass.
    pub fn new(points: usize, run: impl FnMut(usize) + 'a) -> Self {
        Self {
            run: Box::new(run),
            points,
            passes: 1,
            times: Vec::new(),
        }
    }

    /// Returns the time in s of the passes of a round.
    fn pass(&mut self) -> f64 {
        let start = Instant::now();
        for _ in 0..self.passes {
            (self.run)(self.points);
        }
        start.elapsed().as_secs_f64()
    }

    fn fit(&mut self) {
        let all = self.points;
        self.points = all.min(FEWEST_POINTS);
        self.pass();
        let one = self.pass() / self.points as f64;
        self.points = all.min(((LONGEST / one) as usize).max(FEWEST_POINTS));
        self.passes = (SHORTEST / (one * self.points as f64)).ceil().max(1.0) as usize;
    }
}

/// Times several jobs in turn, round by round. Returns the time of a call of each job.
pub fn interleaved(jobs: &mut [Job<'_>], rounds: usize) -> Vec<Time> {
    jobs.iter_mut().for_each(Job::fit);
    for _ in 0..rounds {
        for job in jobs.iter_mut() {
            let seconds = job.pass();
            job.times
                .push(seconds / (job.passes * job.points) as f64 * 1e9);
        }
    }
    let time = |job: &mut Job<'_>| {
        job.times.sort_by(f64::total_cmp);
        Time {
            median: job.times[job.times.len() / 2],
            least: job.times[0],
        }
    };
    jobs.iter_mut().map(time).collect()
}

//! Nanoseconds a call: medians and minima of interleaved rounds.

use std::time::Instant;

/// One pass lasts at least this long, or is repeated within a round.
const SHORTEST: f64 = 2e-4;
/// Passes that last longer are cut to fewer points.
const LONGEST: f64 = 0.05;
const FEWEST_POINTS: usize = 8;

/// Something to time: calls itself at the first points, as many as it is told.
pub struct Job<'a> {
    run: Box<dyn FnMut(usize) + 'a>,
    points: usize,
    passes: usize,
    times: Vec<f64>,
}

/// Of all rounds, ns a call.
#[derive(Clone, Copy, Debug)]
pub struct Time {
    /// The median.
    pub median: f64,
    /// The shortest.
    pub least: f64,
}

impl<'a> Job<'a> {
    /// A job of at most `points` calls a pass.
    pub fn new(points: usize, run: impl FnMut(usize) + 'a) -> Self {
        Self {
            run: Box::new(run),
            points,
            passes: 1,
            times: Vec::new(),
        }
    }

    fn pass(&mut self) -> f64 {
        let start = Instant::now();
        for _ in 0..self.passes {
            (self.run)(self.points);
        }
        start.elapsed().as_secs_f64()
    }

    fn fit(&mut self) {
        (self.run)(self.points.min(FEWEST_POINTS));
        let all = self.points;
        self.points = all.min(FEWEST_POINTS);
        let one = self.pass() / self.points as f64;
        self.points = all.min(((LONGEST / one) as usize).max(FEWEST_POINTS));
        self.passes = (SHORTEST / (one * self.points as f64)).ceil().max(1.0) as usize;
    }
}

/// Times jobs in turn.
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

//! Nanoseconds a call: medians and minima of interleaved rounds.

use std::time::Instant;

/// One pass lasts at least this long, or is repeated within a round.
const SHORTEST: f64 = 2e-4;
/// Passes that last longer are cut to fewer points.
const LONGEST: f64 = 0.05;
const FEWEST_POINTS: usize = 8;

/// Something to time: calls itself at the first points, as many and as often as it is told.
pub struct Job<'a> {
    seconds: Box<dyn FnMut(usize, usize) -> f64 + 'a>,
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
    pub fn new(points: usize, mut run: impl FnMut(usize) + 'a) -> Self {
        Self::timed_by(points, move |count, passes| {
            let start = Instant::now();
            for _ in 0..passes {
                run(count);
            }
            start.elapsed().as_secs_f64()
        })
    }

    /// A job that knows itself how many seconds it took, for so many points and passes.
    pub fn timed_by(points: usize, seconds: impl FnMut(usize, usize) -> f64 + 'a) -> Self {
        Self {
            seconds: Box::new(seconds),
            points,
            passes: 1,
            times: Vec::new(),
        }
    }

    fn pass(&mut self) -> f64 {
        (self.seconds)(self.points, self.passes)
    }

    fn fit(&mut self) {
        (self.seconds)(self.points.min(FEWEST_POINTS), 1);
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

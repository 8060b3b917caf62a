//! Finds the slowest calls that compute exact limits, and compares their time with the median.

use crate::methods::{Fill, Method, Pair};
use crate::points::logarithmic;
use crate::scenes::Label;
use frictiongen::{Effort, System};
use std::hint::black_box;
use std::time::Instant;

/// Range of frequency ratios r over which single calls are timed.
pub const RANGE: [f64; 2] = [0.02, 10.0];
/// Number of calls at each point. The shortest of their times is taken.
const CALLS: usize = 3;
/// Number of the slowest points that the program times a second time, with more calls. In this way an interruption of a
/// call does not count.
const SLOWEST: usize = 100;
const CALLS_OF_SLOWEST: usize = 20;
/// Largest number of rounds in which the program repeats the timing of the slowest points. After a round, other points
/// may be the slowest.
const TIMES_ANEW: usize = 10;

/// Distribution of the times of single calls over the points of a scene, in ns.
#[derive(Clone, Copy, Debug)]
pub struct Tail {
    /// Scene whose calls are timed.
    pub label: Label,
    /// Number of points at which calls were timed.
    pub points: usize,
    /// Median time of a call.
    pub median: f64,
    /// Time that 99 of 100 calls do not exceed.
    pub hundredth: f64,
    /// Time that 999 of 1000 calls do not exceed.
    pub thousandth: f64,
    /// Time of the slowest call.
    pub slowest: f64,
    /// Frequency ratio r of the slowest call.
    pub r: f64,
    /// Largest number of evaluations in a search that finished within its limit.
    pub evaluations: u32,
    /// Number of searches that did not finish within their limit.
    pub exceeded: usize,
}

struct Timed {
    r: f64,
    time: f64,
    anew: bool,
}

/// Returns the shortest time of `calls` calls, in ns. `clock` is the time of reading the clock and is subtracted.
fn least(calls: usize, clock: f64, mut call: impl FnMut()) -> f64 {
    let one = |_| {
        let start = Instant::now();
        call();
        start.elapsed().as_secs_f64() * 1e9
    };
    let least = (0..calls).map(one).fold(f64::INFINITY, f64::min);
    (least - clock).max(0.0)
}

/// Returns the median time in ns between two readings of the clock.
fn clock() -> f64 {
    let mut times: Vec<f64> = (0..10_001).map(|_| least(1, 0.0, || ())).collect();
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn sort(timed: &mut [Timed]) {
    timed.sort_by(|a, b| b.time.total_cmp(&a.time));
}

/// Times calls for exact limits at `points` points of a scene, one by one.
pub fn of(label: Label, fill: &Fill<f64>, system: &System, points: usize) -> Tail {
    let clock = clock();
    let time = |r: f64, calls| {
        let point: Pair<f64> = [r, 0.0];
        let mut out = [[0.0; 2]];
        let time = least(calls, clock, || {
            fill(Method::Limits, black_box(&[point]), &mut out);
            black_box(&mut out);
        });
        Timed {
            r,
            time,
            anew: calls == CALLS_OF_SLOWEST,
        }
    };
    let ratios = logarithmic(points, RANGE);
    let mut timed: Vec<Timed> = ratios.iter().map(|r| time(*r, CALLS)).collect();
    for _ in 0..TIMES_ANEW {
        sort(&mut timed);
        let slowest = timed.iter_mut().take(SLOWEST);
        let mut changed = false;
        for point in slowest.filter(|point| !point.anew) {
            *point = time(point.r, CALLS_OF_SLOWEST);
            changed = true;
        }
        if !changed {
            break;
        }
    }
    sort(&mut timed);
    let beyond = |part: usize| timed[points / part].time;
    let (mut evaluations, mut exceeded) = (0, 0);
    for at in ratios.iter().filter_map(|r| system.at(*r).ok()) {
        match at.limits_searched().1 {
            Effort::Bounded(count) => evaluations = evaluations.max(count),
            Effort::Exceeded => exceeded += 1,
        }
    }
    Tail {
        label,
        points,
        median: beyond(2),
        hundredth: beyond(100),
        thousandth: beyond(1000),
        slowest: timed[0].time,
        r: timed[0].r,
        evaluations,
        exceeded,
    }
}

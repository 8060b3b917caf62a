//! Chooses candidates for the witness over an interval of r. A witness is an instant near the largest velocity
//! constraint. The candidates come from the instants at which the exact search finds this constraint.

use crate::force;
use crate::series::IntervalSeries;
use crate::stage::{ChainStage, IntervalChain, ORDER};
use crate::witness::Witness;
use frictiongen_model::interval::Interval;
use frictiongen_model::table::building::Exact;
use frictiongen_model::table::building::interpolated;
use std::f64::consts::PI;

/// Number of instants through which the polynomial of a witness passes. The value is tuned. Each instant costs a
/// search. Five instants give a polynomial of degree 4 in r.
const NODES: usize = 5;
/// Two instants belong to different maxima, and so not to one witness, if their distance exceeds this value, in
/// half-turns. The value is tuned. A polynomial through two maxima would be near neither of them.
const JUMP: f64 = 0.05;
/// A witness may use the Taylor series in τ (module `early`) if its instant is closer to the start of the half period
/// than this distance. The unit is a radian of the fastest mode. The series is valid for all instants of such a
/// witness.
const EARLY: f64 = 1.2;
/// A witness uses only the Taylor series in τ if its instant is closer to the start of the half period than this
/// distance, in radians of the fastest mode. The value is tuned. So close to the start, F/sin τ is a quotient of two
/// small intervals.
const SURELY: f64 = 0.3;
/// The start of the half period itself is also a candidate if an instant is closer to it than this distance, in radians
/// of the fastest mode. The value is tuned. A maximum this close may reach the start within the interval of r.
const START: f64 = 0.05;

/// Returns the candidates for the instant of the largest constraint, from exact searches at several r.
pub(crate) fn candidates(
    exact: &mut Exact<'_>,
    chain: &IntervalChain,
    (from, to): (f64, f64),
    centre: f64,
    over: &ChainStage<ORDER>,
    singular: &[bool],
) -> Vec<Witness> {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let mut places = Vec::with_capacity(NODES);
    let mut instants = Vec::with_capacity(NODES);
    let (mut early, mut starts, mut latest) = (true, false, 0.0_f64);
    let modes = over.modes.iter();
    let fastest = modes
        .map(|mode| PI * mode.x.value().high)
        .fold(PI, f64::max);
    let turned = over.kappa.is_some_and(|kappa| {
        let own = ChainStage::<1>::over(chain, Interval::point(middle), singular);
        let own = own.kappa.map_or(1.0, |kappa| kappa.value().middle());
        own * kappa.value().middle() < 0.0
    });
    for k in 0..NODES {
        let r = middle - half * (PI * (k as f64 + 0.5) / NODES as f64).cos();
        let Some(tau) = exact.at(r).and_then(|sample| sample.tau) else {
            starts = true;
            continue;
        };
        let mut t = tau / PI;
        early &= t * fastest < EARLY;
        latest = latest.max(t * fastest);
        starts |= t * fastest < START;
        if chain.all_undamped {
            let own = ChainStage::<1>::over(chain, Interval::point(r), singular);
            let own = if turned { own.turned() } else { own };
            let at = IntervalSeries::fixed(Interval::point(t));
            let motions = force::motions(&own, &at);
            let force = force::value(&own, &motions, &at.sine_cosine().1);
            if force.value().middle() < 0.0 {
                t = 1.0 - t;
            }
        }
        places.push((r - centre) / half);
        instants.push(t);
    }
    let mut witnesses = Vec::new();
    let apart = |pair: &[f64]| matches!(pair, [a, b] if (a - b).abs() > JUMP);
    if places.len() == NODES && !instants.windows(2).any(apart) {
        let mut power = 1.0;
        let mut path = interpolated(&places, &instants);
        for coefficient in &mut path {
            *coefficient /= power;
            power *= half;
        }
        if early {
            witnesses.push(Witness::Early(path.clone()));
        }
        // If the instant is between `SURELY` and `EARLY`, the witness with and the witness without the Taylor series
        // are both candidates.
        if !(early && latest < SURELY) {
            witnesses.push(Witness::Instant(path));
        }
    }
    if starts {
        witnesses.push(Witness::BreakAway);
    }
    witnesses
}

//! Chooses candidates for the witness over an interval of r. A witness is an instant near the largest velocity
//! constraint, as a polynomial in r. The candidates follow from the instants at which exact searches find the largest
//! constraint.

use crate::force;
use crate::series::IntervalSeries;
use crate::stage::{ChainStage, IntervalChain, ORDER};
use crate::witness::Witness;
use frictiongen_model::interval::Interval;
use frictiongen_model::table::building::Exact;
use frictiongen_model::table::building::interpolated;
use std::f64::consts::PI;

/// Number of instants through which the polynomial of a witness passes. A witness is an instant near the largest
/// velocity constraint, as a function of r. The value is tuned. Each instant takes the work of a search. Five
/// instants give a polynomial of degree 4 in r.
const NODES: usize = 5;
/// Distance of two instants in half-turns of τ. Instants that are farther apart belong to different maxima of the
/// velocity constraint, and so not to one witness. The value is tuned. A polynomial through instants of two maxima
/// would be far from both maxima.
const JUMP: f64 = 0.05;
/// Phase of the fastest mode, in rad, counted from the start of the half period. If a witness (an instant near the
/// largest velocity constraint) has a smaller phase, a Taylor series in τ may give its constraint (module `early`).
/// The series is valid at all instants up to this phase.
const EARLY: f64 = 1.2;
/// Phase of the fastest mode, in rad, counted from the start of the half period. If a witness (an instant near the
/// largest velocity constraint) has a smaller phase, only a Taylor series in τ gives its constraint (module `early`).
/// The value is tuned. So close to the start, the constraint F/sin τ would be a quotient of two small intervals.
const SURELY: f64 = 0.3;
/// Phase of the fastest mode, in rad, counted from the start of the half period. If the instant of the largest
/// velocity constraint has a smaller phase, the start itself is also a candidate for the witness. The maximum may then
/// reach the start within the interval of r. The value is tuned.
const START: f64 = 0.05;

/// Returns the candidates for the `Witness` over an interval of r, from exact searches for the largest velocity
/// constraint at several r of the interval.
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
        // If the largest phase is between `SURELY` and `EARLY`, the code adds two candidates. One uses the Taylor
        // series in τ, the second does not.
        if !(early && latest < SURELY) {
            witnesses.push(Witness::Instant(path));
        }
    }
    if starts {
        witnesses.push(Witness::BreakAway);
    }
    witnesses
}

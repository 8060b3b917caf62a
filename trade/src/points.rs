//! Where is measured.

use crate::methods::{Fill, Method, Pair};
use frictiongen::FrictionSystem;
use frictiongen::System;
use frictiongen::kernel::Float;
use frictiongen::kernel::number::dd::Dd;

/// How much is measured.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Points for the clock.
    pub timed: usize,
    /// Usual points for the errors; the edges come on top.
    pub usual: usize,
    /// Rounds of the clock.
    pub rounds: usize,
    /// Points with stops.
    pub orbits: usize,
    /// Points that the event stepper runs.
    pub stepped: usize,
    /// Points whose times are taken one by one.
    pub tail: usize,
    /// Scenes of at most so many masses.
    pub masses: usize,
}

/// β over the smaller limit at usual points.
pub const USUAL: [f64; 3] = [0.5, 0.1, 0.9];
/// β over the smaller limit at the edges.
pub const EXTREME: [f64; 4] = [0.5, 1e-3, 0.9, 1.0 - 1e-6];
/// The golden ratio's fraction: its multiples cover an interval evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

fn spread(index: usize) -> f64 {
    ((index as f64 + 0.5) * GOLDEN).fract()
}

/// Usual frequency ratios: even over 0.2 to 2.5.
pub fn usual(count: usize) -> Vec<f64> {
    (0..count).map(|i| 0.2 + 2.3 * spread(i)).collect()
}

/// Frequency ratios of even logarithms.
pub fn logarithmic(count: usize, [low, high]: [f64; 2]) -> Vec<f64> {
    let ratio = |i| low * (high / low).powf(spread(i));
    (0..count).map(ratio).collect()
}

/// Frequency ratios of the edges: beside every resonance and its sub-harmonics, and far out.
pub fn edges(resonances: &[f64]) -> Vec<f64> {
    let mut ratios = Vec::new();
    for resonance in resonances {
        for off in [1e-3, 1e-6, 1e-9] {
            ratios.extend([resonance * (1.0 - off), resonance * (1.0 + off)]);
        }
        for part in [2.0, 3.0, 4.0, 5.0] {
            for off in [-1e-6, 1e-6] {
                ratios.push(resonance / part * (1.0 + off));
            }
        }
    }
    ratios.extend([0.01, 0.03, 0.1, 5.0, 10.0, 100.0, 1e4]);
    ratios
}

/// Points of a scalar, rounded to it, with what double-double answers there.
pub struct Set<S> {
    /// r and β.
    pub points: Vec<Pair<S>>,
    truths: Vec<(Method, Vec<Pair<Dd>>)>,
}

impl<S: Float> Set<S> {
    /// Continuous points: β is a share of the smaller limit, by turns.
    pub fn continuous(ratios: &[f64], reference: &Fill<Dd>, shares: &[f64]) -> Self {
        let ratios: Vec<Dd> = ratios
            .iter()
            .map(|r| Dd::from(S::constant(*r).to_f64()))
            .collect();
        let at: Vec<Pair<Dd>> = ratios.iter().map(|r| [*r; 2]).collect();
        let limits = asked(reference, Method::Limits, &at);
        let share = |i: usize| shares[i % shares.len()];
        let points = ratios
            .iter()
            .zip(&limits)
            .enumerate()
            .filter_map(|(i, (r, [a, b]))| {
                let smaller = if a < b { a.to_f64() } else { b.to_f64() };
                let beta = smaller * share(i);
                (beta > 0.0 && beta.is_finite())
                    .then(|| [S::constant(r.to_f64()), S::constant(beta)])
            });
        Self::of(points.collect(), reference, &Method::JUDGED)
    }

    /// Points between the limits whose steady state double-double finds.
    pub fn with_stops(system: &System<Dd>, reference: &Fill<Dd>, most: usize) -> Self {
        let mut points = Vec::new();
        let found = |r: f64, i: usize| -> Option<Pair<S>> {
            let at = FrictionSystem::at(system, Dd::from(r)).ok()?;
            let (low, high) = (at.continuous_limit().to_f64(), at.sliding_limit().to_f64());
            let beta = low + (high - low) * (0.1 + 0.8 * spread(3 * i + 1));
            (low < high).then(|| [S::constant(r), S::constant(beta)])
        };
        for (i, r) in usual(4 * most).into_iter().enumerate() {
            let Some(point) = found(S::constant(r).to_f64(), i) else {
                continue;
            };
            let [answer, _] = asked(
                reference,
                Method::Orbit,
                &[point.map(|x| Dd::from(x.to_f64()))],
            )[0];
            if answer.is_finite() && points.len() < most {
                points.push(point);
            }
        }
        Self::of(points, reference, &[Method::Orbit])
    }

    fn of(points: Vec<Pair<S>>, reference: &Fill<Dd>, methods: &[Method]) -> Self {
        let wide: Vec<Pair<Dd>> = points
            .iter()
            .map(|p| p.map(|x| Dd::from(x.to_f64())))
            .collect();
        let truths = methods
            .iter()
            .map(|method| (*method, asked(reference, *method, &wide)));
        Self {
            truths: truths.collect(),
            points,
        }
    }

    /// The relative forward errors of answers to `method` against double-double's to `truth`, and
    /// at how many points there was no answer.
    pub fn errors(&self, answers: &[Pair<S>], truth: Method) -> Errors {
        let exact = self.truths.iter().find(|(method, _)| *method == truth);
        let mut errors = Vec::new();
        let mut none = 0;
        for (answer, exact) in answers
            .iter()
            .zip(exact.into_iter().flat_map(|(_, exact)| exact))
        {
            let relative = |i: usize| {
                ((Dd::from(answer[i].to_f64()) - exact[i]) / exact[i])
                    .to_f64()
                    .abs()
            };
            if exact.iter().any(|x| !x.is_finite() || *x == Dd::from(0.0)) {
                continue;
            }
            let error = relative(0).max(relative(1));
            if answer.iter().all(|x| x.is_finite()) {
                errors.push(error);
            } else {
                none += 1;
            }
        }
        errors.sort_by(f64::total_cmp);
        Errors {
            sorted: errors,
            none,
        }
    }
}

/// The errors at a set of points, ascending.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    /// Where there was an answer.
    pub sorted: Vec<f64>,
    /// At how many points there was none.
    pub none: usize,
}

impl Errors {
    /// What 99 of 100 do not exceed.
    pub fn percentile(&self) -> f64 {
        let place = (self.sorted.len() * 99).div_ceil(100).saturating_sub(1);
        self.sorted.get(place).copied().unwrap_or(f64::NAN)
    }

    /// The largest.
    pub fn worst(&self) -> f64 {
        self.sorted.last().copied().unwrap_or(f64::NAN)
    }

    /// These and others: both together.
    pub fn with(&self, other: &Self) -> Self {
        let mut all = self.clone();
        all.and(other);
        all
    }

    /// Adds others.
    pub fn and(&mut self, other: &Self) {
        self.sorted.extend(&other.sorted);
        self.sorted.sort_by(f64::total_cmp);
        self.none += other.none;
    }
}

/// The answers to one question.
pub fn asked<S: Float>(fill: &Fill<S>, method: Method, points: &[Pair<S>]) -> Vec<Pair<S>> {
    let mut out = vec![[S::constant(f64::NAN); 2]; points.len()];
    fill(method, points, &mut out);
    out
}

//! The points (r, β) at which the methods are measured.

use crate::methods::{Fill, Method, Pair};
use frictiongen::FrictionSystem;
use frictiongen::System;
use frictiongen::kernel::Float;
use frictiongen::kernel::number::dd::Dd;

/// Extent of a measurement: its numbers of points and of rounds.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Number of points at which calls are timed.
    pub timed: usize,
    /// Number of usual points at which errors are computed. Points at the edges of the domain come in addition.
    pub usual: usize,
    /// Number of rounds in which calls are timed.
    pub rounds: usize,
    /// Number of points at which the contact stops in each cycle.
    pub orbits: usize,
    /// Number of points at which the event stepper runs.
    pub stepped: usize,
    /// Number of points at which single calls are timed.
    pub tail: usize,
    /// Largest number of masses in a scene.
    pub masses: usize,
}

/// Friction ratios β of usual points, as fractions of the smaller limit.
pub const USUAL: [f64; 3] = [0.5, 0.1, 0.9];
/// Friction ratios β of points at the edges of the domain, as fractions of the smaller limit.
pub const EXTREME: [f64; 4] = [0.5, 1e-3, 0.9, 1.0 - 1e-6];
/// Fractional part of the golden ratio. Its multiples cover an interval evenly.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

fn spread(index: usize) -> f64 {
    ((index as f64 + 0.5) * GOLDEN).fract()
}

/// Returns `count` usual frequency ratios, evenly spread over 0.2 to 2.5.
pub fn usual(count: usize) -> Vec<f64> {
    (0..count).map(|i| 0.2 + 2.3 * spread(i)).collect()
}

/// Returns `count` frequency ratios between `low` and `high`, whose logarithms are evenly spread.
pub fn logarithmic(count: usize, [low, high]: [f64; 2]) -> Vec<f64> {
    let ratio = |i| low * (high / low).powf(spread(i));
    (0..count).map(ratio).collect()
}

/// Returns frequency ratios at the edges of the domain: next to every resonance and its subharmonics, and far away from
/// all resonances.
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

/// Points rounded to a scalar, with the exact results at the rounded points. The exact results come from
/// double-double.
pub struct Set<S> {
    /// The points (r, β), rounded to the scalar.
    pub points: Vec<Pair<S>>,
    truths: Vec<(Method, Vec<Pair<Dd>>)>,
}

impl<S: Float> Set<S> {
    /// Creates points of continuous motion at the given frequency ratios. Their friction ratios are the fractions
    /// `shares` of the smaller limit, in turn.
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

    /// Creates at most `most` points between the limits, where the contact stops. Points without a steady state are
    /// left out.
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

    /// Returns the relative errors of the results `answers` at these points. The exact values are those of the
    /// quantity `truth` in double-double. The function also counts points without a result.
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

/// Relative errors at a set of points, in ascending order.
#[derive(Clone, Debug, Default)]
pub struct Errors {
    /// The errors at points with a result, in ascending order.
    pub sorted: Vec<f64>,
    /// Number of points without a result.
    pub none: usize,
}

impl Errors {
    /// Returns the error that 99 % of the errors do not exceed.
    pub fn percentile(&self) -> f64 {
        let place = (self.sorted.len() * 99).div_ceil(100).saturating_sub(1);
        self.sorted.get(place).copied().unwrap_or(f64::NAN)
    }

    /// Returns the largest error.
    pub fn worst(&self) -> f64 {
        self.sorted.last().copied().unwrap_or(f64::NAN)
    }

    /// Returns these errors together with those of another set.
    pub fn with(&self, other: &Self) -> Self {
        let mut all = self.clone();
        all.and(other);
        all
    }

    /// Adds the errors of another set to these errors.
    pub fn and(&mut self, other: &Self) {
        self.sorted.extend(&other.sorted);
        self.sorted.sort_by(f64::total_cmp);
        self.none += other.none;
    }
}

/// Computes a quantity at each of the points. The result is NaN where the quantity does not exist.
pub fn asked<S: Float>(fill: &Fill<S>, method: Method, points: &[Pair<S>]) -> Vec<Pair<S>> {
    let mut out = vec![[S::constant(f64::NAN); 2]; points.len()];
    fill(method, points, &mut out);
    out
}

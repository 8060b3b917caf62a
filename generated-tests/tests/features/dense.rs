//! Random scenes against dense samples: no zero is missed, and none is made up.

use crate::scenes::{random, shown};
use frictiongen::study::{Edge, Measured, RegimeEnd, System};
use frictiongen::{FrictionSystem, LimitsAt, Of, Regime};
use fuzzing::Random;

/// Samples over a range.
const DENSE: usize = 4_000;
/// Where two places count as one.
const NEAR: f64 = 1e-9;

/// Evenly over 1/r, as sub-harmonics are spaced.
fn dense([from, to]: [f64; 2], count: usize) -> Vec<f64> {
    let share = |i: usize| i as f64 / count as f64;
    (0..=count)
        .map(|i| (1.0 / (1.0 / to + (1.0 / from - 1.0 / to) * share(i))).clamp(from, to))
        .rev()
        .collect()
}

/// Places where a function changes its sign, other than through a pole: halved to rounding, where its size falls.
fn sign_changes(places: &[f64], f: impl Fn(f64) -> f64) -> Vec<f64> {
    let mut found = Vec::new();
    for pair in places.windows(2) {
        let (mut low, mut high) = (pair[0], pair[1]);
        let (at_low, at_high) = (f(low), f(high));
        if !(at_low * at_high < 0.0) {
            continue;
        }
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if f(middle) * at_low > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        // Beside a pole it grows towards it.
        let distance = 1e-6 * low;
        let at = |r: f64| f(r).abs();
        if at(low - 1e-3 * distance) < at(low - distance) {
            found.push(low);
        }
    }
    found
}

/// Plain sums over modes, from the frequencies and shapes alone: V, H, U of the contact, then of mass k.
struct Sums {
    v: f64,
    h: f64,
    u: f64,
    own_v: f64,
    own_h: f64,
    own_u: f64,
}

/// φᵀw, φᵀp and φ_k by mode, from the shapes and the scene's numbers.
struct Modes {
    resonances: Vec<f64>,
    contacts: Vec<f64>,
    loads: Vec<f64>,
    shapes: Vec<f64>,
    share: f64,
}

impl Modes {
    fn new(system: &System, mass: usize) -> Self {
        let modal = system.modal();
        let plain = |list: &[frictiongen_kernel::number::dd::Dd]| -> Vec<f64> {
            list.iter().map(|value| value.hi).collect()
        };
        Self {
            resonances: plain(&modal.resonances),
            contacts: plain(&modal.contacts),
            loads: plain(&modal.loads),
            shapes: modal.shapes.iter().map(|shape| shape[mass].hi).collect(),
            share: if modal.on_moving_base { 1.0 } else { 0.0 },
        }
    }

    fn at(&self, r: f64) -> Sums {
        let mut sums = Sums {
            v: -self.share,
            h: 0.0,
            u: 0.0,
            own_v: 0.0,
            own_h: 0.0,
            own_u: 0.0,
        };
        for i in 0..self.resonances.len() {
            let (root, w, p, shape) = (
                self.resonances[i],
                self.contacts[i],
                self.loads[i],
                self.shapes[i],
            );
            let lambda = root * root;
            let response = 1.0 / (lambda - r * r);
            let lag = (std::f64::consts::FRAC_PI_2 * root / r).tan() * root / r / lambda;
            sums.v += w * p * response;
            sums.h += w * w * response;
            sums.u += w * w * lag;
            sums.own_v += shape * p * response;
            sums.own_h += shape * w * response;
            sums.own_u += shape * w * lag;
        }
        sums
    }
}

/// Every wanted place is among the found; where `both`, every found one among the wanted or between two samples.
fn compare(found: &[f64], wanted: &[f64], what: &str) -> usize {
    for want in wanted {
        assert!(
            found.iter().any(|place| (place / want - 1.0).abs() < NEAR),
            "{what}: {want} is missed; found {found:?}"
        );
    }
    wanted.len()
}

/// Whether a limit is β at r: to 1e-9, or it passes β within 1e-12 of r where it is steep.
fn is_at(limit: impl Fn(f64) -> f64, r: f64, beta: f64) -> bool {
    let [left, right] = [1.0 - 1e-12, 1.0 + 1e-12].map(|factor| limit(r * factor) - beta);
    (limit(r) / beta - 1.0).abs() < 1e-9 || left * right <= 0.0
}

/// How many zeros were compared, and how many more were found, too near to each other for the samples.
#[derive(Default)]
struct Count {
    compared: usize,
    more: usize,
}

impl Count {
    fn add(
        &mut self,
        found: &[f64],
        wanted: &[f64],
        step: f64,
        resonances: &[f64],
        functions: &[Box<dyn Fn(f64) -> f64 + '_>],
        what: &str,
    ) {
        self.compared += compare(found, wanted, what);
        for place in found {
            // Its sign changes there, or it is the end of what numbers can tell.
            let beside = 1e-7;
            let crosses = |f: &dyn Fn(f64) -> f64| {
                f(place * (1.0 - beside)) * f(place * (1.0 + beside)) < 0.0
            };
            let near = found
                .iter()
                .any(|other| other != place && (other / place - 1.0).abs() < 4.0 * beside);
            // Poles at the resonances and their odd sub-harmonics.
            let pole = resonances.iter().any(|resonance| {
                let odd = 2.0 * (0.5 * (resonance / place - 1.0)).round() + 1.0;
                (resonance / odd / place - 1.0).abs() < 4.0 * beside
            });
            assert!(
                near || pole || functions.iter().any(|f| crosses(f.as_ref())),
                "{what}: {place} is none"
            );
            if wanted.iter().any(|want| (want / place - 1.0).abs() < NEAR) {
                continue;
            }
            // The samples do not show a zero with a pole or another zero beside it, between two of them.
            self.more += 1;
            let within = |other: f64| (1.0 / other - 1.0 / place).abs() < step;
            let odd = |resonance: &f64| 2.0 * (0.5 * (resonance / place - 1.0)).round() + 1.0;
            let hidden = found.iter().any(|other| other != place && within(*other))
                || resonances
                    .iter()
                    .any(|resonance| within(resonance / odd(resonance)));
            assert!(hidden, "{what}: {place} is not among {wanted:?}");
        }
    }
}

#[test]
fn undamped_functions() {
    let mut random_numbers = Random(22);
    let mut count = Count::default();
    for scene in 0..30 {
        let system = random(&mut random_numbers, 10, false);
        let largest = *system.resonances().last().unwrap();
        let range = [0.12 * largest, 1.5 * largest];
        let places = dense(range, DENSE);
        let step = (1.0 / range[0] - 1.0 / range[1]) / DENSE as f64;
        let mass = scene % system.scene().masses.len();
        let modes = Modes::new(&system, mass);
        let what = shown(&system);
        let features = system.features(None).unwrap();
        let at = |r: f64| modes.at(r);
        let free: Vec<f64> = features
            .antiresonances(Of::Contact, range)
            .unwrap()
            .iter()
            .map(|zero| zero.r)
            .collect();
        let of_v = |r: f64| at(r).v;
        count.add(
            &free,
            &sign_changes(&places, of_v),
            step,
            &modes.resonances,
            &[Box::new(of_v)],
            &format!("V, {what}"),
        );
        if modes
            .contacts
            .iter()
            .zip(&modes.shapes)
            .all(|(w, shape)| w * shape == 0.0)
        {
            continue;
        }
        let of = Of::Mass(mass);
        let as_contact = system.modal().rubbing() == Some(mass) && modes.share == 0.0;
        for measured in [Measured::Amplitude, Measured::Fundamental] {
            let points = features.invariant_points(of, measured, range).unwrap();
            let mut wanted = Vec::new();
            let functions: Vec<Box<dyn Fn(f64) -> f64>> = match (measured, as_contact) {
                (Measured::Amplitude, true) => vec![Box::new(|r| at(r).u)],
                (Measured::Amplitude, false) => vec![
                    Box::new(|r| at(r).own_u),
                    Box::new(|r| {
                        let sums = at(r);
                        if system.modal().rubbing() == Some(mass) {
                            // U_k = U, which is the other condition.
                            sums.v - 2.0 * sums.own_v
                        } else {
                            sums.v * sums.own_u - 2.0 * sums.own_v * sums.u
                        }
                    }),
                ],
                (Measured::Fundamental, _) => vec![
                    Box::new(|r| at(r).own_h),
                    Box::new(|r| {
                        let sums = at(r);
                        let share = std::f64::consts::FRAC_2_PI;
                        if as_contact {
                            sums.u + share * sums.h
                        } else {
                            sums.own_v * sums.u + share * sums.own_h * sums.v
                        }
                    }),
                ],
            };
            for function in &functions {
                wanted.extend(sign_changes(&places, function));
            }
            // Where the contact is still without friction there is no motion to be invariant.
            wanted.retain(|r| system.at(*r).unwrap().continuous_limit() > 1e-10);
            let found: Vec<f64> = points.iter().map(|point| point.r).collect();
            count.add(
                &found,
                &wanted,
                step,
                &modes.resonances,
                &functions,
                &format!("{measured:?} of {mass}, {what}"),
            );
        }
    }
    println!(
        "{} zeros, {} more than the samples show",
        count.compared, count.more
    );
    assert!(count.compared > 600, "{}", count.compared);
}

/// Friction enlarges within, and does not outside: the growth of the estimate and of the fundamental themselves.
#[test]
fn inversions() {
    let mut random_numbers = Random(23);
    let (mut inside, mut outside) = (0, 0);
    for scene in 0..40 {
        let system = random(&mut random_numbers, 6, false);
        let largest = *system.resonances().last().unwrap();
        let range = [0.2 * largest, 1.5 * largest];
        let mass = scene % system.scene().masses.len();
        let (of, what) = (Of::Mass(mass), shown(&system));
        let features = system.features(None).unwrap();
        for measured in [Measured::Amplitude, Measured::Fundamental] {
            let found = features.inversions(of, measured, range).unwrap();
            for pair in found.windows(2) {
                assert!(pair[0].to < pair[1].from, "{what}");
            }
            for r in dense(range, 300) {
                let at = system.at(r).unwrap();
                let limit = at.limits();
                let beta = 0.9 * limit.continuous.min(limit.sliding);
                let size = |beta: f64| -> Option<f64> {
                    let motion = at.motion(beta).ok()?;
                    let motion = motion.mass_at(mass)?;
                    Some(match measured {
                        Measured::Amplitude => motion.amplitude_monoharmonic(),
                        Measured::Fundamental => motion.harmonic(1).norm(),
                    })
                };
                let (Some(with), Some(without)) = (size(beta), size(0.0)) else {
                    continue;
                };
                let growth = (with - without) / without.max(1e-300);
                if growth.abs() < 1e-9 {
                    continue;
                }
                let is_inside = found.iter().any(|found| found.from < r && r < found.to);
                let edges = found.iter().flat_map(|found| [found.from, found.to]);
                let beside = edges.into_iter().any(|edge| (edge / r - 1.0).abs() < 1e-7);
                assert!(
                    beside || is_inside == (growth > 0.0),
                    "{measured:?} of {mass} at {r}: {growth:e}; {found:?}; {what}"
                );
                if is_inside {
                    inside += 1;
                } else {
                    outside += 1;
                }
            }
            for found in &found {
                assert!(found.from_edge != Edge::Range || found.from == range[0]);
            }
        }
    }
    println!("{inside} places inside, {outside} outside");
    assert!(inside > 1_000 && outside > 5_000, "{inside} {outside}");
}

/// Sliding or not at dense places, damped or not, from β*_lim itself.
#[test]
fn sliding_ranges() {
    let mut random_numbers = Random(24);
    let (mut bounds, mut seen) = (0, 0);
    for scene in 0..60 {
        let system = random(&mut random_numbers, 10, scene % 2 == 0);
        let largest = *system.resonances().last().unwrap();
        let range = [0.02 * largest, 2.0 * largest];
        let beta = random_numbers.log_uniform(0.02, 3.0);
        let features = system.features(None).unwrap();
        let ranges = features.sliding_ranges(beta, range).unwrap();
        let places = dense(range, DENSE);
        let mut wanted = Vec::new();
        let margin = |r: f64| system.at(r).unwrap().sliding_limit() - beta;
        for r in &places {
            let inside = ranges
                .iter()
                .any(|range| range.from <= *r && *r <= range.to);
            let margin = margin(*r);
            if margin.abs() > 1e-9 * beta {
                assert_eq!(inside, margin > 0.0, "{r}, β = {beta}, {}", shown(&system));
                seen += 1;
            }
        }
        for pair in places.windows(2) {
            if margin(pair[0]) * margin(pair[1]) < 0.0 {
                wanted.push(pair[0]);
            }
        }
        let ends = ranges
            .iter()
            .flat_map(|range| [&range.from_frequency, &range.to_frequency]);
        let found = ends.flatten().count();
        assert!(wanted.len() <= found, "{} {found}", wanted.len());
        for end in ranges.iter().flat_map(|range| {
            let ends = [
                (range.from, &range.from_frequency),
                (range.to, &range.to_frequency),
            ];
            ends.into_iter()
                .filter_map(|(r, sensed)| sensed.as_ref().map(|_| r))
                .collect::<Vec<_>>()
        }) {
            let limit = |r: f64| system.at(r).unwrap().sliding_limit();
            assert!(is_at(limit, end, beta), "{end}, {beta}, {}", shown(&system));
        }
        bounds += found;
    }
    println!("{bounds} ends, {seen} places");
    assert!(bounds > 150 && seen > 150_000, "{bounds} {seen}");
}

/// The regime at dense places.
#[test]
fn regimes() {
    let mut random_numbers = Random(25);
    let (mut changes, mut seen, mut proven) = (0, 0, 0);
    for scene in 0..30 {
        let system = random(&mut random_numbers, 6, scene % 3 == 0);
        let largest = *system.resonances().last().unwrap();
        let lowest = if scene % 2 == 0 { 0.5 } else { 0.15 };
        let range = [lowest * largest, 2.0 * largest];
        let beta = random_numbers.log_uniform(0.05, 1.5);
        let features = system.features(None).unwrap();
        let (ranges, certainty) = features.regimes(beta, range).unwrap();
        assert_eq!(
            (ranges[0].from, ranges.last().unwrap().to),
            (range[0], range[1])
        );
        for pair in ranges.windows(2) {
            assert!(pair[0].to == pair[1].from && pair[0].regime != pair[1].regime);
        }
        proven += usize::from(certainty == frictiongen::study::Certainty::Proven);
        for r in dense(range, 1_000) {
            let own = ranges
                .iter()
                .find(|range| range.from <= r && r <= range.to)
                .unwrap();
            let beside = [own.from, own.to]
                .into_iter()
                .any(|end| (end / r - 1.0).abs() < 1e-9);
            let regime: Regime = FrictionSystem::at(&system, r)
                .unwrap()
                .regime(beta)
                .unwrap();
            assert!(
                beside || own.regime == regime,
                "{r}, β = {beta}: {regime:?} in {own:?}, {}",
                shown(&system)
            );
            seen += 1;
        }
        for range in &ranges {
            let at = |r: f64| system.at(r).unwrap();
            let (end, what) = (range.to, shown(&system));
            match range.end {
                RegimeEnd::Range => {}
                RegimeEnd::Continuous(_) => {
                    assert!(
                        is_at(|r| at(r).continuous_limit(), end, beta),
                        "{end}, {beta}, {what}"
                    );
                }
                RegimeEnd::Sliding(_) => {
                    assert!(
                        is_at(|r| at(r).sliding_limit(), end, beta),
                        "{end}, {beta}, {what}"
                    );
                }
            }
        }
        changes += ranges.len() - 1;
    }
    println!("{changes} changes, {seen} places, {proven} proven");
    assert!(
        changes > 60 && seen > 25_000 && proven > 5,
        "{changes} {seen} {proven}"
    );
}

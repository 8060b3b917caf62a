//! Compares numbers of one mass that rubs on a wall on its moving base: F04 to F10 without F07.

use super::ask::{
    base, crossings, limit, orbit, orbit_amplitude, peak, regimes, root, sliding_limit,
};
use super::row::{ROUNDING, Row, added, claim, formula_at, number, words};
use frictiongen::study::System;
use frictiongen::{Of, Regime};

pub(super) fn rows() -> Vec<Row> {
    vec![
        sticking(),
        widths(),
        intersection(),
        inversion(),
        no_resonance(),
        direct(),
    ]
}

fn sticking() -> Row {
    let mut points = Vec::new();
    for mu in [1.2, 1.0, 2.0] {
        let system = base(mu);
        for r in [0.9_f64, 0.1, 0.5, 1.0, 1.3, 2.5] {
            points.push((r * r / mu, sliding_limit(&system, r)));
        }
    }
    Row {
        id: "F04",
        claim: "one mass on its base: β*_lim",
        place: "3.4.2, (3.24)",
        entries: vec![formula_at(
            "r = 0.9, μ = 1.2, and 17 more",
            "r²/μ",
            &points,
            ROUNDING,
            6,
        )],
        reason: "",
    }
}

/// Returns the difference of β*_lim and β_lim at the frequency ratio r, the width of the stick-slip region.
fn width(system: &System, r: f64) -> f64 {
    sliding_limit(system, r) - limit(system, r)
}

fn widths() -> Row {
    let system = base(1.0);
    let widest = peak(|r| width(&system, r), 0.51, 0.65);
    let narrowest = peak(|r| -width(&system, r), 0.7, 0.9);
    Row {
        id: "F05",
        claim: "one mass on its base, μ = 1: width β*_lim − β_lim",
        place: "3.4.3",
        entries: vec![
            number("largest at r", "0.55", widest, 4),
            added("width there", width(&system, widest), 4),
            number("smallest at r", "0.79", narrowest, 4),
            added("width there", width(&system, narrowest), 4),
        ],
        reason: "the maximum is at 0.555, which rounds to 0.56",
    }
}

/// Finds the smallest width of the stick-slip region over the frequency ratio. The corner at r = 0, where the width
/// is zero, is left out.
fn smallest_width(mu: f64) -> f64 {
    let system = base(mu);
    let width = |r: f64| width(&system, r);
    let places = (10..200).map(|i| 0.01 * f64::from(i));
    let near = places.fold(0.1, |best, r| if width(r) < width(best) { r } else { best });
    width(peak(|r| -width(r), near - 0.01, near + 0.01))
}

fn intersection() -> Row {
    Row {
        id: "F06",
        claim: "one mass on its base: smallest μ for which the limits intersect",
        place: "3.4.3, figure 3.5",
        entries: vec![number("μ", "about 1.2", root(smallest_width, 1.2, 1.25), 4)],
        reason: "",
    }
}

fn inversion() -> Row {
    let system = base(1.0);
    let betas = [0.05, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4];
    let (mut first, mut last, mut highest) = (f64::INFINITY, 0.0_f64, 0.0_f64);
    let mut count = 0;
    for (i, more) in betas.iter().enumerate() {
        for less in &betas[..i] {
            let found = crossings(&system, Of::Mass(0), [*less, *more], [1.35, 1.7]);
            let (crossing, height) = match *found {
                [only] => only,
                _ => (f64::NAN, f64::NAN),
            };
            count += usize::from(found.len() == 1);
            first = first.min(crossing);
            last = last.max(crossing);
            highest = highest.max(height);
        }
    }
    Row {
        id: "F08",
        claim: "one mass on its base: range of r in which the exact amplitudes for β = 0.05 to 1.4 cross",
        place: "3.5, figure 3.7",
        entries: vec![
            claim(
                "first",
                "beyond about 1.4",
                first,
                4,
                // Each of the 28 pairs of curves crosses exactly once.
                first > 1.4 && count == 28,
            ),
            claim("last", "before about 1.55", last, 4, last < 1.55),
            claim(
                "largest amplitude there",
                "below 1",
                highest,
                4,
                highest < 1.0,
            ),
        ],
        reason: "",
    }
}

/// Returns the largest transmissibility of a sliding mass on its base. At the frequency at which sliding begins, the
/// transmissibility drops below 1. The peak lies beyond that drop.
#[must_use]
pub fn largest_sliding(system: &System, beta: f64) -> f64 {
    let at = |r: f64| orbit(system, r, beta).map_or(0.0, |orbit| orbit_amplitude(&orbit, "m1"));
    let begin = beta.sqrt() + 0.02;
    let places = (0..100).map(|i| begin + 0.02 * f64::from(i));
    let near = places.fold(begin, |best, r| if at(r) > at(best) { r } else { best });
    at(peak_coarse(at, begin.max(near - 0.02), near + 0.02))
}

/// Finds a maximum as [`peak`] does, but to 1e-5 in the frequency ratio. A steady state takes long to compute. Within
/// 1e-5, a flat peak loses only about 1e-9 of its height.
fn peak_coarse(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    while high - low > 1e-5 {
        let third = (high - low) / 3.0;
        if f(low + third) < f(high - third) {
            low += third;
        } else {
            high -= third;
        }
    }
    0.5 * (low + high)
}

fn no_resonance() -> Row {
    let system = base(1.0);
    let (mut above, mut below) = (1.0, 1.2);
    let starts = largest_sliding(&system, above) > 1.0 && largest_sliding(&system, below) < 1.0;
    while below - above > 1e-5 {
        let middle = 0.5 * (above + below);
        if largest_sliding(&system, middle) > 1.0 {
            above = middle;
        } else {
            below = middle;
        }
    }
    let threshold = if starts { below } else { f64::NAN };
    Row {
        id: "F09",
        claim: "one mass on its base: β from which the largest transmissibility of any sliding state is below 1",
        place: "3.6.2",
        entries: vec![number("β", "1.06", threshold, 4)],
        reason: "",
    }
}

fn direct() -> Row {
    let system = base(1.5);
    let along = |system: &System, range| -> Vec<Regime> {
        let found = regimes(system, 1.0, range).into_iter();
        found.map(|found| found.regime).collect()
    };
    let begin = regimes(&system, 1.0, [1.0, 1.4]);
    let beside = begin.first().map_or(f64::NAN, |stuck| stuck.to);
    // A stuck state exists up to the end of the second range.
    let begin = begin.get(1).map_or(f64::NAN, |bistable| bistable.to);
    let direct =
        along(&system, [1.0, 1.4]) == [Regime::Stuck, Regime::Bistable, Regime::Continuous];
    // With μ = 1 a range of stick-slip lies between the stuck range and the continuous range.
    let between = along(&base(1.0), [0.9, 1.4]).starts_with(&[Regime::Stuck, Regime::StickSlip]);
    Row {
        id: "F10",
        claim: "one mass on its base, β = 1, μ = 1.5: the motion changes from stuck directly to continuous",
        place: "3.6.2, figure 3.15",
        entries: vec![
            words(
                "",
                "yes",
                if direct { "yes" } else { "no" }.into(),
                direct && between,
            ),
            added(
                "r from which a sliding state exists as well as the stuck one",
                beside,
                4,
            ),
            added("r of the change", begin, 4),
            added("β_lim there", limit(&system, begin), 4),
        ],
        reason: "",
    }
}

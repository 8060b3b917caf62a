//! Counts the stops in a cycle of one mass that rubs on its moving base, for row F33.

use super::ask::{base, orbit, sliding_limit};
use super::row::{Entry, ROUNDING, Row, added, words};
use frictiongen::Regime;

/// Numbers of points of a grid of r and β, by the number of stops that their steady state has in a cycle.
#[derive(Debug, Default)]
pub struct Stops {
    /// Number of points whose steady state has at least one stop.
    pub stopping: u32,
    /// Number of points whose steady state has one stop.
    pub one: u32,
    /// Number of points whose steady state has two stops.
    pub two: u32,
    /// Number of points whose steady state has more than two stops.
    pub more: u32,
    /// Smallest and largest frequency ratio of the points with one stop.
    pub ends: Option<(f64, f64)>,
    /// Number of stick-slip points without a stable motion that repeats after one cycle.
    pub without: u32,
}

/// Counts the stops over the grid of the figures: r = 0:0.02:2.5 and β = 0:0.01:4. `mu` is the ratio of static to
/// kinetic friction.
#[must_use]
pub fn count(mu: f64) -> Stops {
    let system = base(mu);
    let mut found = Stops::default();
    for i in 1..=125_u32 {
        let r = 0.02 * f64::from(i);
        for j in 1..=400_u32 {
            let beta = 0.01 * f64::from(j);
            let regime = system.at(r).ok().and_then(|at| at.regime(beta).ok());
            // On the grid β often equals β*_lim as a decimal number. A point with β = β*_lim counts as stuck, whichever
            // way the numbers round.
            let on_limit = (beta - sliding_limit(&system, r)).abs() < ROUNDING;
            if regime != Some(Regime::StickSlip) || on_limit {
                continue;
            }
            // The thesis counts stops in a cycle, so only motions that repeat after one cycle count.
            let orbit = orbit(&system, r, beta).filter(|orbit| orbit.period() == 1);
            let Some(orbit) = orbit else {
                found.without += 1;
                continue;
            };
            let stops = orbit.stops();
            found.stopping += u32::from(stops > 0);
            found.one += u32::from(stops == 1);
            found.two += u32::from(stops == 2);
            found.more += u32::from(stops > 2);
            if stops == 1 {
                let (low, high) = found.ends.unwrap_or((r, r));
                found.ends = Some((low.min(r), high.max(r)));
            }
        }
    }
    found
}

pub(super) fn rows() -> Vec<Row> {
    let [equal, more] = [1.0, 1.5].map(count);
    let share = |stops: &Stops| f64::from(stops.two) / f64::from(stops.stopping);
    let numbers = |name: &str, stops: &Stops| -> Vec<Entry> {
        let predominant = share(stops) > 0.9;
        let said = format!(
            "{} of {} stopping states; {} stop once, {} more often; {} points have no stable \
             motion of the excitation's period",
            stops.two, stops.stopping, stops.one, stops.more, stops.without
        );
        vec![
            words(
                &format!("{name}: two stops"),
                "predominate",
                said,
                predominant,
            ),
            added("their share", share(stops), 4),
        ]
    };
    let mut entries = numbers("μ = 1", &equal);
    entries.push(words(
        "μ = 1: one stop",
        "never",
        equal.one.to_string(),
        equal.one == 0,
    ));
    entries.extend(numbers("μ = 1.5", &more));
    let (low, high) = more.ends.unwrap_or((f64::NAN, f64::NAN));
    entries.push(words(
        "μ = 1.5: one stop",
        "near r = 0.5",
        format!("r = {low:.2} to {high:.2}"),
        (low - 0.5).abs() < 0.15 && (high - 0.5).abs() < 0.15,
    ));
    vec![Row {
        id: "F33",
        claim: "one mass on its base, μ = 1 and 1.5: stops a cycle",
        place: "3.6.2, figures 3.12, 3.13",
        entries,
        reason: "",
    }]
}

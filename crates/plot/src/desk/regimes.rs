//! Panels of the regimes over frequency and friction: β_lim, β*_lim, and the areas between them.

use super::scales::Scales;
use crate::{Axis, Colour, Fill, Label, Line, Panel, Point, Region, Stroke};
use frictiongen::study::map::LimitLines;

/// Name of the area above β*_lim and below β_lim. In this area the initial state decides if the contact slides or
/// sticks.
const BISTABLE: &str = "sliding or stuck, by the start";
/// Smallest height of the area with two possible regimes that a figure shows, as a fraction of the height of the axis.
const SEEN: f64 = 1e-3;

/// Returns the limits β_lim and β*_lim as lines over frequency. The code caps both limits at four times the friction
/// ratio `top`.
#[must_use]
pub fn limit_lines(lines: &LimitLines, top: f64, scales: &Scales, colour: Colour) -> [Line; 2] {
    let line = |name: Label, stroke, read: fn(f64, f64) -> f64| {
        let points = lines.points.iter();
        let place = |(r, limits): &(f64, frictiongen::Limits<f64>)| -> Point {
            let beta = read(limits.continuous, limits.sliding).min(4.0 * top);
            (scales.frequency(*r), scales.friction(beta))
        };
        Line::new(name, colour, stroke, vec![points.map(place).collect()])
    };
    [
        line(
            scales.limit_name("", "continuous below"),
            Stroke::Solid,
            |continuous, _| continuous,
        ),
        line(
            scales.limit_name("^*", "stuck state above"),
            Stroke::Dashed,
            |_, sliding| sliding,
        ),
    ]
}

/// Returns a panel of the regimes over frequency, up to the friction ratio `top`. The panel shows named areas and the
/// lines of the limits β_lim and β*_lim.
#[must_use]
pub fn regimes(title: impl Into<Label>, lines: &LimitLines, top: f64, scales: &Scales) -> Panel {
    let low = lines.points.first().map_or(0.0, |point| point.0);
    let high = lines.points.last().map_or(1.0, |point| point.0);
    let x = Axis::new(
        scales.frequency_label(),
        scales.frequency(low),
        scales.frequency(high),
    );
    let y = Axis::new(scales.friction_label(), 0.0, scales.friction(top));
    let mut panel = Panel::new(title, x, y);
    let beyond = 4.0 * top;
    for (name, fill, lower, upper) in [
        ("continuous", 0, AreaEdge::Zero, AreaEdge::Least),
        ("stick-slip", 1, AreaEdge::Least, AreaEdge::Sliding),
        (BISTABLE, 3, AreaEdge::Sliding, AreaEdge::Most),
        ("stuck", 2, AreaEdge::Most, AreaEdge::Beyond),
    ] {
        let places: Vec<(f64, f64, f64)> = lines
            .points
            .iter()
            .map(|(r, limits)| (*r, lower.of(limits, beyond), upper.of(limits, beyond)))
            .collect();
        let drawn: Vec<_> = places
            .iter()
            .map(|(r, low, high)| {
                (
                    scales.frequency(*r),
                    scales.friction(*low),
                    scales.friction(*high),
                )
            })
            .collect();
        // If static and kinetic friction are equal (μ = 1), the limits can cross only by rounding.
        if name == BISTABLE && places.iter().all(|(_, low, high)| high - low < SEEN * top) {
            continue;
        }
        let mut region = Region::between(name, Fill::Class(fill), &drawn);
        // The area with two possible regimes is a narrow wedge, without space for its long name.
        let room = (name != BISTABLE).then(|| roomiest(&places, top)).flatten();
        if let Some((r, beta)) = room {
            region = region.named_at((scales.frequency(r), scales.friction(beta)));
        }
        panel = panel.with(region);
    }
    let [continuous, sliding] = limit_lines(lines, top, scales, Colour::Black);
    panel.with(continuous).with(sliding)
}

/// Lower or upper edge of a named area in a panel of the regimes. `Least` and `Most` are the smaller and the larger of
/// β_lim and β*_lim.
#[derive(Clone, Copy)]
enum AreaEdge {
    Zero,
    Least,
    Sliding,
    Most,
    Beyond,
}

impl AreaEdge {
    fn of(self, limits: &frictiongen::Limits<f64>, beyond: f64) -> f64 {
        let beta = match self {
            Self::Zero => 0.0,
            Self::Least => limits.continuous.min(limits.sliding),
            Self::Sliding => limits.sliding,
            Self::Most => limits.continuous.max(limits.sliding),
            Self::Beyond => beyond,
        };
        beta.min(beyond)
    }
}

/// Returns the frequency ratio and friction ratio at which an area has the most space for its name. Returns `None` if
/// the area has too little space. Each item of `places` is a frequency ratio with the lower and the upper edge of the
/// area. The area counts only up to the friction ratio `top`.
fn roomiest(places: &[(f64, f64, f64)], top: f64) -> Option<(f64, f64)> {
    let first = places.first()?.0;
    let width = places.last()?.0 - first;
    let reach = 0.07 * width;
    let mut best: Option<(f64, f64, f64)> = None;
    for at in (2..=46).map(|i| first + width * f64::from(i) / 48.0) {
        let near = places.iter().filter(|place| (place.0 - at).abs() <= reach);
        let (low, high) = near.fold((0.0_f64, top), |(low, high), place| {
            (low.max(place.1), high.min(place.2))
        });
        let height = high - low;
        // Several positions may have nearly the same space. The code then prefers the position nearest to the middle of
        // the frequency range.
        let aside = (2.0 * (at - first) / width - 1.0).abs();
        let room = height * (1.0 - 0.7 * aside);
        if 0.06 * top < height && best.is_none_or(|best| best.2 < room) {
            best = Some((at, 0.5 * (low + high), room));
        }
    }
    best.map(|(r, beta, _)| (r, beta))
}

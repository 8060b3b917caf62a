//! Figures of response curves: amplitude and phase over frequency. The stroke of a line shows the regime, and its
//! colour the friction.

use super::phases::{folded, phase_ends};
use super::scales::Scales;
use crate::{
    Axis, Colour, Figure, Key, Label, LegendSample, Line, Marker, Markers, Panel, Point, Stroke,
};
use frictiongen::study::curve::{Curve, CurvePiece, CurvePoint, PieceEnd};
use frictiongen::study::response::MotionQuantity;
use frictiongen::study::units::polar;
use frictiongen::{Of, Regime};

/// The quantity of a motion that a curve shows over frequency: amplitude, phase, a [`MotionQuantity`], or one harmonic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reading {
    /// The amplitude of the motion.
    Amplitude,
    /// The phase of the motion in degrees.
    Phase,
    /// The value of a [`MotionQuantity`], such as the largest velocity or acceleration of the motion. The request for
    /// the curve must have included this quantity.
    Rate(MotionQuantity),
    /// The amplitude of one harmonic of the motion. The number is the harmonic's index among the requested harmonics.
    Harmonic(usize),
    /// The phase of one harmonic of the motion, in degrees. The number is the harmonic's index among the requested
    /// harmonics.
    HarmonicPhase(usize),
}

/// A response curve, with the name that it has in the legend, and its colour.
#[derive(Clone, Debug)]
pub struct Drawn<'a> {
    /// The response over frequency at one friction.
    pub curve: &'a Curve,
    /// Name of the curve in the legend, such as the friction ratio.
    pub name: Label,
    /// Colour of the curve in the figure.
    pub colour: Colour,
}

/// Largest difference of phase, in rad, between two neighbouring points that a line joins. A larger difference is a
/// jump of the phase.
const TURN: f64 = 0.6;
/// Smallest amplitude at which a figure shows the phase, as a fraction of the median amplitude of the curve piece. At
/// a smaller amplitude the phase is mostly rounding error, because the amplitude has an error of about 1e-13 of the
/// largest term of its modal sum.
const VANISHING: f64 = 1e-10;

/// Returns the stroke that marks a regime in the curves, such as dotted for a stuck contact.
pub(super) fn stroke(regime: Regime) -> Stroke {
    match regime {
        Regime::Stuck => Stroke::Dotted,
        Regime::StickSlip => Stroke::DashDot,
        _ => Stroke::Solid,
    }
}

/// Returns three legend entries that explain the strokes of the regimes continuous, stick-slip and stuck.
#[must_use]
pub fn keys() -> Vec<Key> {
    vec![
        Key::stroke("continuous", Stroke::Solid),
        Key::stroke("stick-slip", Stroke::DashDot),
        Key::stroke("stuck", Stroke::Dotted),
    ]
}

/// Returns the entries of [`keys`] whose regime occurs in the curves.
#[must_use]
pub fn keys_of<'c>(curves: impl IntoIterator<Item = &'c Curve>) -> Vec<Key> {
    let pieces = curves.into_iter().flat_map(|curve| &curve.pieces);
    let strokes: Vec<Stroke> = pieces.map(|piece| stroke(piece.regime)).collect();
    let occurs =
        |key: &Key| matches!(key.sample, LegendSample::Line(_, drawn) if strokes.contains(&drawn));
    keys().into_iter().filter(occurs).collect()
}

impl Reading {
    /// Returns true if the quantity is a phase.
    #[must_use]
    pub fn is_phase(self) -> bool {
        matches!(self, Self::Phase | Self::HarmonicPhase(_))
    }

    /// Returns the amplitude of a motion (or its [`MotionQuantity`]) at a point of the curve, in the unit of its axis.
    /// `part` is the index of the motion among the requested motions.
    fn size(self, point: &CurvePoint, part: usize, scales: &Scales) -> Option<f64> {
        let (size, _) = self.polar(point, part)?;
        Some(match self {
            Self::Rate(of) => scales.rate_at(of, point.r, size),
            _ => scales.length_at(point.r, size),
        })
    }

    /// Returns the amplitude of a motion (or its [`MotionQuantity`]) at a point of the curve, and its phase in rad.
    /// `part` is the index of the motion among the requested motions. The phase is `None` for a [`MotionQuantity`], and
    /// for an amplitude of zero.
    fn polar(self, point: &CurvePoint, part: usize) -> Option<(f64, Option<f64>)> {
        let movement = point.movements.get(part)?;
        Some(match self {
            Self::Amplitude | Self::Phase => (movement.swing.amplitude, movement.swing.phase),
            Self::Rate(size) => {
                let (velocity, acceleration) = movement.rates?;
                let rate = match size {
                    MotionQuantity::Displacement => movement.swing.amplitude,
                    MotionQuantity::Velocity => velocity,
                    MotionQuantity::Acceleration => acceleration,
                    MotionQuantity::Force => point.contact_force,
                    MotionQuantity::Energy => point.friction_work,
                    MotionQuantity::Damping => movement.damping?,
                };
                (rate, None)
            }
            Self::Harmonic(index) | Self::HarmonicPhase(index) => {
                let (size, lag) = polar(*movement.harmonics.get(index)?);
                (size, (0.0 < size).then_some(lag))
            }
        })
    }
}

/// Returns the curve of the motion `part` as a list of pieces. Each piece has its regime, and its points in the units
/// of the axes.
fn traced(
    curve: &Curve,
    part: usize,
    reading: Reading,
    scales: &Scales,
) -> Vec<(Regime, Vec<Vec<Point>>)> {
    let pieces = curve.pieces.iter().map(|piece| {
        let runs = if reading.is_phase() {
            phases(piece, part, reading, scales)
        } else {
            let points = piece.points.iter();
            let placed = points.filter_map(|point| {
                let size = reading.size(point, part, scales)?;
                Some((scales.frequency(point.r), size))
            });
            vec![placed.collect()]
        };
        (piece.regime, runs)
    });
    pieces.collect()
}

/// Returns the phase curve of a piece as lists of points. Each list is one line. The phases are in degrees, in (−180,
/// 180].
fn phases(piece: &CurvePiece, part: usize, reading: Reading, scales: &Scales) -> Vec<Vec<Point>> {
    let sizes = piece.points.iter();
    let sizes: Vec<Point> = sizes
        .filter_map(|point| Some((point.r, reading.polar(point, part)?.0)))
        .collect();
    // Near a pole the points are dense. The code therefore takes the median over the frequency range, not over the
    // points.
    let least = VANISHING * exceeded(&sizes, 0.5);
    let mut runs: Vec<Vec<Point>> = vec![Vec::new()];
    let mut before: Option<f64> = None;
    for point in &piece.points {
        let polar = reading.polar(point, part);
        let phase = polar
            .filter(|(size, _)| least <= *size)
            .and_then(|(_, phase)| phase);
        let Some(phase) = phase else {
            runs.push(Vec::new());
            before = None;
            continue;
        };
        let near = |other: f64| phase - ((phase - other) / FULL).round() * FULL;
        let joined = before.filter(|before| (near(*before) - before).abs() < TURN);
        let turned = match joined {
            Some(before) => near(before),
            None => {
                runs.push(Vec::new());
                phase
            }
        };
        before = Some(turned);
        if let Some(run) = runs.last_mut() {
            run.push((scales.frequency(point.r), turned.to_degrees()));
        }
    }
    folded(&runs)
}

const FULL: f64 = std::f64::consts::TAU;

/// Returns the layers that draw the motion `part` of a curve: one line for each regime, and dots for motions that do
/// not become periodic. All lines share one legend entry. If their strokes differ, this entry shows only the colour.
#[must_use]
pub fn lines(
    drawn: &Drawn<'_>,
    part: usize,
    reading: Reading,
    scales: &Scales,
) -> Vec<crate::Layer> {
    let mut layers: Vec<crate::Layer> = Vec::new();
    let traced = traced(drawn.curve, part, reading, scales);
    for regime in [Regime::Continuous, Regime::StickSlip, Regime::Stuck] {
        let of_regime = traced.iter().filter(|(of, _)| *of == regime);
        let runs: Vec<Vec<Point>> = of_regime.flat_map(|(_, runs)| runs.clone()).collect();
        if runs.iter().all(|run| run.len() < 2) {
            continue;
        }
        layers.push(Line::new(drawn.name.clone(), drawn.colour, stroke(regime), runs).into());
    }
    if !reading.is_phase() {
        // A motion that does not become periodic has irregular amplitudes, which no line should join. Each amplitude is
        // a piece with a single point, and the figure shows it as a dot.
        let lone = drawn
            .curve
            .pieces
            .iter()
            .filter(|piece| piece.points.len() == 1);
        let points = lone.flat_map(|piece| &piece.points);
        let placed: Vec<Point> = points
            .filter(|point| !point.settled)
            .filter_map(|point| {
                let size = reading.size(point, part, scales)?;
                Some((scales.frequency(point.r), size))
            })
            .collect();
        if !placed.is_empty() {
            layers.push(Markers::unnamed(drawn.colour, Marker::Dot, placed).into());
        }
    }
    layers
}

/// Returns a panel that shows the motion `part` of several curves over frequency. The axes have the range of the
/// curves.
#[must_use]
pub fn panel(
    title: impl Into<Label>,
    drawn: &[Drawn<'_>],
    part: usize,
    reading: Reading,
    scales: &Scales,
) -> Panel {
    let ends = drawn
        .iter()
        .flat_map(|drawn| &drawn.curve.pieces)
        .flat_map(|piece| {
            [piece.points.first(), piece.points.last()]
                .into_iter()
                .flatten()
                .map(|point| scales.frequency(point.r))
        });
    let (low, high) = ends.fold((f64::INFINITY, 0.0_f64), |(low, high), r| {
        (low.min(r), high.max(r))
    });
    let x = scales.frequency_axis(low, high);
    let y = if reading.is_phase() {
        phase_axis(drawn, part, reading, scales)
    } else {
        let label = match reading {
            Reading::Rate(size) => scales.size_label(size),
            _ => scales.length_label(),
        };
        let sizes = drawn.iter().flat_map(|drawn| {
            let pieces = drawn.curve.pieces.iter();
            let points = pieces.flat_map(|piece| &piece.points);
            points.filter_map(|point| reading.size(point, part, scales))
        });
        scales.amplitude_axis(label, top(drawn, part, reading, scales), sizes)
    };
    let mut panel = Panel::new(title, x, y);
    for drawn in drawn {
        for layer in lines(drawn, part, reading, scales) {
            panel = panel.with(layer);
        }
    }
    panel
}

fn phase_axis(drawn: &[Drawn<'_>], part: usize, reading: Reading, scales: &Scales) -> Axis {
    let traced = drawn
        .iter()
        .flat_map(|drawn| traced(drawn.curve, part, reading, scales));
    let phases = traced
        .flat_map(|(_, runs)| runs)
        .flatten()
        .map(|point| point.1);
    let (low, high) = phase_ends(phases);
    Axis::new("phase *φ* (degrees)", low, high).degrees()
}

/// Returns the upper end of the amplitude axis of several curves. For a curve without a pole, the axis shows all
/// amplitudes. For a curve with a pole, where the amplitude is unbounded, the axis shows the amplitudes over at least
/// nine tenths of the frequency range.
fn top(drawn: &[Drawn<'_>], part: usize, reading: Reading, scales: &Scales) -> f64 {
    let mut largest = 0.0_f64;
    for drawn in drawn {
        let pieces = &drawn.curve.pieces;
        let pole = pieces
            .iter()
            .any(|piece| piece.start == PieceEnd::Pole || piece.end == PieceEnd::Pole);
        let points = || {
            pieces.iter().flat_map(|piece| {
                let read = |point: &CurvePoint| Some((point.r, reading.size(point, part, scales)?));
                piece.points.iter().filter_map(read)
            })
        };
        let most = points().fold(0.0, |most, (_, size)| size.max(most));
        let shown = if pole {
            // With this upper end, the axis cuts off a curve over less than a tenth of its frequency range.
            (1.3 * exceeded(&points().collect::<Vec<_>>(), 0.1)).min(most)
        } else {
            most
        };
        largest = largest.max(shown);
    }
    if largest > 0.0 { 1.06 * largest } else { 1.0 }
}

/// Returns the amplitude that a curve exceeds over the fraction `share` of its frequency range. Each point of the curve
/// has a frequency ratio r and an amplitude.
fn exceeded(points: &[Point], share: f64) -> f64 {
    let mut parts: Vec<Point> = points
        .windows(2)
        .filter_map(|pair| match pair {
            [a, b] => Some((a.1.max(b.1), (b.0 - a.0).max(0.0))),
            _ => None,
        })
        .collect();
    parts.sort_by(|a, b| b.0.total_cmp(&a.0));
    let whole: f64 = parts.iter().map(|part| part.1).sum();
    let mut seen = 0.0;
    for (size, width) in parts {
        seen += width;
        if share * whole <= seen {
            return size;
        }
    }
    0.0
}

/// Returns a figure of response curves, with one row of panels for each requested motion. The left panel shows the
/// amplitude, the right panel the phase. A velocity, an acceleration or another [`MotionQuantity`] has no panel for a
/// phase.
#[must_use]
pub fn curve_figure(
    title: impl Into<Label>,
    drawn: &[Drawn<'_>],
    parts: &[(Of, MotionQuantity, Label)],
    scales: &Scales,
) -> Figure {
    let mut panels = Vec::new();
    for (index, (of, size, part)) in parts.iter().enumerate() {
        let scales = &scales.showing(*of);
        if *size != MotionQuantity::Displacement {
            let reading = Reading::Rate(*size);
            panels.push(panel(part.clone(), drawn, index, reading, scales));
            continue;
        }
        panels.push(panel(
            part.clone(),
            drawn,
            index,
            Reading::Amplitude,
            scales,
        ));
        panels.push(panel(part.clone(), drawn, index, Reading::Phase, scales));
    }
    let curves = drawn.iter().map(|drawn| drawn.curve);
    Figure::new("", title, 2, panels).with_keys(keys_of(curves))
}

#[cfg(test)]
mod tests {
    use super::{Drawn, Reading, Scales, curve_figure, traced};
    use crate::Colour;
    use frictiongen::study::curve::CurveRequest;
    use frictiongen::study::response::MotionQuantity;
    use frictiongen::{Of, System};

    /// Checks that the figure shows a phase wherever the phase has significant digits. The test uses the last mass of a
    /// long chain, which hardly moves at high frequency.
    #[test]
    fn phases_are_drawn_as_far_as_they_are_known() -> Result<(), Box<dyn std::error::Error>> {
        let chain: System = "struct Chain {
            masses: { a: 1.0, b: 1.0, c: 1.0, d: 1.0, e: 1.0, f: 1.0 },
            springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - d: 1.0, d - e: 1.0, e - f: 1.0 },
            contact: a - wall, excitation: base,
        }"
        .parse()?;
        let request = CurveRequest {
            widest: Some(0.1),
            ..CurveRequest::new(0.1, 20.0, &[Of::Mass(5)])
        };
        let curve = chain.curve(&request, 0.0)?;
        let scales = Scales::groups(&chain);
        let drawn = traced(&curve, 0, Reading::Phase, &scales);
        let last = drawn.iter().flat_map(|(_, runs)| runs).flatten();
        let last = last.map(|(r, _)| *r).fold(0.0, f64::max);
        assert!((last - 20.0).abs() < 1e-9, "the phase ends at r = {last}");
        Ok(())
    }

    /// Checks the phases of a long chain, which lag by several turns. The figure must show these phases in (−180,
    /// 180]. The legend must list the regimes that occur, and no others.
    #[test]
    fn pictures_have_one_turn_and_their_own_regimes() -> Result<(), Box<dyn std::error::Error>> {
        let chain: System = "struct Chain {
            masses: { a: 1.0, b: 1.0, c: 1.0, d: 1.0, e: 1.0 },
            springs: { base - a: 1.0, a - b: 1.0, b - c: 1.0, c - d: 1.0, d - e: 1.0 },
            contact: a - wall, excitation: a, damping: modal(0.01),
        }"
        .parse()?;
        let scales = Scales::groups(&chain);
        let figure = |beta: f64| -> Result<_, frictiongen::study::curve::CurveError> {
            let curve = chain.curve(&CurveRequest::new(0.7, 2.5, &[Of::Mass(4)]), beta)?;
            let drawn = [Drawn {
                curve: &curve,
                name: "some".into(),
                colour: Colour::Series(0),
            }];
            let phases = traced(&curve, 0, Reading::Phase, &scales);
            let phases: Vec<f64> = phases
                .iter()
                .flat_map(|(_, runs)| runs.iter().flatten().map(|point| point.1))
                .collect();
            Ok((
                phases,
                curve_figure(
                    "",
                    &drawn,
                    &[(Of::Mass(4), MotionQuantity::Displacement, "e".into())],
                    &scales,
                )
                .svg(),
            ))
        };
        let (phases, svg) = figure(0.0)?;
        let least = phases.iter().copied().fold(0.0, f64::min);
        let most = phases.iter().copied().fold(0.0, f64::max);
        assert!((-180.0..-90.0).contains(&least), "{least}");
        assert!(90.0 < most && most < 180.1, "{most}");
        assert!(svg.contains(">continuous<") && !svg.contains(">stuck<"));
        let (_, svg) = figure(1e3)?;
        assert!(svg.contains(">stuck<") && !svg.contains(">continuous<"));
        Ok(())
    }
}

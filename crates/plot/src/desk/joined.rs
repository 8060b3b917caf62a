//! Figures of scenes with several contacts: motions over time with a hysteresis loop of each contact, and responses
//! over frequency.

use super::curves::stroke;
use super::scales::Scales;
use crate::{Across, Axis, Colour, Figure, Guide, Key, Label, Line, Panel, Point, Stroke};
use frictiongen::Regime;

/// Motion of one contact over time, in the units of the axes.
#[derive(Clone, Debug)]
pub struct ContactTrack {
    /// Name of the contact.
    pub name: String,
    /// Relative displacement of the two sides of the contact, at each sample.
    pub displacement: Vec<f64>,
    /// Force of the contact at each sample, in the unit of the force axis.
    pub force: Vec<f64>,
    /// True at each sample at which the contact sticks.
    pub sticks: Vec<bool>,
}

/// A motion over time in a scene with several contacts, in the units of the axes.
#[derive(Clone, Debug)]
pub struct JoinedMotion {
    /// Time of each sample, in the unit of the time axis.
    pub times: Vec<f64>,
    /// Label of the time axis.
    pub time_label: Label,
    /// Label of the axis of displacements.
    pub displacement_label: Label,
    /// Label of the axis of forces.
    pub force_label: Label,
    /// Displacements of masses and of combinations, each with its name.
    pub masses: Vec<(String, Vec<f64>)>,
    /// Forces of springs, each with its name.
    pub springs: Vec<(String, Vec<f64>)>,
    /// The motion of each contact.
    pub contacts: Vec<ContactTrack>,
}

impl JoinedMotion {
    fn time(&self) -> Axis {
        let ends = (self.times.first(), self.times.last());
        let (first, last) = (
            ends.0.copied().unwrap_or(0.0),
            ends.1.copied().unwrap_or(1.0),
        );
        let last = if first < last { last } else { first + 1.0 };
        Axis::new(self.time_label.clone(), first, last)
    }

    fn over(&self, values: &[f64]) -> Vec<Point> {
        let times = self.times.iter().copied();
        times.zip(values.iter().copied()).collect()
    }

    /// Returns a panel with one line over time for each named quantity. Returns `None` if `tracks` is empty. `first`
    /// is the index of the first line's colour.
    fn panel(
        &self,
        (title, label): (&str, &Label),
        tracks: &[(String, Vec<f64>)],
        first: usize,
    ) -> Option<Panel> {
        if tracks.is_empty() {
            return None;
        }
        let values = tracks.iter().flat_map(|(_, values)| values.iter().copied());
        let panel = Panel::new(title, self.time(), Axis::fitted(label.clone(), values));
        let lines = tracks.iter().enumerate().map(|(index, (name, values))| {
            let colour = Colour::Series(first + index);
            let pieces = vec![self.over(values)];
            Line::new(Label::verbatim(name), colour, Stroke::Solid, pieces)
        });
        Some(lines.fold(panel, |panel, line| panel.with(line)))
    }

    /// Returns the panel with the forces of all contacts over time. `first` is the index of the first contact's
    /// colour.
    fn forces(&self, first: usize) -> Panel {
        let values = self.contacts.iter().flat_map(|contact| &contact.force);
        let axis = Axis::fitted(self.force_label.clone(), values.copied());
        let mut panel = Panel::new("forces of the contacts", self.time(), axis)
            .with(Guide::new(Across::Y(0.0)));
        for (index, contact) in self.contacts.iter().enumerate() {
            let path = self.over(&contact.force);
            for line in contact.lines(&path, Colour::Series(first + index)) {
                panel = panel.with(line);
            }
        }
        panel
    }

    /// Returns the panel with the hysteresis loop of a contact, which is the contact force against the relative
    /// displacement.
    fn hysteresis(&self, contact: &ContactTrack, colour: Colour) -> Panel {
        let x = contact.displacement.iter().copied();
        let f = contact.force.iter().copied();
        let path: Vec<Point> = x.clone().zip(f.clone()).collect();
        let title = Label::verbatim(&format!("{}: hysteresis loop, area = energy", contact.name));
        let across = Axis::fitted(self.displacement_label.clone(), x);
        let panel = Panel::new(title, across, Axis::fitted(self.force_label.clone(), f));
        let lines = contact.lines(&path, colour).into_iter();
        lines.fold(panel, |panel, line| panel.with(line))
    }
}

impl ContactTrack {
    /// Returns the lines that draw a curve of the contact. The stroke is solid while the contact slides, and dotted
    /// while it sticks.
    fn lines(&self, path: &[Point], colour: Colour) -> Vec<Line> {
        let name = || Label::verbatim(&self.name);
        let lines = [(false, Stroke::Solid), (true, Stroke::Dotted)];
        let lines = lines.map(|(sticks, stroke)| {
            let pieces = pieces(path, stuck_segments(&self.sticks), sticks);
            Line::new(name(), colour, stroke, pieces)
        });
        let lines = lines.into_iter().filter(|line| !line.pieces.is_empty());
        lines.collect()
    }
}

/// Returns the pieces of a path whose segments have the flag `wanted`. `flags` has a flag for each segment, which joins
/// two neighbouring points.
pub(super) fn pieces(
    path: &[Point],
    flags: impl IntoIterator<Item = bool>,
    wanted: bool,
) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    let mut open = false;
    for (points, flag) in path.windows(2).zip(flags) {
        if flag != wanted {
            open = false;
            continue;
        }
        if !open {
            pieces.push(points.iter().take(1).copied().collect());
            open = true;
        }
        if let Some(piece) = pieces.last_mut() {
            piece.extend(points.iter().skip(1));
        }
    }
    pieces
}

/// Returns a flag for each segment of a path: true if the contact sticks at both ends of the segment.
fn stuck_segments(sticks: &[bool]) -> impl Iterator<Item = bool> {
    let ends = sticks.windows(2);
    ends.map(|ends| ends.iter().all(|sticks| *sticks))
}

/// Returns a figure of a motion over time: displacements, the forces of the contacts, and a hysteresis loop of each
/// contact. The area of the loop of one period is the energy that the contact dissipates in that period.
#[must_use]
pub fn joined_motion_figure(title: impl Into<Label>, motion: &JoinedMotion) -> Figure {
    let first = motion.masses.len();
    let titled = ("displacement", &motion.displacement_label);
    let mut panels: Vec<Panel> = motion
        .panel(titled, &motion.masses, 0)
        .into_iter()
        .collect();
    panels.push(motion.forces(first));
    let springs = first + motion.contacts.len();
    panels.extend(motion.panel(
        ("forces of springs", &motion.force_label),
        &motion.springs,
        springs,
    ));
    let contacts = motion.contacts.iter().enumerate();
    panels.extend(
        contacts.map(|(index, contact)| motion.hysteresis(contact, Colour::Series(first + index))),
    );
    let sticks = motion.contacts.iter().flat_map(|contact| &contact.sticks);
    let keys = if sticks.clone().any(|sticks| *sticks) {
        vec![
            Key::stroke("the contact slides", Stroke::Solid),
            Key::stroke("the contact sticks", Stroke::Dotted),
        ]
    } else {
        Vec::new()
    };
    Figure::new("", title, 2, panels).with_keys(keys)
}

/// Steady states over frequency of a scene with several contacts, at one friction, in the units of the axes.
#[derive(Clone, Debug)]
pub struct JoinedCurve {
    /// Name of the curve in the legend, such as the friction.
    pub name: Label,
    /// For each frequency, the value on the frequency axis and the regime of the steady state. The regime is `None` if
    /// no steady state was found.
    pub points: Vec<(f64, Option<Regime>)>,
    /// For each panel, a list with the value at each frequency. The value is NaN if no steady state was found.
    pub values: Vec<Vec<f64>>,
}

/// Returns a figure of responses over frequency. The figure has one panel for each pair of title and axis label. The
/// stroke of a line shows the regime: all contacts slide, some stick, or all are stuck.
#[must_use]
pub fn joined_curve_figure(
    title: impl Into<Label>,
    titles: &[(Label, Label)],
    curves: &[JoinedCurve],
    scales: &Scales,
) -> Figure {
    let all = || curves.iter().flat_map(|curve| &curve.points);
    let ends = all().map(|point| point.0);
    let (low, high) = ends.fold((f64::INFINITY, 0.0_f64), |(low, high), x| {
        (low.min(x), high.max(x))
    });
    let panels = titles.iter().enumerate().map(|(index, (name, label))| {
        let values = || {
            let values = curves.iter().filter_map(|curve| curve.values.get(index));
            values.flatten().copied().filter(|value| value.is_finite())
        };
        let most = values().fold(0.0, f64::max);
        let most = if 0.0 < most { 1.06 * most } else { 1.0 };
        let y = scales.amplitude_axis(label.clone(), most, values());
        let mut panel = Panel::new(name.clone(), scales.frequency_axis(low, high), y);
        for (place, curve) in curves.iter().enumerate() {
            for line in curve.lines(index, Colour::Series(place)) {
                panel = panel.with(line);
            }
        }
        panel
    });
    let keys = [
        ("all contacts slide", Regime::Continuous),
        ("some contacts stick", Regime::StickSlip),
        ("all contacts are stuck", Regime::Stuck),
    ];
    let keys = keys.into_iter().filter(|(_, regime)| {
        let mut all = all();
        all.any(|point| point.1 == Some(*regime))
    });
    let keys = keys.map(|(name, regime)| Key::stroke(name, stroke(regime)));
    Figure::new("", title, 2, panels.collect()).with_keys(keys)
}

impl JoinedCurve {
    /// Returns the lines that draw this curve in the panel `index`, one for each regime. A line continues to the
    /// first point of the next regime, so that no gap remains.
    fn lines(&self, index: usize, colour: Colour) -> Vec<Line> {
        let values = self.values.get(index).map_or(&[][..], Vec::as_slice);
        let points = self.points.iter().zip(values);
        let path: Vec<Point> = points.map(|((x, _), y)| (*x, *y)).collect();
        let regimes = [Regime::Continuous, Regime::StickSlip, Regime::Stuck];
        let lines = regimes.into_iter().map(|regime| {
            let ends = self.points.windows(2);
            let flags = ends.map(|ends| match ends {
                [(_, before), (_, after)] => *before == Some(regime) && after.is_some(),
                _ => false,
            });
            (regime, pieces(&path, flags, true))
        });
        let drawn = lines.filter(|(_, pieces)| !pieces.is_empty());
        drawn
            .map(|(regime, pieces)| Line::new(self.name.clone(), colour, stroke(regime), pieces))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{pieces, stuck_segments};

    #[test]
    fn pieces_cover_a_path_once() {
        let path: Vec<(f64, f64)> = (0..7).map(|i| (f64::from(i), 0.0)).collect();
        let sticks = [false, false, true, true, true, false, true];
        let starts = |wanted| -> Vec<(f64, f64)> {
            let pieces = pieces(&path, stuck_segments(&sticks), wanted).into_iter();
            let ends = pieces.filter_map(|piece| Some((piece.first()?.0, piece.last()?.0)));
            ends.collect()
        };
        assert_eq!(starts(true), [(2.0, 4.0)]);
        assert_eq!(starts(false), [(0.0, 2.0), (4.0, 6.0)]);
    }
}

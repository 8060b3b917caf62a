//! Figures of branches of steady states along a parameter.

use super::joined::pieces;
use crate::axis::Axis;
use crate::figure::{Figure, Key, Panel};
use crate::geometry::Point;
use crate::label::Label;
use crate::layer::{Line, Markers};
use crate::palette::Colour;
use crate::stroke::{Marker, Stroke};

/// A branch of steady states, in the units of the axes.
#[derive(Clone, Debug)]
pub struct BranchCurve {
    /// Name of the branch in the legend.
    pub name: Label,
    /// For each point, the value of the parameter.
    pub places: Vec<f64>,
    /// For each point, true if the state is stable. The line from a point to the next one shows the state at the first.
    pub stable: Vec<bool>,
    /// Indices of the points at which the number or the stability of states changes.
    pub bifurcations: Vec<usize>,
    /// For each panel, a list with the value at each point.
    pub values: Vec<Vec<f64>>,
}

/// Returns a figure of branches over a parameter. The figure has one panel for each pair of title and axis label. Stable
/// states have solid lines, unstable ones dashed lines, and bifurcations a circle.
#[must_use]
pub fn branch_figure(
    title: impl Into<Label>,
    parameter: &Label,
    titles: &[(Label, Label)],
    branches: &[BranchCurve],
) -> Figure {
    let places = || {
        branches
            .iter()
            .flat_map(|branch| branch.places.iter().copied())
    };
    let panels = titles.iter().enumerate().map(|(index, (name, label))| {
        let values = branches
            .iter()
            .filter_map(|branch| branch.values.get(index));
        let y = Axis::fitted(label.clone(), values.flatten().copied().chain([0.0]));
        let mut panel = Panel::new(name.clone(), Axis::fitted(parameter.clone(), places()), y);
        for (number, branch) in branches.iter().enumerate() {
            let points = branch.points(index);
            let colour = Colour::Series(number);
            for (stable, stroke) in [(true, Stroke::Solid), (false, Stroke::Dashed)] {
                let pieces = pieces(&points, branch.stable.iter().copied(), stable);
                if !pieces.is_empty() {
                    panel = panel.with(Line::new(branch.name.clone(), colour, stroke, pieces));
                }
            }
            let marked = branch.bifurcations.iter();
            let marked: Vec<Point> = marked.filter_map(|at| points.get(*at).copied()).collect();
            panel = panel.with(Markers::unnamed(colour, Marker::Circle, marked));
        }
        panel
    });
    let keys = [
        Key::stroke("stable", Stroke::Solid),
        Key::stroke("unstable", Stroke::Dashed),
        Key::marker("bifurcation", Marker::Circle),
    ];
    Figure::new("", title, 2, panels.collect()).with_keys(keys)
}

impl BranchCurve {
    fn points(&self, panel: usize) -> Vec<Point> {
        let values = self.values.get(panel).map_or(&[][..], Vec::as_slice);
        self.places
            .iter()
            .copied()
            .zip(values.iter().copied())
            .collect()
    }
}

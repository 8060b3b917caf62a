//! Chains of masses m₁, m₂, …: their description, and panels with amplitude and phase of a mass.

use super::responses::Responses;
use super::systems::system;
use super::tidy::{one_turn, tidy, without_specks};
use frictiongen::System;
use frictiongen_plot::desk::{self, Reading, Scales, sketch};
use frictiongen_plot::{Key, Layer, Marker, Panel, Scale, Sketch, Stroke};

/// Label of the frequency axis for a system of several masses.
pub const RATIO: &str = "frequency ratio *r*_1";

/// Range of the phase axis in degrees: a whole turn with a margin. If all phases of a panel are above `HIGH`, its axis
/// begins at `HIGH`.
const WIDE: (f64, f64) = (-190.0, 190.0);
const HIGH: f64 = -45.0;

/// Builds a chain of masses m1, m2, …, which begins at the base. Masses are given as multiples of the first mass, and
/// springs as multiples of the first spring.
#[must_use]
pub fn chain(
    masses: &[f64],
    springs: &[f64],
    contact: &str,
    excitation: &str,
    more: &str,
) -> System {
    let masses = masses.iter().enumerate();
    let masses: Vec<String> = masses.map(|(i, m)| format!("m{}: {m:?}", i + 1)).collect();
    let spring = |(i, k): (usize, &f64)| match i {
        0 => format!("base - m1: {k:?}"),
        _ => format!("m{i} - m{}: {k:?}", i + 1),
    };
    let springs: Vec<String> = springs.iter().enumerate().map(spring).collect();
    system(&format!(
        "struct Chain {{
            masses: {{ {} }}, springs: {{ {} }},
            contact: {contact}, excitation: {excitation}, {more}
        }}",
        masses.join(", "),
        springs.join(", "),
    ))
}

/// Sketches a system with the symbols of the thesis.
#[must_use]
pub fn drawn(system: &System) -> Sketch {
    sketch(system.scene(), false)
}

/// Returns the panel with the label r₁ on its frequency axis.
#[must_use]
pub fn over_r1(mut panel: Panel) -> Panel {
    panel.x.label = RATIO.into();
    panel
}

/// Returns a panel of the regimes over the frequency ratio r₁ and the friction ratio β. `top` is the highest β.
///
/// # Errors
/// Fails if the limits cannot be computed.
pub fn map(title: &str, system: &System, top: f64) -> Result<Panel, Box<dyn std::error::Error>> {
    let lines = system.limit_lines(0.0, 2.5, 1e-4)?;
    let panel = desk::regimes(title, &lines, top, &Scales::groups(system));
    Ok(tidy(over_r1(panel)))
}

/// Content of a row of two panels: amplitude and phase of one mass or of the contact.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a> {
    /// Index of the motion that the row shows, among the motions of the responses.
    pub part: usize,
    /// Titles of the amplitude panel and of the phase panel.
    pub titles: [&'a str; 2],
    /// Labels of the vertical axes of the amplitude panel and of the phase panel.
    pub labels: [&'a str; 2],
    /// Range of the amplitude axis. The axis is logarithmic if the lower bound is above 0.
    pub sizes: (f64, f64),
    /// True if the row also shows the response with the contact stuck.
    pub stuck: bool,
    /// Lowest frequency ratio at which the row shows the response at the limit of continuous motion.
    pub limit_from: f64,
    /// Distance in the frequency ratio between the circles of the simulation. With 0 there are no circles.
    pub circles: f64,
    /// True if the row shows the first harmonic instead of amplitude and lag of the motion.
    pub harmonic: bool,
}

impl Row<'_> {
    /// Returns the two panels of the row: amplitude and phase over the frequency ratio.
    #[must_use]
    pub fn panels(&self, responses: &Responses<'_>) -> [Panel; 2] {
        [self.amplitude(responses), self.phase(responses)]
    }

    /// Returns the panel with the amplitude over the frequency ratio.
    #[must_use]
    pub fn amplitude(&self, responses: &Responses<'_>) -> Panel {
        let reading = if self.harmonic {
            Reading::Harmonic(0)
        } else {
            Reading::Amplitude
        };
        let y = (self.labels[0], Some(self.sizes));
        let mut panel = self.panel(responses, self.titles[0], reading, y);
        if 0.0 < self.sizes.0 {
            panel.y.scale = Scale::Log;
        }
        if 0.0 < self.circles {
            let circles = responses.simulation(self.circles, self.part, reading);
            panel.layers.extend(circles);
        }
        tidy(panel)
    }

    /// Returns the panel with the phase over the frequency ratio.
    #[must_use]
    pub fn phase(&self, responses: &Responses<'_>) -> Panel {
        let reading = if self.harmonic {
            Reading::HarmonicPhase(0)
        } else {
            Reading::Phase
        };
        let y = (self.labels[1], Some(WIDE));
        let mut panel = self.panel(responses, self.titles[1], reading, y);
        panel.y = panel.y.degrees();
        if 0.0 < self.circles {
            // During a stop the displacement stays at its maximum. The largest sample of the simulation may then be
            // at any instant of the stop (3.6.1).
            let continuous = responses.clone().continuous();
            let circles = continuous.simulation(self.circles, self.part, reading);
            panel.layers.extend(circles);
        }
        let mut panel = one_turn(without_specks(panel));
        if HIGH < least(&panel) {
            panel.y.low = HIGH;
        }
        tidy(panel)
    }

    fn panel(
        &self,
        responses: &Responses<'_>,
        title: &str,
        reading: Reading,
        y: (&str, Option<(f64, f64)>),
    ) -> Panel {
        let mut panel = responses.panel(title, self.part, reading, y);
        let mut limit = responses.limit(self.part, reading);
        for piece in &mut limit.pieces {
            piece.retain(|point| self.limit_from <= point.0);
        }
        if self.stuck {
            // The stuck response is drawn over its whole range, even where no β reaches it.
            let some =
                |layer: &Layer| matches!(layer, Layer::Line(line) if line.stroke == Stroke::Dotted);
            panel.layers.retain(|layer| !some(layer));
            panel = panel.with(responses.stuck(self.part, reading));
        }
        over_r1(panel.with(limit))
    }
}

/// Returns the smallest phase of all lines of a panel, in degrees.
fn least(panel: &Panel) -> f64 {
    let lines = panel.layers.iter().filter_map(|layer| match layer {
        Layer::Line(line) => Some(line),
        _ => None,
    });
    let phases = lines.flat_map(|line| line.pieces.iter().flatten().map(|point| point.1));
    phases.fold(0.0, f64::min)
}

/// Returns legend entries for the strokes of the regimes and for the circles of the simulation. The entry of the
/// stuck response appears only if `stuck` is true, that of the circles only if `circles` is true.
#[must_use]
pub fn strokes(stuck: bool, circles: bool) -> Vec<Key> {
    let mut keys = desk::keys();
    if !stuck {
        keys.truncate(2);
    }
    if circles {
        keys.push(Key::marker("simulation from rest", Marker::Circle));
    }
    keys
}

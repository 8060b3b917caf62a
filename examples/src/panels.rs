//! The kinds of panel that the chapters share.

use crate::curve::sample;
use crate::figure::{Axis, Colour, Curve, Panel, Stroke};
use crate::scene::{Measure, Of, Polar, Scene};
use std::f64::consts::TAU;

/// Lags are drawn from here on: a lag of ±180° is one line, not two.
const FIRST_LAG: f64 = -90.0;
/// The lowest r that is drawn; towards r = 0 the cycles of a slow contact have ever more events.
const FIRST: f64 = 0.02;

/// Responses of a scene over r for some β.
#[derive(Clone, Copy)]
pub struct Sweep<'a> {
    pub scene: &'a dyn Scene,
    pub from: f64,
    pub to: f64,
    pub betas: &'a [f64],
    pub measure: Measure,
    /// Distance of the markers in r; none where it is 0.
    pub markers: f64,
    /// Whether responses are drawn beyond the continuous regime.
    pub beyond: bool,
}

/// What of a motion is drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    Amplitude,
    Lag,
}

impl Part {
    fn read(self, polar: Polar) -> f64 {
        match self {
            Self::Amplitude => polar.amplitude,
            Self::Lag => (polar.lag - FIRST_LAG).rem_euclid(360.0) + FIRST_LAG,
        }
    }
}

impl Sweep<'_> {
    /// The amplitude over r.
    #[must_use]
    pub fn amplitude(&self, title: &str, label: &str, of: Of, top: f64) -> Panel {
        self.panel(title, Axis::new(label, 0.0, top), of, Part::Amplitude)
    }

    /// The lag over r, degrees.
    #[must_use]
    pub fn lag(&self, title: &str, label: &str, of: Of, low: f64, high: f64) -> Panel {
        // Where the contact stops, the maximum is a plateau, and its lag means nothing (3.6.1).
        let beyond = self.beyond && self.measure == Measure::Fundamental;
        let sweep = Self { beyond, ..*self };
        sweep.panel(title, Axis::new(label, low, high), of, Part::Lag)
    }

    fn panel(&self, title: &str, y: Axis, of: Of, part: Part) -> Panel {
        let x = Axis::new("frequency ratio r", self.from, self.to);
        let drawn = self.drawn();
        let marks = self.scene.resonances();
        let read = |polar| part.read(polar);
        let (scene, measure) = (self.scene, self.measure);
        let mut curves: Vec<Curve> = Vec::new();
        for (index, beta) in self.betas.iter().enumerate() {
            let pieces = sample(&drawn, &y, &marks, |r| {
                let (continuous, sliding) = scene.limits(r)?;
                let polar = if *beta < continuous.min(sliding) {
                    scene.continuous(r, *beta, of, measure)
                } else if self.beyond && *beta < sliding {
                    scene.stick_slip(r, *beta, of, measure)
                } else {
                    None
                };
                polar.map(read)
            });
            let name = format!("β = {beta}");
            curves.push(Curve {
                name,
                colour: Colour::Series(index),
                stroke: Stroke::Solid,
                pieces,
            });
        }
        curves.push(Curve {
            name: "at β_lim".to_owned(),
            colour: Colour::Black,
            stroke: Stroke::Dashed,
            pieces: sample(&drawn, &y, &[], |r| {
                scene.at_limit(r, of, measure).map(read)
            }),
        });
        if self.beyond && of != Of::Contact && self.sticks() {
            curves.push(self.stuck_part(&y, of, part));
        }
        if 0.0 < self.markers {
            self.mark(&mut curves, of, read);
        }
        Panel {
            title: title.to_owned(),
            x,
            y,
            curves,
        }
    }

    /// The amplitude with the contact stuck, for a panel that does not have it.
    #[must_use]
    pub fn stuck(&self, y: &Axis, of: Of) -> Curve {
        self.stuck_part(y, of, Part::Amplitude)
    }

    fn stuck_part(&self, y: &Axis, of: Of, part: Part) -> Curve {
        Curve {
            name: "stuck".to_owned(),
            colour: Colour::Black,
            stroke: Stroke::Dotted,
            pieces: sample(&self.drawn(), y, &self.scene.resonances(), |r| {
                self.scene.stuck(r, of).map(|polar| part.read(polar))
            }),
        }
    }

    fn drawn(&self) -> Axis {
        Axis::new("", FIRST.max(self.from), self.to)
    }

    /// Whether the contact is stuck anywhere for any of the β.
    fn sticks(&self) -> bool {
        (1..=100).any(|i| {
            let limits = self.scene.limits(self.to * f64::from(i) / 100.0);
            limits.is_some_and(|(_, sliding)| self.betas.iter().any(|beta| sliding <= *beta))
        })
    }

    fn mark(&self, curves: &mut Vec<Curve>, of: Of, read: impl Fn(Polar) -> f64) {
        let count = (self.to / self.markers).floor() as usize;
        for (index, beta) in self.betas.iter().enumerate() {
            // Without friction nothing settles.
            if *beta == 0.0 {
                continue;
            }
            // Between round numbers, so that no marker sits on a resonance.
            let points = (1..count).filter_map(|i| {
                let r = (i as f64 + 0.37) * self.markers;
                let (continuous, sliding) = self.scene.limits(r)?;
                let shown = *beta < sliding && (self.beyond || *beta < continuous);
                let polar = shown.then(|| self.scene.simulated(r, *beta, of, self.measure))??;
                Some((r, read(polar)))
            });
            curves.push(Curve {
                name: "simulation".to_owned(),
                colour: Colour::Series(index),
                stroke: Stroke::Circles,
                pieces: vec![points.collect()],
            });
        }
    }
}

/// Both limits over r.
#[must_use]
pub fn regimes(title: &str, scene: &dyn Scene, to: f64, top: f64) -> Panel {
    regimes_of(title, &[("", scene)], to, top)
}

/// Both limits over r, of several scenes.
#[must_use]
pub fn regimes_of(title: &str, scenes: &[(&str, &dyn Scene)], to: f64, top: f64) -> Panel {
    let x = Axis::new("frequency ratio r", 0.0, to);
    let y = Axis::new("friction ratio β", 0.0, top);
    let drawn = Axis::new("", 1e-3 * to, to);
    let mut curves = Vec::new();
    for (index, (label, scene)) in scenes.iter().enumerate() {
        let mut marks = scene.resonances();
        // β_lim touches zero at the odd sub-harmonics of each.
        marks.extend(
            scene
                .resonances()
                .iter()
                .flat_map(|r| [r / 3.0, r / 5.0, r / 7.0]),
        );
        let after = if label.is_empty() {
            String::new()
        } else {
            format!(", {label}")
        };
        for (name, stroke, second) in [
            ("β_lim: continuous below", Stroke::Solid, false),
            ("β*_lim: stuck above", Stroke::Dashed, true),
        ] {
            let pieces = sample(&drawn, &y, &marks, |r| {
                scene
                    .limits(r)
                    .map(|limits| if second { limits.1 } else { limits.0 })
            });
            let name = format!("{name}{after}");
            curves.push(Curve {
                name,
                colour: Colour::Series(index),
                stroke,
                pieces,
            });
        }
    }
    Panel {
        title: title.to_owned(),
        x,
        y,
        curves,
    }
}

/// Motions over a cycle from a maximum of the relative motion in the contact, with the excitation.
#[must_use]
pub fn cycle(
    title: &str,
    scene: &dyn Scene,
    (r, beta): (f64, f64),
    motions: &[(&str, Of)],
    (span, reach): (f64, f64),
) -> Panel {
    let count = 120;
    let taus: Vec<f64> = (0..=count)
        .map(|i| span * f64::from(i) / f64::from(count))
        .collect();
    let y = Axis::new("x̄", -reach, reach);
    let mut curves = Vec::new();
    let mut excitation = None;
    for (index, (name, of)) in motions.iter().enumerate() {
        let Some(cycle) = scene.cycle(r, beta, *of, &taus) else {
            continue;
        };
        excitation = Some(cycle.origin);
        let points = taus.iter().copied().zip(cycle.motion).collect();
        let colour = Colour::Series(index);
        curves.push(Curve {
            name: (*name).to_owned(),
            colour,
            stroke: Stroke::Solid,
            pieces: vec![points],
        });
        let every: Vec<f64> = taus.iter().copied().step_by(4).collect();
        if let Some(points) = marks(scene, (r, beta), *of, cycle.origin, &every) {
            let name = "simulation".to_owned();
            curves.push(Curve {
                name,
                colour,
                stroke: Stroke::Circles,
                pieces: vec![points],
            });
        }
    }
    if let Some(origin) = excitation {
        curves.push(Curve {
            name: "excitation".to_owned(),
            colour: Colour::Black,
            stroke: Stroke::Dashed,
            pieces: vec![
                taus.iter()
                    .map(|tau| (*tau, (tau + origin).cos()))
                    .collect(),
            ],
        });
    }
    Panel {
        title: title.to_owned(),
        x: Axis::new("τ", 0.0, span),
        y,
        curves,
    }
}

/// The simulated motion at some τ, which are the excitation's angles less `origin`.
fn marks(
    scene: &dyn Scene,
    (r, beta): (f64, f64),
    of: Of,
    origin: f64,
    taus: &[f64],
) -> Option<Vec<(f64, f64)>> {
    let first = origin.rem_euclid(TAU);
    let angles: Vec<f64> = taus.iter().map(|tau| tau + first).collect();
    let motion = scene.run(r, beta, of, &angles)?;
    Some(taus.iter().copied().zip(motion).collect())
}

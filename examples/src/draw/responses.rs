//! Responses of one system over the frequency ratio for several friction ratios.

use super::colours::beta_colour;
use super::limit::at_limit;
use super::simulated::simulated;
use super::stuck::stuck;
use frictiongen::study::curve::{
    Curve, CurveError, CurvePiece, CurvePoint, CurveRequest, PieceEnd,
};
use frictiongen::{Of, Regime, System};
use frictiongen_plot::desk::{self, Drawn, Reading, Scales};
use frictiongen_plot::{Colour, Layer, Line, Marker, Markers, Panel, Point};

/// Lowest frequency ratio at which the response at β_lim is drawn. Below it the peaks are too close together.
const LOWEST_LIMIT: f64 = 0.2;

/// Largest amplitude that is computed, unless the caller gives another limit. Larger amplitudes occur only near an
/// infinite resonance.
const LARGEST: f64 = 200.0;

/// Responses of one system over the frequency ratio r, one curve for each of several friction ratios β.
#[derive(Clone, Debug)]
pub struct Responses<'a> {
    system: &'a System,
    range: (f64, f64),
    of: Vec<Of>,
    curves: Vec<Curve>,
    continuous: bool,
}

impl<'a> Responses<'a> {
    /// Computes the responses of masses or of the contact over a range of frequency ratios, in all regimes.
    ///
    /// # Errors
    /// Fails if the curves cannot be computed.
    pub fn new(
        system: &'a System,
        range: (f64, f64),
        betas: &[f64],
        of: &[Of],
    ) -> Result<Self, CurveError> {
        Self::up_to(LARGEST, 2e-4, system, range, betas, of)
    }

    /// Computes the responses with amplitudes up to `largest`. `accuracy` is the relative accuracy of each curve.
    ///
    /// # Errors
    /// Fails if the curves cannot be computed.
    pub fn up_to(
        largest: f64,
        accuracy: f64,
        system: &'a System,
        range: (f64, f64),
        betas: &[f64],
        of: &[Of],
    ) -> Result<Self, CurveError> {
        let request = CurveRequest {
            harmonics: vec![1],
            accuracy,
            turned: system.contact_is_reversed(),
            ..CurveRequest::new(range.0, range.1, of)
        };
        let curve = |beta: &f64| {
            let mut curve = system.curve(&request, *beta)?;
            for piece in &mut curve.pieces {
                piece.points.retain(|point| {
                    let mut parts = point.movements.iter();
                    parts.all(|part| part.swing.amplitude < largest)
                });
            }
            curve.pieces = curve.pieces.iter().flat_map(settled).collect();
            Ok(curve)
        };
        let curves = betas.iter().map(curve);
        Ok(Self {
            system,
            range,
            of: of.to_vec(),
            curves: curves.collect::<Result<_, _>>()?,
            continuous: false,
        })
    }

    /// Returns the responses with their points of continuous motion only.
    #[must_use]
    pub fn continuous(mut self) -> Self {
        for curve in &mut self.curves {
            let continuous =
                |piece: &frictiongen::study::curve::CurvePiece| piece.regime == Regime::Continuous;
            curve.pieces.retain(continuous);
        }
        self.continuous = true;
        self
    }

    /// Returns the responses without their points of stick-slip motion.
    #[must_use]
    pub fn sliding_or_stuck(mut self) -> Self {
        for curve in &mut self.curves {
            curve
                .pieces
                .retain(|piece| piece.regime != Regime::StickSlip);
        }
        self
    }

    /// Returns the response with the contact stuck as a line over the same range of frequency ratios. `part` is the
    /// index of the motion.
    #[must_use]
    pub fn stuck(&self, part: usize, reading: Reading) -> Line {
        let of = self.of.get(part).copied().unwrap_or(Of::Contact);
        stuck(self.system, self.range, of, reading)
    }

    /// Returns the response curves, in the order of the friction ratios.
    #[must_use]
    pub fn curves(&self) -> &[Curve] {
        &self.curves
    }

    /// Returns a panel with amplitude or phase of one motion over the frequency ratio. It begins at r = 0 if the
    /// curves begin near 0. Without a given range the vertical axis is fitted to the curves.
    #[must_use]
    pub fn panel(
        &self,
        title: &str,
        part: usize,
        reading: Reading,
        y: (&str, Option<(f64, f64)>),
    ) -> Panel {
        let scales = Scales::groups(self.system);
        // The stuck response does not depend on β, so it is drawn once, in black.
        let sliding: Vec<Curve> = self
            .curves
            .iter()
            .map(|curve| only_regimes(curve, false))
            .collect();
        let drawn: Vec<Drawn<'_>> = sliding
            .iter()
            .map(|curve| Drawn {
                curve,
                name: format!("*β* = {}", curve.beta).into(),
                colour: beta_colour(curve.beta),
            })
            .collect();
        let mut panel = desk::panel(title, &drawn, part, reading, &scales);
        panel.x.low = if self.range.0 < 0.3 {
            0.0
        } else {
            self.range.0
        };
        panel.x.high = self.range.1;
        panel.y.label = y.0.into();
        if let Some((low, high)) = y.1 {
            (panel.y.low, panel.y.high) = (low, high);
        }
        let stuck = self.curves.last().map(|curve| only_regimes(curve, true));
        if let Some(curve) = &stuck {
            let drawn = Drawn {
                curve,
                name: "stuck".into(),
                colour: Colour::Black,
            };
            panel
                .layers
                .extend(desk::lines(&drawn, part, reading, &scales));
        }
        panel
    }

    /// Returns a panel with the amplitude of a motion over the frequency ratio. `top` is the upper end of its axis.
    #[must_use]
    pub fn amplitude(&self, title: &str, part: usize, label: &str, top: f64) -> Panel {
        self.panel(title, part, Reading::Amplitude, (label, Some((0.0, top))))
    }

    /// Returns a panel with the phase of a motion over the frequency ratio, in degrees.
    #[must_use]
    pub fn phase(&self, title: &str, part: usize, label: &str, ends: (f64, f64)) -> Panel {
        let panel = self.panel(title, part, Reading::Phase, (label, Some(ends)));
        Panel {
            y: panel.y.degrees(),
            ..panel
        }
    }

    /// Returns the response at the limit of continuous motion, β = β_lim, as a line.
    #[must_use]
    pub fn limit(&self, part: usize, reading: Reading) -> Line {
        let range = (self.range.0.max(LOWEST_LIMIT), self.range.1);
        let of = self.of.get(part).copied().unwrap_or(Of::Contact);
        at_limit(self.system, range, of, reading)
    }

    /// Returns open circles that show simulations from rest, at frequency ratios with the distance `step`.
    #[must_use]
    pub fn simulation(&self, step: f64, part: usize, reading: Reading) -> Vec<Layer> {
        let of = self.of.get(part).copied().unwrap_or(Of::Contact);
        let count = ((self.range.1 - self.range.0) / step).floor() as usize;
        // Without friction the simulation does not settle.
        let rubbing = self.curves.iter().filter(|curve| 0.0 < curve.beta);
        rubbing
            .map(|curve| {
                // The frequencies are not round numbers, so that no marker lies on a resonance.
                let place = |i: usize| self.range.0 + (i as f64 + 0.37) * step;
                let points = (0..count).filter_map(|i| self.marker(place(i), curve, of, reading));
                let colour = beta_colour(curve.beta);
                Markers::unnamed(colour, Marker::Circle, points.collect()).into()
            })
            .collect()
    }

    fn marker(&self, r: f64, curve: &Curve, of: Of, reading: Reading) -> Option<Point> {
        let limits = self.system.at(r).ok()?.limits();
        let shown =
            curve.beta < limits.sliding && (!self.continuous || curve.beta < limits.continuous);
        if !shown {
            return None;
        }
        let polar = *simulated(self.system, (r, curve.beta), &[of], reading)?.first()?;
        Some(match reading {
            reading if !reading.is_phase() => (r, polar.amplitude),
            _ => (r, desk::principal(polar.lag.to_degrees())),
        })
    }
}

/// Splits a piece of a curve into pieces of steady states. Motions that have not settled are left out.
fn settled(piece: &CurvePiece) -> Vec<CurvePiece> {
    let runs = piece.points.split(|point| !point.settled);
    let runs: Vec<_> = runs.filter(|run| !run.is_empty()).collect();
    let last = runs.len().saturating_sub(1);
    let part = |(index, run): (usize, &&[CurvePoint])| CurvePiece {
        regime: piece.regime,
        points: run.to_vec(),
        start: if index == 0 {
            piece.start
        } else {
            PieceEnd::NoAnswer
        },
        end: if index == last {
            piece.end
        } else {
            PieceEnd::NoAnswer
        },
    };
    runs.iter().enumerate().map(part).collect()
}

/// Returns the pieces of a curve in the stuck regime if `stuck` is true, and otherwise the pieces in all other regimes.
#[must_use]
pub fn only_regimes(curve: &Curve, stuck: bool) -> Curve {
    let pieces = curve.pieces.iter();
    Curve {
        pieces: pieces
            .filter(|piece| (piece.regime == Regime::Stuck) == stuck)
            .cloned()
            .collect(),
        gaps: Vec::new(),
        ..curve.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::Responses;
    use crate::draw::{block, chain};
    use frictiongen::Of;
    use frictiongen_plot::Layer;

    #[test]
    fn a_pole_parts_a_curve_once_and_turns_the_phase() {
        // One frequency of the first grid lies on the resonance.
        let system = block("wall", "block", "");
        let responses =
            Responses::new(&system, (0.1, 2.5), &[0.0], &[Of::Mass(0)]).expect("a range");
        assert_eq!(responses.curves()[0].pieces.len(), 2);
        let panel = responses.phase("", 0, "", (-45.0, 190.0));
        let Some(Layer::Line(line)) = panel.layers.first() else {
            panic!("{panel:?}");
        };
        let ends: Vec<(f64, f64)> = line
            .pieces
            .iter()
            .map(|piece| (piece[0].1, piece.last().expect("points").1))
            .collect();
        assert_eq!(ends, [(0.0, 0.0), (180.0, 180.0)]);
    }

    #[test]
    fn what_a_stuck_contact_cuts_off_costs_no_points() {
        let system = chain(&[1.0; 5], &[1.0; 5], "m3 - wall", "m1", "");
        let of: Vec<Of> = (0..5).map(Of::Mass).collect();
        let responses = Responses::up_to(1e4, 1e-3, &system, (1.35, 1.5), &[2.0], &of);
        let responses = responses.expect("a curve");
        let pieces = responses.curves().iter().flat_map(|curve| &curve.pieces);
        let points: usize = pieces.map(|piece| piece.points.len()).sum();
        assert!(points < 5000, "{points}");
    }
}

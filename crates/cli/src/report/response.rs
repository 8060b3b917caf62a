//! Computes and draws amplitudes and phases over frequency, at several frictions and with the contact stuck.

use super::asked::ReportRequest;
use super::found::{FoundMotion, STUCK, at_once, found, line_styles};
use super::plot::{Axes, HorizontalAxis, Plot, PlotCurve};
use super::words::{PageUnits, object};

use crate::failure::Failure;
use crate::features::draw::marks;
use crate::measure::PhysicalQuantity;
use frictiongen::study::columns::FeatureLine;
use frictiongen::study::{
    curve::{Curve, CurveRequest, PieceEnd},
    words,
};
use frictiongen::{Of, Regime};
use frictiongen_plot::desk::{Drawn, Reading, keys_of, lines, phase_ends};
use frictiongen_plot::{Axis, Colour, Figure, Label, Layer, Markers, Panel};
use maud::{Markup, html};
use serde_json::{Value as Json, json};

/// Number of rows of the table of responses.
const ROWS: usize = 31;
/// Largest number of frequency ranges that the page lists in words. Each range has one regime.
const MOST_STRETCHES: usize = 6;
/// Bound on the work of one curve, in units of about 10 µs. A page has up to eight curves.
const WORK: usize = 60_000;
/// Smallest lower end of an amplitude axis, as a fraction of the largest amplitude. The axis therefore shows about four
/// decades at most.
const DECADES: f64 = 1e-4;

/// A response curve over frequency at one friction, with the name of the curve.
struct FrictionCurve {
    name: String,
    beta: f64,
    colour: Colour,
    curve: Curve,
}

/// Contents of the section about amplitudes and phases.
pub struct Responses {
    levels: Vec<FrictionCurve>,
    /// Rows of the table. Each row has a frequency ratio r and, for each friction, a list with the motion of each
    /// contact or mass.
    rows: Vec<(f64, Vec<Vec<FoundMotion>>)>,
}

impl Responses {
    /// Computes the curves at the given frictions.
    pub fn of(
        asked: &ReportRequest,
        frictions: &[f64],
        best: Option<f64>,
    ) -> Result<Self, Failure> {
        let words = &asked.words;
        let of: Vec<Of> = asked.parts.iter().map(|part| part.of).collect();
        let request = CurveRequest {
            accuracy: accuracy(asked.system.scene().masses.len()),
            turned: words.measure.turns_contact(),
            work: WORK,
            ..CurveRequest::new(asked.band.from, asked.band.to, &of)
        };
        let symbol = if words.measure.scale().is_some() {
            "F = "
        } else {
            ""
        };
        let mut named = vec![(0.0, "no friction".to_owned(), Colour::Grey)];
        for (index, beta) in frictions
            .iter()
            .enumerate()
            .filter(|(_, beta)| **beta > 0.0)
        {
            let mark = if best == Some(*beta) {
                ", the best"
            } else {
                ""
            };
            let name = format!("{symbol}{}{mark}", words.friction(*beta));
            named.push((*beta, name, Colour::Series(index)));
        }
        named.push((STUCK, "contact stuck".to_owned(), Colour::Black));
        let levels = at_once(named, |(beta, name, colour)| {
            let mut curve = asked.system.curve(&request, beta).map_err(Failure::new)?;
            if beta == STUCK {
                curve.pieces.retain(|piece| piece.regime == Regime::Stuck);
            }
            Ok(FrictionCurve {
                name,
                beta,
                colour,
                curve,
            })
        });
        let levels = levels.into_iter().collect::<Result<Vec<_>, Failure>>()?;
        let cells = |r: f64, level: &FrictionCurve| -> Vec<FoundMotion> {
            of.iter()
                .map(|of| found(asked, r, level.beta, *of))
                .collect()
        };
        let rows = asked
            .even(ROWS)
            .map(|r| (r, levels.iter().map(|level| cells(r, level)).collect()));
        let rows = rows.collect();
        Ok(Self { levels, rows })
    }

    /// Returns the regimes along a curve, each with its lowest and highest frequency ratio r. Returns `None` if the
    /// curve has more such ranges than the page can list. If `elastic` is true, the words are for an elastic contact.
    pub fn stretches(&self, beta: f64, elastic: bool) -> Option<Vec<(&'static str, f64, f64)>> {
        let level = self.levels.iter().find(|level| level.beta == beta)?;
        let mut found: Vec<(&'static str, f64, f64)> = Vec::new();
        for piece in &level.curve.pieces {
            let (Some(first), Some(last)) = (piece.points.first(), piece.points.last()) else {
                continue;
            };
            let does = match piece.regime {
                Regime::Continuous => "slides all the time",
                Regime::Stuck => "is stuck",
                _ if elastic => "sticks and slides",
                _ => "stops and slides",
            };
            match found.last_mut() {
                Some((same, _, end)) if *same == does => *end = last.r,
                _ => found.push((does, first.r, last.r)),
            }
        }
        (1..=MOST_STRETCHES).contains(&found.len()).then_some(found)
    }

    /// Returns one picture for each motion, on which the features are marked.
    pub fn plots(&self, asked: &ReportRequest, features: &[FeatureLine]) -> Vec<Plot> {
        let parts = asked.parts.iter().enumerate();
        parts
            .map(|(index, part)| {
                let marked = marks(features, part, &asked.words.measure, &asked.words.scales);
                self.plot(index, &part.name, asked, marked)
            })
            .collect()
    }

    fn plot(&self, part: usize, name: &str, asked: &ReportRequest, marked: Vec<Markers>) -> Plot {
        let words = &asked.words;
        let scales = &words.scales;
        let (from, to) = (
            scales.frequency(asked.band.from),
            scales.frequency(asked.band.to),
        );
        let across = || Axis::new(scales.frequency_label(), from, to);
        let (low, high) = self.ends(part, words);
        let upper = Axis::log(scales.length_label(), low, high);
        let mut panels = [
            Panel::new("", across(), upper),
            Panel::new(
                "",
                across(),
                Axis::new("phase *φ* (degrees)", 0.0, 180.0).degrees(),
            ),
        ];
        let mut series = [Vec::new(), Vec::new()];
        let readings = [Reading::Amplitude, Reading::Phase];
        for ((panel, series), reading) in panels.iter_mut().zip(&mut series).zip(readings) {
            for level in &self.levels {
                let label = Label::verbatim(&level.name);
                let drawn = Drawn {
                    curve: &level.curve,
                    name: label.clone(),
                    colour: level.colour,
                };
                let layers = lines(&drawn, part, reading, scales);
                series.push(PlotCurve::of(&label, level.colour, &layers, true));
                panel.layers.extend(layers);
            }
        }
        let [amplitude, phase] = &mut panels;
        amplitude.layers.extend(marked.into_iter().map(Layer::from));
        (phase.y.low, phase.y.high) = turns(&phase.layers);
        let [amplitudes, phases] = series;
        let keys = keys_of(self.levels.iter().map(|level| &level.curve));
        let figure = Figure::new("", Label::verbatim(name), 1, panels.to_vec()).with_keys(keys);
        let curves = [
            (
                Axes {
                    quantity: "amplitude",
                    unit: words.length_unit(),
                },
                amplitudes,
            ),
            (
                Axes {
                    quantity: "phase",
                    unit: "°",
                },
                phases,
            ),
        ];
        let title = format!("Amplitude and phase of {name} over frequency");
        let across = HorizontalAxis {
            name: if words.in_hertz {
                "frequency"
            } else {
                "frequency ratio"
            },
            unit: if words.in_hertz { "Hz" } else { "" },
        };
        Plot::new(
            &format!("response-{name}"),
            &title,
            figure,
            &across,
            &curves,
            Json::Null,
        )
    }

    /// Returns the lower and the upper end of the amplitude axis for a motion. The upper end is 1.3 times the largest
    /// amplitude. For a curve with a pole, at most three times the largest amplitude in the table counts. The lower end
    /// is the smallest amplitude, but at least 1e-4 and at most 0.1 times the largest amplitude.
    fn ends(&self, part: usize, words: &PageUnits) -> (f64, f64) {
        let sizes = |level: &FrictionCurve| -> Vec<f64> {
            let points = level.curve.pieces.iter().flat_map(|piece| &piece.points);
            let size = points.filter_map(|point| Some(point.movements.get(part)?.swing.amplitude));
            size.filter(|size| size.is_finite() && 0.0 < *size)
                .collect()
        };
        let unbounded = |level: &FrictionCurve| {
            let mut pieces = level.curve.pieces.iter();
            pieces.any(|piece| piece.start == PieceEnd::Pole || piece.end == PieceEnd::Pole)
        };
        let on_grid = |index: usize| {
            let cells = self
                .rows
                .iter()
                .filter_map(move |(_, cells)| cells.get(index)?.get(part));
            let sizes = cells.filter_map(|found| Some(found.as_ref().ok()?.1.amplitude));
            3.0 * sizes.fold(0.0, f64::max)
        };
        let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
        for (index, level) in self.levels.iter().enumerate() {
            let sizes = sizes(level);
            let most = sizes.iter().copied().fold(0.0, f64::max);
            let shown = if unbounded(level) {
                most.min(on_grid(index))
            } else {
                most
            };
            high = high.max(shown);
            low = sizes.into_iter().fold(low, f64::min);
        }
        let high = words.scales.length(if 0.0 < high { high } else { 1.0 });
        let low = words.scales.length(if low.is_finite() { low } else { 1.0 });
        (low.max(DECADES * high).min(0.1 * high), 1.3 * high)
    }

    /// Returns the section about amplitudes and phases as HTML.
    pub fn html(&self, plots: &[Plot], asked: &ReportRequest) -> Markup {
        let words = &asked.words;
        html! {
            section #responses {
                h2 { "Amplitudes and phases" }
                p {
                    "The steady response from " (words.frequency(asked.band.from)) " to " (words.frequency(asked.band.to)) ". " (line_styles(asked.is_elastic())) " \
                     Where a line changes its style, the friction is equal to a limit. An amplitude is the largest displacement of a cycle. \
                     A phase is the lag of that maximum behind the maximum of the load."
                    @if asked.parts.iter().any(|part| part.of == Of::Contact) {
                        " “contact” is the relative motion in the contact."
                    }
                }
                div.plots { @for plot in plots { (plot.html()) } }
                h3 { "The largest amplitudes" }
                (self.peaks(asked))
                @for (index, part) in asked.parts.iter().enumerate() {
                    details {
                        summary { "Values: " (part.name) }
                        (self.table(index, asked))
                    }
                }
            }
        }
    }

    /// Returns the largest amplitude of a motion on a curve, with its frequency ratio r and its regime.
    fn peak(level: &FrictionCurve, part: usize) -> Option<(f64, f64, Regime)> {
        let points = level.curve.pieces.iter().flat_map(|piece| &piece.points);
        let sizes = points.filter_map(|point| {
            let size = point.movements.get(part)?.swing.amplitude;
            Some((size, point.r, point.regime))
        });
        sizes.max_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn pole(level: &FrictionCurve) -> bool {
        let mut pieces = level.curve.pieces.iter();
        pieces.any(|piece| piece.start == PieceEnd::Pole || piece.end == PieceEnd::Pole)
    }

    fn peaks(&self, asked: &ReportRequest) -> Markup {
        let words = &asked.words;
        html! {
            div.scroll tabindex="0" role="region" aria-label="The largest amplitudes" {
                table {
                    thead { tr {
                        th scope="col" { "friction" }
                        @for part in &asked.parts { th scope="col" { (part.name) } }
                    } }
                    tbody { @for level in &self.levels { tr {
                        th scope="row" { (level.name) }
                        @for index in 0..asked.parts.len() {
                            td { @match Self::peak(level, index) {
                                None => "no answer",
                                Some((size, ..)) if size == 0.0 => "at rest",
                                Some(_) if Self::pole(level) => "unbounded",
                                Some((size, r, regime)) => {
                                    (words.length(size)) " at " (words.frequency(r))
                                    @if level.beta > 0.0 && level.beta < STUCK { " (" (words::regime(regime)) ")" }
                                }
                            } }
                        }
                    } } }
                }
            }
        }
    }

    fn table(&self, part: usize, asked: &ReportRequest) -> Markup {
        let words = &asked.words;
        html! {
            div.scroll tabindex="0" role="region" aria-label="Values over frequency" {
                table {
                    thead { tr {
                        th scope="col" { (words.frequency_title()) }
                        @for level in &self.levels { th scope="col" { (level.name) } }
                    } }
                    tbody { @for (r, cells) in &self.rows { tr {
                        th scope="row" { (words.frequency(*r)) }
                        @for cell in cells.iter().filter_map(|cell| cell.get(part)) {
                            td { @match cell {
                                Err(error) => (words::no_answer(*error)),
                                Ok((_, swing)) => {
                                    (words.length(swing.amplitude))
                                    @if let Some(phase) = swing.phase { ", " (PageUnits::angle(phase)) }
                                }
                            } }
                        }
                    } } }
                }
            }
        }
    }

    /// Returns the table and the peaks of the curves as JSON data.
    pub fn data(&self, asked: &ReportRequest) -> Json {
        let words = &asked.words;
        let cell = |found: &FoundMotion| match found {
            Err(error) => json!({ "none": words::no_answer(*error) }),
            Ok((regime, swing)) => {
                let phase = words.measure.name("phase", PhysicalQuantity::Angle);
                let lag = swing.phase.map(|phase| words.measure.angle(phase));
                object([
                    words.length_json(swing.amplitude),
                    (phase, lag.map_or(Json::Null, Json::from)),
                    ("regime".to_owned(), words::regime(*regime).into()),
                ])
            }
        };
        let levels = self.levels.iter().enumerate().map(|(index, level)| {
            let rows = self.rows.iter().map(|(r, cells)| {
                let mut fields: Vec<(String, Json)> = Vec::new();
                for (name, value) in words.frequency_json(&asked.system, *r) {
                    fields.push((name.to_owned(), value));
                }
                let cells = cells.get(index).into_iter().flatten();
                let cells = asked.parts.iter().zip(cells);
                fields.extend(cells.map(|(part, found)| (part.name.clone(), cell(found))));
                object(fields)
            });
            let mut fields: Vec<(&str, Json)> = vec![("name", level.name.as_str().into())];
            if level.beta < STUCK {
                fields.extend(words.friction_json(level.beta));
            }
            fields.push(("points", rows.collect()));
            object(fields)
        });
        levels.collect()
    }
}

/// Returns the accuracy of a curve, which is the largest relative deviation of straight lines through its points. The
/// accuracy is coarser for more masses, because the steady states of long chains take longer.
fn accuracy(masses: usize) -> f64 {
    match masses {
        0..=4 => 5e-4,
        5..=16 => 2e-3,
        _ => 1e-2,
    }
}

/// Returns the lower and the upper end of a phase axis, in degrees.
fn turns(layers: &[Layer]) -> (f64, f64) {
    let lines = layers.iter().filter_map(|layer| match layer {
        Layer::Line(line) => Some(line.pieces.iter().flatten()),
        _ => None,
    });
    phase_ends(lines.flatten().map(|point| point.1))
}

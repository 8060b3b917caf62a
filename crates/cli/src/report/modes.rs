//! Section of the report about the modes: frequencies, damping, shapes, and participation of load and contact.

use super::asked::ReportRequest;
use super::plot::{Axes, HorizontalAxis, Plot, PlotCurve};
use super::words::{PageUnits, digits, number};
use frictiongen_plot::{
    Across as At, Axis, Colour, Figure, Guide, Label, Line, Marker, Markers, Panel, Stroke,
};
use maud::{Markup, html};
use serde_json::{Value as Json, json};

/// Largest number of modes in the picture. A reader could not distinguish the colours of more modes.
const MOST_DRAWN: usize = 5;
/// Largest number of modes in the table. The JSON data contain all modes.
const MOST_LISTED: usize = 16;
/// Largest participation that the table shows as zero, as a fraction of the largest participation of all modes.
const NONE: f64 = 1e-12;

/// A vibration mode of the chain, with the numbers that the page shows.
struct ModeRow {
    r: f64,
    hertz: f64,
    zeta: f64,
    /// Displacement of each mass in the mode, scaled so that the largest displacement is 1.
    shape: Vec<f64>,
    load: f64,
    contact: f64,
    threshold: Option<f64>,
}

/// Contents of the section about modes.
pub struct ModeSection(Vec<ModeRow>);

impl ModeSection {
    /// Collects the modes of a system.
    pub fn of(asked: &ReportRequest) -> Self {
        let system = &asked.system;
        let modal = system.modal();
        let zeta = modal.damping_ratios.iter().map(|zeta| zeta.hi);
        let thresholds = system.resonance_thresholds();
        let parts = modal.loads.iter().zip(&modal.contacts);
        let parts = parts.map(|(load, contact)| (load.hi, contact.hi));
        let modes = system
            .resonances()
            .iter()
            .zip(zeta)
            .zip(system.mode_shapes());
        let modes = modes.zip(parts).zip(thresholds);
        Self(
            modes
                .map(
                    |((((r, zeta), shape), (load, contact)), threshold)| ModeRow {
                        r: *r,
                        hertz: system.hertz(*r),
                        zeta,
                        shape: normalised(&shape),
                        load,
                        contact,
                        threshold,
                    },
                )
                .collect(),
        )
    }

    /// Returns the resonance frequencies as text.
    pub fn resonances(&self, words: &PageUnits) -> Vec<String> {
        self.0.iter().map(|mode| words.frequency(mode.r)).collect()
    }

    /// Returns the picture of the chain's mode shapes.
    pub fn plot(&self, asked: &ReportRequest) -> Plot {
        let masses = asked.system.scene().masses.len();
        let x = Axis::new(
            "mass, in the order of the description",
            0.5,
            masses as f64 + 0.5,
        );
        let y = Axis::new("displacement over the largest", -1.1, 1.1);
        let mut panel = Panel::new("", x, y).with(Guide::new(At::Y(0.0)));
        let mut series = Vec::new();
        for (index, mode) in self.0.iter().take(MOST_DRAWN).enumerate() {
            let points: Vec<(f64, f64)> = (1..)
                .map(f64::from)
                .zip(mode.shape.iter().copied())
                .collect();
            let name = Label::verbatim(&format!(
                "mode {}, {}",
                index + 1,
                asked.words.frequency(mode.r)
            ));
            let colour = Colour::Series(index);
            let line = Line::new(name.clone(), colour, Stroke::Solid, vec![points.clone()]);
            series.push(PlotCurve::of(&name, colour, &[line.clone().into()], false));
            panel = panel
                .with(line)
                .with(Markers::unnamed(colour, Marker::Dot, points));
        }
        let across = HorizontalAxis {
            name: "mass",
            unit: "",
        };
        let axes = Axes {
            quantity: "displacement",
            unit: "",
        };
        let names: Vec<&str> = asked
            .system
            .scene()
            .masses
            .iter()
            .map(|mass| mass.name.as_str())
            .collect();
        let more = json!({ "steps": names });
        let figure = Figure::new("", "", 1, vec![panel]);
        Plot::new(
            "modes",
            "Mode shapes",
            figure,
            &across,
            &[(axes, series)],
            more,
        )
    }

    /// Returns the section about modes as HTML.
    pub fn html(&self, plot: &Plot, asked: &ReportRequest) -> Markup {
        let scene = asked.system.scene();
        let words = &asked.words;
        let listed = self.0.iter().take(MOST_LISTED).enumerate();
        let largest = |read: fn(&ModeRow) -> f64| {
            self.0
                .iter()
                .map(|mode| read(mode).abs())
                .fold(0.0, f64::max)
        };
        let (loads, contacts) = (largest(|mode| mode.load), largest(|mode| mode.contact));
        let share = |value: f64, most: f64| {
            if value.abs() <= NONE * most {
                "none".to_owned()
            } else {
                digits(value)
            }
        };
        let undamped = self.0.iter().any(|mode| mode.zeta == 0.0);
        html! {
            section #modes {
                h2 { "Modes without friction" }
                p {
                    "The table has the frequencies, the damping and the shapes of the chain without friction. The columns load and contact show how \
                     strongly each acts on a mode. Where the contact does not act on a mode, it does not damp that mode."
                    @if undamped {
                        " A mode without damping that the load drives is bounded at its resonance only by friction above its threshold."
                    }
                    @if self.0.len() > MOST_LISTED { " The first " (MOST_LISTED) " of " (self.0.len()) " are listed. The data block at the end of this page has all of them." }
                }
                div.scroll tabindex="0" role="region" aria-label="Modes" {
                    table {
                        thead { tr {
                            th scope="col" { "mode" }
                            @if words.in_hertz { th scope="col" { "f (Hz)" } }
                            th scope="col" { "r" }
                            th scope="col" { "damping ratio" }
                            @if scene.masses.len() <= MOST_DRAWN {
                                @for mass in &scene.masses { th scope="col" { (mass.name) } }
                            }
                            th scope="col" { "load" }
                            th scope="col" { "contact" }
                            @if undamped { th scope="col" { "threshold" } }
                        } }
                        tbody { @for (index, mode) in listed { tr {
                            th scope="row" { (index + 1) }
                            @if words.in_hertz { td { (digits(mode.hertz)) } }
                            td { (digits(mode.r)) }
                            td { (digits(mode.zeta)) }
                            @if scene.masses.len() <= MOST_DRAWN {
                                @for part in &mode.shape { td { (digits(*part)) } }
                            }
                            td { (share(mode.load, loads)) }
                            td { (share(mode.contact, contacts)) }
                            @if undamped { td { @match mode.threshold {
                                Some(beta) => (words.friction(beta)),
                                None => "none",
                            } } }
                        } } }
                    }
                }
                div.plots.single { (plot.html()) }
                @if self.0.len() > MOST_DRAWN { p.note { "The lowest " (MOST_DRAWN) " modes are drawn." } }
            }
        }
    }

    /// Returns all modes as JSON data.
    pub fn data(&self) -> Json {
        let modes = self.0.iter().map(|mode| {
            json!({
                "r": number(mode.r),
                "frequency": number(mode.hertz),
                "damping_ratio": number(mode.zeta),
                "shape": mode.shape,
                "load": number(mode.load),
                "contact": number(mode.contact),
                "threshold_beta": mode.threshold.map_or(Json::Null, number),
            })
        });
        modes.collect()
    }
}

/// Scales a mode shape so that its largest displacement is 1, with a positive sign.
fn normalised(shape: &[f64]) -> Vec<f64> {
    let largest =
        shape.iter().copied().fold(
            0.0_f64,
            |most, part| {
                if most.abs() < part.abs() { part } else { most }
            },
        );
    let largest = if largest == 0.0 { 1.0 } else { largest };
    shape.iter().map(|part| part / largest + 0.0).collect()
}

//! Cost and accuracy of the emitted code. The module counts operations in the code, and compares its results with
//! results in double-double precision.

use super::asked::ReportRequest;
use super::words::{digits, number};
use crate::emitted::{self, EmittedFunction};
use frictiongen::System;
use frictiongen::scalar::{Dd, Float};
use frictiongen::study::scene::{Accuracy, Precision, Range, Scene};
use frictiongen_codegen::{SceneTables, SizeLimits, parse_text, pretty};
use maud::{Markup, html};
use serde_json::{Value as Json, json};

/// Largest number of masses for which the command compares results with double-double precision.
const MOST_COMPARED: usize = 16;
/// Number of frequencies at which the command compares the results with double-double precision.
const PLACES: usize = 101;
/// Largest number of masses for which the command builds tables of declared accuracy.
const MOST_TABLED: usize = 4;
/// Largest relative error that the command declares for results from the tables.
const DECLARED: f64 = 1e-4;

/// Number of steps in one period of the highest resonance, for the stepper whose cost the page states.
const STEPS_OF_A_PERIOD: f64 = 20.0;

/// Largest relative differences between results of a solver and the same results in double-double precision.
struct MeasuredErrors {
    precision: &'static str,
    continuous: f64,
    sliding: f64,
    amplitude: f64,
    /// Number of limits and number of amplitudes that the check has compared.
    compared: (usize, usize),
}

/// Costs of the scene's tables, which have a declared accuracy.
struct TableCosts {
    pieces: usize,
    bytes: usize,
    error: f64,
    points: usize,
    comparisons: usize,
    operations: usize,
}

/// Upper bounds on the evaluations, the memory and the operations of the emitted solvers. The numbers of masses and
/// modes determine these bounds.
struct SolverBounds {
    /// Largest number of evaluations of the modal sum in a search for β_lim.
    limit: Option<u32>,
    /// Largest number of evaluations of the modal sum in a search for an amplitude.
    amplitude: u32,
    /// Memory for a steady state with stops, in bytes.
    orbit: usize,
    /// Length of a step of the stepper in s, then the numbers of operations in a step without an event and in a step
    /// with one event. `None` if the stepper does not accept this length.
    step: Option<(f64, u64, u64)>,
}

/// Contents of the section about cost and accuracy.
pub struct CostSection {
    bounds: Option<SolverBounds>,
    functions: Result<Vec<EmittedFunction>, String>,
    measured: Result<Vec<MeasuredErrors>, String>,
    tabled: Result<TableCosts, String>,
    precision: &'static str,
}

impl CostSection {
    /// Computes the contents of the section for the text of a scene description.
    pub fn of(text: &str, asked: &ReportRequest) -> Self {
        let scene = asked.system.scene();
        Self {
            bounds: bounds(asked),
            functions: functions(text),
            measured: measured(text, asked),
            tabled: tabled(asked),
            precision: match scene.precision {
                Precision::F64 => "f64",
                Precision::F32 => "f32",
            },
        }
    }

    /// Returns the section about cost and accuracy as HTML.
    pub fn html(&self) -> Markup {
        html! {
            section #cost {
                h2 { "Cost and accuracy of the emitted code" }
                p {
                    "The macro emits Rust code for this description, in " (self.precision) ", for firmware and real-time use. \
                     The table has the operations of each emitted function, as its documentation counts them. Functions that search also call the library."
                }
                @match &self.functions {
                    Err(reason) => p { (reason) },
                    Ok(all) => div.scroll tabindex="0" role="region" aria-label="Operations of emitted functions" { table {
                        thead { tr { th scope="col" { "function" } th scope="col" { "operations" } } }
                        tbody { @for function in all { tr {
                            th scope="row" { code { (function.name) } @if !function.about.is_empty() { br; small { (function.about) } } }
                            td.words { (function.operations) }
                        } } }
                    } },
                }
                @if let Some(bounds) = &self.bounds { (bounds.html(self.precision)) }
                @match &self.measured {
                    Err(reason) => p { (reason) },
                    Ok(all) => {
                        p {
                            "For this page the same formulas were also computed with about 30 digits. The table has the largest relative differences at "
                            (PLACES) " frequencies of the range. The amplitudes are those of the contact, with half the friction at which it may stop."
                        }
                        div.scroll tabindex="0" role="region" aria-label="Differences" { table {
                            thead { tr {
                                th scope="col" { "computed in" }
                                th scope="col" { "limit of continuous motion" }
                                th scope="col" { "limit of sliding" }
                                th scope="col" { "amplitude" }
                            } }
                            tbody { @for one in all { tr {
                                th scope="row" { (one.precision) }
                                td { (digits(one.continuous)) }
                                td { (digits(one.sliding)) }
                                td { @if one.compared.1 == 0 { "none compared" } @else { (digits(one.amplitude)) } }
                            } } }
                        } }
                    }
                }
                @match &self.tabled {
                    Err(reason) => p { (reason) },
                    Ok(tables) => p {
                        "Tables can replace the formulas. For a declared accuracy of " (digits(DECLARED)) " over this range they have "
                        (tables.bytes) " bytes in " (tables.pieces) " pieces. A lookup takes " (tables.comparisons) @if tables.comparisons == 1 { " comparison" } @else { " comparisons" } ", and then "
                        (tables.operations) " additions and multiplications. The largest error at " (tables.points)
                        " points that the fit did not use is " (digits(tables.error)) "."
                    },
                }
            }
        }
    }

    /// Returns the section about cost and accuracy as JSON data.
    pub fn data(&self) -> Json {
        let none = |reason: &String| json!({ "none": reason });
        let functions = self.functions.as_ref().map_or_else(none, |all| {
            let one = |function: &EmittedFunction| json!({ "name": function.name, "operations": function.operations });
            all.iter().map(one).collect()
        });
        let measured = self.measured.as_ref().map_or_else(none, |all| {
            let one = |one: &MeasuredErrors| {
                json!({
                    "precision": one.precision,
                    "continuous_limit": number(one.continuous),
                    "sliding_limit": number(one.sliding),
                    "contact_amplitude": number(one.amplitude),
                    "limits_compared": one.compared.0,
                    "amplitudes_compared": one.compared.1,
                })
            };
            all.iter().map(one).collect()
        });
        let tabled = self.tabled.as_ref().map_or_else(none, |tables| {
            json!({
                "accuracy": DECLARED,
                "bytes": tables.bytes,
                "pieces": tables.pieces,
                "largest_error": number(tables.error),
                "checked_points": tables.points,
                "comparisons": tables.comparisons,
                "additions_and_multiplications": tables.operations,
            })
        });
        let bounds = self.bounds.as_ref().map(|bounds| {
            json!({
                "evaluations_of_a_limit": bounds.limit,
                "evaluations_of_an_amplitude": bounds.amplitude,
                "bytes_of_a_steady_state": bounds.orbit,
                "step": bounds.step.map(|(seconds, tables, one_event)| json!({
                    "length_s": number(seconds),
                    "operations_by_tables": tables,
                    "operations_with_one_event": one_event,
                })),
            })
        });
        json!({ "precision": self.precision, "bounds": bounds, "functions": functions, "differences": measured, "tables": tabled })
    }
}

impl SolverBounds {
    fn html(&self, precision: &str) -> Markup {
        html! {
            dl.facts {
                @if let Some(limit) = self.limit {
                    div { dt { "a search for the limit of continuous motion, at most" } dd { (limit) " evaluations" } }
                }
                div { dt { "a search for an amplitude, at most" } dd { (self.amplitude) " evaluations" } }
                div { dt { "a steady state with stops, in " (precision) } dd { (self.orbit) " bytes" } }
                @if let Some((seconds, tables, one_event)) = self.step {
                    div { dt { "a step of " (digits(1e3 * seconds)) " ms without an event" } dd { (tables) " operations" } }
                    div { dt { "a step with one event" } dd { (one_event) " operations" } }
                }
            }
            p.note {
                "An evaluation computes the sum over all modes once. At higher frequencies searches need fewer evaluations. A step is a twentieth of \
                 the period of the highest resonance. In the project, docs/firmware.md has the instructions, flash and stack of a few scenes on a \
                 microcontroller, and docs/data/accuracy.csv has the error budget of every function."
            }
        }
    }
}

fn bounds(asked: &ReportRequest) -> Option<SolverBounds> {
    let system = &asked.system;
    let most = system.at(asked.band.from).ok()?.most_evaluations();
    let size = match system.scene().precision {
        Precision::F64 => size_of::<f64>(),
        Precision::F32 => size_of::<f32>(),
    };
    let modes = system.scene().masses.len();
    let touched = system.modal().contacts.iter();
    let touched = touched.filter(|contact| !contact.is_zero()).count();
    let state = 2 * touched + usize::from(asked.is_elastic());
    let highest = system.resonances().last().map(|r| system.hertz(*r));
    let step = highest.and_then(|hertz| {
        let seconds = 1.0 / (STEPS_OF_A_PERIOD * hertz);
        let cost = system.stepper(seconds).ok()?.cost();
        Some((seconds, cost.tables, cost.one_event))
    });
    Some(SolverBounds {
        limit: (!asked.is_elastic()).then_some(most.limit),
        amplitude: most.amplitude,
        orbit: size * frictiongen::kernel::orbit::numbers_of(modes, state),
        step,
    })
}

/// Returns the functions of the emitted code whose documentation states a number of operations.
fn functions(text: &str) -> Result<Vec<EmittedFunction>, String> {
    let description = parse_text(text, &SizeLimits::CHECK).map_err(|_| {
        "The macro does not accept this description; “frictiongen check” lists the errors."
            .to_owned()
    })?;
    let source = pretty(&description)?;
    let found = emitted::functions(&source);
    if found.is_empty() {
        return Err("No emitted function counts its operations.".to_owned());
    }
    Ok(found)
}

fn measured(text: &str, asked: &ReportRequest) -> Result<Vec<MeasuredErrors>, String> {
    if MOST_COMPARED < asked.system.scene().masses.len() {
        return Err(format!(
            "The page does not compare the results of more than {MOST_COMPARED} masses with longer arithmetic."
        ));
    }
    let unread = |_| "The description cannot be read in longer arithmetic.".to_owned();
    let reference: System<Dd> = text.parse().map_err(unread)?;
    let single: System<f32> = text.parse().map_err(unread)?;
    Ok(vec![
        compared("f64", &asked.system, &reference, asked),
        compared("f32", &single, &reference, asked),
    ])
}

/// Returns the largest relative differences between the results of a system and those of a reference in double-double
/// precision.
fn compared<S: Float>(
    precision: &'static str,
    system: &System<S>,
    reference: &System<Dd>,
    asked: &ReportRequest,
) -> MeasuredErrors {
    let mut measured = MeasuredErrors {
        precision,
        continuous: 0.0,
        sliding: 0.0,
        amplitude: 0.0,
        compared: (0, 0),
    };
    for r in asked.even(PLACES) {
        // Both systems get the same number r, which the code rounds only once.
        let own = S::constant(r);
        let (Ok(at), Ok(exact)) = (system.at(own), reference.at(Dd::from(own.to_f64()))) else {
            continue;
        };
        let (found, limits) = (at.limits(), exact.limits());
        let off = |found: S, exact: Dd| {
            let (found, exact) = (found.to_f64(), exact.hi);
            let both = found.is_finite() && exact.is_finite() && exact != 0.0;
            both.then(|| ((found - exact) / exact).abs())
        };
        if let Some(off) = off(found.continuous, limits.continuous) {
            measured.continuous = measured.continuous.max(off);
            measured.compared.0 += 1;
        }
        if let Some(off) = off(found.sliding, limits.sliding) {
            measured.sliding = measured.sliding.max(off);
        }
        let beta = S::constant(0.5 * limits.continuous.hi.min(limits.sliding.hi));
        let (Ok(motion), Ok(exact)) = (at.motion(beta), exact.motion(Dd::from(beta.to_f64())))
        else {
            continue;
        };
        if let Some(off) = off(motion.contact().amplitude(), exact.contact().amplitude()) {
            measured.amplitude = measured.amplitude.max(off);
            measured.compared.1 += 1;
        }
    }
    measured
}

fn tabled(asked: &ReportRequest) -> Result<TableCosts, String> {
    let scene = asked.system.scene();
    if scene.stiffness.is_some() {
        return Err("Tables need a rigid contact.".to_owned());
    }
    if MOST_TABLED < scene.masses.len() {
        return Err(format!(
            "The page does not build tables for chains of more than {MOST_TABLED} masses; “frictiongen compile” builds them."
        ));
    }
    let mut scene: Scene = scene.clone();
    scene.declared.accuracy = Accuracy::Relative(DECLARED);
    scene.declared.budget = None;
    scene.declared.range = Some(Range {
        r: (asked.band.from, asked.band.to),
        beta: (0.0, f64::INFINITY),
    });
    let made = System::<f64>::try_from(scene.clone()).map(drop);
    made.map_err(|_| "Tables cannot be made for this range.".to_owned())?;
    match SceneTables::of(&scene) {
        Err(error) => Err(format!("Tables cannot be made for this range: {error}.")),
        Ok(None) => Err("No tables were made.".to_owned()),
        Ok(Some(SceneTables::Double(tables))) => Ok(figures(&tables)),
        Ok(Some(SceneTables::Single(tables))) => Ok(figures(&tables)),
    }
}

fn figures<S: Float>(tables: &frictiongen::study::table::Tables<S>) -> TableCosts {
    TableCosts {
        pieces: tables.pieces.len(),
        bytes: tables.report.bytes,
        error: tables.report.worst.error,
        points: tables.report.points,
        comparisons: tables.index.halvings as usize,
        operations: tables.additions_and_multiplications(),
    }
}

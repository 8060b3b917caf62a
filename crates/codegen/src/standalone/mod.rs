//! Writes tables as code without dependencies: a Rust file, or C99.
//!
//! The Rust file and the C file perform the kernel's operations in the kernel's order, so that their results have the
//! same bits as the kernel's results. Only the arc tangent of a phase may differ. It is a function of the platform, or
//! of the file itself in Rust without std.

mod c;
mod checksum;
mod constants;
mod formulas;
mod known;
mod origin;
mod products;
mod rust;
mod stepping;
mod stuck;
mod units;

pub use c::{c_header, c_name, c_source, c_tables, c_tables_name};
pub use known::known_answers;
pub use origin::{NOTICE, Origin, c_text, scene_hash};
pub use rust::rust_source;
pub use stepping::{StepperShape, StepperSizes};

pub use crate::units::UnitConstants;

use crate::emit::motion_in_contact;
use checksum::about_table;
use constants::{ConstantForm, FileConstants};
use frictiongen_kernel::Float;
use frictiongen_model::scene::{Excitation, Provide, Scene};
use frictiongen_model::table::{Evidence, FINEST_PROVEN, MOST_SHARE, Proof, ProofWork, Tables};

/// A scene with its tables and with their origin.
#[derive(Clone, Copy, Debug)]
pub struct Source<'a, S> {
    /// The scene whose tables the file contains.
    pub scene: &'a Scene,
    /// The tables of the scene.
    pub tables: &'a Tables<S>,
    /// The text of the description, and the command.
    pub origin: Origin<'a>,
}

/// The language of the written file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Language {
    C,
    Rust,
}

/// Format of numbers in the target language.
#[derive(Clone, Copy)]
struct NumberFormat {
    language: Language,
    /// True if the numbers of the file are `f32`.
    single: bool,
    /// The type of numbers in the language of the file.
    real: &'static str,
}

impl NumberFormat {
    /// Returns the number format of a scalar type.
    fn of<S: Float>(language: Language) -> Self {
        let single = S::EPSILON > f64::EPSILON;
        Self {
            language,
            single,
            real: match (language, single) {
                (Language::C, true) => "float",
                (Language::C, false) => "double",
                (Language::Rust, true) => "f32",
                (Language::Rust, false) => "f64",
            },
        }
    }

    /// Returns the suffix of mathematical functions in C.
    fn letter(self) -> &'static str {
        if self.single { "f" } else { "" }
    }

    #[allow(clippy::cast_possible_truncation, reason = "it is an f32")]
    fn write(self, value: f64) -> String {
        // The sign of a zero has no effect on any answer.
        let value = value + 0.0;
        match (self.single, self.language) {
            (true, Language::C) => format!("{:?}f", value as f32),
            (true, Language::Rust) => format!("{:?}", value as f32),
            (false, _) => format!("{value:?}"),
        }
    }

    fn list(self, values: impl IntoIterator<Item = f64>) -> String {
        let values: Vec<String> = values.into_iter().map(|value| self.write(value)).collect();
        values.join(", ")
    }
}

/// Writes a list of indices in lines of at most 96 characters.
fn wrapped(places: &[usize]) -> String {
    let mut lines = vec![String::new()];
    for place in places {
        let word = format!("{place}, ");
        if lines
            .last()
            .is_some_and(|line| line.len() + word.len() > 96)
        {
            lines.push(String::new());
        }
        if let Some(line) = lines.last_mut() {
            line.push_str(&word);
        }
    }
    let lines: Vec<&str> = lines.iter().map(|line| line.trim_end()).collect();
    lines.join("\n    ")
}

/// Returns the items of `provide` for which the emitted C and Rust files have no functions.
#[must_use]
pub fn left_out(scene: &Scene) -> Vec<String> {
    let word = |item: &Provide| match item {
        Provide::Motion(Some(masses)) if !masses.is_empty() => {
            let names = masses.iter().filter_map(|mass| scene.masses.get(*mass));
            let names: Vec<&str> = names.map(|mass| mass.name.as_str()).collect();
            Some(format!("motion({})", names.join(", ")))
        }
        Provide::Orbit => Some("orbit".to_owned()),
        Provide::Simulation => Some("simulation".to_owned()),
        Provide::Stepper => Some("stepper".to_owned()),
        // The files always contain a self-check.
        Provide::Limits | Provide::Motion(_) | Provide::Stuck | Provide::SelfCheck => None,
    };
    scene.provide.iter().filter_map(word).collect()
}

/// Returns lines of text that describe the tables and their largest error.
fn about<S: Float>(source: &Source<'_, S>) -> Vec<String> {
    let Source { scene, tables, .. } = *source;
    let (low, high) = tables.request.r;
    let report = &tables.report;
    let piece = (2 + tables.functions * tables.terms) * core::mem::size_of::<S>();
    let checked = if tables.moves() {
        "`beta_lim`, amplitude and phase"
    } else {
        "`beta_lim`"
    };
    let mut about = vec![
        THESIS.to_owned(),
        format!(
            "The tables cover r from {low} to {high}.  Their largest allowed relative error is {:e}.",
            tables.request.accuracy,
        ),
        format!(
            "Tables and products take {} bytes: {} pieces of {piece} bytes with polynomials of degree {}, and {} bytes for the buckets and for products over zeros and poles.",
            report.bytes,
            tables.pieces.len(),
            tables.terms - 1,
            report.bytes - piece * tables.pieces.len(),
        ),
        format!(
            "The check of {checked} found a largest error of {:.1e}, at r = {}.  It used {} values of r that the fit did not use, in the arithmetic of this file.",
            report.worst.error,
            report.worst.place::<S>(),
            report.points,
        ),
        "The command above writes this file again.  It repeats the check.  Add `--prove` for the proof.".to_owned(),
        "A proof covers the numbers and the arithmetic of this file.  The proof of `beta*_lim`, a product, needs no option.".to_owned(),
        format!("`beta_lim`: {}", told(tables, &tables.proof)),
    ];
    if tables.sliding.is_some() {
        about.push(format!(
            "`beta*_lim`: {}",
            tables.sliding_proof.told_in::<S>()
        ));
    }
    if tables.moves() {
        about.push(format!(
            "Amplitude and phase of the contact, for beta up to {MOST_SHARE} `beta_lim`: {}",
            told(tables, &tables.motion_proof)
        ));
        about.push(
            "For a larger beta this bound grows in proportion to `1/(1 - (beta/beta_lim)^2)`."
                .to_owned(),
        );
    }
    if let Some(held) = &tables.held {
        about.push(format!("Stuck responses: {}", held.told()));
    }
    let left_out = left_out(scene);
    if !left_out.is_empty() {
        about.push(format!(
            "This file lacks these items of `provide`: {}.  This format only supports limits, the motion of the contact and stuck responses.",
            left_out.join(", ")
        ));
    }
    about.push("Errors of the phase are in rad.  All other errors are relative.  If beta differs from a limit by less than the error of the limit, the status may be wrong.".to_owned());
    if let Some(acts_on) = scene.damping_acts_on() {
        about.push(format!("In this scene {acts_on}."));
    }
    if tables.moves() {
        about.push(
            "While the contact slides, this file has the motion in the contact, not that of each mass."
                .to_owned(),
        );
    }
    about.push(format!(
        "`TABLE` in the code that the macro emits has the same index (smallest r, buckets per r, halvings of the search), buckets and pieces:{}",
        about_table(tables)
    ));
    about
}

/// Returns sentences about the accuracy of the tables between the checked points. A command without `--prove` tries no
/// proof. The sentences then name this option, or state that frictiongen proves no accuracy as fine as this one.
fn told<S: Float>(tables: &Tables<S>, proof: &Proof) -> String {
    if proof.evidence != Evidence::Checked || proof.work != ProofWork(0) {
        return proof.told_in::<S>();
    }
    let remedy = if FINEST_PROVEN <= tables.request.accuracy {
        "Add `--prove` to the command to try a proof.".to_owned()
    } else {
        format!("frictiongen proves no accuracy finer than {FINEST_PROVEN:e}.")
    };
    format!(
        "Checked at points and not proven, because the command had no `--prove`.  Between the points an error may be larger.  {remedy}"
    )
}

/// Names and meanings of the polynomials of a piece. A piece is an interval of r in the tables.
const COLUMNS: [(&str, &str); 5] = [
    ("beta_lim", "`beta_lim`, the limit of continuous motion"),
    (
        "a",
        "`a = beta_lim U/|V|`, times the sign of V if nothing is damped",
    ),
    ("g", "`g = beta_lim G/|V|`"),
    ("arg_v", "argument of V in rad, continuous within a piece"),
    ("abs_v", "`|V|`"),
];

/// The meaning of U, G and V, as two lines for the comments of the file.
const RESPONSES: [&str; 2] = [
    "V is the response of the contact to the load, without friction.  At a maximum of its displacement,",
    "friction contributes -beta G to the displacement and -beta U to the velocity over omega.",
];

/// Returns a comment on the zeros and poles of β*_lim. It is empty if the expression `sliding` does not depend on r.
fn quotient_about(sliding: &str) -> &'static str {
    if sliding.contains("(r") {
        "\nV and H have the same poles.  The zeros of the quotient are therefore those of V, and its poles the zeros of H."
    } else {
        ""
    }
}

/// The source of the equation numbers, for the comments of the file.
const THESIS: &str = "Numbers in brackets are equations of L. Marino, Dynamic analysis of mechanical systems with Coulomb friction, Oxford 2021.";

/// Equations of the thesis for β_lim.
const CONTINUOUS_EQUATIONS: &str = "5.65, 5.80, 5.96, 7.49";

/// Equations of the thesis for β*_lim and for the responses while the contact is stuck.
const STUCK_EQUATIONS: &str = "6.11, 6.27, 6.33";

/// Returns the names and meanings of the polynomials that the tables have.
fn columns<S>(tables: &Tables<S>) -> &'static [(&'static str, &'static str)] {
    COLUMNS.get(..tables.functions).unwrap_or_default()
}

/// Returns the numbers of all pieces, in the order of the emitted structures.
fn piece_numbers<S: Float>(tables: &Tables<S>) -> Vec<f64> {
    let pieces = tables.pieces.iter().flat_map(|piece| {
        let coefficients = piece.coefficients.iter().flatten();
        [&piece.from, &piece.origin].into_iter().chain(coefficients)
    });
    pieces.map(|number| number.to_f64()).collect()
}

/// Returns the first step of the binary search for a piece within a bucket, as a number of pieces.
fn first_step<S>(tables: &Tables<S>) -> usize {
    (1_usize << tables.index.halvings) >> 1
}

/// Status values of the functions: name, number in C, and meaning.
const STATUSES: [(&str, i32, &str); 5] = [
    (
        "OutOfDomain",
        -1,
        "r or beta is outside its range, or is not a number",
    ),
    ("Ok", 0, "The values are written"),
    (
        "StickSlip",
        1,
        "`beta_lim <= beta < beta*_lim`: the contact sticks and slides in turn",
    ),
    (
        "Stuck",
        2,
        "`beta >= beta_lim` and `beta >= beta*_lim`: no continuous motion, but a stuck state, exists; with stiction > 1 a motion with stops may exist too",
    ),
    (
        "Unbounded",
        3,
        "No function of this file returns this value; it keeps its number in all files",
    ),
];

/// Returns the meaning of a status. The meaning of `Unbounded` depends on the functions that may return this status.
fn meaning<S: Float>(
    tables: &Tables<S>,
    (status, _, meaning): (&str, i32, &'static str),
) -> &'static str {
    let motion = tables.moves() && !tables.unbounded.is_empty();
    let held = tables.held.as_ref();
    let stuck = held.is_some_and(|held| !held.resonances.is_empty());
    match (status, motion, stuck) {
        ("Unbounded", true, true) => {
            "r is an undamped resonance that the load drives; for stuck responses, one of the chain with its contact stuck"
        }
        ("Unbounded", true, false) => {
            "r is an undamped resonance that the load drives, so that the amplitude has no bound"
        }
        ("Unbounded", false, true) => {
            "r is an undamped resonance of the chain with its contact stuck"
        }
        _ => meaning,
    }
}

/// Words of the documentation that depend on the kind of load.
struct LoadWords {
    /// Meaning of β: F/P, or F/(k₁Y) if the base moves.
    beta: &'static str,
    /// The load as a function of the time τ, for the comments of the file.
    signal: &'static str,
    /// Explanation of an amplitude, for the comments of the file.
    amplitude: &'static str,
    /// The load by which forces are divided, as words for the comments of the file.
    load: &'static str,
    /// Meaning of the symbol in `load`, as words for the comments of the file.
    load_means: &'static str,
    /// Sentence about a stuck state that exists at the same β as a motion, for the comments of the file. It is empty if
    /// μ is 1, because a stuck state and a sliding motion then never exist at the same β.
    stuck_beside: &'static str,
}

impl LoadWords {
    fn of(scene: &Scene) -> Self {
        let moving = scene.excitation == Excitation::Base;
        Self {
            beta: if moving { "F/(k1 Y)" } else { "F/P" },
            signal: if moving {
                "base motion Y cos(tau)"
            } else {
                "force P cos(tau)"
            },
            amplitude: if moving { "x/Y" } else { "x k1/P" },
            load: if moving { "k1 Y" } else { "P" },
            load_means: if moving {
                "where Y is the amplitude of the base motion"
            } else {
                "the amplitude of the force"
            },
            stuck_beside: if scene.stiction > 1.0 {
                "For beta >= beta*_lim a stuck state also exists."
            } else {
                ""
            },
        }
    }
}

/// Returns a name in snake case: `TwoStorey` becomes `two_storey`.
fn snake(name: &str) -> String {
    let mut snake = String::new();
    for letter in name.chars() {
        if letter.is_uppercase() && !snake.is_empty() && !snake.ends_with('_') {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

//! Converts a parsed description to a scene with the tables and names that emitted code needs.

mod joints;
mod limits;
mod written;

use core::fmt;

use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{Precision, Proving, Scene};
use frictiongen_model::stepping::refused_step;
#[cfg(feature = "proof")]
use frictiongen_model::table::ProofWork;
use frictiongen_model::table::{TableError, Tables};
use frictiongen_model::transient::excess_loss;
use frictiongen_model::validate::Path;
use frictiongen_syntax::{Diagnostics, Located, Problems, Readable, Syntax};
use proc_macro2::{Ident, TokenStream};

use crate::diagnostics::{MacroErrors, Partial};
use crate::header::Header;
use crate::tokens::{self, Sources};

pub use limits::{ProofAt, SizeLimits};

/// The error of `proof: whole` in a build without the feature `proof`.
const WITHOUT_PROOF: &str = "`proof: whole` needs the feature `proof` of frictiongen, which is off; write `frictiongen = { version = \"0.1\", features = [\"proof\"] }` in Cargo.toml, or leave `proof` out, so that the table is checked but not proven";

/// A valid description, after parsing and checking.
pub struct Description {
    /// The doc comments and attributes before the struct, as attributes of Rust.
    pub attributes: TokenStream,
    /// The lines of the doc comments before the struct.
    pub documentation: Vec<String>,
    /// The visibility of the described struct, such as `pub`.
    pub visibility: TokenStream,
    /// The name of the described struct.
    pub name: Ident,
    /// Path of the facade crate. It is `::frictiongen` unless the description has another path.
    pub facade: TokenStream,
    /// The scene that the description defines.
    pub scene: Scene,
    /// Names of the masses with the spans of the user's tokens, in the order of [`Scene::masses`].
    pub mass_names: Vec<Ident>,
    /// Tables of a declared accuracy, or `None` for a scene without tables.
    pub tables: Option<SceneTables>,
    /// The description as it was written, without the doc comments before the struct.
    pub written: String,
}

impl Description {
    /// Returns the text of the doc comments before the struct, line by line.
    #[must_use]
    pub fn documentation(&self) -> String {
        let lines: Vec<&str> = self.documentation.iter().map(|line| line.trim()).collect();
        lines.join("\n")
    }
}

/// Tables that replace the exact formulas in a scene with a declared accuracy. Their numbers are in the scene's scalar
/// type.
#[derive(Clone, Debug)]
pub enum SceneTables {
    /// Tables in double precision.
    Double(Tables<f64>),
    /// Tables in single precision.
    Single(Tables<f32>),
}

impl SceneTables {
    /// Builds the tables that a scene declares. Returns `None` for a scene without tables.
    ///
    /// # Errors
    /// Returns every [`TableError`].
    pub fn of(scene: &Scene) -> Result<Option<Self>, TableError> {
        Ok(match scene.precision {
            Precision::F64 => Tables::of(scene)?.map(Self::Double),
            Precision::F32 => Tables::of(scene)?.map(Self::Single),
        })
    }

    /// Adds a proof that the tables have the declared accuracy, as far as `work` allows.
    #[cfg(feature = "proof")]
    pub fn prove(&mut self, scene: &Scene, work: ProofWork) {
        let modal = Modal::of(scene);
        match self {
            Self::Double(tables) => frictiongen_proof::prove(tables, &modal, work),
            Self::Single(tables) => frictiongen_proof::prove(tables, &modal, work),
        }
    }

    /// Adds a proof that the tables have the declared accuracy, if `work` is likely to suffice.
    #[cfg(feature = "proof")]
    fn prove_if_small(&mut self, scene: &Scene, work: ProofWork) {
        let modal = Modal::of(scene);
        match self {
            Self::Double(tables) => frictiongen_proof::prove_if_small(tables, &modal, work),
            Self::Single(tables) => frictiongen_proof::prove_if_small(tables, &modal, work),
        }
    }

    /// Adds the proof that a macro makes for the accuracy of the tables, with the work that the scene's `proof`
    /// allows.
    #[cfg(feature = "proof")]
    fn prove_requested(&mut self, scene: &Scene) {
        match scene.declared.proof {
            Proving::Quick => self.prove_if_small(scene, ProofWork::AT_EXPANSION),
            Proving::Whole => self.prove(scene, ProofWork::WHOLE),
        }
    }
}

impl fmt::Debug for Description {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Description")
            .field("scene", &self.scene)
            .finish_non_exhaustive()
    }
}

/// Reads the tokens of a macro call.
///
/// # Errors
/// Returns all errors of the description, and the fields that could be read.
#[allow(
    clippy::result_large_err,
    reason = "once a macro call; the parts are for the caller to take"
)]
pub fn parse_tokens(tokens: TokenStream, limits: &SizeLimits) -> Result<Description, MacroErrors> {
    let mut problems = Problems::default();
    let written = written::of_tokens(&tokens);
    let (syntax, sources) = tokens::parse(tokens, &mut problems);
    match lower(&syntax, &sources, limits, &mut problems) {
        Ok(description) => Ok(Description {
            written,
            ..description
        }),
        Err(partial) => Err(MacroErrors {
            errors: sources.errors(problems),
            partial: *partial,
        }),
    }
}

/// Reads a description from a text. If a macro calls this function, the names in the result have the span of the macro
/// call.
///
/// # Errors
/// Returns all errors of the text, with line and column.
pub fn parse_text(text: &str, limits: &SizeLimits) -> Result<Description, Diagnostics> {
    let mut problems = Problems::default();
    frictiongen_syntax::parse_text(text, &mut problems)
        .and_then(|syntax| lower(&syntax, &Sources::default(), limits, &mut problems).ok())
        .map(|description| Description {
            written: written::of_text(text),
            ..description
        })
        .ok_or_else(|| problems.into_diagnostics())
}

/// Returns the description with its tables. If `problems` contains errors, returns the fields from which a macro can
/// still emit a type.
fn lower(
    syntax: &Syntax,
    sources: &Sources,
    limits: &SizeLimits,
    problems: &mut Problems,
) -> Result<Description, Box<Partial>> {
    let header = Header::of(syntax, sources);
    let located = syntax.lower(limits.masses, limits.emitted, problems);
    if let Some(located) = &located
        && limits.proof == ProofAt::Missing
        && located.scene.declared.proof == Proving::Whole
        && problems.is_empty()
    {
        problems.report(located.place(Path::Proof), WITHOUT_PROOF);
    }
    if let Some(located) = &located
        && limits.emitted
        && located.scene.is_joined()
        && problems.is_empty()
    {
        joints::check(located, problems);
    }
    let mut tables = None;
    if let Some(located) = &located
        && limits.tables
        && !located.scene.is_joined()
        && problems.is_empty()
    {
        match SceneTables::of(&located.scene) {
            Ok(built) => tables = built,
            Err(error) => {
                let accuracy = located.written(Path::Accuracy);
                let place = accuracy.unwrap_or_else(|| located.place(Path::Budget));
                problems.report(place, error.to_string());
            }
        }
        check_motion_in_time(located, problems);
    }
    match (located, &syntax.name) {
        (Some(Located { scene, .. }), Some(name)) if problems.is_empty() => Ok(Description {
            // The proof takes longest, so it runs after all checks.
            tables: proven(tables, &scene, limits),
            attributes: header.attributes,
            documentation: header.documentation,
            visibility: header.visibility,
            name: sources.ident(name),
            facade: header.facade,
            scene,
            mass_names: syntax
                .mass_names()
                .map(|name| sources.ident(name))
                .collect(),
            written: String::new(),
        }),
        _ => Err(Box::new(partial(syntax, sources, header))),
    }
}

/// Reports a declared time step outside the range of a stepper. If the step is valid, reports overdamped modes for
/// which rounding errors in a simulation, an orbit or a stepper would be too large.
fn check_motion_in_time(located: &Located<'_>, problems: &mut Problems) {
    let scene = &located.scene;
    if !problems.is_empty() {
        return;
    }
    if scene.stepping.step.is_some()
        && let Some((angle, [least, most])) = refused_step(scene, &Modal::of(scene))
    {
        let message = format!(
            "the fastest oscillator turns by {angle:.1e} rad in this step, outside the range of a stepper, {least:.0e} to {most} rad; write a step within this range"
        );
        problems.report(located.place(Path::Step), message);
    } else if scene.moves_in_time()
        && let Some(loss) = excess_loss(scene)
    {
        let message = format!(
            "with this number of modes at or beyond critical damping, a motion in time has a relative error of {loss:.0e}; write damping ratios below 1, or `scalar: f64` instead of `f32`, or leave simulation, orbit and stepper out"
        );
        problems.report(located.place(Path::Damping(None)), message);
    }
}

/// Returns the fields of a faulty description from which a macro can still emit a type.
fn partial(syntax: &Syntax, sources: &Sources, header: Header) -> Partial {
    let Readable {
        mass_names,
        precision,
        on_base,
        forces,
        has_step,
    } = syntax.readable();
    Partial {
        attributes: header.attributes,
        documentation: header.documentation,
        visibility: header.visibility,
        name: syntax.name.as_ref().map(|name| sources.ident(name)),
        facade: header.facade,
        mass_names: mass_names
            .into_iter()
            .map(|name| sources.ident(name))
            .collect(),
        precision,
        on_base,
        forces,
        has_step,
    }
}

/// Returns the tables with the requested proof, if the limits allow a proof.
fn proven(tables: Option<SceneTables>, scene: &Scene, limits: &SizeLimits) -> Option<SceneTables> {
    #[cfg(feature = "proof")]
    if limits.proof == ProofAt::Requested {
        return tables.map(|mut tables| {
            tables.prove_requested(scene);
            tables
        });
    }
    let _ = (scene, limits);
    tables
}

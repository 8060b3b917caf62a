//! Turns a syntax tree into a scene that makes physical sense.

mod limits;
mod places;
mod resolve;
mod settings;
mod stepping;

use core::fmt;
use std::collections::HashSet;

use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{Precision, Proving, Scene};
use frictiongen_model::stepping::refused_step;
#[cfg(feature = "proof")]
use frictiongen_model::table::Work;
use frictiongen_model::table::{TableError, Tables};
use frictiongen_model::transient::excess_loss;
use frictiongen_model::validate::may_name;
use proc_macro2::{Ident, Span, TokenStream};

use crate::diagnostics::{Diagnostics, Failure, Partial, Problems};
use crate::parse;
use crate::parse::syntax::{AccuracyEntry, Syntax};

pub use limits::{Limits, ProofAt};

/// The error of `proof: whole` in a build without the feature `proof`.
const WITHOUT_PROOF: &str = "`proof: whole` needs the feature `proof` of frictiongen, which is off; write `frictiongen = { version = \"0.1\", features = [\"proof\"] }` in Cargo.toml, or leave `proof` out, so that the table is checked but not proven";

/// A description that was read and that makes physical sense.
pub struct Description {
    /// The doc comments and attributes before the struct.
    pub attributes: Vec<syn::Attribute>,
    /// The visibility of the struct.
    pub visibility: syn::Visibility,
    /// The name of the struct.
    pub name: Ident,
    /// The path of the facade crate, `::frictiongen` unless the description gives another one.
    pub facade: syn::Path,
    /// The scene that the description defines.
    pub scene: Scene,
    /// The names of the masses with the user's spans, in the order of [`Scene::masses`].
    pub mass_names: Vec<Ident>,
    /// The tables of a declared accuracy; `None` for an exact scene.
    pub tables: Option<SceneTables>,
}

impl Description {
    /// Returns the text of the doc comments before the struct, line by line.
    #[must_use]
    pub fn documentation(&self) -> String {
        let text = |attribute: &syn::Attribute| match &attribute.meta {
            syn::Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                syn::Expr::Lit(syn::ExprLit {
                    lit: syn::Lit::Str(text),
                    ..
                }) => Some(text.value().trim().to_owned()),
                _ => None,
            },
            _ => None,
        };
        let lines: Vec<String> = self.attributes.iter().filter_map(text).collect();
        lines.join("\n")
    }
}

/// Tables in the scene's scalar.
#[derive(Clone, Debug)]
pub enum SceneTables {
    /// Tables in double precision.
    Double(Tables<f64>),
    /// Tables in single precision.
    Single(Tables<f32>),
}

impl SceneTables {
    /// Builds the tables that a scene declares. Returns `None` for an exact scene.
    ///
    /// # Errors
    /// Returns every [`TableError`].
    pub fn of(scene: &Scene) -> Result<Option<Self>, TableError> {
        Ok(match scene.precision {
            Precision::F64 => Tables::of(scene)?.map(Self::Double),
            Precision::F32 => Tables::of(scene)?.map(Self::Single),
        })
    }

    /// Adds a proof of the accuracy, as far as `work` allows.
    #[cfg(feature = "proof")]
    pub fn prove(&mut self, scene: &Scene, work: Work) {
        let modal = Modal::of(scene);
        match self {
            Self::Double(tables) => frictiongen_proof::prove(tables, &modal, work),
            Self::Single(tables) => frictiongen_proof::prove(tables, &modal, work),
        }
    }

    /// Adds a proof of the accuracy if `work` is likely to suffice.
    #[cfg(feature = "proof")]
    fn prove_if_small(&mut self, scene: &Scene, work: Work) {
        let modal = Modal::of(scene);
        match self {
            Self::Double(tables) => frictiongen_proof::prove_if_small(tables, &modal, work),
            Self::Single(tables) => frictiongen_proof::prove_if_small(tables, &modal, work),
        }
    }

    /// Adds the proof that a scene requests from the macro.
    #[cfg(feature = "proof")]
    fn prove_requested(&mut self, scene: &Scene) {
        match scene.declared.proof {
            Proving::Quick => self.prove_if_small(scene, Work::AT_EXPANSION),
            Proving::Whole => self.prove(scene, Work::WHOLE),
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
pub fn parse_tokens(tokens: TokenStream, limits: &Limits) -> Result<Description, Failure> {
    let mut problems = Problems::default();
    let syntax = parse::tokens(tokens, &mut problems);
    lower(syntax, limits, &mut problems).map_err(|partial| Failure {
        errors: problems.into_error(),
        partial: *partial,
    })
}

/// Reads a text in the language of the macro call. The names in the result carry the span of the
/// call, if there is a call.
///
/// # Errors
/// Returns all errors of the text, with line and column.
pub fn parse_text(text: &str, limits: &Limits) -> Result<Description, Diagnostics> {
    let mut problems = Problems::default();
    match parse::text(text, &mut problems) {
        Some(syntax) => lower(syntax, limits, &mut problems).ok(),
        None => None,
    }
    .ok_or_else(|| problems.into_diagnostics())
}

/// Returns the scene. If `problems` has errors, returns the fields from which a macro can still
/// emit a type.
fn lower(
    mut syntax: Syntax,
    limits: &Limits,
    problems: &mut Problems,
) -> Result<Description, Box<Partial>> {
    let scene = if syntax.has_body {
        Some(resolve::resolve(&syntax, limits, problems))
    } else {
        None
    };
    let facade = syntax.fields.facade.take().unwrap_or_else(default_facade);
    let fields = &syntax.fields;
    let entries = syntax
        .fields
        .masses
        .given()
        .map_or(&[][..], |masses| &masses.list.entries);
    let names = entries.iter().map(|entry| &entry.name);
    if let Some(scene) = scene
        .as_ref()
        .filter(|_| limits.proof == ProofAt::Missing && problems.is_empty())
        && scene.declared.proof == Proving::Whole
    {
        let place = fields
            .proof
            .given()
            .map_or(syntax.place, |proof| proof.place);
        problems.report(place, WITHOUT_PROOF);
    }
    let mut tables = None;
    if let Some(scene) = scene
        .as_ref()
        .filter(|_| limits.tables && problems.is_empty())
    {
        match SceneTables::of(scene) {
            Ok(built) => tables = built,
            Err(error) => {
                let number = match fields.accuracy.given() {
                    Some(AccuracyEntry::Relative(number)) => Some(number.place),
                    _ => fields.budget.given().map(|number| number.place),
                };
                problems.report(number.unwrap_or(syntax.place), error.to_string());
            }
        }
    }
    if let Some(scene) = scene
        .as_ref()
        .filter(|_| limits.tables && problems.is_empty())
        && scene.stepping.step.is_some()
        && let Some((angle, [least, most])) = refused_step(scene, &Modal::of(scene))
    {
        let place = fields.step.given().map_or(syntax.place, |step| step.place);
        let message = format!(
            "the fastest oscillator turns by {angle:.1e} rad in this step, outside the range of a stepper, {least:.0e} to {most} rad; write a step within this range"
        );
        problems.report(place, message);
    }
    if let Some(scene) = scene
        .as_ref()
        .filter(|_| limits.tables && problems.is_empty())
        && scene.moves_in_time()
        && let Some(loss) = excess_loss(scene)
    {
        let place = fields
            .damping
            .given()
            .map_or(syntax.place, |damping| damping.place);
        let message = format!(
            "with this number of modes at or beyond critical damping, a motion in time has a relative error of {loss:.0e}; write damping ratios below 1, or `scalar: f64` instead of `f32`, or leave simulation, orbit and stepper out"
        );
        problems.report(place, message);
    }
    match (scene, syntax.name) {
        (Some(scene), Some(name)) if problems.is_empty() => Ok(Description {
            // The proof takes longest, so it runs after all checks.
            tables: proven(tables, &scene, limits),
            attributes: syntax.attributes,
            visibility: syntax.visibility,
            name: name.ident,
            facade,
            scene,
            mass_names: names.map(|name| name.ident.clone()).collect(),
        }),
        (_, name) => {
            let mut seen = HashSet::new();
            let mass_names: Vec<Ident> = names
                .filter(|name| may_name(&name.text))
                .filter(|name| seen.insert(name.text.as_str()))
                .map(|name| name.ident.clone())
                .collect();
            let excitation = fields.excitation.given().map(|name| name.text.as_str());
            let loaded = fields.force.given();
            let loaded = loaded.map_or(&[][..], |force| &force.list.entries);
            let mut forces: Vec<usize> = loaded
                .iter()
                .filter(|name| excitation != Some(name.text.as_str()))
                .filter_map(|name| mass_names.iter().position(|mass| *mass == name.text))
                .collect();
            forces.sort_unstable();
            forces.dedup();
            Err(Box::new(Partial {
                on_base: excitation == Some("base"),
                forces,
                has_step: !fields.step.is_missing(),
                attributes: syntax.attributes,
                visibility: syntax.visibility,
                name: name.map(|name| name.ident),
                facade,
                mass_names,
                precision: syntax
                    .fields
                    .scalar
                    .given()
                    .copied()
                    .unwrap_or(Precision::F64),
            }))
        }
    }
}

/// Returns the tables with the requested proof, as far as the limits allow one.
fn proven(tables: Option<SceneTables>, scene: &Scene, limits: &Limits) -> Option<SceneTables> {
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

fn default_facade() -> syn::Path {
    let span = Span::call_site();
    let mut segments = syn::punctuated::Punctuated::new();
    segments.push_value(syn::PathSegment::from(Ident::new("frictiongen", span)));
    syn::Path {
        leading_colon: Some(syn::Token![::]([span, span])),
        segments,
    }
}

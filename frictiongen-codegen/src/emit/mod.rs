//! Emits a scene's solver: one file for each group of emitted items.

mod constants;
mod dynamics;
mod frequency;
mod legend;
mod limits;
mod missing;
mod mode;
mod motion;
mod names;
mod orbit;
mod scene;
mod shield;
mod simulation;
mod step_table;
mod stepper;
mod stuck;
mod table;
mod trace;

use crate::Description;
use crate::graph::print::scalar;
use frictiongen_model::modal::Modal;
use frictiongen_model::reduced::Reduced;
use frictiongen_model::scene::{Precision, Provide, Scene};
use names::{IMPORTED, field, local, names};
use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

pub use trace::traces;

/// From this many modes on the frequency stage is emitted as passes over an array of modes instead
/// of straight lines, which are faster (1.1 to 1.5 times, 4 to 16 modes: `scripts/passes-trial`) but
/// grow with the modes.
pub const PASSES_FROM: usize = 17;

/// From this many modes on the sums over modes in a motion are calls of the kernel instead of straight lines, of
/// which each mass has its own.
const SUMS_FROM: usize = 3;

/// Everything that the emitted items have in common.
struct Emission<'a> {
    description: &'a Description,
    scene: &'a Scene,
    modal: Modal,
    /// The driven modes, in double-double bits rounded to the scene's precision, as `f64`.
    reduced: Reduced<f64>,
    precision: Precision,
    /// `f64` or `f32`.
    scalar: TokenStream,
    /// How modes decay: `Undamped` or `Damped<f64>`.
    decay: TokenStream,
    name: Ident,
    at: Ident,
    motion: Ident,
    stuck: Ident,
    simulation: Ident,
    orbit: Ident,
    stepper: Ident,
    input: Ident,
    facade: &'a syn::Path,
    /// From this many modes on passes are emitted.
    passes_from: usize,
}

/// What a scene asks for.
struct Wanted<'a> {
    motion: Option<Vec<(usize, &'a Ident)>>,
    stuck: bool,
    simulation: bool,
    orbit: bool,
    stepper: bool,
}

impl Emission<'_> {
    fn names(&self) -> [Ident; 8] {
        [
            self.name.clone(),
            self.at.clone(),
            self.motion.clone(),
            self.stuck.clone(),
            self.simulation.clone(),
            self.orbit.clone(),
            self.stepper.clone(),
            self.input.clone(),
        ]
    }

    fn rename(&mut self, scene: &Ident) {
        [
            self.name,
            self.at,
            self.motion,
            self.stuck,
            self.simulation,
            self.orbit,
            self.stepper,
            self.input,
        ] = names(scene);
    }

    fn modes(&self) -> usize {
        self.reduced.modes.len()
    }

    /// Whether the frequency stage is emitted as passes over modes.
    fn in_passes(&self) -> bool {
        self.modes() >= self.passes_from
    }

    /// Whether a mass's sums over modes are emitted as calls.
    fn in_sums(&self) -> bool {
        self.modes() >= SUMS_FROM.min(self.passes_from)
    }

    /// Whether tables answer, of a declared accuracy.
    fn is_tabled(&self) -> bool {
        self.description.tables.is_some()
    }

    fn damped(&self) -> bool {
        self.reduced.chain.damped
    }

    /// Whether the motion of this mass is the contact's: it rubs on a support at rest.
    fn moves_as_contact(&self, mass: usize) -> bool {
        self.reduced.chain.on_moving_base.is_none() && self.reduced.rubbing == Some(mass)
    }

    fn literal(&self, value: f64) -> TokenStream {
        crate::graph::print::literal(value, self.precision)
    }

    fn list(&self, values: impl IntoIterator<Item = f64>) -> TokenStream {
        let values = values.into_iter().map(|value| self.literal(value));
        code!([#(#values),*])
    }

    fn wanted(&self) -> Wanted<'_> {
        let mut wanted = Wanted {
            motion: None,
            stuck: false,
            simulation: false,
            orbit: false,
            stepper: false,
        };
        let all = || {
            self.description
                .mass_names
                .iter()
                .enumerate()
                .collect::<Vec<_>>()
        };
        for item in &self.scene.provide {
            match item {
                Provide::Limits => {}
                Provide::Motion(None) => wanted.motion = Some(all()),
                Provide::Motion(Some(masses)) => {
                    let named = all()
                        .into_iter()
                        .filter(|(index, _)| masses.contains(index));
                    let known = wanted.motion.take().unwrap_or_default();
                    let mut merged: Vec<_> = known.into_iter().chain(named).collect();
                    merged.sort_by_key(|(index, _)| *index);
                    merged.dedup_by_key(|(index, _)| *index);
                    wanted.motion = Some(merged);
                }
                Provide::Stuck => wanted.stuck = true,
                Provide::Orbit => wanted.orbit = true,
                Provide::Simulation => wanted.simulation = true,
                Provide::Stepper => wanted.stepper = true,
            }
        }
        wanted
    }
}

/// Rounded once from double-double to the scene's scalar, as an `f64`.
#[allow(clippy::cast_possible_truncation, reason = "the scene's scalar is f32")]
pub(crate) fn rounded(value: frictiongen_kernel::number::dd::Dd, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => value.hi,
        Precision::F32 => {
            // An f64 halfway between two f32 would hide on which side the low part is: move it.
            let moved = match value.lo.partial_cmp(&0.0) {
                Some(std::cmp::Ordering::Greater) => value.hi.next_up(),
                Some(std::cmp::Ordering::Less) => value.hi.next_down(),
                _ => value.hi,
            };
            let (plain, moved) = (value.hi as f32, moved as f32);
            f64::from(if f64::from(plain) == value.hi {
                plain
            } else {
                moved
            })
        }
    }
}

/// The solver of a description.
#[must_use]
pub fn emit(description: &Description) -> TokenStream {
    emit_in_passes(description, PASSES_FROM)
}

/// The same with passes from another number of modes on, for measuring where they begin to pay.
#[must_use]
pub fn emit_in_passes(description: &Description, passes_from: usize) -> TokenStream {
    let scene = &description.scene;
    let modal = Modal::of(scene);
    let precision = scene.precision;
    let reduced = modal.reduced(|value| rounded(value, precision));
    let scalar = scalar(precision);
    let decay = if reduced.chain.damped {
        code!(Damped<#scalar>)
    } else {
        code!(Undamped)
    };
    let [name, at, motion, stuck, simulation, orbit, stepper, input] = names(&description.name);
    let mut emission = Emission {
        description,
        scene,
        modal,
        reduced,
        precision,
        scalar,
        decay,
        name,
        at,
        motion,
        stuck,
        simulation,
        orbit,
        stepper,
        input,
        facade: &description.facade,
        passes_from,
    };
    let wanted = emission.wanted();
    let has = [
        true,
        scene.needs_frequency(),
        wanted.motion.is_some(),
        wanted.stuck,
        wanted.simulation,
        wanted.orbit,
        wanted.stepper,
        wanted.stepper,
    ];
    let (types, mut items) = parts(&emission);
    let own = emission.names();
    let clashes = own
        .iter()
        .any(|name| IMPORTED.iter().any(|imported| *name == imported));
    let mut aliases = TokenStream::new();
    if clashes {
        // Within the block the scene goes by other names than what is imported there.
        emission.rename(&format_ident!("Emitted{}", description.name));
        (_, items) = parts(&emission);
        for ((alias, own), _) in emission
            .names()
            .into_iter()
            .zip(&own)
            .zip(has)
            .filter(|(_, has)| *has)
        {
            aliases.extend(code!(type #alias = #own;));
        }
    }
    let facade = emission.facade;
    let shield = shield::emit(&items);
    let block = code! {
            use #facade::kernel::emitted::*;
            #shield
            #items
    };
    let block = if clashes {
        code!(#aliases const _: () = { #block };)
    } else {
        block
    };
    code! {
        #types
        #[automatically_derived]
        #[allow(
            deprecated,
            non_snake_case,
            non_camel_case_types,
            unused_imports,
            unused_qualifications,
            clippy::all,
            clippy::pedantic,
            clippy::nursery,
            clippy::restriction
        )]
        const _: () = { #block };
    }
}

/// Everything that is emitted, types and what stays hidden.
fn parts(emission: &Emission<'_>) -> (TokenStream, TokenStream) {
    let wanted = emission.wanted();
    let Part {
        mut types,
        mut items,
    } = constants::emit(emission);
    let motion = wanted
        .motion
        .as_deref()
        .map(|masses| motion::emit(emission, masses));
    let stuck = wanted.stuck.then(|| stuck::emit(emission));
    if emission.scene.needs_frequency() {
        items.extend(scene::emit(emission, &wanted));
        items.extend(table::emit(emission, wanted.motion.is_some()));
    }
    items.extend(missing::emit(emission, &wanted));
    let in_time = wanted.simulation || wanted.orbit || wanted.stepper;
    let dynamics = in_time.then(|| dynamics::emit(emission));
    let (mut simulation, mut orbit, mut stepper) = (None, None, None);
    if let Some(dynamics) = dynamics {
        simulation = wanted
            .simulation
            .then(|| simulation::emit(emission, &dynamics));
        orbit = wanted.orbit.then(|| orbit::emit(emission, &dynamics));
        stepper = wanted.stepper.then(|| stepper::emit(emission, &dynamics));
        items.extend(dynamics.items);
    }
    let parts = [motion, stuck, simulation, orbit, stepper];
    for part in parts.into_iter().flatten() {
        types.extend(part.types);
        items.extend(part.items);
    }
    (types, items)
}

/// What one file emits: types in the user's module, and what stays hidden.
struct Part {
    types: TokenStream,
    items: TokenStream,
}

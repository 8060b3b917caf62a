//! What the emitted items have in common, and what a file of them is made of.

use super::names::{local, names};
use crate::Description;
use crate::graph::literal::{literal, scalar};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::modal::Modal;
use frictiongen_model::reduced::Reduced;
use frictiongen_model::scene::{Precision, Provide, Scene};
use proc_macro2::{Ident, TokenStream};

/// From this many modes on the sums over modes in a motion are calls of the kernel instead of straight lines, of
/// which each mass has its own.
const SUMS_FROM: usize = 3;

/// Everything that the emitted items have in common.
pub(super) struct Emission<'a> {
    pub description: &'a Description,
    pub scene: &'a Scene,
    pub modal: Modal,
    /// The driven modes, in double-double bits rounded to the scene's precision, as `f64`.
    pub reduced: Reduced<f64>,
    pub precision: Precision,
    /// `f64` or `f32`.
    pub scalar: TokenStream,
    /// How modes decay: `Undamped` or `Damped<f64>`.
    pub decay: TokenStream,
    pub name: Ident,
    pub at: Ident,
    pub motion: Ident,
    pub stuck: Ident,
    pub simulation: Ident,
    pub orbit: Ident,
    pub stepper: Ident,
    pub input: Ident,
    pub facade: &'a syn::Path,
    /// From this many modes on passes are emitted.
    pub passes_from: usize,
}

/// What a scene asks for.
pub(super) struct Wanted<'a> {
    pub motion: Option<Vec<(usize, &'a Ident)>>,
    pub stuck: bool,
    pub simulation: bool,
    pub orbit: bool,
    pub stepper: bool,
}

impl Wanted<'_> {
    /// Whether something is asked of a mass at a frequency.
    pub fn shapes(&self) -> bool {
        let moves = |masses: &Vec<(usize, &Ident)>| !masses.is_empty();
        self.stuck || self.motion.as_ref().is_some_and(moves)
    }
}

impl<'a> Emission<'a> {
    pub fn of(description: &'a Description, passes_from: usize) -> Self {
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
        Self {
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
        }
    }

    pub fn names(&self) -> [Ident; 8] {
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

    pub fn rename(&mut self, scene: &Ident) {
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

    pub fn modes(&self) -> usize {
        self.reduced.modes.len()
    }

    /// `mode_1`, `mode_2`, …: the modes at a frequency.
    pub fn mode_names(&self) -> Vec<Ident> {
        self.numbered("mode")
    }

    /// `constants_1`, `constants_2`, …: the modes' constants.
    pub fn constant_names(&self) -> Vec<Ident> {
        self.numbered("constants")
    }

    fn numbered(&self, name: &str) -> Vec<Ident> {
        let modes = 1..=self.modes();
        modes.map(|mode| local(&format!("{name}_{mode}"))).collect()
    }

    /// The statement that gives the modes' constants their names.
    pub fn constants(&self) -> TokenStream {
        let names = self.constant_names();
        code!(let [#(#names),*] = &Self::MODES;)
    }

    /// Whether the frequency stage is emitted as passes over modes.
    pub fn in_passes(&self) -> bool {
        self.modes() >= self.passes_from
    }

    /// Whether a mass's sums over modes are emitted as calls.
    pub fn in_sums(&self) -> bool {
        self.modes() >= SUMS_FROM.min(self.passes_from)
    }

    /// Whether tables answer, of a declared accuracy.
    pub fn is_tabled(&self) -> bool {
        self.description.tables.is_some()
    }

    pub fn damped(&self) -> bool {
        self.reduced.chain.damped
    }

    /// Whether the motion of this mass is the contact's: it rubs on a support at rest.
    pub fn moves_as_contact(&self, mass: usize) -> bool {
        self.reduced.chain.on_moving_base.is_none() && self.reduced.rubbing == Some(mass)
    }

    /// Whether the load acts on the mass that rubs, so that V = H.
    pub(super) fn loads_contact(&self) -> bool {
        let Reduced { chain, modes, .. } = &self.reduced;
        chain.loads_contact(modes)
    }

    pub fn literal(&self, value: f64) -> TokenStream {
        literal(value, self.precision)
    }

    pub fn list(&self, values: impl IntoIterator<Item = f64>) -> TokenStream {
        let values = values.into_iter().map(|value| self.literal(value));
        code!([#(#values),*])
    }

    pub fn wanted(&self) -> Wanted<'_> {
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
pub(super) fn rounded(value: Dd, precision: Precision) -> f64 {
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

/// What one file emits.
#[derive(Default)]
pub(super) struct Part {
    /// In the user's module.
    pub types: TokenStream,
    /// In the one `impl` of the scene's type.
    pub associated: TokenStream,
    /// Beside that, hidden.
    pub items: TokenStream,
}

impl Part {
    pub fn join(&mut self, other: Self) {
        self.types.extend(other.types);
        self.associated.extend(other.associated);
        self.items.extend(other.items);
    }
}

//! Emits the solver of a scene. Each file emits one group of items.

mod arm;
mod constants;
mod dynamics;
mod emission;
mod frequency;
mod held;
mod legend;
mod limits;
mod missing;
mod mode;
mod motion;
mod names;
mod orbit;
mod scene;
mod shapes;
mod shield;
mod simulation;
mod step_table;
mod stepper;
mod stuck;
mod table;
mod trace;

use crate::Description;
use emission::{Emission, Part};
use names::IMPORTED;
use proc_macro2::TokenStream;
use quote::format_ident;

pub use trace::traces;

/// From this number of modes on, the frequency stage is emitted as passes over an array of modes. Straight lines are
/// faster but grow with the number of modes. `scripts/passes-trial` measures both.
pub const PASSES_FROM: usize = 17;

/// Returns the solver of a description.
#[must_use]
pub fn emit(description: &Description) -> TokenStream {
    emit_in_passes(description, PASSES_FROM)
}

/// Returns the solver of a description, with passes from another number of modes on. `scripts/passes-trial` uses it to
/// measure where passes pay off.
#[must_use]
pub fn emit_in_passes(description: &Description, passes_from: usize) -> TokenStream {
    let mut emission = Emission::of(description, passes_from);
    let wanted = emission.wanted();
    let has = [
        true,
        emission.scene.needs_frequency(),
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
        // The scene's own names clash with imported names, so the block uses aliases.
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

/// Returns all emitted code: the types, then the hidden items.
fn parts(emission: &Emission<'_>) -> (TokenStream, TokenStream) {
    let wanted = emission.wanted();
    let mut all = constants::emit(emission);
    if emission.scene.needs_frequency() {
        all.join(scene::emit(emission, &wanted));
        all.join(table::emit(emission, wanted.motion.is_some()));
    }
    all.items.extend(missing::emit(emission, &wanted));
    if let Some(masses) = &wanted.motion {
        all.join(motion::emit(emission, masses));
    }
    if wanted.stuck {
        all.join(stuck::emit(emission));
        all.join(held::emit(emission));
    }
    if wanted.simulation || wanted.orbit || wanted.stepper {
        let dynamics = dynamics::emit(emission, &wanted);
        all.associated.extend(dynamics.associated.clone());
        if wanted.simulation {
            all.join(simulation::emit(emission, &dynamics));
        }
        if wanted.orbit {
            all.join(orbit::emit(emission, &dynamics));
        }
        if wanted.stepper {
            all.join(stepper::emit(emission, &dynamics));
        }
    }
    let Part {
        types,
        associated,
        items,
    } = all;
    let name = &emission.name;
    (types, code!(impl #name { #associated } #items))
}

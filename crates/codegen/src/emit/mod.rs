//! Emits the solver of a scene. Each file emits one group of items.

mod about;
mod arm;
mod checksum;
mod constants;
mod declared;
mod domain;
mod dynamics;
mod emission;
mod fields;
mod fingerprint;
mod frequency;
mod held;
pub(crate) mod joints;
mod limits;
mod missing;
mod mode;
mod motion;
mod names;
mod orbit;
mod scene;
mod self_check;
mod shapes;
mod shield;
mod simulation;
mod step_cost;
#[cfg(feature = "pretty")]
mod step_facts;
mod step_table;
mod stepper;
mod stuck;
mod table;
mod trace;
mod units;

use crate::Description;
use emission::{Checked, Emission, EmittedCode};
use names::TypeNames;
use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

#[cfg(feature = "pretty")]
pub use step_facts::{StepFacts, step_facts};
pub use trace::traces;
#[cfg(feature = "pretty")]
pub(crate) use {
    about::motion_in_contact, checksum::about as about_numbers, fingerprint::fingerprint,
};

/// Returns the emitted code of a description.
#[must_use]
pub fn emit(description: &Description) -> TokenStream {
    if description.scene.is_joined() {
        let (types, items) = joints::emit(description);
        return in_block(&types, &items);
    }
    let mut emission = Emission::of(description);
    let own = groups(&emission);
    let clashes = emission.names.clash();
    let mut aliases = TokenStream::new();
    let (types, mut items) = joined(&emission, &own);
    if clashes {
        // The names of the scene's types clash with imported names, so the emitted block uses aliases for the scene's
        // types.
        emission.names = TypeNames::of(&format_ident!("Emitted{}", description.name));
        let renamed = groups(&emission);
        for (alias, own) in types_of(&renamed).zip(types_of(&own)) {
            aliases.extend(code!(type #alias = #own;));
        }
        (_, items) = joined(&emission, &renamed);
    }
    let facade = emission.facade;
    let shield = shield::emit(&items);
    let pi = pi(&items, &emission.scalar);
    let block = code! {
            use #facade::kernel::emitted::*;
            #pi
            #shield
            #items
    };
    let block = if clashes {
        code!(#aliases const _: () = { #block };)
    } else {
        block
    };
    in_block(&types, &block)
}

/// Emits the types in the user's module, and all other items in a block that hides their names.
fn in_block(types: &TokenStream, block: &TokenStream) -> TokenStream {
    code! {
        #types
        #[allow(
            deprecated,
            non_snake_case,
            non_camel_case_types,
            reason = "names and attributes are those of the description"
        )]
        #[allow(
            unused_doc_comments,
            clippy::doc_markdown,
            reason = "comments above statements explain them by formulas"
        )]
        #[allow(
            clippy::unreadable_literal,
            clippy::excessive_precision,
            clippy::approx_constant,
            clippy::similar_names,
            clippy::too_many_lines,
            reason = "numbers have all their digits, and formulas are written out"
        )]
        #[allow(
            clippy::suboptimal_flops,
            clippy::assign_op_pattern,
            clippy::suspicious_operation_groupings,
            reason = "operations and their order are those of the tested formulas"
        )]
        #[allow(
            clippy::wildcard_imports,
            clippy::inline_always,
            reason = "one import serves every scene, and the compiler folds constants after inlining"
        )]
        #[allow(
            clippy::expl_impl_clone_on_copy,
            reason = "`wraps!` implements both traits for types that stand outside this block"
        )]
        const _: () = { #block };
    }
}

/// Emits the imports of `PI` and `TAU`, each only if its name occurs in the items.
fn pi(items: &TokenStream, scalar: &TokenStream) -> TokenStream {
    let names = ["PI", "TAU"].into_iter();
    let names = names.filter(|name| emission::mentions(items, name));
    let names = names.map(|name| {
        let name = names::local(name);
        code!(use ::core::#scalar::consts::#name;)
    });
    names.collect()
}

/// Emitted code of one group of methods, with the names of its types.
struct MethodGroup {
    types: Vec<Ident>,
    part: EmittedCode,
}

/// Returns the groups of methods that the scene provides, in the order of the emitted code.
fn groups(emission: &Emission<'_>) -> Vec<MethodGroup> {
    let wanted = emission.wanted();
    let names = &emission.names;
    let mut groups = Vec::new();
    let mut add = |types: &[&Ident], part: EmittedCode| {
        let types = types.iter().copied().cloned().collect();
        groups.push(MethodGroup { types, part });
    };
    add(&[&names.name], constants::emit(emission));
    if emission.scene.needs_frequency() {
        add(&[&names.at], scene::emit(emission, &wanted));
        add(&[], table::emit(emission, wanted.motion.is_some()));
    }
    add(&[], missing::emit(emission, &wanted));
    if let Some(masses) = &wanted.motion {
        add(&[&names.motion], motion::emit(emission, masses));
    }
    if wanted.stuck {
        add(&[&names.stuck], stuck::emit(emission));
        add(&[], held::emit(emission));
    }
    if wanted.simulation || wanted.orbit || wanted.stepper {
        let dynamics = dynamics::emit(emission, &wanted);
        let constants = EmittedCode {
            associated: dynamics.associated.clone(),
            constants: vec![Checked::of_sum(
                "DYNAMICS",
                code!(&Self::DYNAMICS),
                dynamics.sum,
            )],
            ..EmittedCode::default()
        };
        add(&[], constants);
        if wanted.simulation {
            add(&[&names.simulation], simulation::emit(emission, &dynamics));
        }
        if wanted.orbit {
            add(&[&names.orbit], orbit::emit(emission, &dynamics));
        }
        if wanted.stepper {
            let types = [&names.stepper, &names.input, &names.declared];
            let types = if emission.scene.stepping.step.is_some() {
                &types[..]
            } else {
                &types[..2]
            };
            add(types, stepper::emit(emission, &dynamics));
        }
    }
    if wanted.self_check {
        let constants = groups.iter().flat_map(|group| &group.part.constants);
        let constants: Vec<&Checked> = constants.collect();
        let part = self_check::emit(emission, &wanted, &constants);
        groups.push(MethodGroup {
            types: Vec::new(),
            part,
        });
    }
    groups
}

/// Returns the names of the types of all groups.
fn types_of(groups: &[MethodGroup]) -> impl Iterator<Item = &Ident> {
    groups.iter().flat_map(|group| &group.types)
}

/// Returns all emitted code: the types, then the hidden items.
fn joined(emission: &Emission<'_>, groups: &[MethodGroup]) -> (TokenStream, TokenStream) {
    let parts = || groups.iter().map(|group| &group.part);
    let types = parts().map(|part| part.types.clone()).collect();
    let associated = parts().map(|part| &part.associated);
    let items = parts().map(|part| &part.items);
    let name = &emission.names.name;
    let tables: TokenStream = parts().map(|part| part.tables.clone()).collect();
    let tables = (!tables.is_empty()).then(|| {
        code! {
            /// Tables: numbers alone, apart from the code that reads them.
            impl #name { #tables }
        }
    });
    (
        types,
        code!(impl #name { #(#associated)* } #(#items)* #tables),
    )
}

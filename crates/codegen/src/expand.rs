//! Expands the macro, for a description in the source or in a file.
//!
//! If the description has errors, the macro also emits a type with the same methods. The user's crate then has no
//! follow-up errors.

use crate::diagnostics::{MacroErrors, Partial, compile_error};
use crate::lower::{Description, SizeLimits, parse_text, parse_tokens};
use crate::{Diagnostics, emit, quoted};
use frictiongen_model::scene::{
    CONTACT, ContactSides, Damping, DampingFrom, Declared, Excitation, FrictionLaw, Joints, Mass,
    Node, Provide, Scene, Spring, StepperOptions,
};
use proc_macro2::{Delimiter, Ident, Literal, Span, TokenStream, TokenTree};
use std::path::{Path, PathBuf};

/// Returns the expansion of a macro call. For invalid input the expansion contains the errors.
#[must_use]
pub fn expand(input: TokenStream) -> TokenStream {
    match file(&input) {
        Some((path, relative)) => expand_file(&path, &relative),
        None => match parse_tokens(input, &SizeLimits::MACRO) {
            Ok(description) => emit(&description),
            Err(failure) => emit_failure(failure),
        },
    }
}

/// Returns the literal and its value, the path of a file, if the input is a single string. Otherwise returns `None`.
fn file(input: &TokenStream) -> Option<(Literal, String)> {
    let mut trees = input.clone().into_iter();
    match (trees.next()?, trees.next()) {
        (TokenTree::Literal(path), None) => {
            let relative = quoted::value(&path)?;
            Some((path, relative))
        }
        // `macro_rules!` passes a literal between invisible brackets.
        (TokenTree::Group(group), None) if group.delimiter() == Delimiter::None => {
            file(&group.stream())
        }
        _ => None,
    }
}

/// Expands `friction_system!("frame.friction")`. The path is relative to the folder of Cargo.toml. If the file changes,
/// the compiler repeats the expansion of the call.
fn expand_file(path: &Literal, relative: &str) -> TokenStream {
    let folder = std::env::var_os("CARGO_MANIFEST_DIR")
        .map(PathBuf::from)
        .unwrap_or_default();
    let full = folder.join(relative);
    let text = match std::fs::read_to_string(&full) {
        Ok(text) => text,
        Err(error) => {
            let message = format!(
                "cannot read `{relative}`: {error}; the path must be relative to the folder of Cargo.toml, {}",
                folder.display()
            );
            return compile_error(path.span(), &message);
        }
    };
    let mut tokens = tracked(relative);
    match parse_text(&text, &SizeLimits::MACRO) {
        Ok(description) => tokens.extend(emit(&description)),
        Err(diagnostics) => {
            tokens.extend(file_errors(path.span(), relative, &diagnostics));
            // With the fields that could be read, the macro emits a replacement type. It prevents follow-up errors in
            // the user's crate.
            let partial = text.parse().ok().and_then(|tokens| {
                parse_tokens(tokens, &SizeLimits::MACRO)
                    .err()
                    .map(|failure| failure.partial)
            });
            tokens.extend(partial.and_then(stand_in));
        }
    }
    tokens
}

/// Emits code that includes the file as bytes. The compiler then expands the macro again if the file changes.
fn tracked(relative: &str) -> TokenStream {
    if Path::new(relative).is_absolute() {
        return code!(
            const _: &[::core::primitive::u8] = ::core::include_bytes!(#relative);
        );
    }
    let from_root = format!("/{relative}");
    code! {
        const _: &[::core::primitive::u8] = ::core::include_bytes!(
            ::core::concat!(::core::env!("CARGO_MANIFEST_DIR"), #from_root)
        );
    }
}

/// Emits each error of a file. The compiler shows the error at the path argument, with line and column in the file.
fn file_errors(path: Span, relative: &str, diagnostics: &Diagnostics) -> TokenStream {
    let errors = diagnostics
        .list
        .iter()
        .map(|diagnostic| compile_error(path, &format!("{relative}:{diagnostic}")));
    errors.collect()
}

/// Emits the errors, and a replacement type with the methods of the described scene.
fn emit_failure(failure: MacroErrors) -> TokenStream {
    let mut tokens = failure.errors.to_compile_error();
    tokens.extend(stand_in(failure.partial));
    tokens
}

/// Emits a solver with the names of a faulty description, but for a simple chain. The solver never runs, because the
/// errors end the build.
fn stand_in(partial: Partial) -> Option<TokenStream> {
    let Partial {
        attributes,
        documentation,
        visibility,
        name,
        facade,
        mut mass_names,
        precision,
        on_base,
        mut forces,
        has_step,
    } = partial;
    let name = name?;
    mass_names.truncate(SizeLimits::MACRO.masses);
    if mass_names.is_empty() {
        mass_names.push(Ident::new("unnamed", Span::mixed_site()));
    }
    let masses: Vec<Mass> = mass_names
        .iter()
        .map(|name| Mass {
            name: name.to_string(),
            value: 1.0,
        })
        .collect();
    // The excited mass is the first mass that `force` does not name.
    let excited = (0..masses.len()).find(|mass| !forces.contains(mass));
    let excitation = match excited {
        Some(mass) if !on_base => Excitation::Force(mass),
        _ => Excitation::Base,
    };
    forces.retain(|mass| *mass < masses.len());
    let springs = (0..masses.len())
        .map(|mass| Spring {
            from: mass.checked_sub(1).map_or(Node::Base, Node::Mass),
            to: Node::Mass(mass),
            stiffness: 1.0,
        })
        .collect();
    let scene = Scene {
        name: name.to_string(),
        masses,
        springs,
        contact: ContactSides {
            from: Node::Mass(0),
            to: Node::Wall,
        },
        contact_name: CONTACT.to_owned(),
        excitation,
        damping: Damping::None,
        damping_from: DampingFrom::Rest,
        stiction: 1.0,
        stiffness: None,
        precision,
        provide: vec![
            Provide::Limits,
            Provide::Motion(None),
            Provide::Stuck,
            Provide::Orbit,
            Provide::Simulation,
            Provide::Stepper,
            Provide::SelfCheck,
        ],
        declared: Declared::default(),
        friction: FrictionLaw::default(),
        stepping: StepperOptions {
            step: has_step.then_some(0.1),
            forces,
            ..StepperOptions::default()
        },
        joints: Joints::default(),
    };
    Some(emit(&Description {
        attributes,
        documentation,
        visibility,
        name,
        facade,
        scene,
        mass_names,
        tables: None,
        written: String::new(),
    }))
}

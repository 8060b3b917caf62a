//! A new public function of the kernel needs a row: the sources themselves are asked.

use crate::cases;
use proc_macro2::{TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use syn::{ImplItem, Item, TraitItem, Type, Visibility};

const KERNEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../frictiongen-kernel/src");

/// Functions that compute no numbers of their own, and why.
const NO_NUMBERS: [(&str, &[&str]); 4] = [
    (
        "hands on, picks or compares numbers as they are",
        &[
            "complex::real",
            "dd::Dd::abs",
            "dd::Dd::is_zero",
            "dd::Dd::max",
            "dd::Dd::min",
            "dd::Dd::neg",
            "dd::Dd::new",
            "regime::check_beta",
            "regime::check_ratio",
            "regime::inverse_ratio_range",
            "regime::Limits::margin",
            "regime::Limits::regime",
            "regime::regime",
            "regime::with_ends",
            "scalar::Float::held",
            "scalar::Float::inverse_ratio_range",
            "scalar::Float::sway_terms",
            "scalar::Float::is_finite",
            "scalar::Float::vanishes",
            "scalar::Scalar::abs",
            "scalar::Scalar::copysign",
            "scalar::Scalar::is_zero",
            "scalar::Scalar::lt",
            "scalar::Scalar::max",
            "scalar::Scalar::min",
            "scalar::Scalar::named",
            "scalar::Scalar::replaced",
            "scalar::Scalar::select",
            "search::Peak::effort",
        ],
    ),
    (
        "is never called",
        &[
            "missing::AddMassToMotion::answer",
            "missing::AddMotionToProvide::answer",
            "missing::AddOrbitToProvide::answer",
            "missing::AddSimulationToProvide::answer",
            "missing::AddStuckToProvide::answer",
            "missing::motion",
            "missing::orbit",
            "missing::orbit_from",
            "missing::orbit_or_last_cycles",
            "missing::simulation",
            "missing::simulation_from",
            "missing::stuck",
        ],
    ),
    (
        "one rounding of the language",
        &[
            "dd::Dd::to_f64",
            "scalar::Float::to_f64",
            "scalar::Scalar::constant",
        ],
    ),
    (
        "fills a structure",
        &[
            "chain::ContactAt::zero",
            "chain::ModeAt::zero",
            "decay::Decay::kind",
            "motion::Carrier::at_rest",
            "decay::Decay::of",
            "decay::Decay::zeta",
            "dual::Dual::fixed",
            "dual::Dual::variable",
            "mode::ModeResponse::zero",
            "steady::Motion::of_contact",
            "steady::Motion::of_mass",
            "steady::mass_wave",
            "steady::motion_wave",
            "wave::Wave::idle",
            "wave::Wave::rest",
        ],
    ),
];

/// Functions of whole scenes, whose error is the scene's as much as theirs, and the test that
/// measures them.
const WHOLE_SCENES: [(&str, &[&str]); 4] = [
    (
        "sums over modes and what is made of them: closed_form, backward",
        &[
            "absorber::Chain::absorbed_force",
            "absorber::Chain::stuck_under",
            "chain::Chain::completed",
            "chain::Chain::contact",
            "chain::Chain::joined_by",
            "chain::Chain::responses",
            "chain::Chain::scaled",
            "chain::Chain::at_scale",
            "motion::Chain::carrier",
            "motion::Chain::contact_carrier",
            "motion::Chain::friction",
            "motion::Chain::mass_share",
            "motion::Chain::share",
            "motion::Chain::stuck",
            "steady::Chain::contact_wave",
            "steady::Chain::contact_waves",
            "steady::Chain::mass_wave",
            "steady::Chain::mass_waves",
            "steady::Motion::amplitude_monoharmonic",
            "steady::Motion::displacement",
            "steady::Motion::harmonic",
            "steady::Motion::velocity",
            "wave::Sum::slope",
            "wave::Sum::value",
            "wave::Wave::value",
        ],
    ),
    (
        "searches: search, closed_form",
        &[
            "constraint::Chain::admitted",
            "constraint::Chain::constraint_per_mode",
            "constraint::Chain::is_continuous",
            "constraint::Chain::stuck_admitted",
            "constraint::Chain::velocity_constraint",
            "search::largest",
            "search::largest_from",
            "steady::Motion::amplitude",
            "steady::Motion::largest",
            "steady::Motion::peak",
            "steady::Motion::phase",
        ],
    ),
    (
        "motion in time and its steady states: stick_slip",
        &[
            "orbit::Orbit::contact",
            "orbit::Orbit::is_marginal",
            "orbit::Orbit::is_settled",
            "orbit::Orbit::is_stable",
            "orbit::Orbit::is_symmetric",
            "orbit::Orbit::mass",
            "orbit::Orbit::mass_at",
            "orbit::Orbit::multipliers",
            "orbit::Orbit::origin",
            "orbit::Orbit::period",
            "orbit::Orbit::reversals",
            "orbit::Orbit::sticking_intervals",
            "orbit::Orbit::stops",
            "orbit::Orbit::stuck_fraction",
            "orbit::numbers",
            "simulation::Contact::reversed",
            "simulation::Dynamics::in_contact",
            "two_stops::TwoStops::amplitude",
            "two_stops::TwoStops::new",
            "two_stops::TwoStops::phase",
            "two_stops::TwoStops::slide",
            "two_stops::TwoStops::stuck_fraction",
        ],
    ),
    (
        "derivatives by the chain rule, from functions of the table: backward",
        &[
            "dual::Dual::add",
            "dual::Dual::div",
            "dual::Dual::mul",
            "dual::Dual::neg",
            "dual::Dual::sub",
        ],
    ),
];

/// The public functions under a module's items, as module::function or module::Type::method.
fn collect(items: &[Item], module: &str, folder: &Path, found: &mut BTreeSet<String>) {
    for item in items {
        match item {
            Item::Mod(inner)
                if matches!(inner.vis, Visibility::Public(_)) && inner.content.is_none() =>
            {
                let name = inner.ident.to_string();
                let path = if module.is_empty() {
                    name.clone()
                } else {
                    format!("{module}::{name}")
                };
                let file = folder.join(format!("{name}.rs"));
                let file = if file.exists() {
                    file
                } else {
                    folder.join(&name).join("mod.rs")
                };
                let text = std::fs::read_to_string(&file).expect("a module's file");
                let parsed = syn::parse_file(&text).expect("Rust");
                collect(&parsed.items, &path, &folder.join(&name), found);
            }
            Item::Fn(function) if matches!(function.vis, Visibility::Public(_)) => {
                found.insert(format!("{module}::{}", function.sig.ident));
            }
            Item::Trait(of) if matches!(of.vis, Visibility::Public(_)) => {
                for item in &of.items {
                    if let TraitItem::Fn(method) = item {
                        found.insert(format!("{module}::{}::{}", of.ident, method.sig.ident));
                    }
                }
            }
            Item::Impl(of) => {
                let Type::Path(of_type) = &*of.self_ty else {
                    continue;
                };
                let name = &of_type.path.segments.last().expect("a name").ident;
                // Of the traits' methods, those of operators; the kernel's own traits count once.
                let operator = of.trait_.as_ref().is_some_and(|of| {
                    let name = format!("{}", of.0.segments.last().expect("a name").ident);
                    ["Add", "Sub", "Mul", "Div", "Neg"].contains(&name.as_str())
                });
                for item in &of.items {
                    let ImplItem::Fn(method) = item else { continue };
                    let public = matches!(method.vis, Visibility::Public(_));
                    if operator || (of.trait_.is_none() && public) {
                        found.insert(format!("{module}::{name}::{}", method.sig.ident));
                    }
                }
            }
            Item::Macro(of) => in_tokens(of.mac.tokens.clone(), module, found),
            _ => {}
        }
    }
}

/// What a macro would define: `pub fn name` anywhere in it.
fn in_tokens(tokens: TokenStream, module: &str, found: &mut BTreeSet<String>) {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    for window in trees.windows(3) {
        if let [
            TokenTree::Ident(visible),
            TokenTree::Ident(keyword),
            TokenTree::Ident(name),
        ] = window
            && visible == "pub"
            && keyword == "fn"
        {
            found.insert(format!("{module}::{name}"));
        }
    }
    for tree in trees {
        if let TokenTree::Group(group) = tree {
            in_tokens(group.stream(), module, found);
        }
    }
}

#[test]
fn every_public_function_has_a_row() {
    let mut found = BTreeSet::new();
    let text = std::fs::read_to_string(format!("{KERNEL}/lib.rs")).expect("the kernel");
    collect(
        &syn::parse_file(&text).expect("Rust").items,
        "",
        Path::new(KERNEL),
        &mut found,
    );
    // How many places name each function.
    let mut named: BTreeMap<&str, usize> = BTreeMap::new();
    let measured: BTreeSet<&str> = cases::all()
        .iter()
        .flat_map(|case| case.covers)
        .copied()
        .collect();
    let listed = NO_NUMBERS
        .iter()
        .chain(&WHOLE_SCENES)
        .flat_map(|(_, functions)| functions.iter().copied());
    for name in measured.iter().copied().chain(listed) {
        *named.entry(name).or_default() += 1;
    }
    let missing: Vec<&String> = found
        .iter()
        .filter(|name| !named.contains_key(name.as_str()))
        .collect();
    assert!(
        missing.is_empty(),
        "public functions without a row: measure them in cases.rs, or say in public.rs why not: {missing:#?}"
    );
    for (name, places) in named {
        assert!(
            found.contains(name),
            "{name} is not, or no longer, a public function"
        );
        assert_eq!(places, 1, "{name} is measured and excused");
    }
}

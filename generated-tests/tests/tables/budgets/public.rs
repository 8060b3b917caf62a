//! Tests, by reading the sources, that every public function of the kernel has a row in the table.

use crate::budgets::cases;
use proc_macro2::{TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use syn::{ImplItem, Item, TraitItem, Type, Visibility};

const KERNEL: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../crates/kernel/src");

/// Functions that compute no numbers of their own. Each list comes with the reason.
const NO_NUMBERS: [(&str, &[&str]); 4] = [
    (
        "hands on, picks or compares numbers as they are",
        &[
            "number::complex::real",
            "number::dd::Dd::abs",
            "number::dd::Dd::is_zero",
            "number::dd::Dd::max",
            "number::dd::Dd::min",
            "number::dd::Dd::neg",
            "number::dd::Dd::new",
            "emitted::check::compare",
            "emitted::check::mixed",
            "emitted::check::sum",
            "emitted::check::with",
            "contact::limits::Chain::loads_contact",
            "contact::limits::Chain::sliding_limit_is_one",
            "contact::regime::check_beta",
            "contact::regime::check_ratio",
            "contact::regime::inverse_ratio_range",
            "contact::regime::limits_into",
            "contact::regime::Limits::margin",
            "contact::regime::Limits::regime",
            "contact::regime::regime",
            "contact::regime::with_ends",
            "number::scalar::Float::at_most",
            "number::scalar::Float::carried",
            "number::scalar::Float::primal",
            "number::scalar::Float::to_index",
            "number::scalar::Float::whole",
            "emitted::written::WrittenFields::flags",
            "emitted::written::WrittenFields::set",
            "emitted::written::WrittenFields::write",
            "emitted::written::Next::value",
            "emitted::written::plain",
            "emitted::written::read",
            "emitted::written::write",
            "number::scalar::Float::inverse_ratio_range",
            "number::scalar::Float::euler_terms",
            "number::scalar::Float::sin_cos_pi_minus_of",
            "number::scalar::Float::sin_cos_pi_of",
            "number::scalar::Float::is_finite",
            "number::scalar::Float::vanishes",
            "number::scalar::Scalar::abs",
            "number::scalar::Scalar::copysign",
            "number::scalar::Scalar::cosine_off_pole",
            "number::scalar::Scalar::detuning_off_pole",
            "number::scalar::Scalar::is_zero",
            "number::scalar::Scalar::lt",
            "number::scalar::Scalar::max",
            "number::scalar::Scalar::min",
            "number::scalar::Scalar::named",
            "number::scalar::Scalar::replaced",
            "number::scalar::Scalar::select",
            "modal_sum::search::Peak::effort",
            "modal_sum::search::most_evaluations",
            "orbit::numbers_of",
            "orbit::Orbit::beta",
            "orbit::Orbit::shapes",
            "contact::quadrature::Quadratures::of",
        ],
    ),
    (
        "is never called, or only passes a call on",
        &[
            "emitted::at",
            "emitted::limits_into",
            "emitted::limits_without_search",
            "emitted::missing::AddLimitsToProvide::answer",
            "emitted::missing::AddMassToMotion::answer",
            "emitted::missing::AddMotionToProvide::answer",
            "emitted::missing::AddOrbitToProvide::answer",
            "emitted::missing::AddSelfCheckToProvide::answer",
            "emitted::missing::AddSimulationToProvide::answer",
            "emitted::missing::AddStepperToProvide::answer",
            "emitted::missing::AddStuckToProvide::answer",
            "emitted::missing::motion",
            "emitted::missing::orbit",
            "emitted::missing::orbit_from",
            "emitted::missing::orbit_or_last_cycles",
            "emitted::missing::stuck",
        ],
    ),
    (
        "one rounding of the language",
        &[
            "number::dd::Dd::to_f64",
            "number::scalar::Float::bits",
            "number::scalar::Float::to_f64",
            "number::scalar::Scalar::constant",
        ],
    ),
    (
        "fills a structure",
        &[
            "contact::driven::DrivenModes::of",
            "contact::sums::ContactAt::zero",
            "contact::sums::ModeAt::zero",
            "oscillator::decay::Decay::free",
            "oscillator::decay::Decay::kind",
            "oscillator::decay::Decay::of",
            "oscillator::decay::Decay::zeta",
            "number::dual::Dual::fixed",
            "number::dual::Dual::variable",
            "oscillator::mode::ModeResponse::zero",
            "response::motion::Motion::of_contact",
            "response::motion::Motion::of_mass",
            "response::motion::mass_wave",
            "response::motion::motion_wave",
            "modal_sum::wave::Wave::idle",
            "modal_sum::wave::Wave::at_rest",
        ],
    ),
];

/// Functions of whole scenes. Their errors depend on the scene as much as on the function. With each list comes the
/// name of the tests that measure its functions.
const WHOLE_SCENES: [(&str, &[&str]); 4] = [
    (
        "sums over modes and what is made of them: closed_form, backward",
        &[
            "contact::absorber::Chain::absorbed_force",
            "contact::absorber::Chain::stuck_under",
            "contact::driven::Chain::limits_of_driven",
            "contact::sums::Chain::begun_by",
            "contact::sums::Chain::completed",
            "contact::pairs::Chain::contact",
            "contact::sums::Chain::joined_by",
            "contact::sums::Chain::contact_of",
            "contact::sums::Chain::contact_loaded",
            "contact::sums::Chain::term",
            "contact::sums::Chain::with_term",
            "contact::pairs::Chain::contact_without_g",
            "contact::pairs::Chain::in_turn",
            "contact::pairs::Chain::loaded_in_turn",
            "contact::sums::Chain::scale",
            "contact::sums::Chain::scaled",
            "contact::sums::Chain::at_scale",
            "response::coefficients::Chain::fundamental",
            "response::coefficients::Chain::fundamental_loaded",
            "response::coefficients::Chain::contact_fundamental",
            "response::coefficients::Chain::friction",
            "response::coefficients::Chain::mass_coefficients",
            "response::coefficients::Chain::modal_coefficients",
            "response::coefficients::Chain::stuck",
            "response::coefficients::Chain::stuck_loaded",
            "response::motion::Chain::contact_wave",
            "response::motion::Chain::mass_wave",
            "response::motion::Motion::acceleration",
            "response::motion::Motion::amplitude_monoharmonic",
            "response::motion::Motion::displacement",
            "response::motion::Motion::harmonic",
            "response::motion::Motion::velocity",
            "modal_sum::wave::Sum::slope",
            "modal_sum::wave::Sum::value",
            "modal_sum::wave::Wave::value",
        ],
    ),
    (
        "searches: search, closed_form",
        &[
            "contact::constraint::Chain::admitted",
            "contact::constraint::Chain::constraint_per_mode",
            "contact::constraint::Chain::is_continuous",
            "contact::constraint::Chain::stuck_admitted",
            "contact::constraint::Chain::velocity_constraint",
            "modal_sum::search::largest",
            "modal_sum::search::largest_near",
            "response::motion::Motion::amplitude",
            "response::motion::Motion::largest",
            "response::motion::Motion::largest_near",
            "response::motion::Motion::peak",
            "response::motion::Motion::phase",
        ],
    ),
    (
        "motion in time and its steady states: stick_slip",
        &[
            "orbit::Orbit::combination",
            "orbit::Orbit::contact",
            "orbit::Orbit::reversed_contact",
            "orbit::Orbit::friction",
            "orbit::Orbit::intervals",
            "orbit::Orbit::is_marginal",
            "orbit::Orbit::is_settled",
            "orbit::Orbit::is_stable",
            "orbit::Orbit::is_symmetric",
            "orbit::Orbit::mass",
            "orbit::Orbit::mass_at",
            "orbit::Orbit::multipliers",
            "orbit::Orbit::offset_range",
            "orbit::Orbit::origin",
            "orbit::Orbit::period",
            "orbit::Orbit::reversals",
            "orbit::Orbit::sliding_distance",
            "orbit::Orbit::sticking_intervals",
            "orbit::Orbit::stops",
            "orbit::Orbit::stuck_fraction",
            "orbit::numbers",
        ],
    ),
    (
        "derivatives by the chain rule, from functions of the table: backward",
        &[
            "number::dual::Dual::add",
            "number::dual::Dual::div",
            "number::dual::Dual::mul",
            "number::dual::Dual::neg",
            "number::dual::Dual::sub",
        ],
    ),
];

/// Collects the public functions of a module as module::function or module::Type::method.
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
                // Methods of operator traits count for each type. Methods of the kernel's own traits count once.
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

/// Collects the functions that a macro would define: every `pub fn name` in it.
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
    // `named` counts the lists that contain each function.
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
    let gone: Vec<&&str> = named
        .keys()
        .filter(|name| !found.contains(**name))
        .collect();
    assert!(
        gone.is_empty(),
        "not, or no longer, public functions: {gone:#?}"
    );
    let twice: Vec<&&str> = named
        .iter()
        .filter_map(|(name, places)| (*places != 1).then_some(name))
        .collect();
    assert!(twice.is_empty(), "measured and excused: {twice:#?}");
}

//! Emits the scene's type and all constants that do not depend on the frequency.

use super::about;
use super::emission::{Checked, Emission, EmittedCode, rounded};
use super::fields::fields;
use super::names::TypeNames;
use super::units;
use frictiongen_kernel::modal_sum::search::MAX_EVALUATIONS;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_model::scene::Excitation;
use proc_macro2::{Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>) -> EmittedCode {
    let Emission {
        description,
        scene,
        modal,
        precision,
        scalar,
        facade,
        names: TypeNames { name, .. },
        ..
    } = emission;
    let visibility = &description.visibility;
    let at_about = format!(" [`{name}`] at one frequency ratio: {}.", answers(emission));
    let work_about = work_about(emission);
    let at = &emission.names.at;
    let inner = if emission.is_tabled() {
        code!(table::Compiled)
    } else {
        code!(response::At)
    };
    let at_type = scene.needs_frequency().then(|| {
        code! {
            #[doc = #at_about]
            ///
            #[doc = #work_about]
            #[allow(deprecated, non_camel_case_types, reason = "names and attributes are those of the description")]
            #visibility struct #at(#facade::kernel::#inner<#name>);
        }
    });
    let scene_type = about::scene_type(emission);
    let types = code! {
        #scene_type
        #at_type
    };

    let masses = Literal::usize_unsuffixed(scene.masses.len());
    let round = |value| rounded(value, *precision);
    let frequencies: Vec<f64> = modal.natural_frequencies().into_iter().map(round).collect();
    let resonances: Vec<f64> = modal.resonances.iter().map(|value| round(*value)).collect();
    let shapes: Vec<Vec<f64>> = modal
        .shapes
        .iter()
        .map(|shape| shape.iter().map(|value| round(*value)).collect())
        .collect();
    let units = units::emit(emission, (&frequencies, &resonances));
    let constants = units.constants.into_iter().chain([
        Checked::new(
            "MODE_SHAPES",
            code!(&Self::MODE_SHAPES),
            &shapes.concat().as_slice(),
        ),
        Checked::new("CHAIN", code!(&Self::CHAIN), &emission.reduced.chain),
    ]);
    let constants = constants.collect();
    let (frequencies, resonances) = (emission.list(frequencies), emission.list(resonances));
    let shapes = shapes.into_iter().map(|shape| emission.list(shape));
    let (units, conversions) = (units.associated, units.items);
    let (chain, at_rest) = (chain(emission), at_rest(emission));
    let spring = emission.reduced.compliance.map(|compliance| {
        let compliance = emission.literal(compliance);
        code! {
            /// Constants of the chain and of its elastic contact.  ρ = k₁/k is the compliance of the spring in series with
            /// the slider.
            const CONTACT: ElasticChain<#scalar> =
                ElasticChain { chain: Self::CHAIN, compliance: #compliance };
        }
    });
    let associated = code! {
            #units
            /// Natural frequencies ω_i, ascending; rad/s if masses are in kg and springs in N/m.
            pub const NATURAL_FREQUENCIES: [#scalar; #masses] = #frequencies;
            /// Frequency ratios r of the undamped resonances, √λ_i = ω_i√(m₁/k₁).
            pub const RESONANCES: [#scalar; #masses] = #resonances;
            /// Mode shapes φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁).  The first component that is not 0 is positive.
            pub const MODE_SHAPES: [[#scalar; #masses]; #masses] = [#(#shapes),*];

            #at_rest

            /// Constants of the chain.
            const CHAIN: Chain<#scalar> = #chain;

            #spring

            #conversions
    };
    let mut part = EmittedCode {
        types,
        associated,
        constants,
        ..EmittedCode::default()
    };
    if scene.needs_frequency() {
        part.join(at_frequency(emission));
    }
    part
}

/// Emits the constants for the evaluation of the scene at one frequency ratio r, and the constructor `at`.
fn at_frequency(emission: &Emission<'_>) -> EmittedCode {
    let Emission {
        scene,
        scalar,
        facade,
        names: TypeNames { name, at, .. },
        ..
    } = emission;
    let mode_count = Literal::usize_unsuffixed(emission.modes());
    let modes = mode_constants(emission, &emission.reduced.modes);
    let ends = emission.reduced.ends;
    let rubbing = rubbing(emission.reduced.rubbing);
    let absorbs = emission.reduced.absorbs;
    let unbounded = emission.list(emission.reduced.unbounded.iter().copied());
    let invisible = emission.list(emission.reduced.invisible.iter().copied());
    let sliding_at_rest = emission.literal(ends.sliding_at_rest);
    let continuous_at_infinity = emission.literal(ends.continuous_at_infinity);
    let sliding_at_infinity = emission.literal(ends.sliding_at_infinity);
    let ends = fields(
        true,
        &[
            ("sliding_at_rest", sliding_at_rest, "β*_lim for r → 0"),
            (
                "continuous_at_infinity",
                continuous_at_infinity,
                "β_lim for r → ∞",
            ),
            (
                "sliding_at_infinity",
                sliding_at_infinity,
                "β*_lim for r → ∞",
            ),
        ],
    );
    let numbers = fields(
        true,
        &[
            (
                "modes",
                code!(&Self::MODES),
                "modes that the load or the contact drives",
            ),
            ("chain", code!(Self::CHAIN), "constants of the chain"),
            (
                "ends",
                code!(Ends { #ends }),
                "limits of β for r → 0 and for r → ∞, which a range of tables does not restrict; β_lim for r → 0 is 0",
            ),
            (
                "rubbing",
                rubbing,
                "index of the mass that rubs on a support",
            ),
            (
                "absorbs",
                code!(#absorbs),
                "true if V and H may have a common zero: the chain then absorbs the load, and the limits follow from the force that holds a stuck contact",
            ),
            (
                "unbounded",
                code!(&#unbounded),
                "undamped resonances that the load drives",
            ),
            (
                "invisible",
                code!(&#invisible),
                "those of them in which the contact does not move",
            ),
        ],
    );
    let names = scene.masses.iter().map(|mass| mass.name.as_str());
    let of = if emission.is_tabled() {
        code!(Compiled)
    } else {
        code!(At)
    };
    let constants = vec![
        Checked::new(
            "MODES",
            code!(&Self::MODES),
            &emission.reduced.modes.as_slice(),
        ),
        Checked::new(
            "NUMBERS",
            code!(&Self::NUMBERS),
            &emission.reduced.numbers(),
        ),
    ];
    let associated = code! {
            /// Modes that the load or the contact drives.
            const MODES: [Mode<#scalar>; #mode_count] = [#(#modes),*];
            /// Constants of the steady response.
            const NUMBERS: Numbers<'static, #scalar> = Numbers { #numbers };
    };
    let items = code! {
        /// The functions `at`, `limits_without_search` and `limits_into`.
        #facade::kernel::scene_functions!(#name, #at, #scalar, #of);
        /// The trait `FrictionSystem`, by which generic code calls any scene.  The texts are the names of the masses.
        #facade::emitted_system!(#name, #at, #scalar, [#(#names),*]);
    };
    EmittedCode {
        associated,
        items,
        constants,
        ..EmittedCode::default()
    }
}

/// Emits the index of the mass that slides on a support, as an `Option`. It is `None` if two masses slide on each
/// other.
pub(super) fn rubbing(mass: Option<usize>) -> TokenStream {
    match mass {
        None => code!(None),
        Some(mass) => {
            let mass = Literal::usize_unsuffixed(mass);
            code!(Some(#mass))
        }
    }
}

/// Emits modes as constants. Comments in the first mode explain the fields.
pub(super) fn mode_constants(emission: &Emission<'_>, modes: &[Mode<f64>]) -> Vec<TokenStream> {
    let modes = modes.iter().enumerate();
    modes
        .map(|(index, mode)| mode_constant(emission, mode, index == 0))
        .collect()
}

fn mode_constant(emission: &Emission<'_>, mode: &Mode<f64>, first: bool) -> TokenStream {
    let Mode {
        kind, in_contact, ..
    } = mode;
    let kind = self::kind(*kind);
    let of = |value| emission.literal(value);
    let (resonance, zeta, q) = (of(mode.resonance), of(mode.zeta), of(mode.q));
    let (q_defect, load, contact) = (of(mode.q_defect), of(mode.load), of(mode.contact));
    let (residue, contact_squared) = (of(mode.residue), of(mode.contact_squared));
    let static_residue = of(mode.static_residue);
    let load_about = match emission.scene.excitation {
        Excitation::Base => "φᵀp, with p the load on each mass over k₁Y",
        Excitation::Force(_) => "φᵀp, with p the load on each mass over P",
    };
    let fields = fields(
        first,
        &[
            (
                "kind",
                code!(Kind::#kind),
                "kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1",
            ),
            (
                "in_contact",
                code!(#in_contact),
                "true if the contact drives the mode: φᵀw is not 0",
            ),
            (
                "resonance",
                resonance,
                "√λ, the frequency ratio r of the undamped resonance",
            ),
            ("zeta", zeta, "ζ, the modal damping ratio"),
            ("q", q, "√|1 − ζ²|"),
            ("q_defect", q_defect, "1 − q"),
            ("load", load, load_about),
            (
                "contact",
                contact,
                "φᵀw, with w = 1 at the mass that rubs and −1 at its partner",
            ),
            ("residue", residue, "(φᵀp)(φᵀw)"),
            ("contact_squared", contact_squared, "(φᵀw)², the term of m*"),
            ("static_residue", static_residue, "(φᵀp)(φᵀw)/λ"),
        ],
    );
    code!(Mode { #fields })
}

/// Emits the name of the enum variant for a kind of damping.
pub(super) fn kind(kind: Kind) -> TokenStream {
    match kind {
        Kind::Undamped => code!(Undamped),
        Kind::Light => code!(Light),
        Kind::Heavy => code!(Heavy),
        Kind::Critical => code!(Critical),
        Kind::Over => code!(Over),
    }
}

/// Returns the documentation line with the worst-case work of the methods at one frequency.
fn work_about(emission: &Emission<'_>) -> String {
    if emission.is_tabled() {
        return " Worst case: the operations of `tabled_limit` and `tabled_sliding_limit` together."
            .to_owned();
    }
    let stage = if emission.in_passes() {
        "frequency_stage"
    } else {
        "functions"
    };
    let modes = emission.modes();
    let plural = if modes == 1 { "" } else { "s" };
    format!(
        " Worst case: the operations of `{stage}`, and in each search at most `most_evaluations()` sums over {modes} mode{plural}.  This number depends on r, and never exceeds {MAX_EVALUATIONS}."
    )
}

/// Lists, for the documentation, the quantities available at one frequency.
fn answers(emission: &Emission<'_>) -> String {
    let wanted = emission.wanted();
    let mut answers = vec!["limits", "regime"];
    if wanted.motion.is_some() {
        answers.push("continuous motion");
    }
    if wanted.stuck {
        answers.push("stuck response");
    }
    if wanted.orbit {
        answers.push("steady states");
    }
    answers.join(", ")
}

/// Returns the expression for the relative displacement of the contact on a moving base for r → 0. The expression is
/// the name `AT_REST` of an emitted constant. For 0, 1 and −1, which the formulas fold, the expression is the number
/// itself.
fn at_rest_by_name(emission: &Emission<'_>, at_rest: f64) -> TokenStream {
    if at_rest == 0.0 || at_rest.abs() == 1.0 {
        emission.literal(at_rest)
    } else {
        code!(Self::AT_REST)
    }
}

/// Emits the constant `AT_REST`, to which `at_rest_by_name` refers. Returns `None` for 0, 1 and −1, which need no
/// name.
fn at_rest(emission: &Emission<'_>) -> Option<TokenStream> {
    let scalar = &emission.scalar;
    let at_rest = emission.reduced.chain.on_moving_base?;
    if at_rest == 0.0 || at_rest.abs() == 1.0 {
        return None;
    }
    let at_rest = emission.literal(at_rest);
    Some(code! {
        /// Relative motion of the contact on the moving base for r → 0, over Y.
        const AT_REST: #scalar = #at_rest;
    })
}

fn chain(emission: &Emission<'_>) -> TokenStream {
    let chain = &emission.reduced.chain;
    let damped = chain.damped;
    let on_moving_base = match chain.on_moving_base {
        None => code!(None),
        Some(at_rest) => {
            let at_rest = at_rest_by_name(emission, at_rest);
            code!(Some(#at_rest))
        }
    };
    let inverse_mass = emission.literal(chain.inverse_mass);
    let stiction = emission.literal(chain.stiction);
    let fields = fields(
        true,
        &[
            ("damped", code!(#damped), "true if a mode is damped"),
            (
                "on_moving_base",
                on_moving_base,
                "relative motion in the contact for r → 0, over the amplitude Y of the base motion, if the contact rubs on the moving base",
            ),
            (
                "inverse_mass",
                inverse_mass,
                "m* = m₁/(effective mass of the contact)",
            ),
            ("stiction", stiction, "μ, static over kinetic friction"),
        ],
    );
    code!(Chain { #fields })
}

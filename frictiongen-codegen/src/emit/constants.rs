//! Emits the scene's type and all constants that do not depend on the frequency.

use super::emission::{Emission, Part, rounded};
use super::fingerprint::fingerprint;
use super::limits;
use super::names::TypeNames;
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_model::scene::{Beyond, Excitation};
use proc_macro2::{Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>) -> Part {
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
    let attributes = &description.attributes;
    let visibility = &description.visibility;
    let header = format!(
        " Emitted by frictiongen {} from scene {:016x}.",
        env!("CARGO_PKG_VERSION"),
        fingerprint(scene)
    );
    let source = " Numbers in brackets are equations of L. Marino, *Dynamic analysis of mechanical systems with Coulomb friction*, Oxford 2021.";
    let at_about = format!(" [`{name}`] at one frequency ratio: {}.", answers(emission));
    let at = &emission.names.at;
    let inner = if emission.is_tabled() {
        code!(table::Compiled)
    } else {
        code!(response::At)
    };
    let at_type = scene.needs_frequency().then(|| {
        code! {
            #[doc = #at_about]
            #[allow(deprecated, non_camel_case_types)]
            #visibility struct #at(#facade::kernel::#inner<#name>);
        }
    });
    // An empty doc line separates the header from the scene's own documentation.
    let documented = attributes
        .iter()
        .any(|attribute| attribute.path().is_ident("doc"));
    let blank = documented.then(|| code!(#[doc = ""]));
    let types = code! {
        #(#attributes)*
        #blank
        #[doc = #header]
        #[doc = #source]
        #[::core::prelude::v1::derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::cmp::Eq,
            ::core::cmp::PartialEq,
            ::core::default::Default,
            ::core::hash::Hash
        )]
        #visibility struct #name;
        #at_type
    };

    let masses = Literal::usize_unsuffixed(scene.masses.len());
    let round = |value| rounded(value, *precision);
    let frequencies = emission.list(modal.natural_frequencies().into_iter().map(round));
    let resonances = emission.list(modal.resonances.iter().map(|value| round(*value)));
    let shapes = modal
        .shapes
        .iter()
        .map(|shape| emission.list(shape.iter().map(|value| round(*value))));
    let reference = round(modal.reference);
    let frequency_ratio = if reference == 1.0 {
        code!(omega)
    } else {
        let reference = emission.literal(reference);
        code!(omega / #reference)
    };
    let chain = chain(emission);
    let chain_about = chain_about(emission);
    let ratio_about = match scene.excitation {
        Excitation::Base => {
            " β = F/(k₁Y) of a kinetic friction force F; `load` is k₁Y, Y the amplitude of the base's motion."
        }
        Excitation::Force(_) => {
            " β = F/P of a kinetic friction force F; `load` is P, the amplitude of the force."
        }
    };
    let associated = code! {
            /// ω_i, the natural frequencies, ascending: rad/s if masses are in kg and springs in N/m.
            pub const NATURAL_FREQUENCIES: [#scalar; #masses] = #frequencies;
            /// √λ_i = ω_i√(m₁/k₁): the frequency ratios r of the undamped resonances.
            pub const RESONANCES: [#scalar; #masses] = #resonances;
            /// φ, [mode][mass], with φᵀΓφ = 1 and Γ = diag(m_i/m₁); the first component of each that is not 0 is positive.
            pub const MODE_SHAPES: [[#scalar; #masses]; #masses] = [#(#shapes),*];

            #(#[doc = #chain_about])*
            const CHAIN: Chain<#scalar> = #chain;

            /// An angular frequency, rad/s, as frequency ratio r = ω√(m₁/k₁).
            #[inline]
            #[must_use]
            pub const fn frequency_ratio(omega: #scalar) -> #scalar {
                #frequency_ratio
            }

            #[doc = #ratio_about]
            #[inline]
            #[must_use]
            pub const fn friction_ratio(friction: #scalar, load: #scalar) -> #scalar {
                friction / load
            }
    };
    let mut part = Part {
        types,
        associated,
        items: TokenStream::new(),
    };
    if scene.needs_frequency() {
        part.join(at_frequency(emission));
    }
    part
}

/// Emits the constants of the frequency stage and the constructor `at`.
fn at_frequency(emission: &Emission<'_>) -> Part {
    let Emission {
        scene,
        scalar,
        facade,
        names: TypeNames { name, at, .. },
        ..
    } = emission;
    let slices = limits::slices(emission);
    let mode_count = Literal::usize_unsuffixed(emission.modes());
    let modes = emission
        .reduced
        .modes
        .iter()
        .map(|mode| mode_constant(emission, mode));
    let ends = emission.reduced.ends;
    let rubbing = rubbing(emission.reduced.rubbing);
    let absorbs = emission.reduced.absorbs;
    let unbounded = emission.list(emission.reduced.unbounded.iter().copied());
    let invisible = emission.list(emission.reduced.invisible.iter().copied());
    let sliding_at_rest = emission.literal(ends.sliding_at_rest);
    let continuous_at_infinity = emission.literal(ends.continuous_at_infinity);
    let sliding_at_infinity = emission.literal(ends.sliding_at_infinity);
    let names = scene.masses.iter().map(|mass| mass.name.as_str());
    let constructor = constructor(emission);
    let associated = code! {
            /// The modes that the load or the contact drives: `resonance` √λ, `q` √|1 − ζ²|, `q_defect` 1 − q, `load` φᵀp,
            /// with p where the load acts; `contact` φᵀw, with w 1 at the mass that rubs and −1 at its partner; `residue` their
            /// product, `inverse_mass` (φᵀw)², `static_residue` residue/λ.  A mode is `Light` below ζ = 1/2, `Heavy` below 1, `Over` above;
            /// `in_contact`: φᵀw is not 0.
            const MODES: [Mode<#scalar>; #mode_count] = [#(#modes),*];
            /// `ends`: β*_lim for r → 0, both limits for r → ∞; `rubbing`: the mass that rubs on a support at rest; `absorbs`:
            /// V and H may share zeros, where the holding force says what a limit is; `unbounded`: undamped resonances that
            /// the load drives, `invisible`: those that the contact does not touch.
            const NUMBERS: Numbers<'static, #scalar> = Numbers {
                modes: &Self::MODES,
                chain: Self::CHAIN,
                ends: Ends {
                    sliding_at_rest: #sliding_at_rest,
                    continuous_at_infinity: #continuous_at_infinity,
                    sliding_at_infinity: #sliding_at_infinity,
                },
                rubbing: #rubbing,
                absorbs: #absorbs,
                unbounded: &#unbounded,
                invisible: &#invisible,
            };

            #constructor

            #slices
    };
    let items = code!(#facade::emitted_system!(#name, #at, #scalar, [#(#names),*]););
    Part {
        types: TokenStream::new(),
        associated,
        items,
    }
}

/// Emits `at`, which evaluates the scene at a frequency ratio.
fn constructor(emission: &Emission<'_>) -> TokenStream {
    let Emission {
        scalar,
        names: TypeNames { at, .. },
        ..
    } = emission;
    if !emission.is_tabled() {
        return code! {
            /// The scene at the frequency ratio r = ω√(m₁/k₁).
            ///
            /// # Errors
            /// `OutOfDomain` for NaN and negative r; 0 and ∞ answer with the limits.
            #[inline]
            pub fn at(r: #scalar) -> Result<#at, OutOfDomain> {
                At::new(Self, r).map(From::from)
            }
        };
    }
    let errors = match emission.scene.declared.beyond {
        Beyond::Error => " `OutOfDomain` beyond the declared range, and for NaN.",
        Beyond::Exact => {
            " `OutOfDomain` for NaN and negative r; beyond the declared range the exact formulas answer."
        }
    };
    code! {
        /// The scene at the frequency ratio r = ω√(m₁/k₁), to the declared accuracy.
        ///
        /// # Errors
        #[doc = #errors]
        #[inline]
        pub fn at(r: #scalar) -> Result<#at, OutOfDomain> {
            Compiled::new(Self, r).map(From::from)
        }
    }
}

/// Emits the mass that rubs on a support as an `Option` constant.
pub(super) fn rubbing(mass: Option<usize>) -> TokenStream {
    match mass {
        None => code!(None),
        Some(mass) => {
            let mass = Literal::usize_unsuffixed(mass);
            code!(Some(#mass))
        }
    }
}

/// Emits a mode as a constant.
pub(super) fn mode_constant(emission: &Emission<'_>, mode: &Mode<f64>) -> TokenStream {
    let Mode {
        kind, in_contact, ..
    } = mode;
    let kind = self::kind(*kind);
    let of = |value| emission.literal(value);
    let (resonance, zeta, q) = (of(mode.resonance), of(mode.zeta), of(mode.q));
    let (q_defect, load, contact) = (of(mode.q_defect), of(mode.load), of(mode.contact));
    let (residue, inverse_mass) = (of(mode.residue), of(mode.inverse_mass));
    let static_residue = of(mode.static_residue);
    code! {
        Mode {
            kind: Kind::#kind,
            in_contact: #in_contact,
            resonance: #resonance,
            zeta: #zeta,
            q: #q,
            q_defect: #q_defect,
            load: #load,
            contact: #contact,
            residue: #residue,
            inverse_mass: #inverse_mass,
            static_residue: #static_residue,
        }
    }
}

/// Emits the variant name of a damping kind.
pub(super) fn kind(kind: Kind) -> TokenStream {
    match kind {
        Kind::Undamped => code!(Undamped),
        Kind::Light => code!(Light),
        Kind::Heavy => code!(Heavy),
        Kind::Critical => code!(Critical),
        Kind::Over => code!(Over),
    }
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

fn chain_about(emission: &Emission<'_>) -> Vec<&'static str> {
    let mut about = vec![
        " The chain: `damped`, whether a mode is; `inverse_mass` m* = m₁/(effective mass of the contact), `stiction` μ, static over kinetic friction.",
    ];
    if emission.reduced.chain.on_moving_base.is_some() {
        about.push(
            " `on_moving_base`: the contact rubs on the moving base; its relative motion over Y for r → 0.",
        );
    } else {
        about.push(" `on_moving_base`: none, as the contact does not rub on a moving base.");
    }
    about
}

fn chain(emission: &Emission<'_>) -> TokenStream {
    let chain = &emission.reduced.chain;
    let damped = chain.damped;
    let on_moving_base = match chain.on_moving_base {
        None => code!(None),
        Some(at_rest) => {
            let at_rest = emission.literal(at_rest);
            code!(Some(#at_rest))
        }
    };
    let inverse_mass = emission.literal(chain.inverse_mass);
    let stiction = emission.literal(chain.stiction);
    code! {
        Chain {
            damped: #damped,
            on_moving_base: #on_moving_base,
            inverse_mass: #inverse_mass,
            stiction: #stiction,
        }
    }
}

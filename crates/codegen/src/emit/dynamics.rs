//! Emits the constants of the time-domain solvers: all modes of the chain, and its *held modes*. Held modes are the
//! modes of the chain with its contact stuck.

use super::constants::{kind, mode_constants, rubbing};
use super::emission::{self, Emission, Wanted, rounded};
use super::fields::fields;
use super::shapes;
use frictiongen_kernel::motion::{HeldMode, LOST_MODES};
use frictiongen_kernel::oscillator::mode::Mode;
use frictiongen_model::transient::Transient;
use proc_macro2::{Literal, TokenStream};

/// Emitted constants of the time-domain solvers, with the sizes of their arrays.
pub(super) struct DynamicsConstants {
    pub associated: TokenStream,
    /// Number of scalars in a state of a steady motion: two for each mode that the contact drives, and the force of an
    /// elastic contact.
    pub state: usize,
    /// Number of modes of the chain with its contact stuck.
    pub held: usize,
    /// Number of oscillators: the modes of the chain, plus the modes of the chain with its contact stuck.
    pub parts: usize,
    /// Checksum of the constants of the motion in time.
    pub sum: u32,
}

pub(super) fn emit(emission: &Emission<'_>, wanted: &Wanted<'_>) -> DynamicsConstants {
    let Emission {
        scene,
        modal,
        precision,
        scalar,
        ..
    } = emission;
    let transient = Transient::<f64>::of(scene, modal, |value| rounded(value, *precision));
    let modes = modes(emission, &transient);
    let held = transient.held.iter().enumerate();
    let held = held.map(|(index, mode)| self::held(emission, mode, index == 0));
    let participations = transient.participations.iter();
    let participations = participations.map(|pair| emission.list(pair.iter().copied()));
    let known = emission.scene.needs_frequency() && wanted.shapes();
    let (own_shapes, shapes) = if known && transient.shapes == emission.reduced.shapes {
        (None, code!(Self::SHAPES))
    } else {
        let shapes = shapes::by_masses(emission, &transient.shapes);
        let masses = count(scene.masses.len());
        let own = code! {
            /// φ of all modes, [mass][mode].
            const ALL_SHAPES: [[#scalar; #masses]; #masses] = #shapes;
        };
        (Some(own), code!(Self::ALL_SHAPES))
    };
    let weights = emission.list(transient.weights.iter().copied());
    let from_base = transient.weights.len() > transient.shapes.len();
    let from_base = from_base.then(|| {
        code! {
            /// Damping acts relative to the base: at the end of `weights` each mode has its load in quadrature, 2ζλΓ with Γ = φᵀΓ1, and
            /// `static_residue` − (φᵀw)Γ.
        }
    });
    let rubbing = rubbing(transient.rubbing);
    let elastic = emission.is_elastic();
    let (chain, chain_about) = if elastic {
        let about = "constants of the chain and of its elastic contact";
        (code!(Self::CONTACT), about)
    } else {
        (code!(Self::CHAIN), "constants of the chain")
    };
    let law = emission.law();
    let numbers = fields(
        true,
        &[
            ("chain", chain, chain_about),
            (
                "modes",
                modes,
                "all modes, those that the contact drives first",
            ),
            (
                "held",
                code!(&[#(#held),*]),
                "modes of the chain with its contact stuck; the state of a mode is y and u = y′/Ω",
            ),
            (
                "participations",
                code!(&[#(#participations),*]),
                "displacement of a mode of the chain per unit of y and of u: for each mode of `held` in turn, one pair for each mode that the contact drives; the largest number of a held mode has the modulus 1",
            ),
            (
                "shapes",
                code!(#shapes.as_flattened()),
                "φ, mass after mass",
            ),
            ("weights", code!(&#weights), "φᵀΓ, mode after mode"),
            (
                "rubbing",
                rubbing,
                "index of the mass that rubs on a support",
            ),
        ],
    );
    let associated = code! {
            #own_shapes

            /// Constants of the motion in time.
            #from_base
            const DYNAMICS: Dynamics<'static, #scalar #law> = Dynamics { #numbers };
    };
    // A rigid contact that sticks removes `LOST_MODES` modes from the chain. A stuck elastic contact removes none,
    // because its spring can still deform.
    let lost = if elastic { 0 } else { LOST_MODES };
    let driven = transient.held.len() + lost;
    DynamicsConstants {
        associated,
        state: 2 * driven + usize::from(elastic),
        held: transient.held.len(),
        parts: transient.modes.len() + transient.held.len(),
        sum: emission::sum(&transient.dynamics()),
    }
}

/// Emits all modes of the chain as an array. If the constant `MODES` of the steady response has the same modes, emits
/// a reference to `MODES` instead.
fn modes(emission: &Emission<'_>, transient: &Transient<f64>) -> TokenStream {
    let all = |modes: &[Mode<f64>]| {
        let modes = mode_constants(emission, modes);
        code!([#(#modes),*])
    };
    let modes = all(&transient.modes);
    let same = all(&emission.reduced.modes).to_string() == modes.to_string();
    if emission.scene.needs_frequency() && same {
        code!(&Self::MODES)
    } else {
        code!(&#modes)
    }
}

/// Emitted comment on the field `inverse` of a held mode, which is a mode of the chain with its contact stuck
/// (derivation, section 7).
const INVERSE: &str = "m₁₁, m₁₂ and m₂₂ give y = m₁₁B(η, g) + m₁₂B(η, h) and u = m₁₂B(η, g) + m₂₂B(η, h).  η is the motion of the chain's modes minus the static motion that the stuck contact causes.  g and h are the `participations` of y and u.  B(a, b) is the sum of 2ζσab + a′b + ab′ over the chain's modes, with σ = `resonance`.  g′ is −Ωh, and h′ is Ω(g − 2ζh), with Ω = `frequency` and ζ of this mode.  [m₁₁, m₁₂, m₂₂] = [B(h, h), −B(g, h), B(g, g)]/(B(g, g)B(h, h) − B(g, h)²)";

fn held(emission: &Emission<'_>, mode: &HeldMode<f64>, first: bool) -> TokenStream {
    let kind = kind(mode.kind);
    let of = |value| emission.literal(value);
    let (frequency, zeta, q, force) = (
        of(mode.frequency),
        of(mode.zeta),
        of(mode.q),
        of(mode.force),
    );
    let inverse = emission.list(mode.inverse);
    let fields = fields(
        first,
        &[
            (
                "kind",
                code!(Kind::#kind),
                "kind of damping: `Undamped` for ζ = 0, `Light` for ζ < 1/2, `Heavy` for ζ < 1, `Critical` for ζ = 1, `Over` for ζ > 1",
            ),
            (
                "frequency",
                frequency,
                "|s| of the oscillator's root s, over √(k₁/m₁): without damping, the frequency ratio r of the resonance",
            ),
            ("zeta", zeta, "ζ = −Re s/|s|"),
            ("q", q, "√|1 − ζ²|"),
            (
                "force",
                force,
                "force of the chain on the contact, with its damping force, at y = −1",
            ),
            ("inverse", inverse, INVERSE),
        ],
    );
    code!(HeldMode { #fields })
}

/// Returns a whole number as a literal of the emitted code.
pub(super) fn count(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

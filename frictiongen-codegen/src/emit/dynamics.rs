//! Emits the constants of the time-domain solvers: all modes of the chain, and its *held modes*,
//! which are those with the contact stuck.

use super::constants::{kind, mode_constant, rubbing};
use super::emission::{Emission, Wanted, rounded};
use super::shapes;
use frictiongen_kernel::motion::{HeldMode, LOST_MODES};
use frictiongen_kernel::oscillator::mode::Mode;
use frictiongen_model::transient::Transient;
use proc_macro2::{Literal, TokenStream};

/// Emitted constants of the time-domain solvers, with the sizes of their arrays.
pub(super) struct Constants {
    pub associated: TokenStream,
    /// Number of modes that the contact drives.
    pub driven: usize,
    /// Number of all modes and all held modes together.
    pub parts: usize,
}

pub(super) fn emit(emission: &Emission<'_>, wanted: &Wanted<'_>) -> Constants {
    let Emission {
        scene,
        modal,
        precision,
        scalar,
        ..
    } = emission;
    let transient = Transient::<f64>::of(scene, modal, |value| rounded(value, *precision));
    let modes = modes(emission, &transient);
    let held = transient.held.iter().map(|mode| held(emission, mode));
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
    let associated = code! {
            #own_shapes

            /// The motion in time: all modes, those that the contact drives first, and the modes of the chain with its contact
            /// held.  Of a held mode `frequency` is √λ, `force` −(contact force)/y, and `inverse` the symmetric matrix
            /// [m₁₁, m₁₂, m₂₂] that takes the products of a motion with its two states to y and u.  `participations`: how far
            /// each free mode takes part in y and u of each held one; `shapes`: φ, mass after mass; `weights`: φᵀΓ, mode after
            /// mode.
            #from_base
            const DYNAMICS: Dynamics<'static, #scalar> = Dynamics {
                chain: Self::CHAIN,
                modes: #modes,
                held: &[#(#held),*],
                participations: &[#(#participations),*],
                shapes: #shapes.as_flattened(),
                weights: &#weights,
                rubbing: #rubbing,
            };
    };
    let driven = transient.held.len() + LOST_MODES;
    Constants {
        associated,
        driven,
        parts: transient.modes.len() + transient.held.len(),
    }
}

/// Emits all modes. The constant `MODES` of the steady response is reused if it lists the same
/// modes.
fn modes(emission: &Emission<'_>, transient: &Transient<f64>) -> TokenStream {
    let all = |modes: &[Mode<f64>]| {
        let modes = modes.iter().map(|mode| mode_constant(emission, mode));
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

fn held(emission: &Emission<'_>, mode: &HeldMode<f64>) -> TokenStream {
    let kind = kind(mode.kind);
    let of = |value| emission.literal(value);
    let (frequency, zeta, q, force) = (
        of(mode.frequency),
        of(mode.zeta),
        of(mode.q),
        of(mode.force),
    );
    let inverse = emission.list(mode.inverse);
    code! {
        HeldMode {
            kind: Kind::#kind,
            frequency: #frequency,
            zeta: #zeta,
            q: #q,
            force: #force,
            inverse: #inverse,
        }
    }
}

/// Returns a count as a literal.
pub(super) fn count(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

//! What the motion in time rests on, as constants: every mode, and the chain with its contact held.

use super::constants::{kind, mode_constant, rubbing};
use super::{Emission, rounded};
use frictiongen_kernel::simulation::HeldMode;
use frictiongen_model::transient::Transient;
use proc_macro2::{Literal, TokenStream};

/// The constants, and how many of what there are.
pub(super) struct Constants {
    pub items: TokenStream,
    /// Modes that the contact drives.
    pub driven: usize,
    /// All modes and all held modes.
    pub parts: usize,
}

pub(super) fn emit(emission: &Emission<'_>) -> Constants {
    let Emission {
        scene,
        modal,
        precision,
        scalar,
        name,
        ..
    } = emission;
    let transient = Transient::<f64>::of(scene, modal, |value| rounded(value, *precision));
    let modes = transient.modes.iter();
    let modes = modes.map(|mode| mode_constant(emission, mode));
    let held = transient.held.iter().map(|mode| held(emission, mode));
    let shares = transient.shares.iter();
    let shares = shares.map(|pair| emission.list(pair.iter().copied()));
    let shapes = emission.list(transient.shapes.iter().copied());
    let weights = emission.list(transient.weights.iter().copied());
    let rubbing = rubbing(transient.rubbing);
    let items = code! {
        impl #name {
            /// The motion in time: all modes, those that the contact drives first, and the modes of
            /// the chain with its contact held.
            const DYNAMICS: Dynamics<'static, #scalar> = Dynamics {
                chain: #name::CHAIN,
                modes: &[#(#modes),*],
                held: &[#(#held),*],
                shares: &[#(#shares),*],
                shapes: &#shapes,
                weights: &#weights,
                rubbing: #rubbing,
            };
        }
    };
    let driven = transient.held.len() + 1;
    Constants {
        items,
        driven,
        parts: transient.modes.len() + transient.held.len(),
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

/// A count as a literal.
pub(super) fn count(value: usize) -> Literal {
    Literal::usize_unsuffixed(value)
}

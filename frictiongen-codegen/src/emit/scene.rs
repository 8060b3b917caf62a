//! The scene as the kernel's response knows it: constants and specialised formulas.

use super::{Emission, Wanted, frequency, limits, mode};
use proc_macro2::{Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>, wanted: &Wanted<'_>) -> TokenStream {
    let Emission {
        name,
        at,
        scalar,
        decay,
        facade,
        ..
    } = emission;
    let modes = Literal::usize_unsuffixed(emission.modes());
    let (low, high) = match emission.precision {
        frictiongen_model::scene::Precision::F64 => range::<f64>(emission),
        frictiongen_model::scene::Precision::F32 => range::<f32>(emission),
    };
    let (low, high) = (emission.literal(low), emission.literal(high));
    let stage = frequency::emit(emission);
    let formulas = limits::formulas(emission);
    let shapes = shapes(emission, wanted);
    let kept = (wanted.stuck || wanted.motion.is_some()).then(|| {
        code! {
            /// A copy of the modes for a motion to keep.
            #[inline]
            fn kept(modes: &Self::Modes) -> Self::Modes {
                *modes
            }
        }
    });
    let wraps = if emission.is_tabled() {
        code!(#facade::kernel::wraps!(#at, Compiled of tabled #name, Copy);)
    } else {
        code!(#facade::kernel::wraps!(#at, At of #name, Copy);)
    };
    let functions = [mode::functions(emission), stage.function];
    let functions = functions
        .iter()
        .any(|functions| !functions.is_empty())
        .then(|| {
            code! {
                impl #name {
                    #(#functions)*
                }
            }
        });
    let frequency = stage.methods;
    code! {
        #wraps

        #functions

        impl Scene for #name {
            type Scalar = #scalar;
            type Decay = #decay;
            type Modes = [ModeAt<#scalar>; #modes];
            type Waves = [Wave<#scalar, #decay>; #modes];

            #[inline]
            fn numbers(&self) -> Numbers<'static, #scalar> {
                Self::NUMBERS
            }

            #shapes

            /// The smallest and the largest 1/r at which the formulas are evaluated: beyond, squares leave the scalar's range.
            #[inline]
            fn inverse_ratio_range(&self) -> (#scalar, #scalar) {
                (#low, #high)
            }

            /// Working space of the searches, and of the waves of a motion.
            #[inline]
            fn idle(&self) -> Self::Waves {
                Self::MODES.map(|mode| Wave::idle(&mode))
            }

            #kept

            #frequency
            #formulas
        }
    }
}

/// The shapes of the masses of which something is asked.
fn shapes(emission: &Emission<'_>, wanted: &Wanted<'_>) -> TokenStream {
    let scalar = &emission.scalar;
    let moving: Vec<usize> = wanted
        .motion
        .iter()
        .flatten()
        .map(|(mass, _)| *mass)
        .collect();
    let masses = 0..emission.scene.masses.len();
    let asked = masses
        .clone()
        .filter(|mass| wanted.stuck || moving.contains(mass));
    let shapes = asked.map(|mass| {
        let shape = emission.list(emission.reduced.shape(mass).iter().copied());
        let mass = Literal::usize_unsuffixed(mass);
        code!(#mass => Some(&#shape),)
    });
    let shapes: TokenStream = shapes.collect();
    let mass = if shapes.is_empty() {
        code!(_)
    } else {
        code!(mass)
    };
    let about = if shapes.is_empty() {
        " φ of a mass, by modes: of none here, as no motion of a mass is provided."
    } else {
        " φ of a mass, by modes."
    };
    let body = if shapes.is_empty() {
        code!(None)
    } else {
        code!(match mass { #shapes _ => None })
    };
    // Where `stuck` has shapes of masses whose motion is not provided.
    let partly = wanted.stuck && wanted.motion.is_some() && moving.len() < masses.len();
    let moves = partly.then(|| {
        let moving = moving.into_iter().map(Literal::usize_unsuffixed);
        code! {
            /// Whether the motion of this mass is provided; others have shapes for the stuck response alone.
            #[inline]
            fn moves(&self, mass: usize) -> bool {
                match mass { #(#moving)|* => true, _ => false }
            }
        }
    });
    code! {
        #[doc = #about]
        #[inline]
        fn shape(&self, #mass: usize) -> Option<&[#scalar]> {
            #body
        }

        #moves
    }
}

fn range<S: frictiongen_kernel::Float>(emission: &Emission<'_>) -> (f64, f64) {
    let resonances = emission.reduced.modes.iter().map(|mode| mode.resonance);
    let (low, high) =
        frictiongen_kernel::contact::regime::inverse_ratio_range(resonances.map(S::constant));
    (low.to_f64(), high.to_f64())
}

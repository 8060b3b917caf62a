//! Emits the implementation of the kernel's trait `Scene`: constants and specialised formulas.

use super::emission::{Checked, Emission, EmittedCode, Wanted};
use super::names::TypeNames;
use super::{frequency, limits, mode, shapes};
use proc_macro2::{Literal, TokenStream};

pub(super) fn emit(emission: &Emission<'_>, wanted: &Wanted<'_>) -> EmittedCode {
    let Emission {
        scalar,
        facade,
        names: TypeNames { name, at, .. },
        ..
    } = emission;
    let modes = Literal::usize_unsuffixed(emission.modes());
    let (low, high) = match emission.precision {
        frictiongen_model::scene::Precision::F64 => range::<f64>(emission),
        frictiongen_model::scene::Precision::F32 => range::<f32>(emission),
    };
    let mut constants = vec![Checked::new(
        "inverse_ratio_range",
        code!(&Self.inverse_ratio_range()),
        &(low, high),
    )];
    if wanted.shapes() {
        let shapes = emission.reduced.shapes.as_slice();
        constants.push(Checked::new("SHAPES", code!(&Self::SHAPES), &shapes));
    }
    if !emission.reduced.quadratures.is_empty() {
        let numbers = code!(&Self::QUADRATURES);
        let quadratures = emission.reduced.quadratures.as_slice();
        constants.push(Checked::new("QUADRATURES", numbers, &quadratures));
    }
    let range_about = range_about(low, high);
    let (low, high) = (emission.literal(low), emission.literal(high));
    let stage = frequency::emit(emission);
    // The kernel has the formulas of an elastic contact.
    let formulas = (!emission.is_elastic()).then(|| limits::formulas(emission));
    let Shapes { constant, methods } = shapes(emission, wanted);
    let wraps = if emission.is_tabled() {
        code!(#facade::kernel::wraps!(#at, Compiled of tabled #name, Copy);)
    } else {
        code!(#facade::kernel::wraps!(#at, At of #name, Copy);)
    };
    let mut associated = constant.unwrap_or_default();
    let (quadratures, quadratures_of) = quadratures(emission);
    associated.extend(quadratures);
    associated.extend(mode::functions(emission));
    associated.extend(stage.function);
    let compliance = emission.is_elastic().then(|| {
        code! {
            /// Compliance ρ of the elastic contact, which is added to H.
            #[inline]
            fn compliance(&self) -> Option<#scalar> {
                Some(Self::CONTACT.compliance)
            }
        }
    });
    let (frequency, in_passes) = (stage.methods, stage.in_passes);
    let damped = if emission.damped() {
        code!(damped)
    } else {
        code!(undamped)
    };
    let items = code! {
        /// `Clone`, `Copy`, `Debug`, `From` and `Deref`: the answers at one frequency have all methods of the wrapped type.
        #wraps

        impl Scene for #name {
            /// The items that every scene has: types, constants and the calls of the frequency stage.  The word says whether a
            /// mode is damped, and the number is the number of modes that the load or the contact drives.
            #facade::kernel::scene_items!(#scalar, #damped, #modes #in_passes);

            #methods

            #quadratures_of

            #compliance

            #[doc = #range_about]
            /// Any other 1/r is moved to the nearer of both, at which the formulas have reached their limits for r → ∞ or r → 0.
            /// Between both, no square of √λ/r overflows or underflows.
            #[inline]
            fn inverse_ratio_range(&self) -> (#scalar, #scalar) {
                (#low, #high)
            }

            #frequency
            #formulas
        }
    };
    EmittedCode {
        associated,
        items,
        constants,
        ..EmittedCode::default()
    }
}

/// Emits, as a constant and a method of the kernel's trait `Scene`, the loads in quadrature with (90° out of phase
/// with) the motion of the base. Only damping relative to a moving base causes these loads. Without it, the constant
/// and the method are empty token streams.
fn quadratures(emission: &Emission<'_>) -> (TokenStream, TokenStream) {
    let (scalar, quadratures) = (&emission.scalar, &emission.reduced.quadratures);
    if quadratures.is_empty() {
        return (TokenStream::new(), TokenStream::new());
    }
    let modes = Literal::usize_unsuffixed(quadratures.len());
    let pairs = quadratures.iter().map(|pair| emission.list(*pair));
    let constant = code! {
        /// Loads of `MODES` in quadrature with the motion of the base, relative to which damping acts: 2ζλΓ with Γ = φᵀΓ1,
        /// and `static_residue` − (φᵀw)Γ.
        const QUADRATURES: [[#scalar; 2]; #modes] = [#(#pairs),*];
    };
    let method = code! {
        /// The loads in quadrature.
        #[inline]
        fn quadratures(&self) -> &[[#scalar; 2]] {
            &Self::QUADRATURES
        }
    };
    (constant, method)
}

/// Mode shapes of the masses that the scene provides, as a constant and methods of the kernel's trait `Scene`.
struct Shapes {
    constant: Option<TokenStream>,
    methods: TokenStream,
}

fn shapes(emission: &Emission<'_>, wanted: &Wanted<'_>) -> Shapes {
    let scalar = &emission.scalar;
    if !wanted.shapes() {
        return Shapes {
            constant: None,
            methods: code! {
                /// Neither the continuous motion nor the stuck response of a mass is provided, so no formula at one frequency needs
                /// mode shapes.
                #[inline]
                fn shape(&self, _: usize) -> Option<&[#scalar]> {
                    None
                }
            },
        };
    }
    let masses = emission.scene.masses.len();
    let modes = Literal::usize_unsuffixed(emission.modes());
    let moving: Vec<usize> = wanted
        .motion
        .iter()
        .flatten()
        .map(|(mass, _)| *mass)
        .collect();
    let all = wanted.stuck || moving.len() == masses;
    let body = if all {
        code!(Self::SHAPES.get(mass).map(<[#scalar; #modes]>::as_slice))
    } else {
        let moving = moving.iter().copied().map(Literal::usize_unsuffixed);
        code!(match mass { #(#moving => Some(&Self::SHAPES[#moving]),)* _ => None })
    };
    // `stuck` needs the shapes of all masses, including masses whose motion is not provided.
    let partly = wanted.stuck && wanted.motion.is_some() && moving.len() < masses;
    let moves = partly.then(|| {
        let moving = moving.into_iter().map(Literal::usize_unsuffixed);
        code! {
            /// Returns true if the scene provides the motion of this mass.  The other masses have mode shapes only for
            /// the stuck response.
            #[inline]
            fn moves(&self, mass: usize) -> bool {
                match mass { #(#moving)|* => true, _ => false }
            }
        }
    });
    let masses = Literal::usize_unsuffixed(masses);
    let shapes = shapes::by_masses(emission, &emission.reduced.shapes);
    Shapes {
        constant: Some(code! {
            /// Mode shapes φ of `MODES`, [mass][mode].
            const SHAPES: [[#scalar; #modes]; #masses] = #shapes;
        }),
        methods: code! {
            /// Components of a mass in the mode shapes.
            #[inline]
            fn shape(&self, mass: usize) -> Option<&[#scalar]> {
                #body
            }

            #moves
        },
    }
}

/// Returns the documentation line about the range of 1/r in which the formulas neither overflow nor underflow.
fn range_about(low: f64, high: f64) -> String {
    let told = |value: f64| {
        let exponent = value.log2();
        if exponent.fract() == 0.0 {
            format!("2^{exponent}")
        } else {
            format!("about {value:.1e}")
        }
    };
    format!(
        " Smallest and largest 1/r at which the formulas are evaluated: {} and {}.",
        told(low),
        told(high)
    )
}

fn range<S: frictiongen_kernel::Float>(emission: &Emission<'_>) -> (f64, f64) {
    let resonances = emission.reduced.modes.iter().map(|mode| mode.resonance);
    let (low, high) =
        frictiongen_kernel::contact::regime::inverse_ratio_range(resonances.map(S::constant));
    (low.to_f64(), high.to_f64())
}

//! Emits the constants that convert between ratios and units, and the hash of the scene.

use super::emission::{Checked, Emission, EmittedCode};
use super::fingerprint::fingerprint;
use crate::units::UnitConstants;
use frictiongen_model::scene::{Excitation, Precision, Scene};
use proc_macro2::{Literal, TokenStream};

/// Returns the constants that convert between ratios and units, rounded to the scene's scalar type.
pub(super) fn constants(emission: &Emission<'_>) -> UnitConstants {
    match emission.precision {
        Precision::F64 => UnitConstants::of::<f64>(emission.scene),
        Precision::F32 => UnitConstants::of::<f32>(emission.scene),
    }
}

/// Emits the reference frequency √(k₁/m₁) by its name. A value of 1 has no name, because the emitted code then contains
/// no division by this value.
pub(super) fn reference_by_name(emission: &Emission<'_>, reference: f64) -> TokenStream {
    if reference == 1.0 {
        emission.literal(reference)
    } else {
        code!(Self::REFERENCE)
    }
}

/// Emits the constants that convert between ratios and units, and after them the conversion functions. The checksum of
/// the constants also covers natural frequencies and resonances.
pub(super) fn emit(
    emission: &Emission<'_>,
    (frequencies, resonances): (&[f64], &[f64]),
) -> EmittedCode {
    let scalar = &emission.scalar;
    let UnitConstants {
        k1,
        spring,
        m1,
        mass,
        reference,
        hertz,
        ..
    } = constants(emission);
    let named = reference != 1.0;
    let of = |value| emission.literal(value);
    let masses = Literal::usize_unsuffixed(hertz.len());
    let k1_about =
        format!(" k₁, the stiffness of the spring `{spring}`: N/m, if springs are in N/m.");
    let m1_about = format!(" m₁, the mass `{mass}`: kg, if masses are in kg.");
    let numbers = [k1, m1, reference];
    let numbers = if named { &numbers[..] } else { &numbers[..2] };
    let sum = (numbers, [hertz.as_slice(), frequencies, resonances]);
    let hash_value = fingerprint(emission.scene);
    let (hash, k1, m1) = (scene_hash(emission.scene), of(k1), of(m1));
    let reference_number = named.then(|| code!(Self::REFERENCE));
    let references = code! {
        &(
            [Self::K1, Self::M1, #reference_number].as_slice(),
            [
                Self::NATURAL_FREQUENCIES_HZ.as_slice(),
                Self::NATURAL_FREQUENCIES.as_slice(),
                Self::RESONANCES.as_slice(),
            ],
        )
    };
    let constants = vec![
        Checked::new("SCENE_HASH", code!(&Self::SCENE_HASH), &hash_value),
        Checked::new("K1, M1 and frequencies", references, &sum),
    ];
    let hertz = emission.list(hertz);
    let reference = named.then(|| {
        let reference = of(reference);
        code! {
            /// √(k₁/m₁), by which angular frequencies are divided: rad/s.
            const REFERENCE: #scalar = #reference;
        }
    });
    let associated = code! {
        #hash
        #[doc = #k1_about]
        pub const K1: #scalar = #k1;
        #[doc = #m1_about]
        pub const M1: #scalar = #m1;
        #reference
        /// Natural frequencies in Hz, ascending, if masses are in kg and springs in N/m.
        pub const NATURAL_FREQUENCIES_HZ: [#scalar; #masses] = #hertz;
    };
    EmittedCode {
        associated,
        items: conversions(emission, named),
        constants,
        ..EmittedCode::default()
    }
}

/// Emits the hash of a scene.
pub(super) fn scene_hash(scene: &Scene) -> TokenStream {
    let hash = hexadecimal(fingerprint(scene));
    code! {
        /// Hash of all fields of the scene and of all names (FNV-1a, 64 bits).  Descriptions that differ only in layout, comments
        /// or attributes have the same hash.  To verify it, emit the description again.
        pub const SCENE_HASH: ::core::primitive::u64 = #hash;
    }
}

fn hexadecimal(hash: u64) -> TokenStream {
    let words = [48, 32, 16, 0].map(|shift| format!("{:04x}", (hash >> shift) & 0xffff));
    format!("0x{}", words.join("_")).parse().unwrap_or_default()
}

/// Emits the conversions between ratios and units.
fn conversions(emission: &Emission<'_>, named: bool) -> TokenStream {
    let scalar = &emission.scalar;
    let frequency_ratio = if named {
        code!(omega / Self::REFERENCE)
    } else {
        code!(omega)
    };
    let ratio_about = match emission.scene.excitation {
        Excitation::Base => {
            " Returns β = F/(k₁Y) of a kinetic friction force F.  `load` is k₁Y, with Y the amplitude of the base motion."
        }
        Excitation::Force(_) => {
            " Returns β = F/P of a kinetic friction force F.  `load` is P, the amplitude of the force."
        }
    };
    code! {
        /// Returns the frequency ratio r = ω√(m₁/k₁) of an angular frequency ω, rad/s.
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
    }
}

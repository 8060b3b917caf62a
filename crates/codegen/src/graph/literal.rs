//! Writes numbers in emitted code.

use frictiongen_model::scene::Precision;
use proc_macro2::{Literal, TokenStream};

/// Returns a number as a literal: the shortest text that Rust reads back to the same bits.
#[must_use]
pub fn literal(value: f64, precision: Precision) -> TokenStream {
    #[allow(clippy::cast_possible_truncation, reason = "the scene's scalar is f32")]
    let (text, negative) = match precision {
        Precision::F64 => (format!("{:?}", value.abs()), value.is_sign_negative()),
        Precision::F32 => (
            format!("{:?}", (value as f32).abs()),
            value.is_sign_negative(),
        ),
    };
    let scalar = scalar(precision);
    if text == "inf" {
        return if negative {
            code!(#scalar::NEG_INFINITY)
        } else {
            code!(#scalar::INFINITY)
        };
    }
    let number = text
        .parse::<Literal>()
        .map_or_else(|_| code!(#scalar::NAN), |number| code!(#number));
    if negative { code!(-#number) } else { number }
}

/// Returns the type `f64` or `f32`.
#[must_use]
pub fn scalar(precision: Precision) -> TokenStream {
    match precision {
        Precision::F64 => code!(f64),
        Precision::F32 => code!(f32),
    }
}

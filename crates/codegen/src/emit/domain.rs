//! Emits the range of r and β in which tables are valid, and lists the constants of tables for the self-check.

use super::emission::{Checked, Emission};
use super::fields::fields;
use frictiongen_kernel::Float;
use frictiongen_kernel::emitted::check::{self, Listed};
use frictiongen_kernel::table::Domain;
use frictiongen_model::scene::{Beyond, Range};
use frictiongen_model::table::{Reach, Tables};
use proc_macro2::TokenStream;

/// Returns the constants of the tables with their checksums, which the self-check compares.
pub(super) fn checked<S: Float + Listed<S>>(
    emission: &Emission<'_>,
    tables: &Tables<S>,
) -> Vec<Checked> {
    // The addition of 0.0 turns −0.0 into 0.0, because the emitted tables have no negative zeros.
    let wide = |value: S| value.to_f64() + 0.0;
    let index = &tables.index;
    let pieces = tables.pieces.iter().map(|piece| {
        let coefficients = piece.coefficients.iter().flatten();
        let coefficients: Vec<f64> = coefficients.map(|number| wide(*number)).collect();
        ([wide(piece.from), wide(piece.origin)], coefficients)
    });
    let pieces: Vec<([f64; 2], Vec<f64>)> = pieces.collect();
    let pieces: Vec<([f64; 2], &[f64])> = pieces
        .iter()
        .map(|(from, coefficients)| (*from, coefficients.as_slice()))
        .collect();
    let head = [wide(index.low), wide(index.density)];
    let lists = (index.buckets.as_slice(), pieces.as_slice());
    let mut constants = vec![
        Checked::new(
            "TABLE",
            code!(&Self::TABLE),
            &((head, index.halvings), lists),
        ),
        Checked::of_sum(
            "domain",
            code!(&Self.domain()),
            check::sum::<S>(&domain_of(emission, tables)),
        ),
    ];
    let products = [
        (
            "SLIDING_LIMIT",
            code!(&Self::SLIDING_LIMIT),
            &tables.sliding,
        ),
        ("EXCITATION", code!(&Self::EXCITATION), &tables.excitation),
    ];
    for (name, numbers, product) in products {
        if let Some(product) = product {
            let sum = check::sum::<S>(&product.quotient());
            constants.push(Checked::of_sum(name, numbers, sum));
        }
    }
    constants
}

/// Returns the range of r and β in which the tables are valid, in the scalar type of the tables.
fn domain_of<S: Float>(emission: &Emission<'_>, tables: &Tables<S>) -> Domain<S> {
    let declared = &emission.scene.declared;
    let (low, high) = tables.request.r;
    let (least, most) = declared
        .range
        .map_or((0.0, f64::INFINITY), |Range { beta, .. }| beta);
    let Reach {
        always_continuous,
        never_stuck,
    } = tables.declared_reach(emission.scene);
    Domain {
        r: (S::constant(low), S::constant(high)),
        beta: (S::constant(least), S::constant(most)),
        exact_beyond: declared.beyond == Beyond::Exact,
        always_continuous,
        never_stuck,
    }
}

/// Emits the range of r and β in which the tables are valid, as a method of the kernel's trait `Tabled`.
pub(super) fn domain<S: Float>(emission: &Emission<'_>, tables: &Tables<S>) -> TokenStream {
    let scalar = &emission.scalar;
    let number = |value: S| emission.literal(value.to_f64());
    let Domain {
        r,
        beta,
        exact_beyond,
        always_continuous,
        never_stuck,
    } = domain_of(emission, tables);
    let (low, high) = (number(r.0), number(r.1));
    let (least, largest) = (number(beta.0), number(beta.1));
    let about = match (always_continuous, never_stuck) {
        (true, true) => {
            " Where the tables hold: at every r and β of these the motion is continuous."
        }
        (true, false) => {
            " Where the tables hold: at every r and β of these the closed form is a steady state."
        }
        (false, true) => " Where the tables hold: at no r and β of these a stuck state exists.",
        (false, false) => " Where the tables hold.",
    };
    let fields = fields(
        true,
        &[
            (
                "r",
                code!((#low, #high)),
                "smallest and largest r of the tables",
            ),
            (
                "beta",
                code!((#least, #largest)),
                "smallest and largest β that a caller may pass",
            ),
            (
                "exact_beyond",
                code!(#exact_beyond),
                "outside, the exact formulas answer; if false, a call is an error",
            ),
            (
                "always_continuous",
                code!(#always_continuous),
                "β_lim exceeds every β of the range, so that no code compares them",
            ),
            (
                "never_stuck",
                code!(#never_stuck),
                "β*_lim exceeds every β of the range, so that no code evaluates it",
            ),
        ],
    );
    code! {
        #[doc = #about]
        #[inline]
        fn domain(&self) -> Domain<#scalar> {
            Domain { #fields }
        }
    }
}

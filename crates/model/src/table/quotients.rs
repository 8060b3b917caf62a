//! β*_lim and the amplitude |V| of the contact without friction, as products over their zeros and poles. The module
//! also compares these products with the exact sums over the modes.

use super::bounds::Receptances;
use super::check;
use super::evidence::Proof;
use super::exact::Exact;
use super::product::Product;
use super::request::Request;
use super::split::Landmarks;
use super::worst::Worst;
use super::zeros::{Zero, Zeros};
use crate::scene::Side;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::table::Factor;

/// Fraction of the declared accuracy that the errors of β*_lim, of |V| and of the stuck responses may take.
pub(super) const EXACT_SHARE: f64 = 0.5;
/// Amounts, in rounding units, by which the code may enlarge β*_lim for `side: safe`. The amount must exceed the
/// errors of the product's factors and zeros. The code chooses the amount with the best proof, and among equally good
/// proofs the smallest amount.
const SAFE_ROUNDINGS: [f64; 5] = [64.0, 512.0, 4096.0, 65_536.0, 1_048_576.0];

/// Returns a rational function as a product over its zeros and poles. The gain is such that the product equals
/// `value` at the frequency ratio that is farthest from all zeros and poles in the range. The function computes the
/// gain in double-double.
fn product<S: Float>(
    squared: bool,
    numerator: [&[Zero]; 2],
    denominator: [&[Zero]; 2],
    (low, high): (f64, f64),
    side_factor: f64,
    value: impl Fn(f64) -> f64,
    to: &impl Fn(Dd) -> S,
) -> Option<Product<S>> {
    const PLACES: usize = 33;
    fn factors<T: Float>(
        zeros: [&[Zero]; 2],
        squared: bool,
        to: &impl Fn(Dd) -> T,
    ) -> Vec<Factor<T>> {
        zeros
            .iter()
            .flat_map(|zeros| zeros.iter())
            .map(|zero| zero.factor(squared, to))
            .collect()
    }
    let wide = |value: Dd| value;
    let unit = Product {
        gain: Dd::ONE,
        squared,
        numerator: factors(numerator, squared, &wide),
        denominator: factors(denominator, squared, &wide),
    };
    let away = |r: f64| {
        let zeros = numerator
            .iter()
            .chain(&denominator)
            .flat_map(|zeros| zeros.iter());
        let off = |zero: &Zero| {
            let (x, y) = (zero.x.to_f64(), zero.y.to_f64());
            x.hypot(r - y) / r
        };
        zeros.map(off).fold(f64::INFINITY, f64::min)
    };
    let places = (0..PLACES).map(|k| low + (high - low) * (k as f64 + 0.5) / PLACES as f64);
    let place = places.max_by(|a, b| away(*a).total_cmp(&away(*b)))?;
    let gain = Dd::from(value(place) * side_factor) / unit.quotient().value(Dd::from(place));
    let plain = unit.numerator.is_empty() && unit.denominator.is_empty();
    Some(Product {
        gain: to(gain),
        squared: squared && !plain,
        numerator: factors(numerator, squared, to),
        denominator: factors(denominator, squared, to),
    })
}

/// Returns β*_lim as a product over its zeros and poles, multiplied by `side_factor`.
fn sliding<S: Float>(
    exact: &Exact<'_>,
    zeros: &Zeros,
    range: (f64, f64),
    side_factor: f64,
    to: &impl Fn(Dd) -> S,
) -> Option<Product<S>> {
    let mut product = product(
        zeros.damped,
        [&zeros.excitation, &zeros.unloaded],
        [&zeros.receptance, &[]],
        range,
        side_factor,
        |r| exact.sliding_limit(r),
        to,
    )?;
    product.gain = product.gain.abs();
    Some(product)
}

/// Returns |V|, the amplitude of the contact without friction, as a product over its zeros and poles. For an undamped
/// chain, the result is V with its sign.
fn excitation<S: Float>(
    exact: &Exact<'_>,
    zeros: &Zeros,
    range: (f64, f64),
    to: &impl Fn(Dd) -> S,
) -> Option<Product<S>> {
    product(
        zeros.damped,
        [&zeros.excitation, &zeros.common],
        [&zeros.loaded, &[]],
        range,
        1.0,
        |r| exact.excitation(r),
        to,
    )
}

/// Rounds a double-double to another number type with a single rounding.
fn rounded<S: Float>(value: Dd) -> S {
    S::constant(value.to_f64())
}

/// Products over zeros and poles for β*_lim, the limit of sliding, and for |V|, the amplitude of the contact without
/// friction. A product is `None` if it is not accurate enough. The exact formulas then replace it.
pub(super) struct Products<S> {
    pub sliding: Option<Product<S>>,
    pub excitation: Option<Product<S>>,
    /// Largest relative error of β*_lim that the check has found.
    pub worst: Worst,
    /// Number of frequency ratios at which the code compared the products with exact values.
    pub points: usize,
    /// Proofs of the accuracy of the products, first for β*_lim, then for |V|.
    pub proofs: [Proof; 2],
}

impl<S: Float> Products<S> {
    pub fn of(
        exact: &Exact<'_>,
        zeros: Option<&Zeros>,
        landmarks: &Landmarks,
        request: &Request,
        with_excitation: bool,
        range: (f64, f64),
    ) -> Self {
        let allowed = EXACT_SHARE * request.accuracy;
        let receptances = Receptances::of(exact, zeros, range.1);
        let to = rounded::<S>;
        let of_sliding = |side_factor: f64| {
            let product = zeros.and_then(|zeros| sliding(exact, zeros, range, side_factor, &to))?;
            let proof = receptances.as_ref();
            let proof = proof.map(|known| known.sliding(&product, request));
            Some((side_factor, product, proof.unwrap_or(Proof::none(range))))
        };
        let built = match request.side {
            Side::Near => of_sliding(1.0),
            Side::Safe => {
                let side_factors = SAFE_ROUNDINGS.map(|count| count * S::EPSILON);
                let side_factors =
                    side_factors.map(|excess| 1.0 + excess.min(0.5 * request.accuracy));
                let built = side_factors.into_iter().filter_map(of_sliding);
                // A proof may fail in some intervals of r. `min_by` takes the product for which these intervals are
                // shortest in total.
                built.min_by(|a, b| a.2.open_length().total_cmp(&b.2.open_length()))
            }
        };
        let mut worst = Worst {
            error: 0.0,
            at: range.0,
        };
        let mut points = 0;
        let mut kept = |product: &Product<S>, exact: &dyn Fn(f64) -> f64| {
            let (seen, looked) = check::product(product, range, landmarks, exact);
            points += looked;
            (seen.error <= allowed).then_some(seen)
        };
        let built = built.filter(|(side_factor, product, _)| {
            let seen = kept(product, &|r| side_factor * exact.sliding_limit(r));
            worst = seen.unwrap_or(worst);
            seen.is_some()
        });
        let none = || Proof::none(range);
        let (sliding, proof) = built.map_or_else(
            || (None, none()),
            |(_, product, proof)| (Some(product), proof),
        );
        let excitation = zeros
            .filter(|_| request.motion && with_excitation)
            .and_then(|zeros| excitation(exact, zeros, range, &to))
            .filter(|product| kept(product, &|r| exact.excitation(r).abs()).is_some());
        let of_excitation = excitation.as_ref().zip(receptances.as_ref());
        let of_excitation =
            of_excitation.map(|(product, known)| known.excitation(product, request));
        Self {
            sliding,
            excitation,
            worst,
            points,
            proofs: [proof, of_excitation.unwrap_or_else(none)],
        }
    }
}

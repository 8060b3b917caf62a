//! Lists the measured cases: each function of the kernel with each scalar type.

use crate::budgets::blocks::*;
use crate::budgets::draw::{self, Domain, Source, arguments};
use crate::budgets::elementary::*;
use crate::budgets::measure::{Arguments, Formula, Real, Results, Unit, against, against_big};
use crate::budgets::modes::*;
use frictiongen_kernel::number::dd::Dd;

pub struct Case {
    /// Name of the function in the table.
    pub function: &'static str,
    /// Names of the results. Each result has a row of the table. The name of a single result may be "".
    pub fields: &'static [&'static str],
    pub scalar: &'static str,
    pub unit: Unit,
    pub domain: Domain,
    pub draw: fn(&Domain, &mut Source) -> Arguments,
    pub error: fn(&Arguments) -> Results<f64>,
    /// True for functions of one `f32` argument that the long form evaluates at all numbers of [`Domain::counted`].
    pub countable: bool,
}

impl Case {
    /// Returns all numbers of the range `counted`, in the order of their bits.
    pub fn counted(&self) -> impl Iterator<Item = Arguments> + use<> {
        let (from, to, negative) = self.domain.counted;
        let through = if self.countable {
            from.to_bits()..to.to_bits()
        } else {
            0..0
        };
        let signs = if negative { 2 } else { 1 };
        through.flat_map(move |bits| {
            let x = f64::from(f32::from_bits(bits));
            [x, -x]
                .into_iter()
                .take(signs)
                .map(|x| [Dd::from(x), Dd::ZERO, Dd::ZERO])
        })
    }
}

struct Shape {
    function: &'static str,
    fields: &'static [&'static str],
    domain: Domain,
    countable: bool,
}

/// Returns a case whose errors are counted in the unit of the formula `F`.
fn case<F: Formula, T: Real>(shape: &Shape, error: fn(&Arguments) -> Results<f64>) -> Case {
    Case {
        function: shape.function,
        fields: shape.fields,
        scalar: T::NAME,
        unit: F::UNIT,
        domain: shape.domain,
        draw: arguments::<T>,
        error,
        countable: shape.countable && T::NAME == "f32",
    }
}

/// Returns three cases: `f32` compared with `f64`, `f64` with double-double, and double-double with big numbers.
fn three<F: Formula>(shape: &Shape) -> Vec<Case> {
    vec![
        case::<F, f32>(shape, against::<F, f32, f64>),
        case::<F, f64>(shape, against::<F, f64, Dd>),
        case::<F, Dd>(shape, against_big::<F>),
    ]
}

fn only_dd<F: Formula>(shape: &Shape) -> Vec<Case> {
    vec![case::<F, Dd>(shape, against_big::<F>)]
}

macro_rules! cases {
    ($($way:ident $formula:ident $function:literal [$($field:literal),*] in $domain:ident $(, $countable:ident)?;)*) => {
        pub fn all() -> Vec<Case> {
            let mut cases = Vec::new();
            $(
                #[allow(unused_mut, unused_assignments)]
                let mut countable = false;
                $( countable = stringify!($countable) == "counted"; )?
                let shape = Shape {
                    function: $function,
                    fields: &[$($field),*],
                    domain: draw::$domain,
                    countable,
                };
                cases.extend($way::<$formula>(&shape));
            )*
            cases
        }
    };
}

cases! {
    three SinCosPi "sin_cos_pi" ["sin", "cos"] in HALF_TURNS, counted;
    three SinCosPiMinus "sin_cos_pi_minus" ["sin", "cos"] in HALF_TURN_PAIRS;
    three Sqrt "sqrt" [""] in NOT_NEGATIVE, counted;
    three Exp "exp" [""] in EXPONENTS, counted;
    three ExpM1 "exp_m1" [""] in GROWTHS, counted;
    three Atan2 "atan2" [""] in PAIRS;
    three OneMinusSincPi "one_minus_sinc_pi" [""] in SINC, counted;
    three ScaledSinhDefect "scaled_sinh_defect" [""] in DECAYS, counted;
    three VersinePi "versine_pi" [""] in SINC, counted;
    three ExpM1Minus "exp_m1_minus" [""] in GROWTHS, counted;
    three Floor "floor" [""] in ANY, counted;
    three Pi "pi" [""] in NOTHING;
    three InversePi "inverse_pi" [""] in NOTHING;
    only_dd Add "a + b" [""] in PAIRS;
    only_dd Subtract "a − b" [""] in PAIRS;
    only_dd Multiply "a · b" [""] in PAIRS;
    only_dd Divide "a / b" [""] in PAIRS;
    only_dd DdSum "sum of two f64" [""] in DOUBLES;
    only_dd DdProduct "product of two f64" [""] in DOUBLES;
    three ComplexAdd "complex add" [""] in COMPLEX;
    three ComplexScale "complex scale" [""] in COMPLEX;
    three ComplexMul "complex mul" [""] in COMPLEX;
    three ComplexReciprocal "complex reciprocal" [""] in LARGE_COMPLEX;
    three ReciprocalOfUnit "complex reciprocal_of_unit" [""] in UNIT_COMPLEX;
    three Modulus "complex modulus" [""] in LARGE_COMPLEX;
    three UndampedComplex "complex, undamped" ["mul", "reciprocal", "modulus", "Im"] in COMPLEX;
    three Constraints "acceleration at a reversal" ["start_constraint", "break_away"] in POSITIVE;
    three ContinuousLimit "continuous_limit" [""] in POSITIVE;
    three SlidingLimit "sliding_limit" [""] in POSITIVE;
    three Margin "margin" [""] in MARGINS;
    three PlainResponse "response, undamped" ["denominator", "u", "g", "reversal"] in FREQUENCIES;
    three Response "response, light" ["denominator re", "denominator im", "u", "g", "reversal"] in LIGHT;
    three DecayedResponse "response, light, decayed" ["denominator re", "denominator im", "u", "g", "reversal"] in LIGHT_DECAYED;
    three Response "response, heavy" ["denominator re", "denominator im", "u", "g", "reversal"] in HEAVY;
    three DecayedResponse "response, heavy, decayed" ["denominator re", "denominator im", "u", "g", "reversal"] in HEAVY_DECAYED;
    three Response "response, critical" ["denominator re", "denominator im", "u", "g", "reversal"] in CRITICAL;
    three DecayedResponse "response, critical, decayed" ["denominator re", "denominator im", "u", "g", "reversal"] in CRITICAL_DECAYED;
    three Response "response, overdamped" ["denominator re", "denominator im", "u", "g", "reversal"] in OVER;
    three DecayedResponse "response, overdamped, decayed" ["denominator re", "denominator im", "u", "g", "reversal"] in OVER_DECAYED;
    three V "v, light" [""] in LIGHT;
    three V "v, overdamped" [""] in OVER_DECAYED;
    three AnInstant "instant" ["tau", "sine", "cosine", "versine"] in INSTANTS, counted;
    three InTimeUndamped "basis, undamped" ["free", "slope", "forced", "forced_slope", "rise"] in UNDAMPED_TIME;
    three InTime "basis, light" ["free", "slope", "forced", "forced_slope", "rise"] in LIGHT_TIME;
    three DecayedInTime "basis, light, decayed" ["free", "slope", "forced", "forced_slope", "rise"] in LIGHT_TIME_DECAYED;
    three InTime "basis, heavy" ["free", "slope", "forced", "forced_slope", "rise"] in HEAVY_TIME;
    three DecayedInTime "basis, heavy, decayed" ["free", "slope", "forced", "forced_slope", "rise"] in HEAVY_TIME_DECAYED;
    three InTime "basis, critical" ["free", "slope", "forced", "forced_slope", "rise"] in CRITICAL_TIME;
    three DecayedInTime "basis, critical, decayed" ["free", "slope", "forced", "forced_slope", "rise"] in CRITICAL_TIME_DECAYED;
    three InTime "basis, overdamped" ["free", "slope", "forced", "forced_slope", "rise"] in OVER_TIME;
    three DecayedInTime "basis, overdamped, decayed" ["free", "slope", "forced", "forced_slope", "rise"] in OVER_TIME_DECAYED;
}

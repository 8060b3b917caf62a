//! Defines the units of error, and measures the error of a function in these units.

use crate::budgets::big::Big;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

/// Arguments of a function. Each is exactly representable in the scalar type under test.
pub type Arguments = [Dd; 3];
/// Results of a function. Unused elements are zero.
pub type Results<T> = [T; 5];

/// A scalar type under test.
pub trait Real: Float {
    /// Number of bits of the significand, and exponent of the smallest normal number of the scalar type.
    const FORMAT: (i32, i64);
    /// Name of the scalar type in the table.
    const NAME: &'static str;
    fn of(x: Dd) -> Self;
    fn widened(self) -> Dd;
    /// Returns q = √|1 − ζ²| and 1 − q, each rounded once, as in the modal analysis of a scene.
    fn of_damping(zeta: Self) -> (Self, Self) {
        let (q, defect) = damping(zeta.widened());
        (Self::of(q), Self::of(defect))
    }
}

fn damping<T: Float>(zeta: T) -> (T, T) {
    let one = T::constant(1.0);
    let q = ((one - zeta) * (one + zeta)).abs().sqrt();
    (q, zeta * zeta / (one + q))
}

impl Real for f32 {
    const FORMAT: (i32, i64) = (24, -126);
    const NAME: &'static str = "f32";
    fn of(x: Dd) -> Self {
        // This conversion by way of `f64` may round a number twice. The arguments are exact, so it does not change
        // them. The constants of a mode get an additional error of at most 2^−30 of a unit.
        x.to_f64() as f32
    }
    fn widened(self) -> Dd {
        Dd::from(f64::from(self))
    }
}

impl Real for f64 {
    const FORMAT: (i32, i64) = (53, -1022);
    const NAME: &'static str = "f64";
    fn of(x: Dd) -> Self {
        x.to_f64()
    }
    fn widened(self) -> Dd {
        Dd::from(self)
    }
}

impl Real for Dd {
    // The unit of a double-double is 2^−104 times the largest power of two that is not above the number. The low word
    // must not be subnormal.
    const FORMAT: (i32, i64) = (105, -916);
    const NAME: &'static str = "Dd";
    fn of(x: Dd) -> Self {
        x
    }
    fn widened(self) -> Dd {
        self
    }
    fn of_damping(zeta: Self) -> (Self, Self) {
        damping(zeta)
    }
}

/// Dual numbers. They serve only to measure how strongly a result depends on an argument.
impl<S: Real> Real for Dual<S> {
    const FORMAT: (i32, i64) = S::FORMAT;
    const NAME: &'static str = "dual";
    fn of(x: Dd) -> Self {
        Self::fixed(S::of(x))
    }
    fn widened(self) -> Dd {
        self.value.widened()
    }
    fn of_damping(zeta: Self) -> (Self, Self) {
        damping(zeta)
    }
}

/// Unit in which an error is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Units in the last place of the exact result.
    Place,
    /// Norm of the errors of all results, divided by ε times the norm of all results, with ε = 2^−23, 2^−52 or
    /// 2^−104.
    Norm,
    /// Error divided by ε·(|f| + Σ|a·∂f/∂a|), where the sum is over the arguments a. An error of 1 can be a relative
    /// change of ε in the result and in every argument.
    Mixed,
    /// Unit of [`Mixed`](Self::Mixed), but the divisor may contain one more term: a larger number to which the result
    /// is added.
    Size,
}

impl Unit {
    pub fn name(self) -> &'static str {
        match self {
            Self::Place => "ulp",
            Self::Norm => "norm",
            Self::Mixed => "mixed",
            Self::Size => "size",
        }
    }
}

/// A function of the kernel over any scalar type, and the printed formula for it in big numbers.
pub trait Formula {
    const UNIT: Unit = Unit::Place;
    fn at<T: Real>(a: [T; 3]) -> Results<T>;
    /// Evaluates the printed formula, or returns `None` where the function has no value.
    fn printed(a: [Big; 3]) -> Option<Vec<Big>>;
    /// Returns the sizes that, times ε, divide the errors of the results. They follow from the results and from
    /// a·∂f/∂a for each argument a. For [`Unit::Mixed`] they are sums of these.
    fn scales(_a: &Arguments, value: Results<f64>, moved: [Results<f64>; 3]) -> Results<f64> {
        moved.into_iter().fold(value, plus)
    }
    /// Returns the second-order effect of a relative change of ε in the arguments, divided by ε². It matters for
    /// results that touch 0 without a change of sign, because the derivative of the result vanishes with the result.
    fn curved(_a: &Arguments) -> Results<f64> {
        [0.0; 5]
    }
}

pub fn plus(a: Results<f64>, b: Results<f64>) -> Results<f64> {
    std::array::from_fn(|i| a[i] + b[i])
}

fn unit<T: Real>(value: f64) -> f64 {
    let (bits, least) = T::FORMAT;
    let exponent = i64::from((value.abs().to_bits() >> 52) as u32) - 1023;
    // The power of two is a product of two factors, neither of which underflows in `f64`.
    let power = exponent.max(least) as i32 - bits + 1;
    2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2)
}

/// Returns the error `off` = got − want in units in the last place. `want` comes from a more accurate scalar type.
fn places<T: Real>(got: Dd, want: Dd, off: f64) -> f64 {
    if got.hi.is_nan() || want.hi.is_nan() {
        return if got.hi.is_nan() && want.hi.is_nan() {
            0.0
        } else {
            f64::INFINITY
        };
    }
    if got.hi == want.hi && got.lo == want.lo {
        return 0.0;
    }
    if !got.hi.is_finite() || !want.hi.is_finite() {
        // If the result and the exact value are near or beyond the largest number, they count as overflowed.
        let largest = if T::FORMAT.0 == 24 {
            f64::from(f32::MAX)
        } else {
            f64::MAX
        };
        let both = got.hi.abs() > largest * (1.0 - 1e-6) && want.hi.abs() >= largest * (1.0 - 1e-6);
        return if both && got.hi.signum() == want.hi.signum() {
            0.0
        } else {
            f64::INFINITY
        };
    }
    off.abs() / unit::<T>(want.hi)
}

/// Returns |a·∂f/∂a| of every result for the argument a with the index `i`, from dual numbers over `S`.
fn moved<F: Formula, S: Real>(a: &Arguments, i: usize) -> Results<f64> {
    let mut point = a.map(<Dual<S> as Real>::of);
    point[i] = Dual::variable(S::of(a[i]));
    F::at(point).map(|result| (a[i].hi * result.slope.to_f64()).abs())
}

fn scales<F: Formula, T: Real>(a: &Arguments, want: &Results<Dd>) -> Results<f64> {
    let mut all = [[0.0; 5]; 3];
    for i in (0..3).filter(|i| !a[*i].is_zero()) {
        // Near a zero of the function, the argument must be as exact as the result.
        all[i] = if T::NAME == Dd::NAME {
            moved::<F, Dd>(a, i)
        } else {
            moved::<F, f64>(a, i)
        };
    }
    F::scales(a, want.map(|w| w.hi.abs()), all)
}

fn judged<F: Formula, T: Real>(
    a: &Arguments,
    got: Results<Dd>,
    want: Results<Dd>,
    off: Results<f64>,
) -> Results<f64> {
    let mut errors = [0.0; 5];
    match F::UNIT {
        Unit::Place => {
            for i in 0..5 {
                errors[i] = places::<T>(got[i], want[i], off[i]);
            }
        }
        Unit::Norm => {
            let size = want.iter().fold(0.0_f64, |m, w| m.max(w.hi.abs()));
            let norm =
                |parts: Results<f64>| parts.iter().map(|p| (p / size).powi(2)).sum::<f64>().sqrt();
            let error = norm(off) / (norm(want.map(|w| w.hi)) * T::EPSILON);
            errors[0] = if off.iter().all(|o| *o == 0.0) {
                0.0
            } else {
                error
            };
        }
        Unit::Mixed | Unit::Size => {
            let curved = F::curved(a).map(|c| c * T::EPSILON);
            let scales = plus(scales::<F, T>(a, &want), curved);
            // All subnormal numbers have the same unit.
            let least = 2.0_f64.powi(T::FORMAT.1 as i32);
            for i in 0..5 {
                let error = off[i].abs() / (scales[i].max(least) * T::EPSILON);
                errors[i] = if off[i] == 0.0 { 0.0 } else { error };
            }
        }
    }
    // NaN counts as an infinite error.
    errors.map(|error| if error.is_nan() { f64::INFINITY } else { error })
}

fn minus(got: Dd, want: Dd) -> f64 {
    (got.hi - want.hi) + (got.lo - want.lo)
}

/// Returns the errors of a function over `T`, compared with the same function over `Better`. That function has a row
/// of its own in the table.
pub fn against<F: Formula, T: Real, Better: Real>(a: &Arguments) -> Results<f64> {
    let got = F::at(a.map(T::of)).map(Real::widened);
    let want = F::at(a.map(Better::of)).map(Real::widened);
    let mut off = [0.0; 5];
    for i in 0..5 {
        off[i] = minus(got[i], want[i]);
    }
    judged::<F, T>(a, got, want, off)
}

/// Returns the errors of a function in double-double, compared with the printed formula in big numbers.
pub fn against_big<F: Formula>(a: &Arguments) -> Results<f64> {
    let Some(printed) = F::printed(a.map(Big::of_dd)) else {
        return [0.0; 5];
    };
    let got = F::at(*a);
    let (mut want, mut off) = ([Dd::ZERO; 5], [0.0; 5]);
    for (i, exact) in printed.iter().enumerate() {
        want[i] = Dd::from(exact.to_f64());
        off[i] = if got[i].hi.is_finite() {
            (Big::of_dd(got[i]) - exact.clone()).to_f64()
        } else {
            f64::NAN
        };
        // Exact results, and equal results beyond the range, have no error.
        if off[i] == 0.0 || (want[i].hi.is_infinite() && got[i].hi == want[i].hi) {
            want[i] = got[i];
            off[i] = 0.0;
        }
    }
    judged::<F, Dd>(a, got, want, off)
}

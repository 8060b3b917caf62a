//! Units of error, and a function's error in them.

use crate::budgets::big::Big;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

/// The arguments of a function, each exactly a number of its scalar.
pub type Arguments = [Dd; 3];
/// As many results as a function has, then zeros.
pub type Results<T> = [T; 5];

/// A scalar under test.
pub trait Real: Float {
    /// The bits of its significand, and the exponent of its smallest normal number.
    const FORMAT: (i32, i64);
    /// The name in the table.
    const NAME: &'static str;
    fn of(x: Dd) -> Self;
    fn widened(self) -> Dd;
    /// √|1 − ζ²| and 1 − q, as a scene's modal analysis hands them over: rounded once.
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
        // By way of f64 a number could be rounded twice; the arguments are exact, the constants
        // of a mode off by at most 2^−30 of a unit more.
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
    // Its unit is 2^−104 of the leading power of two; the second part must not be subnormal.
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

/// Only to ask how strongly a result depends on an argument.
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

/// How an error is counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Units in the last place of the exact result.
    Place,
    /// |error of all results together|/(ε·|all results|), ε = 2^−23, 2^−52, 2^−104.
    Norm,
    /// The error over ε·(|f| + Σ|a·∂f/∂a|) over the arguments a: how many ε of change, in the
    /// result and in every argument together, would explain it.
    Mixed,
    /// The same, where a result is also let off what vanishes beside something that it is added to.
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

/// A function of the kernel over every scalar, and the same as it is printed, in big numbers.
pub trait Formula {
    const UNIT: Unit = Unit::Place;
    fn at<T: Real>(a: [T; 3]) -> Results<T>;
    /// None where the function has no value.
    fn printed(a: [Big; 3]) -> Option<Vec<Big>>;
    /// What the error of each result is compared with (times ε): from the results and, for each
    /// argument a, a·∂f/∂a.  [`Unit::Mixed`] adds them up.
    fn scales(_a: &Arguments, value: Results<f64>, moved: [Results<f64>; 3]) -> Results<f64> {
        moved.into_iter().fold(value, plus)
    }
    /// What a change of ε in the arguments does in the second order, over ε²: for results that
    /// touch 0 without crossing it, where their derivatives vanish too.
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
    // A power of two in two halves: neither is below f64's range.
    let power = exponent.max(least) as i32 - bits + 1;
    2.0_f64.powi(power / 2) * 2.0_f64.powi(power - power / 2)
}

/// got − want over the unit, where `want` comes from something better, `off` being their difference.
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
        // Past the largest number both have overflowed.
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

/// |a·∂f/∂a| of every result for one argument, read in dual numbers over `S`.
fn moved<F: Formula, S: Real>(a: &Arguments, i: usize) -> Results<f64> {
    let mut point = a.map(<Dual<S> as Real>::of);
    point[i] = Dual::variable(S::of(a[i]));
    F::at(point).map(|result| (a[i].hi * result.slope.to_f64()).abs())
}

fn scales<F: Formula, T: Real>(a: &Arguments, want: &Results<Dd>) -> Results<f64> {
    let mut all = [[0.0; 5]; 3];
    for i in (0..3).filter(|i| !a[*i].is_zero()) {
        // Next to a zero the place must be as exact as the result is.
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
            // Among the subnormals all numbers have the same unit.
            let least = 2.0_f64.powi(T::FORMAT.1 as i32);
            for i in 0..5 {
                let error = off[i].abs() / (scales[i].max(least) * T::EPSILON);
                errors[i] = if off[i] == 0.0 { 0.0 } else { error };
            }
        }
    }
    // A NaN is the worst of all.
    errors.map(|error| if error.is_nan() { f64::INFINITY } else { error })
}

fn minus(got: Dd, want: Dd) -> f64 {
    (got.hi - want.hi) + (got.lo - want.lo)
}

/// The errors of a function in `T`, against the same function in `Better`, which has a row of its
/// own in the table.
pub fn against<F: Formula, T: Real, Better: Real>(a: &Arguments) -> Results<f64> {
    let got = F::at(a.map(T::of)).map(Real::widened);
    let want = F::at(a.map(Better::of)).map(Real::widened);
    let mut off = [0.0; 5];
    for i in 0..5 {
        off[i] = minus(got[i], want[i]);
    }
    judged::<F, T>(a, got, want, off)
}

/// The errors of a function in double-double against the printed formula in big numbers.
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
        // An exact result and one beyond the range leave no difference to count.
        if off[i] == 0.0 || (want[i].hi.is_infinite() && got[i].hi == want[i].hi) {
            want[i] = got[i];
            off[i] = 0.0;
        }
    }
    judged::<F, Dd>(a, got, want, off)
}

//! Measures the elementary functions of the kernel against their definitions.

use crate::budgets::big::Big;
use crate::budgets::measure::{Formula, Real, Results, Unit};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::special::{exp_m1_minus, versine_pi};
use frictiongen_kernel::number::trig::{double, single};

/// Defines formulas. An entry has the name, the unit, the arguments a, b and c, the kernel's results, and the printed
/// results.
macro_rules! formulas {
    ($($(#[$doc:meta])* $name:ident $unit:ident: |$a:ident, $b:ident, $c:ident| $kernel:expr, $printed:expr;)*) => { $(
        $(#[$doc])*
        pub struct $name;
        impl Formula for $name {
            const UNIT: Unit = Unit::$unit;
            #[allow(unused_variables)]
            fn at<T: Real>([$a, $b, $c]: [T; 3]) -> Results<T> {
                let mut results = [T::constant(0.0); 5];
                for (result, value) in results.iter_mut().zip($kernel) {
                    *result = value;
                }
                results
            }
            #[allow(unused_variables)]
            fn printed([$a, $b, $c]: [Big; 3]) -> Option<Vec<Big>> {
                $printed
            }
        }
    )* };
}
pub(crate) use formulas;

fn one() -> Big {
    Big::integer(1)
}

/// Returns sin πh and cos πh. Returns NaN if the functions that return only the sine or only the cosine give other
/// bits.
fn sin_cos<T: Real>(h: T) -> [T; 2] {
    let (sin, cos) = h.sin_cos_pi();
    let alone = [h.sin_pi(), h.cos_pi()];
    let same = |a: T, b: T| a == b || (a.to_f64().is_nan() && b.to_f64().is_nan());
    let nan = T::constant(f64::NAN);
    if same(alone[0], sin) && same(alone[1], cos) && module_agrees(h, sin) {
        [sin, cos]
    } else {
        [nan, nan]
    }
}

/// Returns true if the function of the kernel's module gives the same result as the method of the scalar type.
fn module_agrees<T: Real>(h: T, sin: T) -> bool {
    let (h, sin) = (h.to_f64(), sin.to_f64());
    match T::FORMAT.0 {
        53 => double::sin_pi(h).to_bits() == sin.to_bits(),
        24 => single::sin_pi(h as f32).to_bits() == (sin as f32).to_bits(),
        _ => true,
    }
}

/// Returns the quotient, or `None` for a divisor of 0.
fn quotient(a: Big, b: Big) -> Option<Big> {
    (!b.is_zero()).then(|| a / b)
}

/// Returns the angle of the point (x, y), or `None` at the origin. The function corrects an estimate in `f64` five
/// times by (y cos − x sin)/(x cos + y sin), the tangent of the remaining angle.
fn angle(y: Big, x: Big) -> Option<Vec<Big>> {
    if y.is_zero() && x.is_zero() {
        return None;
    }
    let scale = Big::integer(1).shifted(-y.order().max(x.order()));
    let (y, x) = (y * scale.clone(), x * scale);
    let mut guess = Big::of(y.to_f64().atan2(x.to_f64()));
    for _ in 0..5 {
        let (sin, cos) = (guess.clone() / Big::pi()).sin_cos_pi();
        let cross = y.clone() * cos.clone() - x.clone() * sin.clone();
        let along = x.clone() * cos + y.clone() * sin;
        guess = guess + cross / along;
    }
    Some(vec![guess])
}

formulas! {
    SinCosPi Place: |h, b, c| sin_cos(h), { let (s, c) = h.sin_cos_pi(); Some(vec![s, c]) };
    SinCosPiMinus Place: |h, d, c| <[T; 2]>::from(h.sin_cos_pi_minus(d)), {
        // If two numbers differ very much in size, their difference has more digits than a big number can hold. The
        // formula then uses the addition theorems.
        if h.is_zero() || d.is_zero() || (h.order() - d.order()).abs() < 300 {
            let (sin, cos) = (h - d).sin_cos_pi();
            return Some(vec![sin, cos]);
        }
        let ((s, c), (sd, cd)) = (h.sin_cos_pi(), d.sin_cos_pi());
        let sin = s.clone() * cd.clone() - c.clone() * sd.clone();
        Some(vec![sin, c * cd + s * sd])
    };
    Sqrt Place: |x, b, c| [x.sqrt()], (!x.is_negative()).then(|| if x.is_zero() { vec![x] } else { vec![x.sqrt()] });
    Exp Place: |x, b, c| [x.exp()], Some(vec![x.exp()]);
    ExpM1 Place: |x, b, c| [x.exp_m1()], Some(vec![x.exp_m1()]);
    Atan2 Place: |y, x, c| [y.atan2(x)], angle(y, x);
    OneMinusSincPi Place: |z, b, c| [z.one_minus_sinc_pi()], {
        if z.is_zero() {
            return Some(vec![z]);
        }
        let (s, _) = z.sin_cos_pi();
        Some(vec![one() - s / (Big::pi() * z)])
    };
    ScaledSinhDefect Place: |a, b, c| [a.scaled_sinh_defect()], {
        let e = (-a.clone()).exp();
        Some(vec![one() - e.clone() * e.clone() - a.shifted(1) * e])
    };
    VersinePi Place: |z, b, c| [versine_pi(z)], Some(vec![z.versine_pi()]);
    ExpM1Minus Place: |a, b, c| [exp_m1_minus(a)], Some(vec![a.exp_m1_minus()]);
    Floor Place: |x, b, c| [x.floor()], Some(vec![x.floor()]);
    Pi Place: |a, b, c| [T::pi()], Some(vec![Big::pi()]);
    InversePi Place: |a, b, c| [T::inverse_pi()], Some(vec![one() / Big::pi()]);
    Add Place: |x, y, c| [x + y], Some(vec![x + y]);
    Subtract Place: |x, y, c| [x - y], Some(vec![x - y]);
    Multiply Place: |x, y, c| [x * y], Some(vec![x * y]);
    Divide Place: |x, y, c| [x / y], Some(vec![quotient(x, y)?]);
    /// Sum of two `f64`, which is exact.
    DdSum Place: |x, y, c| [T::of(Dd::sum(x.to_f64(), y.to_f64()))], Some(vec![x + y]);
    /// Product of two `f64`, which is exact.
    DdProduct Place: |x, y, c| [T::of(Dd::product(x.to_f64(), y.to_f64()))], Some(vec![x * y]);
    Margin Norm: |beta, continuous, sliding| {
        let one = T::constant(1.0);
        // The size of the result includes the 1 that the function subtracts.
        [frictiongen_kernel::contact::regime::margin(beta, continuous, sliding), one]
    }, {
        let limit = if (continuous.clone() - sliding.clone()).is_negative() { continuous } else { sliding };
        Some(vec![quotient(beta, limit)? - one(), one()])
    };
}

//! Measures the response of a mode and its motion in time against the forms that the thesis prints (section 7.2,
//! appendix B). In big numbers the printed forms keep enough digits.

use crate::budgets::big::Big;
use crate::budgets::measure::{Arguments, Formula, Real, Results, Unit, plus};
use frictiongen_kernel::number::complex::Complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::trig::double;
use frictiongen_kernel::oscillator::decay::{Basis, Damped, Decay, Instant, Undamped};
use frictiongen_kernel::oscillator::mode::{Kind, Mode, ModeResponse};

fn kind(zeta: f64) -> Kind {
    match zeta {
        0.0 => Kind::Undamped,
        z if z < 0.5 => Kind::Light,
        z if z < 1.0 => Kind::Heavy,
        1.0 => Kind::Critical,
        _ => Kind::Over,
    }
}

/// Creates a mode with its resonance at r = x.
fn mode<T: Real>(x: T, zeta: T) -> Mode<T> {
    let one = T::constant(1.0);
    let (q, q_defect) = T::of_damping(zeta);
    Mode {
        kind: kind(zeta.to_f64()),
        in_contact: true,
        resonance: x,
        zeta,
        q,
        q_defect,
        load: one,
        contact: one,
        residue: one,
        contact_squared: one,
        static_residue: one,
    }
}

fn one() -> Big {
    Big::integer(1)
}

/// Returns e^{−a}·(cos b, sin b/q) with a = ζ·angle and b = q·angle. For ζ > 1, q is imaginary. `turns` is the angle
/// in half turns.
fn turning(zeta: &Big, turns: &Big) -> (Big, Big) {
    let square = (one() - zeta.clone()) * (one() + zeta.clone());
    let angle = turns.clone() * Big::pi();
    let decay = (-(zeta.clone() * angle.clone())).exp();
    if square.is_zero() {
        return (decay.clone(), decay * angle);
    }
    let q = square.abs().sqrt();
    if square.is_negative() {
        // The code combines the decay with the hyperbolic functions. Their growing part alone would leave the range
        // of numbers.
        let (slow, fast) = (
            (-((zeta.clone() - q.clone()) * angle.clone())).exp(),
            (-((zeta.clone() + q.clone()) * angle)).exp(),
        );
        return (
            (slow.clone() + fast.clone()).shifted(-1),
            (slow - fast).shifted(-1) / q,
        );
    }
    let (sin, cos) = (q.clone() * turns.clone()).sin_cos_pi();
    (decay.clone() * cos, decay * sin / q)
}

/// Returns five numbers: x² − 1, 2ζx, and u R², g and g + 2ζRu (7.11, 7.12), each multiplied by |x² − 1| + 2ζx.
fn printed_response(x: &Big, zeta: &Big) -> Option<Vec<Big>> {
    let two_loss = zeta.clone().shifted(1) * x.clone();
    let re = x.clone() * x.clone() - one();
    let size = re.abs() + two_loss.clone();
    let (u, g) = if zeta.is_zero() {
        let (sin, cos) = x.clone().shifted(-1).sin_cos_pi();
        if cos.is_zero() {
            return None;
        }
        (x.clone() * sin / cos, Big::integer(0))
    } else {
        let e = (-(Big::pi() * zeta.clone() * x.clone())).exp();
        let (cos, sin_over_q) = turning(zeta, x);
        // The result of `turning` already contains the factor e^{−a} of the decay.
        let d = one() + e.clone() * e.clone() + cos.shifted(1);
        let u = x.clone() * sin_over_q.clone().shifted(1) / d.clone();
        let g = (one() - e.clone() * e - zeta.clone().shifted(1) * sin_over_q) / d;
        (u, g)
    };
    let u_over = u.clone() / (x.clone() * x.clone());
    let reversal = g.clone() + zeta.clone().shifted(1) * u / x.clone();
    Some(vec![
        re,
        two_loss,
        u_over * size.clone(),
        g * size.clone(),
        reversal * size,
    ])
}

fn response<T: Real>(x: T, zeta: T) -> ModeResponse<T> {
    mode(x, zeta).response(T::constant(1.0), 0)
}

/// Results of [`Mode::response`]: real and imaginary part of the denominator of v, then u, g and the reversal term.
pub struct Response;
impl Formula for Response {
    const UNIT: Unit = Unit::Mixed;
    fn at<T: Real>([x, zeta, _]: [T; 3]) -> Results<T> {
        let at = response(x, zeta);
        [
            at.denominator.re,
            at.denominator.im,
            at.u,
            at.g,
            at.reversal,
        ]
    }
    fn printed([x, zeta, _]: [Big; 3]) -> Option<Vec<Big>> {
        printed_response(&x, &zeta)
    }
}

/// Results of [`Mode::response`] for modes that keep little of their motion over a half period. u and 1 − g are then
/// far below the inverse effective mass of the contact, to which they are added. The size that divides the error
/// allows for this.
pub struct DecayedResponse;
impl Formula for DecayedResponse {
    const UNIT: Unit = Unit::Size;
    fn at<T: Real>(a: [T; 3]) -> Results<T> {
        Response::at(a)
    }
    fn printed(a: [Big; 3]) -> Option<Vec<Big>> {
        Response::printed(a)
    }
    fn scales(a: &Arguments, value: Results<f64>, moved: [Results<f64>; 3]) -> Results<f64> {
        let size = response(a[0].to_f64(), a[1].to_f64()).size;
        plus(Response::scales(a, value, moved), [size; 5])
    }
}

/// Results of [`Mode::response`] without damping: the denominator of v, and u. Their errors are in units in the last
/// place.
pub struct PlainResponse;
impl Formula for PlainResponse {
    fn at<T: Real>([x, zeta, _]: [T; 3]) -> Results<T> {
        let at = response(x, zeta);
        let zero = T::constant(0.0);
        [at.denominator.re, at.u, at.g, at.reversal, zero]
    }
    fn printed([x, zeta, _]: [Big; 3]) -> Option<Vec<Big>> {
        let all = printed_response(&x, &zeta)?;
        Some(vec![
            all[0].clone(),
            all[2].clone(),
            all[3].clone(),
            all[4].clone(),
        ])
    }
}

fn printed_basis(x: &Big, zeta: &Big, t: &Big) -> Vec<Big> {
    let (cos, sin_over_q) = turning(zeta, &(x.clone() * t.clone()));
    let (sine, cosine) = t.sin_cos_pi();
    let free = sin_over_q.clone() / x.clone();
    let slope = cos.clone() - zeta.clone() * sin_over_q.clone();
    let d = cos + zeta.clone() * sin_over_q;
    vec![
        free.clone(),
        slope.clone(),
        sine - free,
        cosine - slope,
        (one() - d) / (x.clone() * x.clone()),
    ]
}

fn fields<T>(basis: Basis<T>) -> Results<T> {
    [
        basis.free,
        basis.slope,
        basis.forced,
        basis.forced_slope,
        basis.rise,
    ]
}

/// Returns the sizes that divide the errors of the results in time. The differences sin τ − p and cos τ − p′ are
/// multiplied by damping functions that grow as 1/(|x − 1| + ζ) near the resonance. Near the resonance, a change of x
/// explains none of the error of a difference. The size of the first difference is sin τ. The size of the second is the
/// difference itself, or 1 for τ > π/2.
fn in_time_scales(a: &Arguments, value: Results<f64>, moved: [Results<f64>; 3]) -> Results<f64> {
    let [x, zeta, t] = a.map(Dd::to_f64);
    let (distance, [by_x, by_zeta, by_t]) = ((x - 1.0).abs(), moved);
    let mut scales = plus(plus(value, by_zeta), by_t);
    let near = distance < 0.5;
    let share = (distance + zeta).min(1.0);
    let late = if t > 0.5 { share } else { 0.0 };
    let sizes = [0.0, 0.0, share * double::sin_pi(t), late, 0.0];
    for i in 0..5 {
        let difference = i == 2 || i == 3;
        scales[i] += sizes[i] + if near && difference { 0.0 } else { by_x[i] };
    }
    scales
}

/// Returns the second-order effect of a relative change of ε. 1 − d touches 0 after each whole turn. At these instants
/// the effect of each argument is (xτε)²/2, divided by x².
fn in_time_curved(a: &Arguments) -> Results<f64> {
    let tau = a[2].to_f64() * std::f64::consts::PI;
    [0.0, 0.0, 0.0, 0.0, 2.0 * tau * tau]
}

/// Results of [`Damped::basis`]: p, p′, sin τ − p, cos τ − p′, (1 − d)/x², with the free motions d and p of the mode.
pub struct InTime;
impl Formula for InTime {
    const UNIT: Unit = Unit::Size;
    fn at<T: Real>([x, zeta, t]: [T; 3]) -> Results<T> {
        fields(Damped::of(&mode(x, zeta)).basis(x, &Instant::new(t)))
    }
    fn printed([x, zeta, t]: [Big; 3]) -> Option<Vec<Big>> {
        Some(printed_basis(&x, &zeta, &t))
    }
    fn scales(a: &Arguments, value: Results<f64>, moved: [Results<f64>; 3]) -> Results<f64> {
        in_time_scales(a, value, moved)
    }
    fn curved(a: &Arguments) -> Results<f64> {
        in_time_curved(a)
    }
}

/// Results of [`Damped::basis`] after most of the motion has decayed. The initial sizes of p and of the other results
/// then divide their errors.
pub struct DecayedInTime;
impl Formula for DecayedInTime {
    const UNIT: Unit = Unit::Size;
    fn at<T: Real>(a: [T; 3]) -> Results<T> {
        InTime::at(a)
    }
    fn printed(a: [Big; 3]) -> Option<Vec<Big>> {
        InTime::printed(a)
    }
    fn scales(a: &Arguments, value: Results<f64>, moved: [Results<f64>; 3]) -> Results<f64> {
        let x = a[0].to_f64();
        let size = [1.0 / x, 1.0, 1.0 / x, 1.0, 1.0 / (x * x)];
        plus(InTime::scales(a, value, moved), size)
    }
}

/// Results of [`Undamped::basis`]. The second argument ζ is 0.
pub struct InTimeUndamped;
impl Formula for InTimeUndamped {
    const UNIT: Unit = Unit::Size;
    fn at<T: Real>([x, zeta, t]: [T; 3]) -> Results<T> {
        fields(Undamped::of(&mode(x, zeta)).basis(x, &Instant::new(t)))
    }
    fn printed([x, zeta, t]: [Big; 3]) -> Option<Vec<Big>> {
        Some(printed_basis(&x, &zeta, &t))
    }
    fn scales(a: &Arguments, value: Results<f64>, moved: [Results<f64>; 3]) -> Results<f64> {
        in_time_scales(a, value, moved)
    }
    fn curved(a: &Arguments) -> Results<f64> {
        in_time_curved(a)
    }
}

/// Results of [`Instant::new`]: τ, sin τ, cos τ, 1 − cos τ.
pub struct AnInstant;
impl Formula for AnInstant {
    fn at<T: Real>([t, _, _]: [T; 3]) -> Results<T> {
        let at = Instant::new(t);
        [at.tau, at.sine, at.cosine, at.versine, T::constant(0.0)]
    }
    fn printed([t, _, _]: [Big; 3]) -> Option<Vec<Big>> {
        let (sine, cosine) = t.sin_cos_pi();
        Some(vec![t.clone() * Big::pi(), sine, cosine, t.versine_pi()])
    }
}

/// The response v = x²/(x² − 1 + 2iζx) (7.8), computed from [`ModeResponse`].
pub struct V;
impl Formula for V {
    const UNIT: Unit = Unit::Norm;
    fn at<T: Real>([x, zeta, _]: [T; 3]) -> Results<T> {
        let at = response(x, zeta);
        let inverse = frictiongen_kernel::number::complex::reciprocal(at.denominator, true);
        let v: Complex<T> = frictiongen_kernel::number::complex::scale(inverse, x * x);
        let zero = T::constant(0.0);
        [v.re, v.im, zero, zero, zero]
    }
    fn printed([x, zeta, _]: [Big; 3]) -> Option<Vec<Big>> {
        let (re, im) = (x.clone() * x.clone() - one(), zeta.shifted(1) * x.clone());
        let square = re.clone() * re.clone() + im.clone() * im.clone();
        let v = x.clone() * x / square;
        Some(vec![v.clone() * re, -(v * im)])
    }
}

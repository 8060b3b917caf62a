//! Backward error: by how many roundings of its inputs an answer is the exact one.
//!
//! Inputs are r, β, τ, μ and the modal data, each on its own: λ, ζ, every residue, m*.  An answer is
//! as good as its inputs allow if some inputs within k roundings have it as their exact answer.  To
//! first order that is |error| ≤ k ε (Σ|x ∂f/∂x| + |f|), the last term for the answer's own rounding;
//! where r stands a few roundings beside a pole the first order says nothing, and the exact answer is
//! looked up at displaced inputs instead.

use crate::asked::{Asked, Place, answer};
use crate::condition::{Given, PLAIN, displaced, explained, lowest, modulus, stationary};
use frictiongen_kernel::dd::Dd;
use frictiongen_kernel::dual::Dual;
use frictiongen_kernel::{Complex, Float};
use generated_tests::data::{Data, DataMotion};

/// Where the exact motion is at its largest: next to where it was found to be, which need not be a
/// stationary point.
fn largest(motion: &DataMotion<Dd>, hint: Option<Dd>) -> Dd {
    const ABOUT: f64 = 0.1;
    let Some(hint) = hint else {
        let places = motion.peak().places;
        let mut places = places.iter().flatten();
        return places.next().map_or(Dd::from(0.0), |place| place.tau);
    };
    let below = |away: f64| -motion.displacement(hint + Dd::from(away)).abs().to_f64();
    hint + Dd::from(lowest(below, -ABOUT, ABOUT, f64::NEG_INFINITY).0)
}

/// An angle's distance, within half a turn.
fn angle(difference: Dd) -> Dd {
    let turn = Dd::PI + Dd::PI;
    let turns = Float::floor(difference / turn + Dd::from(0.5));
    difference - turns * turn
}

fn distance(got: Complex<Dd>, want: Complex<Dd>, asked: Asked) -> Dd {
    if asked.is_angle() {
        return angle(got.re - want.re).abs();
    }
    if got.re == want.re && got.im == want.im {
        return Dd::from(0.0);
    }
    modulus(Complex::new(got.re - want.re, got.im - want.im))
}

/// How the answer of a scalar compares with the exact one of its own inputs.
#[derive(Clone, Copy, Debug)]
pub struct Error {
    /// |error|/(ε |f|).
    pub forward: f64,
    /// The smallest k found, in roundings of the inputs.
    pub backward: f64,
}

/// The error of `got` in roundings of S; first-order conditions are only formed where the forward
/// error needs an explanation.  `hint` is where the mass was found to be at its largest.
pub fn error<S: Float>(
    data: &Data<S>,
    place: &Place<S>,
    asked: Asked,
    got: Complex<S>,
    exact: impl Fn(S) -> Dd + Copy,
    hint: Option<S>,
    bar: f64,
) -> Error {
    let data = data.read(exact);
    let place = place.read(exact);
    let got = Complex::new(exact(got.re), exact(got.im));
    let limits = (S::EPSILON, bar);
    let mut error = answered(&data, &place, asked, got, hint.map(exact), limits);
    if !(error.backward <= bar) && asked.is_motion() {
        // Where so small a change of the inputs undoes V itself, nothing about the motion is known.
        let given = (data.read(Dual::fixed), place.read(Dual::fixed));
        let limit = answer(&data, &place, Asked::SlidingLimit).re;
        let whole = limit / Dd::from(S::EPSILON);
        let undone = explained(&given, Asked::SlidingLimit, None, whole, limit).0;
        error.backward = error.backward.min(undone);
    }
    error
}

fn answered(
    data: &Data<Dd>,
    place: &Place<Dd>,
    asked: Asked,
    got: Complex<Dd>,
    hint: Option<Dd>,
    limits: (f64, f64),
) -> Error {
    match asked {
        Asked::Phase(mass) => phase(data, place, mass, got.re, hint, limits),
        Asked::Amplitude(mass) => {
            let given = (data.read(Dual::fixed), place.read(Dual::fixed));
            let motion = data.at(place.r).mass(mass, place.beta);
            let beside = |tau: Dd| {
                let want = Complex::new(motion.displacement(tau).abs(), Dd::from(0.0));
                compared(data, place, asked, got, want, Some(tau), limits)
            };
            // The search has its own tests; here the maximum that it found is what is compared.
            match hint.and_then(|tau| stationary(&given, mass, tau)) {
                Some(tau) => beside(tau),
                None => beside(largest(&motion, hint)),
            }
        }
        _ => {
            let want = answer(data, place, asked);
            compared(data, place, asked, got, want, None, limits)
        }
    }
}

/// A phase is right if the mass is at a maximum there, and if that maximum is, to its own rounding,
/// the largest: of maxima that are equal to rounding either may be the answer.
fn phase(
    data: &Data<Dd>,
    place: &Place<Dd>,
    mass: usize,
    got: Dd,
    hint: Option<Dd>,
    limits: (f64, f64),
) -> Error {
    let at = data.at(place.r);
    let carrier = at.contact(place.beta).phase();
    let motion = at.mass(mass, place.beta);
    let given = (data.read(Dual::fixed), place.read(Dual::fixed));
    let asked = Asked::Phase(mass);
    let real = |value: Dd| Complex::new(value, Dd::from(0.0));
    let found = hint.and_then(|tau| stationary(&given, mass, tau));
    let tau = found.unwrap_or_else(|| largest(&motion, hint));
    let (top, largest) = (Some(tau), motion.displacement(tau).abs());
    let amplitude = Asked::Amplitude(mass);
    // Where so small a change of the inputs can undo the whole motion, it has no phase.
    let (epsilon, bar) = limits;
    let whole = largest / Dd::from(epsilon);
    let undone = || explained(&given, amplitude, top, whole, largest).0;
    let Some(tau) = stationary(&given, mass, got - carrier) else {
        let found = along_the_limit(&given, asked, None, real(got), limits);
        return Error {
            forward: f64::INFINITY,
            backward: found.unwrap_or_else(undone),
        };
    };
    let want = real(carrier + tau);
    let mut error = compared(data, place, asked, real(got), want, Some(tau), limits);
    if !(error.backward <= bar) {
        error.backward = error.backward.min(undone());
    }
    let there = motion.displacement(tau);
    let height = compared(
        data,
        place,
        amplitude,
        real(there.abs()),
        real(largest),
        top,
        limits,
    );
    if height.backward > error.backward {
        height
    } else {
        error
    }
}

/// The error against a value that is known.
pub fn against(
    data: &Data<Dd>,
    place: &Place<Dd>,
    asked: Asked,
    got: Complex<Dd>,
    want: Complex<Dd>,
    limits: (f64, f64),
) -> Error {
    compared(data, place, asked, got, want, None, limits)
}

fn compared(
    data: &Data<Dd>,
    place: &Place<Dd>,
    asked: Asked,
    got: Complex<Dd>,
    want: Complex<Dd>,
    top: Option<Dd>,
    (epsilon, bar): (f64, f64),
) -> Error {
    let epsilon = Dd::from(epsilon);
    // An angle is known to the rounding of a half turn.
    let size = if matches!(asked, Asked::Phase(_)) {
        Dd::PI
    } else {
        modulus(want)
    };
    let off = distance(got, want, asked);
    let forward = if off.is_zero() {
        0.0
    } else {
        (off / (epsilon * size)).to_f64()
    };
    // Scaling residues scales every answer but an angle: no condition is below 1.
    if forward <= PLAIN {
        return Error {
            forward,
            backward: forward,
        };
    }
    let given = (data.read(Dual::fixed), place.read(Dual::fixed));
    let (mut backward, slopes) = explained(&given, asked, top, off / epsilon, size);
    if !(backward <= bar) {
        let found = displaced(&given, asked, top, got, &slopes, epsilon, bar);
        backward = found.unwrap_or(backward);
    }
    if !(backward <= bar) && asked.is_motion() {
        let found = along_the_limit(&given, asked, top, got, (epsilon.to_f64(), bar));
        backward = found.unwrap_or(backward);
    }
    Error { forward, backward }
}

/// Q vanishes as a square root does and has no slope at its end, and beside a pole of U the slopes change
/// within a rounding: the displacement that explains a motion, along what moves the limit.
fn along_the_limit(
    given: &Given,
    asked: Asked,
    top: Option<Dd>,
    got: Complex<Dd>,
    (epsilon, bar): (f64, f64),
) -> Option<f64> {
    let limit = answer(&given.0, &given.1, Asked::WithoutSearch).re.value;
    let all = Dd::from(f64::MAX);
    let slopes = explained(given, Asked::WithoutSearch, None, all, limit).1;
    displaced(given, asked, top, got, &slopes, Dd::from(epsilon), bar)
}

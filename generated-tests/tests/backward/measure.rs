//! Backward error: by how many roundings of its inputs an answer is the exact one.
//!
//! Inputs are r, β, τ, μ and the modal data, each on its own: λ, ζ, every residue, m*.  An answer is
//! as good as its inputs allow if some inputs within k roundings have it as their exact answer.  To
//! first order that is |error| ≤ k ε (Σ|x ∂f/∂x| + |f|), the last term for the answer's own rounding;
//! where r stands a few roundings beside a pole the first order says nothing, and the exact answer is
//! looked up at displaced inputs instead.

use frictiongen_kernel::dd::Dd;
use frictiongen_kernel::dual::Dual;
use frictiongen_kernel::{Complex, Float, complex};
use generated_tests::data::{Data, roots};

/// Errors of so few roundings need no condition to explain them.
const PLAIN: f64 = 8.0;

/// What is asked of a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Asked {
    ContinuousLimit,
    WithoutSearch,
    SlidingLimit,
    ContactAmplitude,
    ContactPhase,
    Amplitude(usize),
    Phase(usize),
    Displacement(usize),
    Stuck(usize),
}

impl Asked {
    pub fn is_angle(self) -> bool {
        matches!(self, Self::ContactPhase | Self::Phase(_))
    }
    fn is_motion(self) -> bool {
        !matches!(
            self,
            Self::ContinuousLimit | Self::WithoutSearch | Self::SlidingLimit | Self::Stuck(_)
        )
    }
    pub fn kind(self) -> &'static str {
        match self {
            Self::ContinuousLimit => "continuous limit",
            Self::WithoutSearch => "without search",
            Self::SlidingLimit => "sliding limit",
            Self::ContactAmplitude => "contact amplitude",
            Self::ContactPhase => "contact phase",
            Self::Amplitude(_) => "amplitude",
            Self::Phase(_) => "phase",
            Self::Displacement(_) => "displacement",
            Self::Stuck(_) => "stuck",
        }
    }
}

/// Where it is asked.
#[derive(Clone, Copy, Debug)]
pub struct Place<S> {
    pub r: S,
    pub beta: S,
    pub tau: S,
}

impl<S: Float> Place<S> {
    pub fn read<T>(&self, to: impl Fn(S) -> T) -> Place<T> {
        Place {
            r: to(self.r),
            beta: to(self.beta),
            tau: to(self.tau),
        }
    }
}

/// The answer of the formulas, in whatever scalar.
pub fn answer<S: Float>(data: &Data<S>, place: &Place<S>, asked: Asked) -> Complex<S> {
    let at = data.at(place.r);
    let real = |value: S| Complex::new(value, S::constant(0.0));
    match asked {
        Asked::ContinuousLimit => real(at.continuous_limit()),
        Asked::WithoutSearch => real(at.continuous_limit_without_search()),
        Asked::SlidingLimit => real(at.sliding_limit()),
        Asked::ContactAmplitude => real(at.contact(place.beta).amplitude()),
        Asked::ContactPhase => real(at.contact(place.beta).phase()),
        Asked::Amplitude(mass) => real(at.mass(mass, place.beta).amplitude()),
        Asked::Phase(mass) => real(at.mass(mass, place.beta).phase()),
        Asked::Displacement(mass) => real(at.mass(mass, place.beta).displacement(place.tau)),
        Asked::Stuck(mass) => at.stuck(mass),
    }
}

type Given = (Data<Dual<Dd>>, Place<Dual<Dd>>);

/// How many kinds of inputs there are.
const KINDS: usize = 14;

/// Every input in turn, by reference, and its kind.  ζ brings q with it.
fn inputs(given: &mut Given, mut visit: impl FnMut(usize, &mut Dual<Dd>)) {
    let (data, place) = given;
    let chain = &mut data.reduced.chain;
    let single = [&mut place.r, &mut place.beta, &mut place.tau];
    let single = single
        .into_iter()
        .chain([&mut chain.stiction, &mut chain.mobility]);
    for (kind, input) in single.chain(&mut chain.on_moving_base).enumerate() {
        visit(kind, input);
    }
    for mode in &mut data.reduced.modes {
        for (kind, input) in [
            &mut mode.load,
            &mut mode.contact,
            &mut mode.residue,
            &mut mode.mobility,
            &mut mode.static_residue,
            &mut mode.resonance,
            &mut mode.zeta,
        ]
        .into_iter()
        .enumerate()
        {
            visit(6 + kind, input);
        }
        (mode.q, mode.q_defect) = roots(mode.zeta);
    }
    for shape in &mut data.reduced.shapes {
        shape.iter_mut().for_each(|input| visit(KINDS - 1, input));
    }
}

/// Which inputs move.
#[derive(Clone, Copy)]
enum Move {
    /// One of them.
    One(usize),
    /// All of a kind, up and down by no rule.
    Kind(usize),
}

fn modulus(value: Complex<Dd>) -> Dd {
    complex::modulus(value, true)
}

/// Σ ±x ∂f/∂x over the inputs that move.  `top` is where a mass is at its largest: its amplitude moves
/// as its displacement there does, its phase as the zero of its velocity.
fn relative_slope(given: &Given, which: Move, asked: Asked, top: Option<Dual<Dd>>) -> Complex<Dd> {
    let mut seeded = given.clone();
    let mut index = 0_usize;
    let mut idle = true;
    inputs(&mut seeded, |kind, input| {
        let (moves, negative) = match which {
            Move::One(which) => (which == index, false),
            // The parity of a multiple's bits: signs without a pattern.
            Move::Kind(which) => (
                which == kind,
                index.wrapping_mul(0x9E37_79B9).count_ones() % 2 == 1,
            ),
        };
        if moves {
            input.slope = if negative { -input.value } else { input.value };
            idle &= input.value.is_zero();
        }
        index += 1;
    });
    if idle {
        return Complex::new(Dd::from(0.0), Dd::from(0.0));
    }
    let (data, place) = &seeded;
    if let Some(top) = top {
        let at = data.at(place.r);
        let slope = match asked {
            Asked::Phase(mass) => {
                let motion = at.mass(mass, place.beta);
                let moved = motion.velocity(top).slope;
                let falls = acceleration(given, mass, top);
                at.contact(place.beta).phase().slope - moved / falls
            }
            Asked::Amplitude(mass) => at.mass(mass, place.beta).displacement(top).slope,
            other => panic!("{other:?} has no top"),
        };
        return Complex::new(slope, Dd::from(0.0));
    }
    let answer = answer(data, place, asked);
    Complex::new(answer.re.slope, answer.im.slope)
}

/// x̄″ at `tau`.
fn acceleration(given: &Given, mass: usize, tau: Dual<Dd>) -> Dd {
    let motion = given.0.at(given.1.r).mass(mass, given.1.beta);
    motion.velocity(Dual::variable(tau.value)).slope
}

/// The stationary instant next to `tau`, by Newton's method on the exact motion; none where it leaves
/// the place or finds no end.
fn stationary(given: &Given, mass: usize, tau: Dd) -> Option<Dd> {
    let motion = given.0.at(given.1.r).mass(mass, given.1.beta);
    let mut at = tau;
    for _ in 0..60 {
        let velocity = motion.velocity(Dual::variable(at));
        let step = velocity.value / velocity.slope;
        at = at - step;
        if !((at - tau).abs().to_f64() < 0.1) {
            return None;
        }
        if step.abs().to_f64() <= 1e-19 {
            return Some(at);
        }
    }
    None
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
            // The search has its own tests; here the maximum that it found is what is compared.
            if let Some(tau) = hint.and_then(|tau| stationary(&given, mass, tau)) {
                let top = data.at(place.r).mass(mass, place.beta).displacement(tau);
                let want = Complex::new(top.abs(), Dd::from(0.0));
                return compared(data, place, asked, got, want, Some(tau), limits);
            }
            let peak = data.at(place.r).mass(mass, place.beta).peak();
            let tau = peak.places.iter().flatten().next().map(|place| place.tau);
            let want = Complex::new(peak.value, Dd::from(0.0));
            compared(data, place, asked, got, want, tau, limits)
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
    let (top, largest) = match hint.and_then(|tau| stationary(&given, mass, tau)) {
        Some(tau) => (Some(tau), motion.displacement(tau).abs()),
        None => {
            let peak = motion.peak();
            let place = peak.places.iter().flatten().next();
            (place.map(|place| place.tau), peak.value)
        }
    };
    let amplitude = Asked::Amplitude(mass);
    // Where so small a change of the inputs can undo the whole motion, it has no phase.
    let (epsilon, bar) = limits;
    let whole = largest / Dd::from(epsilon);
    let undone = || explained(&given, amplitude, top, whole, largest).0;
    let Some(tau) = stationary(&given, mass, got - carrier) else {
        return Error {
            forward: f64::INFINITY,
            backward: undone(),
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
    if !(backward <= bar) && !matches!(asked, Asked::Phase(_)) {
        backward = displaced(&given, asked, got, &slopes, epsilon, bar).unwrap_or(backward);
    }
    Error { forward, backward }
}

/// `off` over the condition: conditions are added one by one until they explain it, so that the
/// answer is an upper bound.
fn explained(
    given: &Given,
    asked: Asked,
    top: Option<Dd>,
    off: Dd,
    size: Dd,
) -> (f64, Vec<Complex<Dd>>) {
    let ratio = |condition: Dd| {
        let ratio = (off / condition).to_f64();
        if ratio.is_nan() { f64::INFINITY } else { ratio }
    };
    let top = top.map(Dual::fixed);
    // A sum with signs is never above the sum of the moduli: a kind at a time first.
    let mut condition = size;
    let order = [0, 1, 2, 13, 6, 8, 9, 7, 10, 11, 12, 3, 4, 5];
    for kind in order {
        condition = condition + modulus(relative_slope(given, Move::Kind(kind), asked, top));
        if ratio(condition) <= PLAIN {
            return (ratio(condition), Vec::new());
        }
    }
    let mut count = 0;
    inputs(&mut given.clone(), |_, _| count += 1);
    let slopes: Vec<_> = (0..count)
        .map(|which| relative_slope(given, Move::One(which), asked, top))
        .collect();
    let condition = slopes.iter().fold(size, |sum, slope| sum + modulus(*slope));
    (ratio(condition), slopes)
}

/// The smallest displacement of the inputs, all in the direction that moves the answer, between
/// whose ends the exact answer passes `got`.
fn displaced(
    given: &Given,
    asked: Asked,
    got: Complex<Dd>,
    slopes: &[Complex<Dd>],
    epsilon: Dd,
    bar: f64,
) -> Option<f64> {
    const PARTS: i32 = 16;
    let at = |k: f64| {
        let mut moved = given.clone();
        let mut index = 0;
        inputs(&mut moved, |_, input| {
            let slope = slopes[index].re;
            let sign = if slope.is_zero() {
                0.0
            } else {
                1.0_f64.copysign(slope.to_f64())
            };
            input.value = input.value + input.value * epsilon * Dd::from(k * sign);
            index += 1;
        });
        let data = moved.0.read(|dual: Dual<Dd>| dual.value);
        let place = moved.1.read(|dual: Dual<Dd>| dual.value);
        answer(&data, &place, asked).re - got.re
    };
    let mut k = 1.0;
    while k <= bar {
        let values: Vec<f64> = (-PARTS..=PARTS)
            .map(|part| at(k * f64::from(part) / f64::from(PARTS)).to_f64())
            .collect();
        if values.iter().any(|v| *v <= 0.0) && values.iter().any(|v| *v >= 0.0) {
            return Some(k);
        }
        k *= 2.0;
    }
    None
}

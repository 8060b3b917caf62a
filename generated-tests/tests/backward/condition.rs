//! How an answer moves with its inputs.

use crate::asked::{Asked, Place, answer};
use frictiongen_kernel::dd::Dd;
use frictiongen_kernel::dual::Dual;
use frictiongen_kernel::{Complex, complex};
use generated_tests::data::{Data, roots};

/// Errors of so few roundings need no condition to explain them.
pub const PLAIN: f64 = 8.0;
/// So many sums over all inputs with signs are tried before the inputs are taken one by one.
const SIGNS: usize = 4;

pub type Given = (Data<Dual<Dd>>, Place<Dual<Dd>>);

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
    /// All, up and down by no rule; a different one for each number.
    All(usize),
}

pub fn modulus(value: Complex<Dd>) -> Dd {
    complex::modulus(value, true)
}

/// Σ ±x ∂f/∂x over the inputs that move.  `top` is where a mass is at its largest: its amplitude moves
/// as its displacement there does, its phase as the zero of its velocity.
fn relative_slope(given: &Given, which: Move, asked: Asked, top: Option<Dual<Dd>>) -> Complex<Dd> {
    let mut seeded = given.clone();
    let mut index = 0_usize;
    let mut idle = true;
    // The parity of a multiple's bits: signs without a pattern.
    let odd = |number: usize| number.wrapping_mul(0x9E37_79B9).count_ones() % 2 == 1;
    inputs(&mut seeded, |kind, input| {
        let (moves, negative) = match which {
            Move::One(which) => (which == index, false),
            Move::Kind(which) => (which == kind, odd(index)),
            Move::All(number) => (true, odd(index + 1009 * number)),
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

/// `off` over the condition: conditions are added one by one until they explain it, so that the
/// answer is an upper bound.
pub fn explained(
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
    // A sum with signs is never above the sum of the moduli: all at once first, then a kind at a time.
    let mut whole = Dd::from(0.0);
    for number in 0..SIGNS {
        whole = whole.max(modulus(relative_slope(
            given,
            Move::All(number),
            asked,
            top,
        )));
        if ratio(size + whole) <= PLAIN {
            return (ratio(size + whole), Vec::new());
        }
    }
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

/// The stationary instant next to `tau`, by Newton's method on the exact motion; none where it leaves
/// the place or finds no end.
pub fn stationary(given: &Given, mass: usize, tau: Dd) -> Option<Dd> {
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

/// The smallest displacement of the inputs, all in the direction that moves the answer, between
/// whose ends the exact answer passes `got`.
pub fn displaced(
    given: &Given,
    asked: Asked,
    top: Option<Dd>,
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
            let slope = slopes.get(index).map_or(Dd::from(0.0), |slope| slope.re);
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
        let moved = match (asked, top) {
            (Asked::Amplitude(mass), Some(tau)) => {
                let motion = data.at(place.r).mass(mass, place.beta);
                motion.displacement(tau).abs()
            }
            (Asked::Phase(mass), _) => {
                // The maximum nearest to the answer: nothing else moves into its place.
                let carrier = data.at(place.r).contact(place.beta).phase();
                match stationary(&moved, mass, got.re - carrier) {
                    Some(tau) => carrier + tau,
                    None => Dd::from(f64::NAN),
                }
            }
            _ => answer(&data, &place, asked).re,
        };
        moved - got.re
    };
    let mut k = 1.0;
    while k <= bar {
        let part = |part: i32| k * f64::from(part) / f64::from(PARTS);
        let values: Vec<f64> = (-PARTS..=PARTS)
            .map(|number| at(part(number)).to_f64())
            .collect();
        if values.iter().any(|v| *v <= 0.0) && values.iter().any(|v| *v >= 0.0) {
            return Some(k);
        }
        // All on one side: a pole or a zero, narrower than a step, may reach the other side.
        let side = values.first().map_or(1.0, |first| first.signum());
        for (number, three) in (1 - PARTS..PARTS).zip(values.windows(3)) {
            let [left, middle, right] = three else {
                continue;
            };
            if side * middle <= side * left && side * middle <= side * right {
                let beyond = |k| side * at(k).to_f64();
                if lowest(beyond, part(number - 1), part(number + 1), 0.0).1 <= 0.0 {
                    return Some(k);
                }
            }
        }
        k *= 2.0;
    }
    None
}

/// Where a function with one minimum is smallest, and what it is there, by golden section; the first
/// value that is not above `enough` is low enough.
pub fn lowest(of: impl Fn(f64) -> f64, from: f64, to: f64, enough: f64) -> (f64, f64) {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let (mut low, mut high) = (from, to);
    let inner = |low: f64, high: f64| (high - GOLDEN * (high - low), low + GOLDEN * (high - low));
    let (mut a, mut b) = inner(low, high);
    let (mut at_a, mut at_b) = (of(a), of(b));
    // 0.618⁹⁰ = 1.5e-19.
    for _ in 0..90 {
        if at_a <= enough || at_b <= enough {
            break;
        }
        if at_a < at_b {
            (high, b, at_b) = (b, a, at_a);
            a = inner(low, high).0;
            at_a = of(a);
        } else {
            (low, a, at_a) = (a, b, at_b);
            b = inner(low, high).1;
            at_b = of(b);
        }
    }
    if at_a < at_b { (a, at_a) } else { (b, at_b) }
}

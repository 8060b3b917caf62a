//! How an answer moves with its inputs, to first order.

use crate::asked::{Asked, Place, watched};
use frictiongen_kernel::dd::Dd;
use frictiongen_kernel::dual::Dual;
use frictiongen_kernel::{Complex, Float, complex};
use generated_tests::data::{Data, roots};

/// Errors of so few roundings need no condition to explain them.
pub const PLAIN: f64 = 8.0;
/// So many sums over all inputs with signs are tried before the inputs are taken one by one.
const SIGNS: usize = 4;

/// How many kinds of inputs there are.
const KINDS: usize = 14;

/// Every input that the answer may depend on in turn, by reference, and its kind.  ζ brings q with it.
pub fn inputs<S: Float>(
    data: &mut Data<S>,
    place: &mut Place<S>,
    asked: Asked,
    mut visit: impl FnMut(usize, &mut S),
) {
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
    if let Some(mass) = asked.mass() {
        let shape = &mut data.reduced.shapes[mass];
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

/// An answer whose condition is asked for: a scene, where, what, and the instant it is looked at.
pub struct Question<'a> {
    pub data: &'a Data<Dual<Dd>>,
    pub place: Place<Dual<Dd>>,
    pub asked: Asked,
    pub instant: Option<Dual<Dd>>,
}

impl Question<'_> {
    /// Σ ±x ∂f/∂x over the inputs that move.
    fn slope(&self, which: Move) -> Complex<Dd> {
        let (mut data, mut place) = (self.data.clone(), self.place);
        let mut index = 0_usize;
        let mut idle = true;
        // The parity of a multiple's bits: signs without a pattern.
        let odd = |number: usize| number.wrapping_mul(0x9E37_79B9).count_ones() % 2 == 1;
        inputs(&mut data, &mut place, self.asked, |kind, input| {
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
        let answer = watched(&data.at(place.r), &place, self.asked, self.instant);
        Complex::new(answer.re.slope, answer.im.slope)
    }

    /// x ∂f/∂x for every input.
    pub fn slopes(&self) -> Vec<Complex<Dd>> {
        let mut count = 0;
        let (mut data, mut place) = (self.data.clone(), self.place);
        inputs(&mut data, &mut place, self.asked, |_, _| count += 1);
        (0..count)
            .map(|which| self.slope(Move::One(which)))
            .collect()
    }

    /// `off` over a condition, which is `size` and a sum of moduli.  A sum with signs is never above it:
    /// the answer is an upper bound.  All inputs at once first, then a kind at a time.
    pub fn roughly(&self, off: Dd, size: Dd) -> f64 {
        let mut best = f64::INFINITY;
        for number in 0..SIGNS {
            let whole = modulus(self.slope(Move::All(number)));
            best = best.min(ratio(off, size + whole));
            if best <= PLAIN {
                return best;
            }
        }
        let mut condition = size;
        for kind in [0, 1, 2, 13, 6, 8, 9, 7, 10, 11, 12, 3, 4, 5] {
            condition = condition + modulus(self.slope(Move::Kind(kind)));
            if ratio(off, condition) <= PLAIN {
                break;
            }
        }
        best.min(ratio(off, condition))
    }

    /// The same from every input's own slope.
    pub fn exactly(&self, off: Dd, size: Dd, slopes: &[Complex<Dd>]) -> f64 {
        let sum = slopes.iter().fold(size, |sum, slope| sum + modulus(*slope));
        ratio(off, sum)
    }
}

/// The number of roundings, as large as need be where nothing is known.
fn ratio(off: Dd, condition: Dd) -> f64 {
    let ratio = (off / condition).to_f64();
    if ratio.is_nan() { f64::INFINITY } else { ratio }
}

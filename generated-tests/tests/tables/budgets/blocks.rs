//! Measures the parts of emitted code: small complex operations, and the last operations of the limits.

use crate::budgets::big::Big;
use crate::budgets::elementary::formulas;
use crate::budgets::measure::{Formula, Real, Results, Unit};
use frictiongen_kernel::contact::sums::{Chain, ContactAt};
use frictiongen_kernel::number::complex::{self, Complex};

/// Returns the second complex number of an operation, made of the arguments: (c, −b/2).
fn second<T: Real>(b: T, c: T) -> Complex<T> {
    Complex::new(c, -b * T::constant(0.5))
}

fn pair<T: Real>(z: Complex<T>) -> [T; 2] {
    [z.re, z.im]
}

fn reciprocal(re: Big, im: Big) -> Option<Vec<Big>> {
    let square = re.clone() * re.clone() + im.clone() * im.clone();
    (!square.is_zero()).then(|| vec![re / square.clone(), -(im / square)])
}

fn hypotenuse(re: Big, im: Big) -> Big {
    let square = re.clone() * re + im.clone() * im;
    if square.is_zero() {
        square
    } else {
        square.sqrt()
    }
}

/// Computes complex operations without damping, which must neither read nor write the imaginary part.
fn undamped<T: Real>(a: T, b: T) -> [T; 4] {
    let z = Complex::new(a, T::constant(f64::NAN));
    let w = Complex::new(b, T::constant(f64::NAN));
    [
        complex::mul(z, w, false).re,
        complex::reciprocal(z, false).re,
        complex::modulus(z, false),
        complex::mul(z, w, false).im + complex::reciprocal(z, false).im,
    ]
}

/// Returns a chain in which only μ and m* are set, because the limits read nothing else.
fn chain<T: Real>(stiction: T, inverse_mass: T) -> Chain<T> {
    Chain {
        damped: true,
        on_moving_base: None,
        inverse_mass,
        stiction,
    }
}

/// Returns a contact with V = v + iv/4 and H = h − ih/2. Only the fields that the limits read are set.
fn contact<T: Real>(v: T, u: T, h: T) -> ContactAt<T> {
    let c = T::constant;
    ContactAt {
        scale: c(0.5),
        v: Complex::new(v, v * c(0.25)),
        u,
        g: c(0.0),
        reversal: u.abs(),
        h: Complex::new(h, -h * c(0.5)),
    }
}

formulas! {
    ComplexAdd Norm: |a, b, c| pair(complex::add(Complex::new(a, b), second(b, c))), {
        Some(vec![a + c, b.clone() - b.shifted(-1)])
    };
    ComplexScale Norm: |a, b, c| pair(complex::scale(Complex::new(a, b), c)), {
        Some(vec![a * c.clone(), b * c])
    };
    ComplexMul Norm: |a, b, c| pair(complex::mul(Complex::new(a, b), second(b, c), true)), {
        let d = -b.clone().shifted(-1);
        Some(vec![
            a.clone() * c.clone() - b.clone() * d.clone(),
            a * d + b * c,
        ])
    };
    ComplexReciprocal Norm: |a, b, c| pair(complex::reciprocal(Complex::new(a, b), true)),
        reciprocal(a, b);
    ReciprocalOfUnit Norm: |a, b, c| pair(complex::reciprocal_of_unit(Complex::new(a, b), None)),
        reciprocal(a, b);
    Modulus Place: |a, b, c| [complex::modulus(Complex::new(a, b), true)], Some(vec![hypotenuse(a, b)]);
    UndampedComplex Place: |a, b, c| undamped(a, b), {
        (!a.is_zero()).then(|| vec![a.clone() * b, Big::integer(1) / a.clone(), a.abs(), Big::integer(0)])
    };
    /// Break-away term r²E(m* + H_c r²) of the constraint, for m* = a and for μ = c.
    Constraints Place: |a, b, c| {
        let (chain, contact) = (chain(c, a), contact(a, b, c));
        [chain.start_constraint(&contact), chain.break_away(&contact)]
    }, {
        let inverse_mass = a.shifted(-1);
        Some(vec![b.abs() + inverse_mass.clone(), b.abs() + c * inverse_mass])
    };
    /// Limit β_lim from V, U and the constraint, where the constraint is c.
    ContinuousLimit Place: |a, b, c| [chain(c, a).continuous_limit(&contact(a, b, c), c)], {
        let square = b.clone() * b + c.clone() * c;
        let v = hypotenuse(a.clone(), a.shifted(-2));
        (!square.is_zero()).then(|| vec![v / square.sqrt()])
    };
    /// Limit β*_lim from V, H and μ = c.
    SlidingLimit Place: |a, b, c| [chain(c, a).sliding_limit(&contact(a, b, b))], {
        let (v, h) = (hypotenuse(a.clone(), a.shifted(-2)), hypotenuse(b.clone(), b.shifted(-1)));
        (!h.is_zero() && !c.is_zero()).then(|| vec![v / (c * h)])
    };
}

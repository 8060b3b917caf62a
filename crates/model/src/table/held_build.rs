//! Builds the responses while the contact is stuck from their zeros and poles, and compares them with the exact sums
//! over the modes.

use super::check::{GOLDEN, ROUNDINGS};
use super::errors::or_infinite;
use super::held::{Held, HeldForm};
use super::held_zeros::{HeldAt, Response, responses};
use super::product::Product;
use super::worst::Worst;
use super::zeros::{Rational, Zero};
use crate::modal::Modal;
use crate::rounded;
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::table::Root;
use frictiongen_kernel::{Complex, Float};

/// Number of frequency ratios, spread over the range, at which the check compares each response with its exact value.
/// Additional points are close to the zeros and poles of the response.
const POINTS: usize = 64;
/// Relative distances from a zero or a pole at which the code compares a response with its exact value.
const BESIDE: [f64; 7] = [0.0, 1e-15, -1e-13, 1e-10, -1e-7, 1e-4, -1e-2];
/// Largest relative difference up to which a pole counts as equal to a number of the table's type. The iteration
/// leaves an uncertainty in the last of a pole's 30 digits.
const SAME: f64 = 1e-26;
/// Number of candidates among which the code chooses a frequency ratio far from all zeros and poles. The gain follows
/// from the response at this frequency ratio.
const PLACES: usize = 33;

impl Zero {
    /// Returns the factor that this zero contributes to a function of s = ir.
    fn root<S: Float>(&self, to: &impl Fn(Dd) -> S) -> Root<S> {
        if self.y.is_zero() {
            return Root::Real { rate: to(-self.x) };
        }
        let at = to(self.y);
        Root::Pair {
            at,
            rest: to(self.y - Dd::from(at.to_f64())),
            off: to(self.x * self.x),
            rate: to(-Dd::from(2.0) * self.x),
        }
    }
}

impl<S: Float> Held<S> {
    /// Builds tables of the responses with the contact stuck, for a range of frequency ratios. Returns `None` if the
    /// zeros of a response cannot be separated from one another.
    #[must_use]
    pub fn of(modal: &Modal, range: (f64, f64)) -> Option<Self> {
        let (masses, force) = responses(modal)?;
        let mut build = Build::new::<S>(modal, range);
        let (low, high) = build.range;
        let masses: Option<Vec<HeldForm<S>>> = masses
            .iter()
            .enumerate()
            .map(|(mass, response)| build.form(response, |at| at.mass(modal, mass)))
            .collect();
        let (masses, force_form) = (masses?, build.form(&force, |at| at.force)?);
        let Build { worst, points, .. } = build;
        let mut resonances: Vec<S> = modal.unbounded(true).into_iter().map(rounded).collect();
        let poles = match &force {
            Response::Fixed(_) => &[],
            Response::Rational(force) => force.poles.as_slice(),
        };
        for pole in poles.iter().filter(|pole| pole.is_on_axis()) {
            let own: S = rounded(pole.y);
            if (Dd::from(own.to_f64()) - pole.y).abs() <= pole.y * Dd::from(SAME) {
                resonances.push(own);
            }
        }
        resonances.retain(|own| low <= own.to_f64() && own.to_f64() <= high);
        Some(Self {
            masses,
            force: force_form,
            resonances,
            worst,
            points,
        })
    }

    /// Compares these responses with the exact values, as [`of`](Self::of) does, and returns the largest error. If
    /// the responses have changed since `of` built them, the result differs from [`worst`](Self::worst). Returns
    /// `None` if the zeros cannot be separated.
    #[must_use]
    pub fn verify(&self, modal: &Modal, range: (f64, f64)) -> Option<Worst> {
        let (masses, force) = responses(modal)?;
        let mut build = Build::new::<S>(modal, range);
        let named = masses.iter().zip(&self.masses).enumerate();
        for (mass, (response, form)) in named {
            build.compare(response, form, |at| at.mass(modal, mass));
        }
        build.compare(&force, &self.force, |at| at.force);
        Some(build.worst)
    }
}

/// A frequency ratio r for comparisons, with the exact responses at r.
struct ComparedPoint {
    r: f64,
    at: HeldAt,
    /// Exact responses at a frequency ratio that is `ROUNDINGS` rounding units larger than r. Their difference from
    /// the responses at r shows the uncertainty of the responses at r.
    moved: HeldAt,
}

impl ComparedPoint {
    fn new(modal: &Modal, r: f64) -> Self {
        Self {
            r,
            at: HeldAt::new(modal, r),
            moved: HeldAt::new(modal, r * (1.0 + ROUNDINGS * f64::EPSILON)),
        }
    }
}

/// The chain and the points of comparison from which responses are built and checked, and the largest error so far.
struct Build<'a> {
    modal: &'a Modal,
    damped: bool,
    range: (f64, f64),
    spread: Vec<ComparedPoint>,
    worst: Worst,
    points: usize,
}

impl<'a> Build<'a> {
    fn new<S: Float>(modal: &'a Modal, (low, high): (f64, f64)) -> Self {
        // The bounds are rounded to the number type, as in the emitted code.
        let (low, high) = (S::constant(low).to_f64(), S::constant(high).to_f64());
        let spread = (0..POINTS).map(|k| {
            let share = (GOLDEN * (k + 1) as f64).fract();
            S::constant(low + share * (high - low)).to_f64()
        });
        let spread = spread.chain([low, high]);
        Self {
            modal,
            damped: modal.is_damped(),
            range: (low, high),
            spread: spread.map(|r| ComparedPoint::new(modal, r)).collect(),
            worst: Worst {
                error: 0.0,
                at: low,
            },
            points: 0,
        }
    }

    fn form<S: Float>(
        &mut self,
        response: &Response,
        exact: impl Fn(&HeldAt) -> Complex<Dd>,
    ) -> Option<HeldForm<S>> {
        let rational = match response {
            Response::Fixed(amplitude) => return Some(HeldForm::Fixed(S::constant(*amplitude))),
            Response::Rational(rational) => rational,
        };
        let place = self.place(rational)?;
        let unit = self.with_gain(rational, Dd::ONE, &|value| value);
        let at = Dd::from(place);
        let inverse = complex::reciprocal(unit.response().value(at), self.damped);
        let gain = complex::mul(exact(&HeldAt::new(self.modal, place)), inverse, true).re;
        let form = self.with_gain(rational, gain, &rounded::<S>);
        self.compare(response, &form, exact);
        Some(form)
    }

    /// Returns the r in the range that is farthest from all zeros and poles of a response.
    fn place(&self, rational: &Rational) -> Option<f64> {
        let (low, high) = self.range;
        let away = |r: f64| {
            let off = |zero: &Zero| zero.x.to_f64().hypot(r - zero.y.to_f64()) / r;
            let zeros = rational.zeros.iter().chain(&rational.poles);
            zeros.map(off).fold(f64::INFINITY, f64::min)
        };
        let places = (0..PLACES).map(|k| low + (high - low) * (k as f64 + 0.5) / PLACES as f64);
        places.max_by(|a, b| away(*a).total_cmp(&away(*b)))
    }

    fn with_gain<T: Float>(
        &self,
        rational: &Rational,
        gain: Dd,
        to: &impl Fn(Dd) -> T,
    ) -> HeldForm<T> {
        let Rational { zeros, poles } = rational;
        let gain = to(gain);
        if self.damped {
            let roots = |zeros: &[Zero]| zeros.iter().map(|zero| zero.root(to)).collect();
            return HeldForm::Damped {
                gain,
                numerator: roots(zeros),
                denominator: roots(poles),
            };
        }
        let factors = |zeros: &[Zero]| zeros.iter().map(|zero| zero.factor(false, to)).collect();
        HeldForm::Undamped(Product {
            gain,
            squared: false,
            numerator: factors(zeros),
            denominator: factors(poles),
        })
    }

    /// Compares a response with its exact values over the range of r, and close to its zeros and poles. Updates the
    /// largest error.
    fn compare<S: Float>(
        &mut self,
        response: &Response,
        form: &HeldForm<S>,
        exact: impl Fn(&HeldAt) -> Complex<Dd>,
    ) {
        // A response that does not depend on r is exact.
        let Response::Rational(rational) = response else {
            return;
        };
        let (low, high) = self.range;
        let places = rational.zeros.iter().chain(&rational.poles);
        let places = places
            .map(|zero| zero.y.to_f64())
            .flat_map(|place| BESIDE.map(|beside| S::constant(place * (1.0 + beside)).to_f64()));
        let within = places.filter(|r| low <= *r && *r <= high);
        let close: Vec<ComparedPoint> = within.map(|r| ComparedPoint::new(self.modal, r)).collect();
        for ComparedPoint { r, at, moved } in self.spread.iter().chain(&close) {
            let expected = exact(at);
            let size = complex::modulus(expected, true).to_f64();
            // At a zero or a pole the exact value is 0 or infinite, so no comparison is possible.
            if !(at.known && 0.0 < size && size.is_finite()) {
                continue;
            }
            let answer = form.response().value(S::constant(*r));
            let apart = |other: Complex<Dd>| {
                let (re, im) = (other.re - expected.re, other.im - expected.im);
                complex::modulus(Complex::new(re, im), true).to_f64()
            };
            let own = Complex::new(answer.re, answer.im);
            let off = apart(Complex::new(
                Dd::from(own.re.to_f64()),
                Dd::from(own.im.to_f64()),
            ));
            // Near a zero or a pole the response is steep, so a few roundings of r change the exact value noticeably.
            let noise = apart(exact(moved));
            let noise = if noise.is_finite() { noise } else { 0.0 };
            let error = or_infinite((off - noise).max(0.0) / size);
            self.points += 1;
            if error > self.worst.error {
                self.worst = Worst { error, at: *r };
            }
        }
    }
}

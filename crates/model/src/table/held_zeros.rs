//! Exact values of the responses while the contact is stuck, and their zeros and poles in double-double.

use super::proportional::Proportional;
use super::zeros::{EQUAL, NONE, Rational, Zero, Zeros, classified, guesses, poles};
use crate::modal::Modal;
use crate::roots::{DrivenMode, iterate, to};
use frictiongen_kernel::number::complex;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Complex, Float};

/// Bound on |s² + 2ζσs + σ²|/σ² of a mode. Below this bound, s is so close to the resonance σ that the sums over the
/// modes lose half of their 30 digits.
const ON_RESONANCE: f64 = 1e-12;

/// Largest number of corrections of a zero in double precision, and the relative correction at which these corrections
/// end. The corrections in double-double follow (`LAST_STEPS`).
const FIRST_STEPS: (usize, f64) = (100, 1e-11);
/// Largest number of corrections of a zero in double-double, and the relative correction at which the iteration ends.
/// Each correction is about the cube of the previous correction, so after a correction of 10⁻²³ only rounding errors
/// remain.
const LAST_STEPS: (usize, f64) = (60, 1e-23);

/// Response of a mass, or the contact force, while the contact is stuck.
#[derive(Clone, Debug)]
pub(super) enum Response {
    /// Response that does not depend on r.
    Fixed(f64),
    Rational(Rational),
}

/// Returns s² + 2ζσs + σ², the denominator of one mode's term in a receptance at s.
fn denominator(modal: &Modal, mode: usize, s: Complex<Dd>) -> Option<Complex<Dd>> {
    let sigma = *modal.resonances.get(mode)?;
    let rate = Dd::from(2.0) * *modal.damping_ratios.get(mode)? * sigma;
    let shifted = Complex::new(s.re + rate, s.im);
    Some(complex::add(
        complex::mul(s, shifted, true),
        complex::real(sigma * sigma),
    ))
}

/// The contact force and the modal amplitudes at one frequency ratio while the contact is stuck, in double-double.
pub(super) struct HeldAt {
    /// V/H, the force that keeps the contact stuck. V and H are the responses of the contact to the load and to a
    /// contact force.
    pub force: Complex<Dd>,
    /// False at an undamped resonance of the sliding chain. A modal amplitude is then a quotient of rounding errors,
    /// although the responses are finite.
    pub known: bool,
    /// Complex amplitude of each mode of the sliding chain.
    modes: Vec<Complex<Dd>>,
}

impl HeldAt {
    pub fn new(modal: &Modal, r: f64) -> Self {
        let r = Dd::from(r);
        let two = Dd::from(2.0);
        let (mut v, mut h) = (complex::real(-carried(modal)), complex::real(Dd::ZERO));
        let mut inverses = Vec::with_capacity(modal.resonances.len());
        let mut known = true;
        let drives = || modal.loads.iter().zip(&modal.contacts);
        let modes = modal.resonances.iter().zip(&modal.damping_ratios);
        for ((sigma, zeta), (load, contact)) in modes.zip(drives()) {
            // (σ − r)(σ + r) keeps all digits of σ² − r² near the resonance σ, where the difference of the squares
            // would cancel.
            let re = (*sigma - r) * (*sigma + r);
            let im = two * *zeta * *sigma * r;
            let size = re.abs() + im.abs();
            known &= contact.is_zero() || size > *sigma * *sigma * Dd::from(ON_RESONANCE);
            let inverse = complex::reciprocal(Complex::new(re, im), true);
            v = complex::add(v, complex::scale(inverse, *load * *contact));
            h = complex::add(h, complex::scale(inverse, *contact * *contact));
            inverses.push(inverse);
        }
        let force = complex::mul(v, complex::reciprocal(h, true), true);
        let moved = inverses.iter().zip(drives());
        let modes = moved.map(|(inverse, (load, contact))| {
            let driven = Complex::new(*load - *contact * force.re, -(*contact * force.im));
            complex::mul(*inverse, driven, true)
        });
        Self {
            force,
            known,
            modes: modes.collect(),
        }
    }

    /// Returns x̄*_k = V_k − H_kV/H, the complex amplitude of mass k while the contact is stuck (section 4 of
    /// `docs/derivation.md`). V/H is the force that keeps the contact stuck. V_k and V are the responses of mass k and
    /// of the contact to the load. H_k and H are their responses to a contact force.
    pub fn mass(&self, modal: &Modal, mass: usize) -> Complex<Dd> {
        let mut sum = complex::real(Dd::ZERO);
        for (shape, moved) in modal.shapes.iter().zip(&self.modes) {
            if let Some(component) = shape.get(mass) {
                sum = complex::add(sum, complex::scale(*moved, *component));
            }
        }
        sum
    }
}

/// Returns s, the coefficient of the base motion in z̄ = wᵀx̄ − s cos τ_e. s is 1 if the contact slides on the moving
/// base, and otherwise 0.
fn carried(modal: &Modal) -> Dd {
    Dd::from(if modal.on_moving_base { 1.0 } else { 0.0 })
}

/// A pole of the responses while the contact is stuck, with its residue for each mass. For a conjugate pair, only the
/// pole with y > 0 is stored.
struct Pole {
    zero: Zero,
    residues: Vec<Complex<Dd>>,
}

/// A sum of terms. If the sum is not larger than the rounding of its terms, its value is exactly 0.
struct CancellingSum {
    value: Complex<Dd>,
    size: Dd,
}

impl CancellingSum {
    fn new() -> Self {
        Self {
            value: complex::real(Dd::ZERO),
            size: Dd::ZERO,
        }
    }

    fn add(&mut self, term: Complex<Dd>) {
        self.value = complex::add(self.value, term);
        self.size = self.size + term.re.abs() + term.im.abs();
    }

    fn cleaned(self) -> Complex<Dd> {
        let size = self.value.re.abs() + self.value.im.abs();
        if size <= self.size * Dd::from(NONE) {
            complex::real(Dd::ZERO)
        } else {
            self.value
        }
    }
}

/// Returns a pole of the stuck chain, with its residue for each mass k. The pole is a zero of H, the response of the
/// contact to a contact force. The residue belongs to −H_kV/H, the response to the force in the stuck contact.
fn held_pole(modal: &Modal, zero: Zero) -> Option<Pole> {
    let s = Complex::new(zero.x, zero.y);
    let two = Dd::from(2.0);
    let mut v = CancellingSum::new();
    v.add(complex::real(-carried(modal)));
    let mut slope = complex::real(Dd::ZERO);
    let mut of_masses: Vec<CancellingSum> = (0..modal.resonances.len())
        .map(|_| CancellingSum::new())
        .collect();
    let modes = modal.resonances.iter().zip(&modal.damping_ratios);
    let drives = modal.loads.iter().zip(&modal.contacts).zip(&modal.shapes);
    for (mode, ((sigma, zeta), ((load, contact), shape))) in modes.zip(drives).enumerate() {
        if contact.is_zero() {
            continue;
        }
        let inverse = complex::reciprocal(denominator(modal, mode, s)?, true);
        v.add(complex::scale(inverse, *load * *contact));
        let steep = Complex::new(two * (s.re + *zeta * *sigma), two * s.im);
        let square = complex::mul(inverse, inverse, true);
        let bent = complex::mul(steep, square, true);
        slope = complex::add(slope, complex::scale(bent, -(*contact * *contact)));
        for (sum, component) in of_masses.iter_mut().zip(shape) {
            sum.add(complex::scale(inverse, *component * *contact));
        }
    }
    let drive = complex::mul(v.cleaned(), complex::reciprocal(slope, true), true);
    let residues = of_masses.into_iter().map(|sum| {
        let residue = complex::mul(sum.cleaned(), drive, true);
        complex::scale(residue, -Dd::ONE)
    });
    Some(Pole {
        zero,
        residues: residues.collect(),
    })
}

/// Returns the poles of all modes in which the contact does not move. A combination of equal modes also counts as such
/// a mode.
fn untouched_poles(modal: &Modal) -> Vec<Pole> {
    let equal = |a: usize, b: usize| {
        let near = |values: &[Dd]| match (values.get(a), values.get(b)) {
            (Some(a), Some(b)) => (*a - *b).abs() <= *a * Dd::from(EQUAL),
            _ => false,
        };
        near(&modal.resonances) && near(&modal.damping_ratios)
    };
    let mut all = Vec::new();
    let mut first = 0;
    while first < modal.resonances.len() {
        let mut end = first + 1;
        while end < modal.resonances.len() && equal(first, end) {
            end += 1;
        }
        all.extend(untouched(modal, first..end));
        first = end;
    }
    all
}

/// Returns the poles of a group of equal modes, for those combinations of the modes in which the contact does not move.
fn untouched(modal: &Modal, modes: std::ops::Range<usize>) -> Vec<Pole> {
    let zero = Dd::ZERO;
    let of = |values: &[Dd], mode: usize| values.get(mode).copied().unwrap_or(zero);
    let dot = |a: &dyn Fn(usize) -> Dd, b: &dyn Fn(usize) -> Dd| {
        modes
            .clone()
            .fold(zero, |sum, mode| sum + a(mode) * b(mode))
    };
    let load = |mode: usize| of(&modal.loads, mode);
    let contact = |mode: usize| of(&modal.contacts, mode);
    let touching = dot(&contact, &contact);
    if modes.len() == 1 && !touching.is_zero() {
        return Vec::new();
    }
    let masses = 0..modal.resonances.len();
    let strengths = masses.map(|mass| {
        let shape = |mode: usize| {
            let component = modal.shapes.get(mode).and_then(|shape| shape.get(mass));
            component.copied().unwrap_or(zero)
        };
        let mut sum = CancellingSum::new();
        sum.add(complex::real(dot(&shape, &load)));
        if !touching.is_zero() {
            let held = dot(&shape, &contact) * dot(&load, &contact) / touching;
            sum.add(complex::real(-held));
        }
        sum.cleaned().re
    });
    let strengths: Vec<Dd> = strengths.collect();
    let mode = DrivenMode {
        sigma: of(&modal.resonances, modes.start),
        zeta: of(&modal.damping_ratios, modes.start),
        inverse_mass: Dd::ONE,
        along: Dd::ZERO,
    };
    let two = Dd::from(2.0);
    let at = |zero: Zero| {
        let steep = Complex::new(two * (zero.x + mode.zeta * mode.sigma), two * zero.y);
        let inverse = complex::reciprocal(steep, true);
        let residues = strengths.iter().map(|own| complex::scale(inverse, *own));
        Pole {
            zero,
            residues: residues.collect(),
        }
    };
    poles(&mode).into_iter().map(at).collect()
}

/// Returns the responses of all masses, and then the contact force, while the contact is stuck. Returns `None` if the
/// zeros cannot be separated.
pub(super) fn responses(modal: &Modal) -> Option<(Vec<Response>, Response)> {
    let known = if modal.is_damped() && !modal.on_moving_base {
        Proportional::of(modal)
    } else {
        None
    };
    let Some(proportional) = known else {
        return found(modal);
    };
    let undamped = Modal {
        damping_ratios: vec![Dd::ZERO; modal.damping_ratios.len()],
        ..modal.clone()
    };
    // The undamped chain may have a double zero at s = 0 that cannot be separated, although the zeros of the damped
    // chain can.
    let Some((masses, force)) = found(&undamped) else {
        return found(modal);
    };
    let moved = |response: Response, over| match response {
        Response::Rational(own) => {
            let own = proportional.of_undamped(&own, over)?;
            Some(Response::Rational(own))
        }
        fixed @ Response::Fixed(_) => Some(fixed),
    };
    let masses: Option<Vec<Response>> = masses.into_iter().map(|own| moved(own, 1)).collect();
    // The contact force is a quotient of two receptances, so the factors 1 + bs of proportional damping cancel.
    Some((masses?, moved(force, 0)?))
}

/// Returns the results of `responses`, computed from the poles of the chain with its contact stuck.
fn found(modal: &Modal) -> Option<(Vec<Response>, Response)> {
    let zeros = Zeros::of(modal)?;
    let held = zeros.receptance.iter();
    let held: Option<Vec<Pole>> = held.map(|zero| held_pole(modal, *zero)).collect();
    let mut poles = held?;
    poles.extend(untouched_poles(modal));
    let masses = 0..modal.resonances.len();
    let masses: Option<Vec<Response>> = masses
        .map(|mass| {
            if modal.rubbing() == Some(mass) {
                return Some(Response::Fixed(carried(modal).to_f64()));
            }
            of_mass(&poles, mass, zeros.damped)
        })
        .collect();
    let above = zeros.excitation.iter().chain(&zeros.unloaded);
    let force = Rational {
        zeros: above.copied().collect(),
        poles: zeros.receptance,
    };
    Some((masses?, Response::Rational(force)))
}

/// Returns the response of a mass while the contact is stuck, by its zeros and poles. Its poles are those of `poles`
/// whose residue for the mass is not zero.
fn of_mass(poles: &[Pole], mass: usize, damped: bool) -> Option<Response> {
    let own = poles.iter().filter_map(|pole| {
        let residue = *pole.residues.get(mass)?;
        let none = residue.re.is_zero() && residue.im.is_zero();
        (!none).then_some((pole.zero, residue))
    });
    let own: Vec<(Zero, Complex<Dd>)> = own.collect();
    if own.is_empty() {
        return Some(Response::Fixed(0.0));
    }
    // The list `simple` has both poles of each conjugate pair.
    let mut simple: Vec<[Complex<Dd>; 2]> = Vec::new();
    for (zero, residue) in &own {
        let place = Complex::new(zero.x, zero.y);
        if zero.y.is_zero() {
            simple.push([place, complex::real(residue.re)]);
        } else {
            simple.push([place, *residue]);
            let other = |of: Complex<Dd>| Complex::new(of.re, -of.im);
            simple.push([other(place), other(*residue)]);
        }
    }
    let degree = degree(&simple)?;
    let sizes = || {
        let places = simple.iter();
        places.map(|[place, _]| complex::modulus(*place, true).to_f64())
    };
    let mut roots = guesses(sizes(), degree);
    correct::<f64>(&simple, &mut roots, FIRST_STEPS);
    correct::<Dd>(&simple, &mut roots, LAST_STEPS);
    // A mass that only dampers drive does not move at r = 0, so its response has a zero at s = 0.
    let least = sizes().fold(f64::INFINITY, f64::min);
    let rests =
        |root: &Complex<Dd>| complex::modulus(*root, true) <= Dd::from(least) * Dd::from(NONE);
    let resting = damped && roots.iter().filter(|root| rests(root)).count() == 1;
    if resting {
        roots.sort_by_key(|root| !rests(root));
    }
    Some(Response::Rational(Rational {
        zeros: classified(roots, usize::from(resting), damped)?,
        poles: own.into_iter().map(|(zero, _)| zero).collect(),
    }))
}

/// Returns the number of zeros of Σ R/(s − z), where z are poles and R their residues. The number follows from the
/// expansion of the sum in powers of 1/s. It depends on the first power whose coefficient is larger than its rounding
/// error.
fn degree(simple: &[[Complex<Dd>; 2]]) -> Option<usize> {
    let mut powers: Vec<Complex<Dd>> = simple.iter().map(|[_, residue]| *residue).collect();
    for lost in 1..=simple.len() {
        let mut sum = CancellingSum::new();
        for (power, [place, _]) in powers.iter_mut().zip(simple) {
            sum.add(*power);
            *power = complex::mul(*power, *place, true);
        }
        let left = sum.cleaned();
        if !(left.re.is_zero() && left.im.is_zero()) {
            return Some(simple.len() - lost);
        }
    }
    None
}

/// Improves the estimates `roots` of the zeros of Σ R/(s − z), in the arithmetic of `S`. `simple` has the pairs (z,
/// R). `most` has the largest number of steps, and the relative step at which the iteration ends.
fn correct<S: Float>(simple: &[[Complex<Dd>; 2]], roots: &mut [Complex<Dd>], most: (usize, f64)) {
    let wide = |value: &Complex<Dd>| Complex::new(to::<S>(value.re), to::<S>(value.im));
    let simple = simple.iter();
    let simple: Vec<[Complex<S>; 2]> = simple
        .map(|[place, residue]| [wide(place), wide(residue)])
        .collect();
    let minus = S::constant(-1.0);
    iterate(roots, 0, most, |s: Complex<S>| {
        let zero = complex::real(S::constant(0.0));
        let (mut value, mut slope, mut others) = (zero, zero, zero);
        for [place, residue] in &simple {
            let distance = complex::add(s, complex::scale(*place, minus));
            let inverse = complex::reciprocal(distance, true);
            let term = complex::mul(*residue, inverse, true);
            value = complex::add(value, term);
            slope = complex::add(slope, complex::mul(term, inverse, true));
            others = complex::add(others, inverse);
        }
        let own = complex::mul(slope, complex::reciprocal(value, true), true);
        complex::add(others, complex::scale(own, minus))
    });
}

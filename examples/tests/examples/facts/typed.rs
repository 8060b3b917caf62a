//! Computes a second time those rows whose numbers this library computed first. The closed forms are typed in as
//! printed (V, U, G, then the lag φ, then x(τ)), and their largest value is found by brute force. Only the regime is
//! taken from the library. It decides which pairs of β count.

use super::close;
use frictiongen_examples::facts::ask::{base, chain, limit, peak, root};
use std::f64::consts::PI;

/// A mode of a scene: √λ, ζ, and four residues divided by λ. They lead from load to mass, from load to contact, from
/// contact to mass, and from contact to contact.
struct Mode {
    root: f64,
    zeta: f64,
    load_mass: f64,
    load_contact: f64,
    contact_mass: f64,
    contact: f64,
}

/// A scene, given by its modes and the coefficient of the base in the contact's motion.
struct Typed {
    modes: Vec<Mode>,
    of_base: f64,
}

#[derive(Clone, Copy)]
struct Complex(f64, f64);

impl Complex {
    fn plus(self, by: f64, other: Self) -> Self {
        Self(self.0 + by * other.0, self.1 + by * other.1)
    }
    fn size(self) -> f64 {
        self.0.hypot(self.1)
    }
    fn angle(self) -> f64 {
        self.1.atan2(self.0)
    }
}

impl Mode {
    /// Returns the response 1/(1 − R² + 2iζR) of the mode to a harmonic force, with R = r/√λ.
    fn v(&self, r: f64) -> Complex {
        let ratio = r / self.root;
        let (re, im) = (1.0 - ratio * ratio, 2.0 * self.zeta * ratio);
        let square = re * re + im * im;
        Complex(re / square, -im / square)
    }

    /// Returns the functions u and g of the mode by (7.11) and (7.12), at the frequency ratio r.
    fn functions(&self, r: f64) -> (f64, f64) {
        let (ratio, zeta) = (r / self.root, self.zeta);
        let q = (1.0 - zeta * zeta).sqrt();
        let e = (-PI * zeta / ratio).exp();
        let (sin, cos) = (PI * q / ratio).sin_cos();
        let below = 1.0 + e * e + 2.0 * e * cos;
        (
            2.0 * e * sin / (ratio * q * below),
            (1.0 - e * e - 2.0 * e * zeta / q * sin) / below,
        )
    }

    /// Returns the response 1 − (1 + g)d − uRq̃ of the mode to the friction force, at the phase τ.
    fn h(&self, r: f64, tau: f64) -> f64 {
        let (ratio, zeta) = (r / self.root, self.zeta);
        let q = (1.0 - zeta * zeta).sqrt();
        let (u, g) = self.functions(r);
        let decay = (-zeta * tau / ratio).exp();
        let (sin, cos) = (q * tau / ratio).sin_cos();
        1.0 - (1.0 + g) * decay * (cos + zeta / q * sin) - u * ratio * decay * sin / q
    }
}

impl Typed {
    /// Finds the largest |x̄| of the mass over half a period. It compares 400 instants and searches next to the best
    /// instant.
    fn amplitude(&self, r: f64, beta: f64) -> f64 {
        let mut mass = Complex(0.0, 0.0);
        let mut contact = Complex(-self.of_base, 0.0);
        let (mut quadrature, mut shift) = (0.0, 0.0);
        for mode in &self.modes {
            let v = mode.v(r);
            mass = mass.plus(mode.load_mass, v);
            contact = contact.plus(mode.load_contact, v);
            let (u, g) = mode.functions(r);
            quadrature += mode.contact * u;
            shift += mode.contact * g;
        }
        assert!(shift.is_finite());
        let root = (contact.size().powi(2) - (beta * quadrature).powi(2)).sqrt();
        let phase = (-beta * quadrature).atan2(root) - contact.angle();
        let size = |tau: f64| {
            let forced = mass.size() * (tau + phase + mass.angle()).cos();
            let friction = self
                .modes
                .iter()
                .map(|mode| mode.contact_mass * mode.h(r, tau));
            (forced + beta * friction.sum::<f64>()).abs()
        };
        let step = PI / 400.0;
        let places = (0..=400).map(|i| step * f64::from(i));
        let best = places.fold(
            0.0,
            |best, tau| if size(best) < size(tau) { tau } else { best },
        );
        size(peak(size, (best - step).max(0.0), (best + step).min(PI)))
    }

    fn crossing(&self, one: f64, other: f64, low: f64, high: f64) -> f64 {
        root(
            |r| self.amplitude(r, one) - self.amplitude(r, other),
            low,
            high,
        )
    }
}

/// Returns a scene with one mass, in which every residue is 1.
fn single(zeta: f64, of_base: f64) -> Typed {
    let (root, load_mass, load_contact, contact_mass, contact) = (1.0, 1.0, 1.0, 1.0, 1.0);
    let mode = Mode {
        root,
        zeta,
        load_mass,
        load_contact,
        contact_mass,
        contact,
    };
    Typed {
        modes: vec![mode],
        of_base,
    }
}

/// Returns the scene with contact between two masses, γ = κ = 1/2, force on m₁. The modes are λ = 1/2 with φ = (1,
/// 2)/√3 and λ = 2 with (1, −1)/√1.5. So φᵀw = φ₂ − φ₁ is 1/√3 and −2/√1.5.
fn between() -> Typed {
    let mode = |lambda: f64, first: f64, across: f64, square: f64| Mode {
        root: lambda.sqrt(),
        zeta: 0.0,
        load_mass: first * first / square / lambda,
        load_contact: first * across / square / lambda,
        contact_mass: first * across / square / lambda,
        contact: across * across / square / lambda,
    };
    Typed {
        modes: vec![mode(0.5, 1.0, 1.0, 3.0), mode(2.0, 1.0, -2.0, 1.5)],
        of_base: 0.0,
    }
}

#[test]
fn f08_once_more() {
    let (typed, system) = (single(0.0, 1.0), base(1.0));
    let betas = [0.05, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4];
    let (mut first, mut last, mut highest) = (f64::INFINITY, 0.0_f64, 0.0_f64);
    let mut pairs = 0;
    for (i, more) in betas.iter().enumerate() {
        for less in &betas[..i] {
            let begin = if limit(&system, 1.35) > *more {
                1.35
            } else {
                root(|r| limit(&system, r) - more, 1.35, 2.0) + 1e-9
            };
            let crossing = typed.crossing(*more, *less, begin, 1.7);
            (first, last) = (first.min(crossing), last.max(crossing));
            highest = highest.max(typed.amplitude(crossing, *less));
            pairs += 1;
        }
    }
    println!("{pairs} pairs, none skipped: {first} to {last}, up to {highest}");
    assert_eq!(pairs, 28);
    close(first, 1.4316, 5e-5);
    close(last, 1.5423, 5e-5);
    close(highest, 0.9529, 5e-5);
}

#[test]
fn f28_once_more() {
    let typed = between();
    let system = chain(&[1.0, 0.5], &[1.0, 0.5], "m1 - m2", "m1", "");
    let betas = [0.0, 0.1, 0.2, 0.3, 0.4, 0.6];
    for (low, high, from, to, used) in [
        (0.74, 0.8, 0.7695, 0.7768, 15),
        (1.2, 1.24, 1.2168, 1.2272, 10),
    ] {
        let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
        let (mut pairs, mut skipped) = (0, 0);
        for (i, one) in betas.iter().enumerate() {
            for other in &betas[..i] {
                // Continuous motion does not exist where the larger β exceeds its limit.
                if limit(&system, low).min(limit(&system, high)) <= *one {
                    skipped += 1;
                    continue;
                }
                let crossing = typed.crossing(*one, *other, low, high);
                (least, most) = (least.min(crossing), most.max(crossing));
                pairs += 1;
            }
        }
        println!("{pairs} pairs, {skipped} skipped as not sliding: {least} to {most}");
        assert_eq!((pairs, pairs + skipped), (used, 15));
        close(least, from, 5e-5);
        close(most, to, 5e-5);
    }
}

#[test]
fn f29_once_more() {
    for (zeta, highest, at_one) in [(0.01, 30.9043, 30.9012), (0.1, 3.1196, 3.0879)] {
        let typed = single(zeta, 0.0);
        let place = peak(|r| typed.amplitude(r, 0.3), 0.9, 1.05);
        close(typed.amplitude(place, 0.3), highest, 5e-5);
        close(typed.amplitude(1.0, 0.3), at_one, 5e-5);
        // The threshold is β_lim at r = 1 with μ = 1. It contains the maximum S over τ, which is found here in steps of
        // π/10⁵.
        let mode = &typed.modes[0];
        let (u, g) = mode.functions(1.0);
        let q = (1.0 - zeta * zeta).sqrt();
        let constraint = (1..100_000).map(|i| {
            let tau = PI * f64::from(i) / 1e5;
            let decay = (-zeta * tau).exp();
            let (sin, cos) = (q * tau).sin_cos();
            let forced_slope = tau.cos() - decay * (cos - zeta / q * sin);
            ((1.0 + g) * decay * sin / q + u * forced_slope) / tau.sin()
        });
        let break_away = 1.0 + g + 2.0 * zeta * u;
        let largest = constraint.fold(break_away, f64::max);
        let threshold = mode.v(1.0).size() / u.hypot(largest);
        close(threshold, if zeta < 0.05 { 0.7732 } else { 0.6720 }, 5e-5);
    }
}

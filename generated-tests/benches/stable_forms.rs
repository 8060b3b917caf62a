//! Compares the kernel's stable form of a quantity with the printed form: its cost, and the error of the printed form
//! where that form loses accuracy.
//!
//! Run with `cargo bench -p generated-tests --bench stable_forms`. With `UPDATE_ACCURACY=1` the program writes the
//! figures to `docs/data/stable-forms.csv`.

use frictiongen_kernel::number::complex::{self, Complex};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::special::{exp_m1_minus, versine_pi};
use frictiongen_kernel::oscillator::decay::{Basis, Damped, Decay, Instant, Undamped};
use frictiongen_kernel::oscillator::mode::{Kind, Mode};
use frictiongen_kernel::{Float, Scalar};
use std::f64::consts::PI;
use std::fmt::Write;
use std::hint::black_box;
use std::time;

/// One quantity in three forms: the kernel's form in `f64`, the kernel's form in double-double, and the printed form.
struct Form {
    name: &'static str,
    stable: fn([f64; 3]) -> f64,
    exact: fn([Dd; 3]) -> Dd,
    printed: fn([f64; 3]) -> f64,
    /// Returns arguments for the timing, from a number between 0 and 1.
    usual: fn(f64) -> [f64; 3],
    breaks: [f64; 3],
    place: &'static str,
}

fn mode<T: Float>(zeta: T) -> Mode<T> {
    let one = T::constant(1.0);
    let q = ((one - zeta) * (one + zeta)).abs().sqrt();
    let kind = match zeta.to_f64() {
        0.0 => Kind::Undamped,
        z if z < 0.5 => Kind::Light,
        z if z < 1.0 => Kind::Heavy,
        1.0 => Kind::Critical,
        _ => Kind::Over,
    };
    Mode {
        kind,
        in_contact: true,
        resonance: one,
        zeta,
        q,
        q_defect: zeta * zeta / (one + q),
        load: one,
        contact: one,
        residue: one,
        contact_squared: one,
        static_residue: one,
    }
}

/// Returns β_lim of one undamped mass on a wall at r ≤ 2, from v and u with their common pole removed.
fn limit<T: Float>(r: T) -> T {
    let one = T::constant(1.0);
    let at = mode(T::constant(0.0)).response(one / r, 0);
    let v = at.size / at.denominator.re;
    v.abs() / (at.u * at.u + at.size * at.size).sqrt()
}

fn printed_limit(r: f64) -> f64 {
    let (v, u) = (1.0 / (1.0 - r * r), (PI / (2.0 * r)).tan() / r);
    v.abs() / (u * u + r.powi(-4)).sqrt()
}

/// Returns u + g of a damped mode at x = 1/R, with u and g of (7.11) and (7.12).
fn damping<T: Float>([x, zeta, _]: [T; 3]) -> T {
    let at = mode(zeta).response(x, 0);
    (at.u * x * x + at.g) / at.size
}

fn printed_damping([x, zeta, _]: [f64; 3]) -> f64 {
    if zeta > 1.0 {
        return printed_overdamping(x, zeta);
    }
    let q = (1.0 - zeta * zeta).sqrt();
    let (a, b) = (PI * zeta * x, PI * q * x);
    let d = a.cosh() + b.cos();
    let (u, g) = (x * b.sin() / q / d, (a.sinh() - zeta / q * b.sin()) / d);
    u + g
}

fn printed_overdamping(x: f64, zeta: f64) -> f64 {
    let q = (zeta * zeta - 1.0).sqrt();
    let (a, b) = (PI * zeta * x, PI * q * x);
    let d = a.cosh() + b.cosh();
    x * b.sinh() / q / d + (a.sinh() - zeta / q * b.sinh()) / d
}

/// Returns g of a damped mode at x = 1/R (7.12).
fn g<T: Float>([x, zeta, _]: [T; 3]) -> T {
    let at = mode(zeta).response(x, 0);
    at.g / at.size
}

fn printed_g([x, zeta, _]: [f64; 3]) -> f64 {
    let q = (1.0 - zeta * zeta).sqrt();
    let (a, b) = (PI * zeta * x, PI * q * x);
    (a.sinh() - zeta / q * b.sin()) / (a.cosh() + b.cos())
}

/// Returns |V|² − (βU)². Its root is one term of the contact's amplitude (5.36, 7.19).
fn remainder<T: Float>([v, beta, u]: [T; 3]) -> T {
    (v - beta * u) * (v + beta * u)
}

fn undamped_basis<T: Float>([x, t, _]: [T; 3]) -> Basis<T> {
    Undamped.basis(x, &Instant::new(t))
}

fn basis<T: Float>([x, zeta, t]: [T; 3]) -> Basis<T> {
    Damped::of(&mode(zeta)).basis(x, &Instant::new(t))
}

/// Returns the sum (1 − d)/x² + p + (cos τ − p′) of a mode's functions at one instant.
fn total<T: Float>(basis: Basis<T>) -> T {
    basis.rise + basis.free + basis.forced_slope
}

fn printed_total([x, zeta, t]: [f64; 3]) -> f64 {
    let (q, tau) = ((1.0 - zeta * zeta).sqrt(), PI * t);
    let e = (-zeta * x * tau).exp();
    let (sin, cos) = (q * x * tau).sin_cos();
    let d = e * (cos + zeta / q * sin);
    (1.0 - d) / (x * x) + e * sin / (q * x) + tau.cos() - e * (cos - zeta / q * sin)
}

fn printed_rise([x, zeta, t]: [f64; 3]) -> f64 {
    let (q, tau) = ((1.0 - zeta * zeta).sqrt(), PI * t);
    let (sin, cos) = (q * x * tau).sin_cos();
    (1.0 - (-zeta * x * tau).exp() * (cos + zeta / q * sin)) / (x * x)
}

fn forms() -> Vec<Form> {
    vec![
        Form {
            name: "sin πh, h reduced before π",
            stable: |[h, ..]| h.sin_pi(),
            exact: |[h, ..]| h.sin_pi(),
            printed: |[h, ..]| (PI * h).sin(),
            usual: |s| [10.0 * s, 0.0, 0.0],
            breaks: [1e6 + 9.313225746154785e-10, 0.0, 0.0],
            place: "h = 10⁶ + 2⁻³⁰",
        },
        Form {
            name: "β_lim of one undamped mass from v and u",
            stable: |[r, ..]| limit(r),
            exact: |[r, ..]| limit(r),
            printed: |[r, ..]| printed_limit(r),
            usual: |s| [0.6 + 0.9 * s, 0.0, 0.0],
            breaks: [1.0 + 1e-12, 0.0, 0.0],
            place: "r = 1 + 10⁻¹²",
        },
        Form {
            name: "u and g, light damping, beside the pole",
            stable: damping,
            exact: damping,
            printed: printed_damping,
            usual: |s| [0.5 + 3.0 * s, 0.01 + 0.1 * s, 0.0],
            breaks: [1.0, 1e-9, 0.0],
            place: "R = 1, ζ = 10⁻⁹",
        },
        Form {
            name: "g, light damping, small 1/R",
            stable: g,
            exact: g,
            printed: printed_g,
            usual: |s| [0.5 + 3.0 * s, 0.01 + 0.1 * s, 0.0],
            breaks: [1e-4, 0.01, 0.0],
            place: "R = 10⁴, ζ = 0.01",
        },
        Form {
            name: "u and g, overdamped",
            stable: damping,
            exact: damping,
            printed: printed_damping,
            usual: |s| [0.5 + 3.0 * s, 1.5 + s, 0.0],
            breaks: [200.0, 1.5, 0.0],
            place: "R = 1/200, ζ = 1.5",
        },
        Form {
            name: "(V − βU)(V + βU)",
            stable: remainder,
            exact: remainder,
            printed: |[v, beta, u]| v * v - beta * beta * u * u,
            usual: |s| [1.0 + s, 0.3, 0.7 + s],
            breaks: [1.0, 1.0 - 1e-9, 1.0],
            place: "V = U = 1, β = 1 − 10⁻⁹",
        },
        Form {
            name: "1 − sin πz/πz",
            stable: |[z, ..]| z.one_minus_sinc_pi(),
            exact: |[z, ..]| z.one_minus_sinc_pi(),
            printed: |[z, ..]| 1.0 - (PI * z).sin() / (PI * z),
            usual: |s| [0.01 + 2.0 * s, 0.0, 0.0],
            breaks: [1e-6, 0.0, 0.0],
            place: "z = 10⁻⁶",
        },
        Form {
            name: "1 − e^(−2a) − 2a·e^(−a)",
            stable: |[a, ..]| a.scaled_sinh_defect(),
            exact: |[a, ..]| a.scaled_sinh_defect(),
            printed: |[a, ..]| 1.0 - (-2.0 * a).exp() - 2.0 * a * (-a).exp(),
            usual: |s| [0.01 + 4.0 * s, 0.0, 0.0],
            breaks: [1e-4, 0.0, 0.0],
            place: "a = 10⁻⁴",
        },
        Form {
            name: "1 − cos πz",
            stable: |[z, ..]| versine_pi(z),
            exact: |[z, ..]| versine_pi(z),
            printed: |[z, ..]| 1.0 - (PI * z).cos(),
            usual: |s| [0.01 + 2.0 * s, 0.0, 0.0],
            breaks: [1e-6, 0.0, 0.0],
            place: "z = 10⁻⁶",
        },
        Form {
            name: "e^a − 1 − a",
            stable: |[a, ..]| exp_m1_minus(a),
            exact: |[a, ..]| exp_m1_minus(a),
            printed: |[a, ..]| a.exp() - 1.0 - a,
            usual: |s| [4.0 * s - 2.0, 0.0, 0.0],
            breaks: [1e-6, 0.0, 0.0],
            place: "a = 10⁻⁶",
        },
        Form {
            name: "|V| from its parts",
            stable: |[re, im, _]| complex::modulus(Complex::new(re, im), true),
            exact: |[re, im, _]| complex::modulus(Complex::new(re, im), true),
            printed: |[re, im, _]| (re * re + im * im).sqrt(),
            usual: |s| [0.1 + s, 2.0 - s, 0.0],
            breaks: [3e-170, 4e-170, 0.0],
            place: "|V| = 5·10⁻¹⁷⁰",
        },
        Form {
            name: "cos τ − cos xτ, undamped basis",
            stable: |a| undamped_basis(a).forced_slope,
            exact: |a| undamped_basis(a).forced_slope,
            printed: |[x, t, _]| (PI * t).cos() - (x * PI * t).cos(),
            usual: |s| [0.2 + 3.0 * s, 0.1 + 0.8 * s, 0.0],
            breaks: [1.0 + 1e-9, 0.3, 0.0],
            place: "x = 1 + 10⁻⁹, τ = 0.3π",
        },
        Form {
            name: "(1 − d)/x², p, cos τ − p′, light damping",
            stable: |a| total(basis(a)),
            exact: |a| total(basis(a)),
            printed: printed_total,
            usual: |s| [1.6 + 2.0 * s, 0.01 + 0.1 * s, 0.1 + 0.8 * s],
            breaks: [2.0, 0.01, 1e-6],
            place: "x = 2, ζ = 0.01, τ = 10⁻⁶π",
        },
        Form {
            name: "(1 − d)/x² alone",
            stable: |a| basis(a).rise,
            exact: |a| basis(a).rise,
            printed: printed_rise,
            usual: |s| [1.6 + 2.0 * s, 0.01 + 0.1 * s, 0.1 + 0.8 * s],
            breaks: [2.0, 0.01, 1e-6],
            place: "x = 2, ζ = 0.01, τ = 10⁻⁶π",
        },
    ]
}

/// Returns the relative error of a form at the arguments where the printed form loses accuracy.
fn error(form: &Form, value: fn(&Form) -> f64) -> f64 {
    let exact = (form.exact)(form.breaks.map(Dd::from));
    ((Dd::from(value(form)) - exact) / exact).to_f64().abs()
}

fn nanoseconds(f: fn([f64; 3]) -> f64, usual: fn(f64) -> [f64; 3]) -> f64 {
    const CALLS: usize = 4096;
    let arguments: Vec<[f64; 3]> = (0..CALLS)
        .map(|i| usual((i as f64 * 0.618_033_988_75).fract()))
        .collect();
    let mut best = f64::INFINITY;
    for _ in 0..60 {
        let clock = time::Instant::now();
        let mut sum = 0.0;
        for a in &arguments {
            sum += f(*black_box(a));
        }
        black_box(sum);
        best = best.min(clock.elapsed().as_secs_f64());
    }
    best / CALLS as f64 * 1e9
}

fn shown(error: f64) -> String {
    match error {
        e if !e.is_finite() => "no number".into(),
        e if e < 1e-16 => "below 1e-16".into(),
        e => format!("{e:.0e}"),
    }
}

fn main() {
    let mut text = String::from(
        "form,stable ns,printed ns,breaks at,error of the printed,error of the stable\n",
    );
    for form in forms() {
        let stable = nanoseconds(form.stable, form.usual);
        let printed = nanoseconds(form.printed, form.usual);
        let wrong = error(&form, |form| (form.printed)(form.breaks));
        let right = error(&form, |form| (form.stable)(form.breaks));
        println!(
            "{:45} {stable:6.1} ns, printed {printed:6.1} ns, ratio {:4.1}; at {}: {wrong:.1e} against {right:.1e}",
            form.name,
            stable / printed,
            form.place,
        );
        writeln!(
            text,
            "\"{}\",{stable:.1},{printed:.1},\"{}\",{},{}",
            form.name,
            form.place,
            shown(wrong),
            shown(right)
        )
        .expect("a string");
    }
    if std::env::var_os("UPDATE_ACCURACY").is_some() {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/data/stable-forms.csv");
        std::fs::write(path, text).expect("the figures are written");
    }
}

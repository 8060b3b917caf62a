//! Draws arguments of a mode's functions: x = 1/R = √λ/r, the damping ratio ζ, and the instant t = τ/π.

use super::{Domain, Source, Span, power};

fn frequency(s: &mut Source, span: Span) -> f64 {
    let whole = (1 + s.next() % 12) as f64;
    match s.next() % 6 {
        0 => s.size(-20.0, 12.0),
        1 | 2 => s.beside(1.0, span.bits).abs(),
        3 => s.beside(whole, span.bits).abs(),
        _ => s.between(0.0, 12.0),
    }
}

pub const FREQUENCIES: Domain = Domain {
    text: "x from 2⁻²⁰ to 2¹², crowded beside 1 and the integers",
    draw: |s, span| [frequency(s, span), 0.0, 0.0],
    holds: |a| a[0] > 0.0,
    tails: true,
    counted: (0.0, 0.0, false),
};

fn light(s: &mut Source) -> f64 {
    match s.next() % 2 {
        0 => s.size(-90.0, -1.0),
        _ => s.size(-12.0, -1.0),
    }
}

fn heavy(s: &mut Source, span: Span) -> f64 {
    match s.next() % 3 {
        0 => s.between(0.5, 1.0),
        1 => 1.0 - s.size(-span.bits, -1.0),
        _ => 0.5 + s.size(-span.bits, -1.0),
    }
}

fn over(s: &mut Source, span: Span) -> f64 {
    match s.next() % 3 {
        0 => s.between(1.0, 4.0),
        1 => 1.0 + s.size(-span.bits, 0.0),
        _ => s.size(0.0, 10.0),
    }
}

/// Largest ζx for which a mode keeps at least the fraction e^−2 of its motion over a half period.
const KEPT: f64 = 2.0 / core::f64::consts::PI;

fn is_light(zeta: f64) -> bool {
    0.0 < zeta && zeta < 0.5
}
fn is_heavy(zeta: f64) -> bool {
    (0.5..1.0).contains(&zeta)
}

macro_rules! damped_frequencies {
    ($($name:ident: $text:literal, $zeta:expr, $holds:expr;)*) => { $(
        pub const $name: Domain = Domain {
            text: $text,
            draw: |s, span| {
                let zeta: fn(&mut Source, Span) -> f64 = $zeta;
                [frequency(s, span), zeta(s, span), 0.0]
            },
            holds: |a| {
                let holds: fn(f64, f64) -> bool = $holds;
                a[0] > 0.0 && holds(a[0], a[1])
            },
            tails: true,
    counted: (0.0, 0.0, false),
        };
    )* };
}

damped_frequencies! {
    LIGHT: "x as undamped, 2⁻⁹⁰ ≤ ζ < 1/2, πζx ≤ 2", |s, _| light(s), |x, z| is_light(z) && z * x <= KEPT;
    LIGHT_DECAYED: "x as undamped, ζ < 1/2, πζx > 2", |s, _| s.between(0.0, 0.5), |x, z| is_light(z) && z * x > KEPT;
    HEAVY: "x as undamped, 1/2 ≤ ζ < 1, πζx ≤ 2", heavy, |x, z| is_heavy(z) && z * x <= KEPT;
    HEAVY_DECAYED: "x as undamped, 1/2 ≤ ζ < 1, πζx > 2", heavy, |x, z| is_heavy(z) && z * x > KEPT;
    CRITICAL: "x as undamped, ζ = 1, πx ≤ 2", |_, _| 1.0, |x, z| z * x <= KEPT;
    CRITICAL_DECAYED: "x as undamped, ζ = 1, πx > 2", |_, _| 1.0, |x, z| z * x > KEPT;
    OVER: "x as undamped, 1 < ζ ≤ 2¹⁰, πζx ≤ 2", over, |x, z| z > 1.0 && z * x <= KEPT;
    OVER_DECAYED: "x as undamped, 1 < ζ ≤ 2¹⁰, πζx > 2", over, |x, z| z > 1.0 && z * x > KEPT;
}

fn instant(s: &mut Source, span: Span) -> f64 {
    match s.next() % 4 {
        0 => s.size(-40.0, 0.0),
        1 => 1.0 - s.size(-span.bits, 0.0),
        _ => s.between(0.0, 1.0),
    }
}

pub const INSTANTS: Domain = Domain {
    text: "0 < t ≤ 1, crowded at both ends",
    draw: |s, span| [instant(s, span), 0.0, 0.0],
    holds: |a| 0.0 < a[0] && a[0] <= 1.0,
    tails: true,
    counted: (power(-14), 1.0, false),
};

pub const UNDAMPED_TIME: Domain = Domain {
    text: "x as in the response, 0 < t ≤ 1 crowded at both ends",
    draw: |s, span| [frequency(s, span), 0.0, instant(s, span)],
    holds: |a| a[0] > 0.0 && 0.0 < a[2] && a[2] <= 1.0,
    tails: true,
    counted: (0.0, 0.0, false),
};

macro_rules! damped_times {
    ($($name:ident: $text:literal, $zeta:expr, $holds:expr;)*) => { $(
        pub const $name: Domain = Domain {
            text: $text,
            draw: |s, span| {
                let zeta: fn(&mut Source, Span) -> f64 = $zeta;
                [frequency(s, span), zeta(s, span), instant(s, span)]
            },
            holds: |a| {
                let holds: fn(f64, f64) -> bool = $holds;
                a[0] > 0.0 && 0.0 < a[2] && a[2] <= 1.0 && holds(a[0] * a[2], a[1])
            },
            tails: true,
    counted: (0.0, 0.0, false),
        };
    )* };
}

damped_times! {
    LIGHT_TIME: "x, t as undamped, 2⁻⁹⁰ ≤ ζ < 1/2, ζxτ ≤ 2", |s, _| light(s), |x, z| is_light(z) && z * x <= KEPT;
    LIGHT_TIME_DECAYED: "x, t as undamped, ζ < 1/2, ζxτ > 2", |s, _| s.between(0.0, 0.5), |x, z| is_light(z) && z * x > KEPT;
    HEAVY_TIME: "x, t as undamped, 1/2 ≤ ζ < 1, ζxτ ≤ 2", heavy, |x, z| is_heavy(z) && z * x <= KEPT;
    HEAVY_TIME_DECAYED: "x, t as undamped, 1/2 ≤ ζ < 1, ζxτ > 2", heavy, |x, z| is_heavy(z) && z * x > KEPT;
    CRITICAL_TIME: "x, t as undamped, ζ = 1, xτ ≤ 2", |_, _| 1.0, |x, z| z * x <= KEPT;
    CRITICAL_TIME_DECAYED: "x, t as undamped, ζ = 1, xτ > 2", |_, _| 1.0, |x, z| z * x > KEPT;
    OVER_TIME: "x, t as undamped, 1 < ζ ≤ 2¹⁰, ζxτ ≤ 2", over, |x, z| z > 1.0 && z * x <= KEPT;
    OVER_TIME_DECAYED: "x, t as undamped, 1 < ζ ≤ 2¹⁰, ζxτ > 2", over, |x, z| z > 1.0 && z * x > KEPT;
}

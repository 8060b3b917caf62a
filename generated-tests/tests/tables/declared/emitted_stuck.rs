//! Tests the responses while the contact is stuck, of scenes that declare an accuracy and are emitted by the macro.

use frictiongen::{Given, OutOfDomain, Ratio, StuckAt, StuckResonance, System, friction_system};
use frictiongen_kernel::Complex;
use fuzzing::Random;

/// Passes a scene to the macro, and keeps its text.
macro_rules! scene {
    ($text:ident: struct $name:ident { $($body:tt)* }) => {
        friction_system! { pub struct $name { $($body)* } }
        const $text: &str = stringify!(struct $name { $($body)* });
    };
}

scene! { ON_TWO: struct OnTwo {
    masses: { lower: 1, upper: 1 },
    springs: { base - lower: 1, lower - upper: 3 },
    contact: upper - wall,
    excitation: lower,
    provide: [limits, stuck],
    accuracy: 1e-6,
    range: { r: 0.3..2.5 },
} }

scene! { FIVE: struct Five {
    masses: { a: 1, b: 1.2, c: 0.8, d: 1.1, e: 0.9 },
    springs: { base - a: 1, a - b: 1.3, b - c: 0.7, c - d: 1, d - e: 1.1 },
    contact: b - c,
    excitation: e,
    damping: modal[0.02, 0.03, 0.4, 1.3, 0.01],
    provide: [limits, stuck],
    accuracy: 1e-9,
    range: { r: 0.2..2.5 },
} }

scene! { SINGLE: struct Single {
    masses: { a: 1, b: 2, c: 1 },
    springs: { base - a: 1, a - b: 2, b - c: 1 },
    contact: b - base,
    excitation: base,
    damping: modal[1.4, 0.05, 0.02],
    scalar: f32,
    provide: [limits, stuck],
    accuracy: 1e-5,
    range: { r: 0.2..2.5 },
} }

scene! { OWN_POLES: struct OwnPoles {
    masses: { a: 1, b: 2, c: 1 },
    springs: { base - a: 1, a - b: 1, b - c: 1 },
    contact: b - base,
    excitation: base,
    provide: [limits, stuck],
    accuracy: 1e-6,
    range: { r: 0.2..2.5 },
} }

scene! { OWN_POLES_DAMPED: struct OwnPolesDamped {
    masses: { a: 1, b: 2, c: 1 },
    springs: { base - a: 1, a - b: 1, b - c: 1 },
    contact: b - base,
    excitation: base,
    damping: rayleigh(0.02, 0.03),
    provide: [limits, stuck],
    accuracy: 1e-6,
    range: { r: 0.2..2.5 },
} }

scene! { BEYOND: struct Beyond {
    masses: { a: 1, b: 1 },
    springs: { base - a: 1, a - b: 2 },
    contact: a - b,
    excitation: b,
    damping: modal(0.03),
    provide: [limits, stuck],
    accuracy: 1e-3,
    range: { r: 0.4..2.0 },
    beyond: exact,
} }

scene! { FEW_BYTES: struct FewBytes {
    masses: { a: 1, b: 1, c: 1, d: 1 },
    springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1 },
    contact: d - wall,
    excitation: a,
    damping: modal(0.03),
    provide: [limits, stuck],
    budget: 1000,
    range: { r: 0.3..2.0 },
} }

/// Returns the scene without a declared accuracy, in double precision.
fn exact(text: &str) -> System {
    let before = text.split("accuracy").next().unwrap();
    let before = before.split("budget").next().unwrap();
    let text = before
        .replace("scalar : f32,", "")
        .replace("scalar: f32,", "")
        + "}";
    text.parse().unwrap()
}

fn apart(a: Complex<f64>, b: Complex<f64>) -> f64 {
    (a.re - b.re).hypot(a.im - b.im)
}

/// Returns frequency ratios over a range, including its bounds.
fn ratios(low: f64, high: f64) -> impl Iterator<Item = f64> {
    (0..=1000).map(move |k| low + (high - low) * f64::from(k) / 1000.0)
}

/// Asserts at ten thousand points that the error of each mass and of the force is within `allowed` of the exact
/// modulus.
macro_rules! within {
    ($scene:ident, $text:ident, $scalar:ident, $range:expr, $allowed:expr, [$($mass:ident),*]) => {{
        let (range, system) = ($range, exact($text));
        let (mut random, mut worst) = (Random(7), 0.0_f64);
        for _ in 0..10_000 {
            let r = random.between(range.start, range.end) as $scalar;
            let r = r.clamp(range.start as $scalar, range.end as $scalar);
            let stuck = $scene::at(r).unwrap().stuck().unwrap();
            let reference = system.at(f64::from(r)).unwrap().stuck().unwrap();
            let wide = |own: Complex<$scalar>| Complex::new(f64::from(own.re), f64::from(own.im));
            let pairs = [
                (stuck.contact_force(), reference.contact_force()),
                $((stuck.$mass(), reference.mass(stringify!($mass)).unwrap()),)*
            ];
            for (answer, expected) in pairs {
                let size = expected.re.hypot(expected.im);
                let off = apart(wide(answer), expected);
                // A mass that does not move has only rounding errors, so its modulus counts as at least 1e-9.
                worst = worst.max(off / size.max(1e-9));
            }
        }
        println!("{}: {worst:.1e}", stringify!($scene));
        assert!(worst <= $allowed, "{}: {worst:e}", stringify!($scene));
    }};
}

#[test]
fn within_the_accuracy() {
    within!(OnTwo, ON_TWO, f64, 0.3..2.5, 1e-6, [lower, upper]);
    within!(Five, FIVE, f64, 0.2..2.5, 1e-9, [a, b, c, d, e]);
    within!(Single, SINGLE, f32, 0.2..2.5, 1e-5, [a, b, c]);
    within!(OwnPoles, OWN_POLES, f64, 0.2..2.5, 1e-6, [a, b, c]);
    within!(
        OwnPolesDamped,
        OWN_POLES_DAMPED,
        f64,
        0.2..2.5,
        1e-6,
        [a, b, c]
    );
    within!(Beyond, BEYOND, f64, 0.4..2.0, 1e-3, [a, b]);
    within!(FewBytes, FEW_BYTES, f64, 0.3..2.0, 1e-9, [a, b, c, d]);
}

/// Asserts that the emitted products equal those of the run-time system bit for bit.
macro_rules! as_at_run_time {
    ($scene:ident, $text:ident, $scalar:ident, $range:expr, $accuracy:expr) => {{
        let (range, system) = ($range, $text.parse::<System<$scalar>>().unwrap());
        let tables = system.compile(range.clone(), $accuracy).unwrap();
        let masses = system.scene().masses.len();
        for r in ratios(range.start, range.end) {
            let r = (r as $scalar).clamp(range.start as $scalar, range.end as $scalar);
            let at = tables.at(r).unwrap();
            let (emitted, compiled) = ($scene::at(r).unwrap().stuck(), at.stuck());
            let (Ok(emitted), Ok(compiled)) = (emitted, compiled) else {
                assert_eq!(r, 2.0);
                continue;
            };
            assert_eq!(emitted.contact_force(), compiled.contact_force());
            for mass in 0..=masses {
                assert_eq!(emitted.mass_at(mass), compiled.mass_at(mass));
                assert_eq!(emitted.mass_at(mass).is_none(), mass == masses);
            }
            // Generic sweeps and maps call the responses through this trait.
            let through = StuckAt::stuck_mass(&tables.at(r).unwrap(), 0).unwrap();
            assert_eq!(through, emitted.mass_at(0));
        }
        tables
            .at(1.0)
            .unwrap()
            .stuck()
            .unwrap()
            .mass("none")
            .unwrap_err();
    }};
}

#[test]
fn of_the_run_time_system() {
    as_at_run_time!(OnTwo, ON_TWO, f64, 0.3..2.5, 1e-6);
    as_at_run_time!(Five, FIVE, f64, 0.2..2.5, 1e-9);
    as_at_run_time!(Single, SINGLE, f32, 0.2..2.5, 1e-5);
}

/// Checks the response on a pole. While the upper mass sticks, the lower mass is on springs of 1 and 3. Its response
/// is infinite at the resonance r = 2.
#[test]
fn on_a_pole() {
    let resonance = OnTwo::at(2.0).unwrap().stuck();
    assert_eq!(resonance.map(drop), Err(StuckResonance));
    let tabled: System = ON_TWO.parse().unwrap();
    let tables = tabled.compile(0.3..2.5, 1e-6).unwrap();
    let resonance = tables.at(2.0).unwrap().stuck();
    assert_eq!(resonance.map(drop), Err(StuckResonance));
    // At the resonance the exact sums return an error, or a response of the order of 1/ε.
    if let Ok(stuck) = exact(ON_TWO).at(2.0).unwrap().stuck() {
        assert!(stuck.mass("lower").unwrap().re.abs() > 1e14);
    }
    let (mut above, mut below) = (2.0_f64.next_up(), 2.0_f64.next_down());
    for _ in 0..60 {
        for r in [above, below] {
            let stuck = OnTwo::at(r).unwrap().stuck().unwrap();
            let expected = 1.0 / ((2.0 - r) * (2.0 + r));
            assert!((stuck.lower().re / expected - 1.0).abs() < 4.0 * f64::EPSILON);
            assert_eq!((stuck.lower().im, stuck.upper().re), (0.0, 0.0));
        }
        (above, below) = (2.0 + 1.5 * (above - 2.0), 2.0 - 1.5 * (2.0 - below));
    }
    assert!(above > 2.00001);
}

#[test]
fn beyond_the_range() {
    let system = exact(BEYOND);
    for r in [0.0, 0.1, 0.39, 2.1, 50.0] {
        let at = Beyond::at(r).unwrap();
        assert!(!at.is_within());
        let (stuck, reference) = (at.stuck().unwrap(), system.at(r).unwrap().stuck().unwrap());
        assert_eq!(stuck.contact_force(), reference.contact_force());
        let close = |answer: Complex<f64>, expected: Complex<f64>| {
            // The emitted sum and the run-time sum add their terms in different orders.
            let size = expected.re.hypot(expected.im);
            assert!(
                apart(answer, expected) <= 1e-14 * size,
                "{r}: {answer} for {expected}"
            );
        };
        close(stuck.a(), reference.mass("a").unwrap());
        close(stuck.b(), reference.mass("b").unwrap());
        assert_eq!(stuck.a(), at.stuck().unwrap().exact().mass(0));
    }
    let out = Err(OutOfDomain::OutsideTables(Ratio::Frequency));
    assert_eq!(Five::at(0.19).map(drop), out);
    let none = Err(OutOfDomain::FrequencyRatio(Given::NotANumber));
    assert_eq!(Five::at(f64::NAN).map(drop), none);
}

/// Checks that the responses have exactly the values of the exact formulas if the products do not fit into the
/// budget.
#[test]
fn without_products() {
    for r in ratios(0.3, 2.0) {
        let stuck = FewBytes::at(r).unwrap().stuck().unwrap();
        let exact = stuck.exact();
        assert_eq!(stuck.contact_force(), exact.contact_force());
        for mass in 0..4 {
            assert_eq!(stuck.mass(mass), exact.mass(mass));
        }
    }
    // In other scenes the products answer. Their rounding errors differ from those of the exact formulas.
    let differs = |r: &f64| {
        let stuck = Five::at(*r).unwrap().stuck().unwrap();
        stuck.a() != stuck.exact().mass(0)
    };
    assert!(ratios(0.2, 2.5).filter(differs).count() > 500);
}

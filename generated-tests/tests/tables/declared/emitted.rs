//! Tests scenes that declare an accuracy and are emitted by the macro. Their tables equal those of the run-time
//! system bit for bit.

use frictiongen::kernel::table::Tabled;
use frictiongen::study::scene::Side;
use frictiongen::study::table::Request;
use frictiongen::{
    FrictionSystem, Given, LimitsAt, NotContinuous, Of, OutOfDomain, Ratio, Regime, System,
    friction_system,
};

/// Passes a scene to the macro, and keeps its text.
macro_rules! scene {
    ($text:ident: $(#[$attribute:meta])* struct $name:ident { $($body:tt)* }) => {
        friction_system! { $(#[$attribute])* pub struct $name { $($body)* } }
        const $text: &str = stringify!(struct $name { $($body)* });
    };
}

scene! { DAMPED: struct Damped {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    stiction: 1.2,
    provide: [limits, motion, stuck, orbit],
    accuracy: 1e-4,
    range: { r: 0.2..2.5 },
} }

scene! { UNDAMPED: struct Undamped {
    masses: { a: 1, b: 2, c: 1 },
    springs: { base - a: 1, a - b: 2, b - c: 1 },
    contact: a - b,
    excitation: c,
    accuracy: 1e-6,
    range: { r: 0.3..2.0, beta: 0..1 },
} }

scene! { SINGLE: struct Single {
    masses: { block: 2 },
    springs: { base - block: 50 },
    contact: block - base,
    excitation: base,
    damping: modal(0.05),
    scalar: f32,
    accuracy: 1e-4,
    range: { r: 0.3..2.0 },
} }

scene! { EXACT_BEYOND: struct ExactBeyond {
    masses: { block: 2 },
    springs: { base - block: 50 },
    contact: block - wall,
    excitation: block,
    accuracy: 1e-3,
    range: { r: 0.4..2.0 },
    beyond: exact,
} }

scene! { SAFE: struct Safe {
    masses: { a: 1, b: 1, c: 1 },
    springs: { base - a: 1, a - b: 1, b - c: 1 },
    contact: c - wall,
    excitation: a,
    damping: modal(0.03),
    accuracy: 1e-3,
    range: { r: 0.2..2.5 },
    side: safe,
} }

scene! { BYTES: struct Bytes {
    masses: { a: 1, b: 1 },
    springs: { base - a: 1, a - b: 1 },
    contact: b - wall,
    excitation: a,
    damping: modal(0.03),
    provide: [limits],
    budget: 2048,
    range: { r: 0.3..2.0 },
} }

scene! { SLIDING: struct Sliding {
    masses: { a: 1, b: 1 },
    springs: { base - a: 1, a - b: 1 },
    contact: b - wall,
    excitation: a,
    damping: modal(0.03),
    stiction: 1.1,
    accuracy: 1e-3,
    range: { r: 0.4..0.8, beta: 0..0.15 },
} }

scene! { NEVER_STUCK: struct NeverStuck {
    masses: { a: 1, b: 1 },
    springs: { base - a: 1, a - b: 1 },
    contact: b - wall,
    excitation: a,
    damping: modal(0.03),
    scalar: f32,
    accuracy: 1e-3,
    range: { r: 0.4..0.8, beta: 0..0.4 },
} }

scene! { FROM_BASE: struct FromBase {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: lower - base,
    excitation: base,
    damping: modal[0.010, 0.012],
    damping_from: base,
    provide: [limits, motion, stuck, orbit],
    accuracy: 1e-4,
    range: { r: 0.2..2.5 },
} }

/// Returns frequency ratios over a range, including its bounds.
fn ratios(low: f64, high: f64) -> impl Iterator<Item = f64> {
    (0..=1000).map(move |k| low + (high - low) * f64::from(k) / 1000.0)
}

#[test]
fn of_the_run_time_system() {
    let system: System = DAMPED.parse().unwrap();
    let tables = system.compile(0.2..2.5, 1e-4).unwrap();
    let mut compared = 0;
    for r in ratios(0.2, 2.5) {
        let (emitted, compiled) = (Damped::at(r).unwrap(), tables.at(r).unwrap());
        assert_eq!(emitted.limits(), compiled.limits(), "r = {r}");
        let beta = 0.7 * emitted.limits().continuous.min(emitted.limits().sliding);
        let (emitted, compiled) = (
            emitted.motion(beta).unwrap(),
            compiled.motion(beta).unwrap(),
        );
        assert_eq!(emitted.contact().largest(), compiled.contact().largest());
        // The mass that rubs on the wall moves as the contact does.
        assert_eq!(emitted.upper().amplitude(), emitted.contact().amplitude());
        assert_eq!(
            emitted.contact().amplitude_monoharmonic(),
            emitted.contact().amplitude()
        );
        compared += 1;
    }
    let system: System = UNDAMPED.parse().unwrap();
    let tables = system.compile(0.3..2.0, 1e-6).unwrap();
    for r in ratios(0.3, 2.0) {
        let (emitted, compiled) = (Undamped::at(r).unwrap(), tables.at(r).unwrap());
        assert_eq!(emitted.limits(), compiled.limits(), "r = {r}");
        let beta = 0.4
            * emitted
                .limits()
                .continuous
                .min(emitted.limits().sliding)
                .min(1.0);
        let (emitted, compiled) = (
            emitted.motion(beta).unwrap(),
            compiled.motion(beta).unwrap(),
        );
        assert_eq!(emitted.contact().largest(), compiled.contact().largest());
        compared += 1;
    }
    let system: System<f32> = SINGLE.parse().unwrap();
    let tables = system.compile(0.3..2.0, 1e-4).unwrap();
    for r in ratios(0.3, 2.0) {
        let r = (r as f32).clamp(0.3, 2.0);
        let (emitted, compiled) = (Single::at(r).unwrap(), tables.at(r).unwrap());
        assert_eq!(emitted.limits(), compiled.limits(), "r = {r}");
        compared += 1;
    }
    assert_eq!(compared, 3003);
}

/// Checks that emitted code contains nothing for regimes that the declared friction ratios cannot reach. No result
/// changes by this.
#[test]
fn out_of_reach() {
    let domain = Sliding.domain();
    assert!(domain.always_continuous && domain.never_stuck);
    let system: System = SLIDING.parse().unwrap();
    let tables = system.compile(0.4..0.8, 1e-3).unwrap();
    let least = ratios(0.4, 0.8).map(|r| {
        let limits = tables.at(r).unwrap().limits();
        limits.continuous.min(limits.sliding)
    });
    let least = least.fold(f64::INFINITY, f64::min);
    assert!(0.15 < least && least < 0.4, "{least}");
    let mut seen = [0; 2];
    for r in ratios(0.4, 0.8) {
        for beta in [0.0, 0.075, 0.15] {
            let (emitted, compiled) = (Sliding::at(r).unwrap(), tables.at(r).unwrap());
            assert_eq!(emitted.regime(beta), Ok(Regime::Continuous));
            assert_eq!(emitted.regime(beta), compiled.regime(beta));
            assert_eq!(emitted.margin(beta), compiled.margin(beta));
            let (emitted, compiled) = (emitted.motion(beta), compiled.motion(beta));
            let (emitted, compiled) = (emitted.unwrap(), compiled.unwrap());
            assert_eq!(emitted.contact().largest(), compiled.contact().largest());
        }
        for beta in [-1e-3, 0.150_1, f64::NAN] {
            let at = Sliding::at(r).unwrap();
            assert_eq!(at.regime(beta), Err(friction_error(beta)));
            assert!(at.motion(beta).is_err(), "{beta}");
        }
    }
    let domain = NeverStuck.domain();
    assert!(!domain.always_continuous && domain.never_stuck);
    let system: System<f32> = NEVER_STUCK.parse().unwrap();
    let tables = system.compile(0.4..0.8, 1e-3).unwrap();
    for r in ratios(0.4, 0.8) {
        let r = (r as f32).clamp(0.4, 0.8);
        for beta in [0.0, 0.2, 0.4] {
            let (emitted, compiled) = (NeverStuck::at(r).unwrap(), tables.at(r).unwrap());
            let regime = emitted.regime(beta).unwrap();
            assert_eq!(Ok(regime), compiled.regime(beta));
            let motion = emitted
                .motion(beta)
                .map(|motion| motion.contact().largest());
            let known = compiled
                .motion(beta)
                .map(|motion| motion.contact().largest());
            assert_eq!(motion, known);
            seen[usize::from(regime == Regime::Continuous)] += 1;
        }
    }
    assert!(seen[0] > 300 && seen[1] > 300, "{seen:?}");
    // The code is complete if the scene declares no friction ratios, or if exact formulas serve for β outside the
    // declared range.
    for domain in [Damped.domain(), ExactBeyond.domain()] {
        assert!(!domain.always_continuous && !domain.never_stuck);
    }
}

/// Checks that quantities without a table have exactly the values of the exact formulas.
#[test]
fn the_rest_is_exact() {
    let text = DAMPED.split("accuracy").next().unwrap().to_owned() + "}";
    let system: System = text.parse().unwrap();
    for r in [0.31, 0.5, 0.77, 1.3, 2.2] {
        let (emitted, exact) = (Damped::at(r).unwrap(), system.at(r).unwrap());
        let beta = 0.5 * exact.limits().continuous.min(exact.limits().sliding);
        let (motion, reference) = (emitted.motion(beta).unwrap(), exact.motion(beta).unwrap());
        let close =
            |a: f64, b: f64| assert!((a - b).abs() <= 1e-12 * b.abs().max(1.0), "{a} for {b}");
        close(
            motion.lower().amplitude(),
            reference.mass("lower").unwrap().amplitude(),
        );
        close(
            motion.contact().displacement(1.0),
            reference.contact().displacement(1.0),
        );
        close(
            motion.contact().velocity(1.0),
            reference.contact().velocity(1.0),
        );
        close(
            motion.contact().harmonic(3).re,
            reference.contact().harmonic(3).re,
        );
        close(
            emitted.continuous_limit_without_search(),
            exact.continuous_limit_without_search(),
        );
        close(
            emitted.continuous_limit_per_mode(),
            exact.continuous_limit_per_mode(),
        );
        close(
            emitted.stuck().unwrap().lower().re,
            exact.stuck().unwrap().mass("lower").unwrap().re,
        );
        close(
            emitted.orbit(beta).unwrap().contact().amplitude(),
            reference.contact().amplitude(),
        );
        close(emitted.exact().continuous_limit(), exact.continuous_limit());
    }
}

/// Checks a scene whose damping acts relative to the moving base. The tables have the bits of the run-time tables and
/// the declared accuracy. All other results are exact.
#[test]
fn of_damping_from_the_base() {
    let text = FROM_BASE.split("accuracy").next().unwrap().to_owned() + "}";
    let exact: System = text.parse().unwrap();
    let system: System = FROM_BASE.parse().unwrap();
    let tables = system.compile(0.2..2.5, 1e-4).unwrap();
    let near = |a: f64, b: f64, by: f64| assert!((a - b).abs() <= by * b.abs(), "{a} for {b}");
    for r in ratios(0.2, 2.5) {
        let (emitted, compiled) = (FromBase::at(r).unwrap(), tables.at(r).unwrap());
        let exact = exact.at(r).unwrap();
        let limits = emitted.limits();
        assert_eq!(limits, compiled.limits(), "r = {r}");
        near(limits.continuous, exact.limits().continuous, 1e-4);
        near(limits.sliding, exact.limits().sliding, 1e-4);
        let beta = 0.7 * limits.continuous.min(limits.sliding);
        let (motion, reference) = (emitted.motion(beta).unwrap(), exact.motion(beta).unwrap());
        let contact = compiled.motion(beta).unwrap();
        assert_eq!(motion.contact().largest(), contact.contact().largest());
        let amplitude = reference.contact().amplitude();
        near(motion.contact().amplitude(), amplitude, 1e-4);
        let amplitude = reference.mass("upper").unwrap().amplitude();
        near(motion.upper().amplitude(), amplitude, 1e-12);
        let (stuck, reference) = (emitted.stuck().unwrap(), exact.stuck().unwrap());
        let reference = reference.mass("upper").unwrap();
        near(stuck.upper().re, reference.re, 1e-12);
        near(stuck.upper().im, reference.im, 1e-9);
    }
}

/// Returns the error for a friction ratio that is outside the domain of the tables.
fn friction_error(beta: f64) -> OutOfDomain {
    match Given::of(beta) {
        Given::Positive | Given::Zero => OutOfDomain::OutsideTables(Ratio::Friction),
        given => OutOfDomain::FrictionRatio(given),
    }
}

#[test]
fn beyond_the_range() {
    let out = Err(OutOfDomain::OutsideTables(Ratio::Frequency));
    assert_eq!(Damped::at(0.199_999).map(drop), out);
    assert_eq!(Damped::at(2.500_001).map(drop), out);
    let none = Err(OutOfDomain::FrequencyRatio(Given::NotANumber));
    assert_eq!(Damped::at(f64::NAN).map(drop), none);
    assert_eq!(Damped::at(f64::INFINITY).map(drop), out);
    assert!(Damped::at(0.2).is_ok() && Damped::at(2.5).is_ok());
    // β outside the declared range gives an error.
    let at = Undamped::at(0.9).unwrap();
    assert_eq!(at.regime(1.5), Err(friction_error(1.5)));
    assert_eq!(at.margin(f64::NAN), Err(friction_error(f64::NAN)));
    assert_eq!(at.motion(1.5).map(drop), Err(NotContinuous::OutOfDomain));
    let (mut continuous, mut sliding) = ([0.0; 2], [0.0; 2]);
    assert_eq!(
        Damped::limits_into(&[1.0, 3.0], &mut continuous, &mut sliding),
        out
    );
    assert!(continuous[0] > 0.0 && continuous[1] == 0.0);
    // With `beyond: exact` the exact formulas answer outside the declared range.
    let exact: System = EXACT_BEYOND
        .split("accuracy")
        .next()
        .map(|text| text.to_owned() + "}")
        .unwrap()
        .parse()
        .unwrap();
    for r in [0.0, 0.1, 0.39, 2.1, 50.0, f64::INFINITY] {
        let (emitted, exact) = (ExactBeyond::at(r).unwrap(), exact.at(r).unwrap());
        assert!(!emitted.is_within());
        assert_eq!(emitted.limits(), exact.limits(), "r = {r}");
        assert_eq!(emitted.regime(0.1), exact.regime(0.1));
        let (motion, reference) = (emitted.motion(0.01), exact.motion(0.01));
        assert_eq!(motion.is_ok(), reference.is_ok());
        if let (Ok(motion), Ok(reference)) = (motion, reference) {
            assert_eq!(
                motion.contact().amplitude(),
                reference.contact().amplitude()
            );
            assert_eq!(motion.contact().phase(), reference.contact().phase());
        }
    }
    assert!(ExactBeyond::at(-1.0).is_err() && ExactBeyond::at(f64::NAN).is_err());
    assert!(ExactBeyond::at(1.0).unwrap().is_within());
}

/// Checks the regimes. A regime may be wrong only if β is within the accuracy of a limit.
#[test]
fn regimes() {
    let text = DAMPED.split("accuracy").next().unwrap().to_owned() + "}";
    let system: System = text.parse().unwrap();
    let mut seen = [0; 3];
    for r in ratios(0.2, 2.5).step_by(7) {
        let (emitted, exact) = (Damped::at(r).unwrap(), system.at(r).unwrap());
        let limits = exact.limits();
        for limit in [limits.continuous, limits.sliding] {
            for part in [0.3, 0.999, 1.0 - 1.1e-4, 1.0 + 1.1e-4, 1.001, 1.7] {
                let beta = part * limit;
                let other = limits.continuous + limits.sliding - limit;
                if (beta / other - 1.0).abs() < 1.1e-4 {
                    continue;
                }
                let regime = emitted.regime(beta).unwrap();
                assert_eq!(
                    regime,
                    exact.regime(beta).unwrap(),
                    "r = {r}, beta = {beta}"
                );
                seen[regime as usize] += 1;
                let margin = emitted.margin(beta).unwrap();
                let expected = exact.margin(beta).unwrap();
                assert!(
                    (margin - expected).abs() < 1.1e-4 * (1.0 + expected),
                    "{margin} for {expected}"
                );
            }
        }
    }
    assert!(seen.iter().all(|count| *count > 50), "{seen:?}");
    assert_eq!(Damped::at(1.0).unwrap().regime(1e6), Ok(Regime::Stuck));
}

/// Checks that for β > 0.98 β_lim the error grows as 1/(1 − (β/β_lim)²), as `docs/firmware.md` states.
#[test]
fn close_to_the_limit() {
    let system: System = (DAMPED.split("accuracy").next().unwrap().to_owned() + "}")
        .parse()
        .unwrap();
    let (mut worst, mut compared) = (0.0_f64, 0);
    for r in ratios(0.2, 2.5) {
        let (emitted, exact) = (Damped::at(r).unwrap(), system.at(r).unwrap());
        let limits = exact.limits();
        for share in [0.99, 0.995, 0.998, 0.999] {
            let beta = share * limits.continuous;
            let (Ok(motion), Ok(reference)) = (emitted.motion(beta), exact.motion(beta)) else {
                // The contact is stuck at this β, because β*_lim is the lower limit.
                assert!(limits.sliding <= beta, "r = {r}");
                continue;
            };
            let (motion, reference) = (motion.contact(), reference.contact());
            let error = (motion.amplitude() / reference.amplitude() - 1.0).abs();
            let allowed = 1e-4 * (1.0 - 0.98 * 0.98) / (1.0 - share * share);
            worst = worst.max(error / allowed);
            compared += 1;
        }
    }
    println!("{compared} compared; worst {worst:.2} of what is stated");
    assert!(worst < 1.0 && compared > 2000);
}

/// Checks that with `side: safe` no result is wrong on the unsafe side.
#[test]
fn the_safe_side() {
    let exact: System = (SAFE.split("accuracy").next().unwrap().to_owned() + "}")
        .parse()
        .unwrap();
    let (mut least, mut most) = (f64::INFINITY, 0.0_f64);
    for r in ratios(0.2, 2.5) {
        let (emitted, exact) = (Safe::at(r).unwrap().limits(), exact.at(r).unwrap().limits());
        let short = 1.0 - emitted.continuous / exact.continuous;
        (least, most) = (least.min(short), most.max(short));
        assert!(emitted.sliding >= exact.sliding && emitted.sliding < exact.sliding * (1.0 + 1e-3));
    }
    assert!(least > 0.0 && most < 1e-3, "{least} to {most}");
    println!("β_lim below the exact one by {least:.1e} to {most:.1e}");
}

/// Checks that with `budget` the macro uses the most accurate table that fits, and that the doc comment states its
/// accuracy.
#[test]
fn a_budget() {
    let system: System = (BYTES.split("provide").next().unwrap().to_owned() + "}")
        .parse()
        .unwrap();
    let mut worst = 0.0_f64;
    for r in ratios(0.3, 2.0) {
        let expected = system.at(r).unwrap().continuous_limit();
        worst = worst.max((Bytes::at(r).unwrap().continuous_limit() / expected - 1.0).abs());
    }
    assert!(worst < 1e-3 && worst > 1e-12, "{worst}");
    let request = Request {
        r: (0.3, 2.0),
        accuracy: 0.1,
        side: Side::Near,
        motion: false,
        stuck: false,
    };
    let tables =
        frictiongen::study::table::Tables::<f64>::within(system.modal(), request, 2048).unwrap();
    assert!(tables.report.bytes <= 2048);
    assert!(worst <= tables.request.accuracy);
}

/// Checks that generic functions for sweeps, maps or fits accept scenes with tables.
#[test]
fn through_the_traits() {
    fn narrowest<F: FrictionSystem<Scalar = f64>>(system: &F) -> f64 {
        let limits = ratios(0.4, 2.0).filter_map(|r| system.at(r).ok());
        limits
            .map(|at| LimitsAt::continuous_limit(&at))
            .fold(f64::INFINITY, f64::min)
    }
    fn amplitude<F>(system: &F, of: Of) -> Option<f64>
    where
        F: FrictionSystem<Scalar = f64>,
        for<'a> F::At<'a>: frictiongen::MotionAt<Scalar = f64>,
    {
        use frictiongen::{ContinuousMotion, MotionAt};
        let at = system.at(0.6).ok()?;
        at.motion(0.01).ok()?.ask(of, |motion| motion.amplitude())
    }
    let system: System = DAMPED.parse().unwrap();
    let tables = system.compile(0.2..2.5, 1e-4).unwrap();
    assert_eq!(narrowest(&Damped), narrowest(&tables));
    assert!((narrowest(&Damped) / narrowest(&system) - 1.0).abs() < 1e-4);
    for of in [Of::Contact, Of::Mass(0), Of::Mass(1)] {
        let (emitted, exact) = (
            amplitude(&Damped, of).unwrap(),
            amplitude(&system, of).unwrap(),
        );
        assert!(
            (emitted / exact - 1.0).abs() < 1e-4,
            "{of:?}: {emitted} for {exact}"
        );
    }
}

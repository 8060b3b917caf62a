//! Compares derivatives of steady states with stops with differences of such states.
//!
//! The differences use states that the same method finds for shifted quantities, converged to 30 digits. The state
//! without a shift must also agree with the state in double-double that the motion from rest reaches, which uses no
//! derivatives. The tolerance is the error of the difference itself (`differences`).

use crate::sensitivities::answers::Answers;
use crate::sensitivities::differences::{Outcome, Side, compare};
use crate::sensitivities::scene::{moved, quantities, shortened};
use frictiongen::study::{
    System,
    orbit::SystemOrbit,
    sensitivity::{NoDerivative, Sensitive},
};
use frictiongen_kernel::Scalar;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;

/// A point (r, β) of a steady state, with its numbers of stops, of reversals, and of cycles in its period.
type Place = (f64, f64, (usize, usize, u32));

/// Scenes of 1, 2, 3 and 5 masses, with contacts to wall, base and mass, damped and undamped. Their steady states
/// have two or more stops. The test rounds the scenes' numbers, which raises μ = 1 to 1.0625 in all but the first
/// scene.
const SCENES: &[(&str, bool, &str, &[Place])] = &[
    (
        "block",
        true,
        "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: a, }",
        &[
            (0.3125, 0.4375, (2, 0, 1)),
            (0.125, 0.25, (4, 0, 1)),
            (0.875, 0.875, (2, 0, 1)),
            (1.25, 0.5, (0, 2, 1)),
        ],
    ),
    (
        "block with stiction on a moving base",
        false,
        "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - base, excitation: base,
         damping: modal(0.05), stiction: 1.25, }",
        &[(0.625, 0.25, (2, 0, 1)), (1.5, 1.5, (2, 0, 1))],
    ),
    (
        "frame",
        false,
        "struct A { masses: { a: 3.25, b: 3.5 }, springs: { base - a: 1190.0, a - b: 1323.0 },
         contact: b - wall, excitation: base, damping: modal[0.01, 0.02], stiction: 1.25, }",
        &[(0.375, 0.3125, (2, 0, 1)), (0.9375, 0.625, (2, 0, 1))],
    ),
    (
        "undamped three",
        false,
        "struct A { masses: { a: 1.0, b: 0.75, c: 1.5 },
         springs: { base - a: 1.0, a - b: 0.5, b - c: 0.375, c - wall: 0.25 }, contact: a - c,
         excitation: b, }",
        &[(0.3125, 0.25, (2, 0, 1)), (0.75, 0.75, (2, 0, 1))],
    ),
    (
        "after three cycles",
        true,
        "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: a,
         stiction: 2.0, }",
        &[(0.352, 0.1563, (6, 0, 3))],
    ),
    (
        "after five cycles",
        true,
        "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: base,
         damping: modal(0.03443), stiction: 3.0, }",
        &[(0.25, 0.1521, (18, 0, 5))],
    ),
    (
        "five",
        false,
        "struct A { masses: { a: 1.0, b: 0.5, c: 1.25, d: 0.75, e: 2.0 },
         springs: { base - a: 1.0, a - b: 0.5, b - c: 0.75, c - d: 1.5, d - e: 0.625 }, contact: c - base,
         excitation: base, damping: rayleigh(0.0625, 0.03125), stiction: 1.5, }",
        &[(0.3125, 0.25, (2, 0, 1)), (0.875, 0.75, (2, 0, 1))],
    ),
];

fn answers(orbit: &SystemOrbit<'_, Sensitive>, masses: usize) -> Answers<Sensitive> {
    let mut all = vec![
        (String::from("stuck fraction"), orbit.stuck_fraction()),
        (String::from("origin phase"), orbit.origin()),
        (
            String::from("reversed phase"),
            orbit.reversed_contact_phase(),
        ),
    ];
    // The order of the stops depends on the phase at which the search ended, so the test sorts them.
    let mut stops: Vec<_> = orbit.sticking_intervals().collect();
    stops.sort_by(|(a, _), (b, _)| a.partial_cmp(b).expect("a number"));
    for (place, (start, length)) in stops.into_iter().enumerate() {
        all.push((format!("stop {place} phase"), start));
        all.push((format!("stop {place} length"), length));
    }
    let motions =
        (0..masses).filter_map(|mass| Some((format!("mass {mass}"), orbit.mass_at(mass)?)));
    for (name, motion) in motions.chain([(String::from("contact"), orbit.contact())]) {
        let [early, late] = [0.7, 2.6].map(Sensitive::constant);
        for (question, value) in [
            ("amplitude", motion.amplitude()),
            ("phase", motion.phase()),
            ("displacement", motion.displacement(early)),
            ("velocity", motion.velocity(late)),
        ] {
            all.push((format!("{name} {question}"), value));
        }
        // A symmetric motion has no even harmonics.
        let orders: &[u32] = if orbit.is_symmetric() {
            &[1, 3]
        } else {
            &[0, 1, 2, 3]
        };
        for n in orders {
            let harmonic = motion.harmonic(*n);
            all.push((format!("{name} harmonic {n} re"), harmonic.re));
            all.push((format!("{name} harmonic {n} im"), harmonic.im));
        }
    }
    all
}

/// Returns the answers of a scene without a shifted quantity.
fn values(system: &System, r: Dd, beta: Dd) -> Answers<Dd> {
    let varied = system.unvaried();
    let orbit = varied
        .orbit(Dual::fixed(r), Dual::fixed(beta))
        .expect("an orbit");
    let all = answers(&orbit, system.scene().masses.len());
    all.into_iter()
        .map(|(name, value)| (name, value.value))
        .collect()
}

#[test]
fn of_steady_states() {
    let mut outcome = Outcome::default();
    let mut stopping = 0;
    for (name, plain, text, places) in SCENES {
        let system: System = text.parse().expect("a valid scene");
        let scene = if *plain {
            system.scene().clone()
        } else {
            shortened(text)
        };
        let system = System::<f64>::try_from(scene.clone()).expect("a valid scene");
        let masses = scene.masses.len();
        for (r, beta, seen) in *places {
            let at = system.at(*r).expect("in the domain");
            let orbit = at.orbit(*beta).expect("an orbit");
            let found = (orbit.stops(), orbit.reversals(), orbit.period());
            assert_eq!(found, *seen, "{name}, r = {r}, β = {beta}");
            stopping += usize::from(orbit.stops() > 0);
            let (r, beta) = (Dd::from(*r), Dd::from(*beta));
            // The reference is the steady state in double-double that the motion from rest reaches.
            let exact = System::<Dd>::try_from(scene.clone()).expect("a valid scene");
            let exact = exact.at(r).expect("in the domain");
            let exact = exact.orbit(beta).expect("an orbit");
            for (mass, (_, value)) in values(&system, r, beta)
                .iter()
                .filter(|(name, _)| name.ends_with("amplitude"))
                .take(masses)
                .enumerate()
            {
                let known = exact.mass_at(mass).expect("a mass").amplitude();
                let off = (*value - known).abs().to_f64();
                assert!(off <= 1e-17 * known.to_f64(), "{name}: {off:e}");
            }
            let (fixed_r, fixed_beta) = (Dual::fixed(r), Dual::fixed(beta));
            let mut note =
                |what: &str, dual: Answers<Sensitive>, at: &dyn Fn(Dd) -> Answers<Dd>, unit| {
                    let name = format!("{name}, r = {}, β = {}, {what}", r.to_f64(), beta.to_f64());
                    outcome.join(compare(&name, &dual, at, unit, Side::Both));
                };
            for (quantity, value) in quantities(&scene) {
                if *plain && value == scene.stiction && format!("{quantity:?}") == "Stiction" {
                    continue;
                }
                let varied = system.along(quantity).expect("a quantity of the scene");
                let orbit = varied.orbit(fixed_r, fixed_beta).expect("an orbit");
                note(
                    &format!("{quantity:?}"),
                    answers(&orbit, masses),
                    &|by| {
                        let scene = moved(&scene, quantity, by.to_f64());
                        let system = System::<f64>::try_from(scene).expect("a valid scene");
                        values(&system, r, beta)
                    },
                    value / 16.0,
                );
            }
            let varied = system.unvaried();
            let orbit = varied
                .orbit(Dual::variable(r), fixed_beta)
                .expect("an orbit");
            note(
                "r",
                answers(&orbit, masses),
                &|by| values(&system, r + by, beta),
                r.to_f64() / 16.0,
            );
            let orbit = varied
                .orbit(fixed_r, Dual::variable(beta))
                .expect("an orbit");
            note(
                "β",
                answers(&orbit, masses),
                &|by| values(&system, r, beta + by),
                beta.to_f64() / 16.0,
            );
        }
    }
    println!("{stopping} of the states stop");
    outcome.report("steady states", (3838, 0));
}

/// Checks that the derivatives equal those of the closed form where the contact slides all the time.
#[test]
fn as_the_closed_form() {
    let mut compared = 0;
    for (_, _, text, _) in SCENES {
        let system: System = text.parse().expect("a valid scene");
        for r in [0.55, 1.3] {
            let at = system.at(r).expect("in the domain");
            let limit = at.continuous_limit().min(at.sliding_limit());
            let (r, beta) = (Dual::fixed(Dd::from(r)), Dual::fixed(Dd::from(0.3 * limit)));
            for (quantity, _) in quantities(system.scene()) {
                let varied = system.along(quantity).expect("a quantity of the scene");
                let at = varied.at(r).expect("in the domain");
                let motion = at.motion(beta).expect("continuous");
                let orbit = varied.orbit(r, beta).expect("an orbit");
                assert_eq!((orbit.stops(), orbit.reversals()), (0, 2));
                for mass in 0..system.scene().masses.len() {
                    let (closed, found) = (
                        motion.mass_at(mass).expect("a mass"),
                        orbit.mass_at(mass).expect("a mass"),
                    );
                    // An orbit's harmonics come from a quadrature whose weights are rounded to `f64`. Their tolerance
                    // is therefore wider.
                    for (a, b, tolerance) in [
                        (closed.amplitude(), found.amplitude(), 1e-24),
                        (closed.phase(), found.phase(), 1e-24),
                        (closed.harmonic(3).re, found.harmonic(3).re, 1e-14),
                    ] {
                        let off = (a.slope - b.slope).abs().to_f64();
                        let size = a.slope.abs().to_f64() + closed.amplitude().value.to_f64();
                        assert!(
                            off <= tolerance * size,
                            "{quantity:?}, mass {mass}: {off:e} of {size:e}"
                        );
                        compared += 1;
                    }
                }
            }
        }
    }
    println!("{compared} slopes of orbits are the closed form's");
    assert_eq!(compared, 666);
}

/// Checks that the answer is an error, and never a number, if no derivative exists.
#[test]
fn refused() {
    let refused = |text: &str, r: f64, beta: f64| {
        let system: System = text.parse().expect("a valid scene");
        let varied = system.unvaried();
        let beta = Dual::variable(Dd::from(beta));
        let orbit = varied.orbit(Dual::fixed(Dd::from(r)), beta);
        orbit
            .map(|orbit| (orbit.stops(), orbit.contact().amplitude()))
            .expect_err("no derivative")
    };
    let block = "struct A { masses: { a: 1.0 }, springs: { base - a: 1.0 }, contact: a - wall, excitation: a, }";
    // This steady state is one of a continuum.
    assert_eq!(refused(block, 0.5, 0.1), NoDerivative::Marginal);
    // At the boundary of the continuous regime a stop is about to appear. Both sides of the boundary are refused.
    let system: System = block.parse().expect("a valid scene");
    let limit = system.at(0.875).expect("in the domain").continuous_limit();
    for share in [1.0 - 1e-13, 1.0 + 1e-13] {
        assert_eq!(
            refused(block, 0.875, limit * share),
            NoDerivative::Graze,
            "{share}"
        );
    }
    // A little farther from the boundary, the motion on each side has derivatives.
    for (share, stops) in [(1.0 - 1e-6, 0), (1.0 + 1e-6, 2)] {
        let varied = system.unvaried();
        let beta = Dual::variable(Dd::from(limit * share));
        let orbit = varied
            .orbit(Dual::fixed(Dd::from(0.875)), beta)
            .expect("an orbit");
        let slope = orbit.contact().amplitude().slope.to_f64();
        assert!(
            orbit.stops() == stops && slope.is_finite(),
            "{share}: {slope}"
        );
    }
    // These derivatives are for another r than the steady state.
    let varied = system.unvaried();
    let orbit = system
        .at(0.4)
        .expect("in the domain")
        .orbit(0.4)
        .expect("an orbit");
    let [r, beta] = [0.41, 0.4].map(|value| Dual::fixed(Dd::from(value)));
    let told = varied
        .orbit_along(&orbit, r, beta)
        .expect_err("another r")
        .to_string();
    assert!(
        told.starts_with("the frequency ratio r differs from that of the orbit"),
        "{told}"
    );
    let unbounded = refused(block, 1.0, 0.1).to_string();
    assert!(unbounded.contains("does not bound"), "{unbounded}");
}

//! Tests the responses while the contact is stuck, as products over zeros and poles, at points that the builder of
//! the products did not use.
//!
//! The reference solves the equations of motion in double-double, with the condition that the contact does not move
//! as one more equation. It uses neither receptances nor zeros. At many more points the reference is the exact
//! system. A result may additionally deviate by the change of the exact result for 16 rounding units of r.

use super::accuracy::points;
use super::held_chain::HeldChain;
use super::random;
use super::scenes::scenes;
use frictiongen::System;
use frictiongen::study::table::{Held, HeldForm};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::table::{Factor, Root};
use frictiongen_kernel::{Complex, Float};
use fuzzing::Random;

const RANGE: std::ops::Range<f64> = 0.2..2.5;
/// Number of rounding units of r. The effect of this change of r counts as noise.
const ROUNDINGS: f64 = 16.0;
/// Relative distance from an undamped resonance or antiresonance. At a smaller distance, a rounding unit of r is more
/// than a hundredth of the distance.
const BESIDE: f64 = 1e-14;

/// Motion that elimination gives a mass that does not move, divided by the largest response. It is rounding only.
const STILL: f64 = 1e-14;

/// Worst results of a test.
#[derive(Default)]
struct Tally {
    compared: usize,
    skipped: usize,
    worst: f64,
    failures: Vec<String>,
}

/// Returns the zeros and poles of a form.
fn places<S: Float>(form: &HeldForm<S>) -> Vec<f64> {
    let of_factor = |factor: &Factor<S>| match factor {
        Factor::Zero { at, .. } | Factor::Pair { at, .. } => at.to_f64(),
        Factor::Real { .. } => 0.0,
    };
    let of_root = |root: &Root<S>| match root {
        Root::Pair { at, .. } => at.to_f64(),
        Root::Real { .. } => 0.0,
    };
    match form {
        HeldForm::Fixed(_) => Vec::new(),
        HeldForm::Undamped(product) => {
            let all = product.numerator.iter().chain(&product.denominator);
            all.map(of_factor).collect()
        }
        HeldForm::Damped {
            numerator,
            denominator,
            ..
        } => numerator.iter().chain(denominator).map(of_root).collect(),
    }
}

fn size(a: Complex<Dd>) -> f64 {
    a.re.to_f64().hypot(a.im.to_f64())
}

fn apart(a: Complex<Dd>, b: Complex<Dd>) -> f64 {
    size(Complex::new(a.re - b.re, a.im - b.im))
}

/// Compares all responses of a scene at one r. `expected` has the exact responses at r, and `moved` those at a
/// frequency that is `ROUNDINGS` rounding units away.
fn compare<S: Float>(
    name: &str,
    forms: &[&HeldForm<S>],
    own: S,
    expected: Vec<Complex<Dd>>,
    moved: Vec<Complex<Dd>>,
    allowed: f64,
    tally: &mut Tally,
) {
    let r = own.to_f64();
    // On a pole the response is infinite, so nothing can be compared.
    if !expected.iter().all(|own| size(*own).is_finite()) {
        tally.skipped += 1;
        return;
    }
    let largest = expected.iter().map(|own| size(*own)).fold(1.0, f64::max);
    for (place, form) in forms.iter().enumerate() {
        let (expected, moved) = (expected[place], moved[place]);
        let answer = form.response().value(own);
        let answer = Complex::new(answer.re.to_f64(), answer.im.to_f64());
        let answer = Complex::new(Dd::from(answer.re), Dd::from(answer.im));
        if let HeldForm::Fixed(_) = form {
            // For a mass that does not move, elimination leaves rounding errors. At a relative distance of 10⁻¹² from
            // a resonance half of the 30 digits are lost.
            let off = apart(answer, expected) / largest;
            assert!(off < STILL, "{name}: {place} at {r}: {off:e}");
            tally.compared += 1;
            continue;
        }
        let noise = apart(moved, expected);
        if !(noise < 0.01 * size(expected)) {
            let near = |at: f64| (r / at - 1.0).abs() < 100.0 * BESIDE * ROUNDINGS;
            assert!(places(form).into_iter().any(near), "{name}: {place} at {r}");
            tally.skipped += 1;
            continue;
        }
        let error = (apart(answer, expected) - noise).max(0.0) / size(expected);
        tally.compared += 1;
        tally.worst = tally.worst.max(error);
        if !(error <= allowed) {
            tally.failures.push(format!(
                "{name}: {place} of {} at r = {r:?}: off by {error:e}",
                forms.len()
            ));
        }
    }
}

/// Compares every response of a scene at random points, at the bounds of the range, and next to zeros and poles. The
/// error must be at most `allowed` times the modulus.
fn check<S: Float>(
    (name, text): (&str, &str),
    held: &Held<S>,
    points: usize,
    allowed: f64,
    tally: &mut Tally,
) {
    let system: System<f64> = text.parse().expect("a scene");
    let chain = HeldChain::of(&system);
    let mut random = Random(name.len() as u64 * 7919 + points as u64);
    let mut ratios: Vec<f64> = (0..points)
        .map(|_| random.between(RANGE.start, RANGE.end))
        .collect();
    ratios.extend([RANGE.start, RANGE.end]);
    let forms: Vec<&HeldForm<S>> = held.masses.iter().chain([&held.force]).collect();
    for place in forms.iter().flat_map(|form| places(form)) {
        for beside in [1e-12, -3e-11, 1e-8, -1e-6, 3e-4, -2e-3] {
            ratios.push(place * (1.0 + beside));
        }
    }
    for r in ratios {
        let own = S::constant(r);
        let r = own.to_f64();
        if !(RANGE.start..=RANGE.end).contains(&r) {
            continue;
        }
        let moved = chain.responses(r * (1.0 + ROUNDINGS * f64::EPSILON));
        compare(name, &forms, own, chain.responses(r), moved, allowed, tally);
    }
}

fn told(what: &str, tally: &Tally) {
    println!(
        "{what}: {} compared, {} too close to a zero or pole for the rounding of r; largest error {:.1e} of the modulus",
        tally.compared, tally.skipped, tally.worst
    );
    for failure in tally.failures.iter().take(20) {
        println!("  {failure}");
    }
    assert!(
        tally.failures.is_empty(),
        "{} answers are off",
        tally.failures.len()
    );
    assert!(tally.skipped * 100 < tally.compared);
}

/// Checks that every chain reaches the most accurate table that its scalar type allows.
fn chains<S: Float>(scalar: &str, points: usize, finest: f64) {
    let mut tally = Tally::default();
    for (name, text) in scenes(scalar) {
        let system: System<S> = text.parse().expect("a scene");
        let range = (RANGE.start, RANGE.end);
        let held = Held::<S>::of(system.modal(), range).unwrap_or_else(|| panic!("{name}"));
        assert!(held.keeps(finest), "{name}: {}", held.told());
        check((&name, &text), &held, points, finest, &mut tally);
    }
    told(&format!("44 chains, {scalar}"), &tally);
    assert!(tally.compared > 44 * points);
}

#[test]
fn of_chains() {
    chains::<f64>("f64", 60, 1e-12);
}

#[test]
fn of_chains_in_single_precision() {
    chains::<f32>("f32", 60, 2e-6);
}

/// Checks all chains at many more points. Run it with `cargo test -p generated-tests --test tables stuck_of_chains --
/// --ignored --nocapture`.
#[test]
#[ignore = "a hundred thousand points a scene, half an hour"]
fn stuck_of_chains_whole() {
    chains::<f64>("f64", 100_000, 1e-12);
    chains::<f32>("f32", 100_000, 2e-6);
}

/// Checks at many points that every response of every chain is within 1e-4 of that of the exact system.
fn beside_the_system<S: Float>(scalar: &str, points: usize) {
    let mut tally = Tally::default();
    let wide = |own: Complex<f64>| Complex::new(Dd::from(own.re), Dd::from(own.im));
    for (name, text) in scenes(scalar) {
        let exact: System<f64> = text.parse().expect("a scene");
        let system: System<S> = text.parse().expect("a scene");
        let responses = |r: f64| -> Option<Vec<Complex<Dd>>> {
            let stuck = exact.at(r).expect("in the domain").stuck().ok()?;
            let masses = (0..exact.scene().masses.len()).map(|mass| stuck.mass_at(mass));
            let all = masses.chain([Some(stuck.contact_force())]);
            all.map(|own| own.map(wide)).collect()
        };
        let held = Held::<S>::of(system.modal(), (RANGE.start, RANGE.end));
        let held = held.unwrap_or_else(|| panic!("{name}"));
        let forms: Vec<&HeldForm<S>> = held.masses.iter().chain([&held.force]).collect();
        let mut random = Random(name.len() as u64 * 104_729 + points as u64);
        for _ in 0..points {
            let own = S::constant(random.between(RANGE.start, RANGE.end));
            let r = own.to_f64();
            let moved = r * (1.0 + ROUNDINGS * f64::EPSILON);
            let (Some(expected), Some(moved)) = (responses(r), responses(moved)) else {
                tally.skipped += 1;
                continue;
            };
            compare(&name, &forms, own, expected, moved, 1e-4, &mut tally);
        }
    }
    told(&format!("44 chains beside the system, {scalar}"), &tally);
}

#[test]
fn beside_the_exact_system() {
    beside_the_system::<f64>("f64", points(10_000));
    beside_the_system::<f32>("f32", points(10_000));
}

/// Compares all chains with the exact system at many more points. Run it with `cargo test -p generated-tests --test
/// tables stuck_beside -- --ignored --nocapture`.
#[test]
#[ignore = "a million points a scene, half an hour"]
fn stuck_beside_the_system_whole() {
    beside_the_system::<f64>("f64", points(1_000_000));
    beside_the_system::<f32>("f32", points(1_000_000));
}

/// Checks random scenes, including graphs and overdamped modes. If the products can reach the accuracy, the responses
/// must be within it.
fn random_scenes<S: Float>(scalar: &str, count: usize, points: usize, accuracy: f64, most: usize) {
    let mut random = Random(20_261_123);
    let (mut tally, mut left) = (Tally::default(), 0);
    for number in 0..count {
        let text = random::scene(&mut random);
        let text = text.replace("stiction:", &format!("scalar: {scalar}, stiction:"));
        let system: System<S> = text.parse().expect("a scene");
        let held = Held::<S>::of(system.modal(), (RANGE.start, RANGE.end));
        match held.filter(|held| held.keeps(accuracy)) {
            None => {
                println!("scene {number} is left to the exact formulas");
                left += 1;
            }
            Some(held) => {
                let name = format!("scene {number}");
                check((&name, &text), &held, points, accuracy, &mut tally);
            }
        }
    }
    println!("{left} of {count} scenes left to the exact formulas");
    told(
        &format!("{count} random scenes, {scalar}, {accuracy:e}"),
        &tally,
    );
    assert!(left <= most, "{left}");
}

#[test]
#[ignore = "a sweep, ten seconds or more: .ci/nightly"]
fn of_random_scenes() {
    random_scenes::<f64>("f64", 40, 30, 1e-4, 1);
    random_scenes::<f64>("f64", 40, 30, 1e-9, 1);
    random_scenes::<f32>("f32", 40, 30, 1e-4, 1);
}

/// Checks more random scenes. Run it with `cargo test -p generated-tests --test tables stuck_of_random -- --ignored
/// --nocapture`.
#[test]
#[ignore = "a hundred scenes, minutes"]
fn stuck_of_random_scenes_whole() {
    for accuracy in [1e-2, 1e-4, 1e-6, 1e-9, 1e-12] {
        random_scenes::<f64>("f64", 100, 1000, accuracy, 10);
    }
    for accuracy in [1e-2, 1e-4, 1e-5] {
        random_scenes::<f32>("f32", 100, 1000, accuracy, 10);
    }
}

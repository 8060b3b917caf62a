//! Tests the backward error of steady states with stops, by comparison with the same states in double-double.
//!
//! The derivatives are differences in double-double, with respect to r, β and every number of the description. If a
//! stop begins or ends within rounding, the displaced motion has another sequence of events. The test counts such
//! points and leaves them out.

use crate::backward::fit::fit;
use crate::backward::judge::angle;
use crate::backward::property::BAR;
use crate::backward::random::scene;
use frictiongen::study::{System, orbit::SystemOrbit};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Float, Plain};
use frictiongen_model::scene::{Damping, Scene};
use fuzzing::Random;
use std::collections::BTreeMap;

/// Largest number of masses of a tested chain. Chains with more masses take too long in double-double.
const MASSES: usize = 5;
/// Largest ratio of a natural frequency to the excitation frequency. For faster modes the simulation needs too many
/// steps.
const FASTEST: f64 = 60.0;
/// Relative step of a difference. The relative error of a difference is of the order of the step's square.
const STEP: f64 = 1e-7;
/// Largest Floquet multiplier of a judged point. With a multiplier nearer to 1 the motion from rest hardly reaches
/// the steady state.
const SLOW: f64 = 0.999;

/// Largest fraction of points whose backward error may exceed the accepted one. The rounding errors of many events
/// add up in a steady state.
const ABOVE: f64 = 0.1;
/// Largest backward error of any point in a short run, in rounding units.
const MOST_OF_FEW: f64 = 1024.0;
/// Largest backward error of any point in a long run, in rounding units. In double precision it is 2e-11 of the
/// motion.
const MOST: f64 = 131_072.0;

/// Names of the answers that a steady state gives. Angles come last.
const NAMES: [&str; 9] = [
    "contact amplitude",
    "amplitude",
    "stuck fraction",
    "displacement",
    "velocity",
    "fundamental, real",
    "fundamental, imaginary",
    "third, real",
    "origin",
];

/// Answers that a steady state gives, each with the size whose rounding units measure its error.
type Answers<S> = [(S, S); NAMES.len()];

fn answers<S: Plain>(orbit: &SystemOrbit<'_, S>, mass: usize, tau: S) -> Answers<S> {
    let motion = orbit.mass_at(mass).expect("a mass");
    let (contact, one) = (orbit.contact(), S::constant(1.0));
    let amplitude = motion.amplitude();
    // The largest motion in the chain measures the errors, because the motion of the whole chain determines the
    // stops.
    let largest = (0..)
        .map_while(|mass| orbit.mass_at(mass))
        .map(|motion| motion.amplitude());
    let largest = largest.fold(contact.amplitude(), |most, value| most.max(value));
    let (first, third) = (motion.harmonic(1), motion.harmonic(3));
    [
        (contact.amplitude(), largest),
        (amplitude, largest),
        (orbit.stuck_fraction(), one),
        (motion.displacement(tau), largest),
        (motion.velocity(tau), largest),
        (first.re, largest),
        (first.im, largest),
        (third.re, largest),
        (orbit.origin(), one),
    ]
}

/// Counts for a period: cycles, stops and reversals.
type Pattern = (u32, usize, usize);

fn pattern<S: Float>(orbit: &SystemOrbit<'_, S>) -> Pattern {
    (orbit.period(), orbit.stops(), orbit.reversals())
}

/// Returns the numbers of a description that the test displaces.
fn numbers(scene: &mut Scene) -> Vec<&mut f64> {
    let mut all: Vec<&mut f64> = Vec::new();
    all.extend(scene.masses.iter_mut().map(|mass| &mut mass.value));
    all.extend(scene.springs.iter_mut().map(|spring| &mut spring.stiffness));
    // The test does not displace μ = 1. It is the smallest value, and any larger value changes the rule for a stop.
    if scene.stiction > 1.0 {
        all.push(&mut scene.stiction);
    }
    match &mut scene.damping {
        Damping::None => {}
        Damping::Uniform(zeta) => all.push(zeta),
        Damping::Modal(list) => all.extend(list),
        Damping::Rayleigh { mass, stiffness } => all.extend([mass, stiffness]),
    }
    all.retain(|value| **value != 0.0);
    all
}

/// Reason why the test leaves out a point.
type Left = &'static str;

/// Exact answers, their changes per relative change of each input, and the numbers of events.
struct Exactly {
    pattern: Pattern,
    answers: Answers<Dd>,
    columns: Vec<Answers<Dd>>,
}

fn ask(
    scene: &Scene,
    r: Dd,
    beta: Dd,
    mass: usize,
    tau: Dd,
) -> Result<(Answers<Dd>, Pattern), Left> {
    let system = System::<Dd>::try_from(scene.clone()).map_err(|_| "a scene that is refused")?;
    let at = system.at(r).map_err(|_| "r out of the domain")?;
    let orbit = at
        .orbit(beta)
        .map_err(|_| "no steady state in double-double")?;
    Ok((answers(&orbit, mass, tau), pattern(&orbit)))
}

impl Exactly {
    fn of(scene: &Scene, r: f64, beta: f64, mass: usize, tau: f64) -> Result<Self, Left> {
        let [exact_r, exact_beta, tau] = [r, beta, tau].map(Dd::from);
        let (own, pattern) = ask(scene, exact_r, exact_beta, mass, tau)?;
        let mut columns = Vec::new();
        let count = numbers(&mut scene.clone()).len();
        for input in 0..count + 2 {
            let at = |sign: f64| {
                let displaced = |value: f64| value * (1.0 + sign * STEP);
                let (mut scene, mut r, mut beta) = (scene.clone(), r, beta);
                let value = match input.checked_sub(count) {
                    Some(0) => &mut r,
                    Some(_) => &mut beta,
                    None => numbers(&mut scene).swap_remove(input),
                };
                let before = Dd::from(*value);
                *value = displaced(*value);
                let moved = (Dd::from(*value) - before) / before;
                let (answers, other) = ask(&scene, Dd::from(r), Dd::from(beta), mass, tau)?;
                if other != pattern {
                    return Err("a stop that rounding could make or undo");
                }
                Ok((answers, moved))
            };
            let ((up, plus), (down, minus)) = (at(1.0)?, at(-1.0)?);
            let mut column = own;
            for (index, place) in column.iter_mut().enumerate() {
                let change = difference(index, up[index].0, down[index].0);
                place.0 = change / (plus - minus);
            }
            columns.push(column);
        }
        Ok(Self {
            pattern,
            answers: own,
            columns,
        })
    }
}

/// Returns a − b. The difference of two angles is reduced to at most half a turn.
fn difference(index: usize, a: Dd, b: Dd) -> Dd {
    if NAMES[index] == "origin" {
        angle(a - b)
    } else {
        a - b
    }
}

/// Results of a run over many points.
#[derive(Default)]
struct Seen {
    places: usize,
    /// Largest backward error of each kind of answer, with each answer taken alone.
    alone: BTreeMap<&'static str, (f64, String)>,
    together: (f64, String),
    above: usize,
    skipped: BTreeMap<&'static str, usize>,
}

/// Judges one point of a random scene. Returns the reason if the test leaves the point out.
fn place<S: Plain>(seed: u64, exact: impl Fn(S) -> f64, seen: &mut Seen) -> Result<(), Left> {
    let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x0B17);
    let text = scene(&mut random, 0.5);
    let system: System<S> = text.parse().map_err(|_| "a scene that is refused")?;
    let described = system.scene().clone();
    let masses = described.masses.len();
    if masses > MASSES {
        return Err("more masses than double-double follows");
    }
    let resonances = &system.modal().resonances;
    let r = resonances[random.below(masses)].to_f64() * random.between(0.2, 1.4);
    let r = S::constant(r);
    let fastest = resonances.last().map_or(1.0, |fastest| fastest.to_f64());
    if fastest > FASTEST * exact(r) {
        return Err("modes too fast for double-double");
    }
    let at = system.at(r).map_err(|_| "r out of the domain")?;
    let (low, high) = (exact(at.continuous_limit()), exact(at.sliding_limit()));
    if !(low < high) || !high.is_finite() {
        return Err("no stick-slip between the limits");
    }
    let beta = S::constant(random.between(low, high));
    let mass = random.below(masses);
    let tau = random.between(0.0, 6.0);
    let orbit = at.orbit(beta).map_err(|_| "no steady state")?;
    let largest = orbit
        .multipliers()
        .iter()
        .map(|value| exact(value.re).hypot(exact(value.im)));
    if orbit.is_marginal() || largest.fold(0.0, f64::max) > SLOW {
        return Err("a member of a continuum, or hardly stable");
    }
    let found = answers(&orbit, mass, S::constant(tau));
    let tau = exact(S::constant(tau));
    let exactly = Exactly::of(&described, exact(r), exact(beta), mass, tau)?;
    if pattern(&orbit) != exactly.pattern {
        return Err("another motion in double-double");
    }
    let what = || {
        format!(
            "seed {seed}: r = {:?}, β = {:?}, {text}",
            exact(r),
            exact(beta)
        )
    };
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for (index, name) in NAMES.into_iter().enumerate() {
        let (value, size) = exactly.answers[index];
        let off = difference(index, Dd::from(exact(found[index].0)), value);
        let rounding = size * Dd::from(S::EPSILON);
        let row: Vec<Dd> = exactly
            .columns
            .iter()
            .map(|column| column[index].0 / size)
            .collect();
        let off = off / rounding;
        let sum = row
            .iter()
            .fold(1.0, |sum, slope| sum + slope.abs().to_f64());
        let alone = off.abs().to_f64() / sum;
        let alone = if alone.is_nan() { f64::INFINITY } else { alone };
        let worst = seen.alone.entry(name).or_insert((0.0, String::new()));
        if worst.0 <= alone {
            *worst = (alone, what());
        }
        a.push(row);
        b.push(off);
    }
    let together = fit(&a, &b, BAR);
    if seen.together.0 <= together {
        seen.together = (together, what());
    }
    if together > BAR {
        println!("above: {together:.1}, {}", what());
        seen.above += 1;
    }
    seen.places += 1;
    Ok(())
}

fn run<S: Plain>(seeds: std::ops::Range<u64>, exact: impl Fn(S) -> f64 + Copy) -> Seen {
    let mut seen = Seen::default();
    for seed in seeds {
        if let Err(reason) = place::<S>(seed, exact, &mut seen) {
            *seen.skipped.entry(reason).or_default() += 1;
        }
    }
    println!("{} steady states, skipped: {:?}", seen.places, seen.skipped);
    for (name, (roundings, what)) in &seen.alone {
        println!("{name:>24}: {roundings:.2} roundings of the inputs at {what}");
    }
    println!(
        "all of a place together: {:.2} at {}",
        seen.together.0, seen.together.1
    );
    println!("{} places above {BAR}", seen.above);
    seen
}

fn keeps(seen: &Seen, places: usize, most: f64) {
    assert!(seen.places >= places, "{} steady states only", seen.places);
    let share = seen.above as f64 / seen.places as f64;
    assert!(share <= ABOVE, "{share} of the places are above the bar");
    let worst = seen.alone.values().map(|worst| worst.0);
    let worst = worst.fold(seen.together.0, f64::max);
    assert!(worst <= most, "{worst} roundings");
}

#[test]
fn orbits_in_double_precision() {
    keeps(&run::<f64>(0..12, |value| value), 3, MOST_OF_FEW);
}

#[test]
fn orbits_in_single_precision() {
    keeps(&run::<f32>(0..12, f64::from), 3, MOST_OF_FEW);
}

/// Run with `SCENES=1500 cargo test --release -p generated-tests --test orbits long_orbits -- --ignored --nocapture`.
#[test]
#[ignore = "takes long; the scenes are SCENES"]
fn long_orbits() {
    let scenes = crate::backward::property::asked();
    let all = [
        run::<f64>(scenes.clone(), |value| value),
        run::<f32>(scenes, f64::from),
    ];
    all.iter().for_each(|seen| keeps(seen, 1, MOST));
}

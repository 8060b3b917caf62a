//! Tests that every result of a table is within its declared accuracy.
//!
//! The reference is the exact system in double precision, which is itself uncertain by several rounding units of r.
//! Near a zero of a limit this uncertainty exceeds the accuracy. A result may therefore deviate by two more amounts:
//! the change of the exact result for 16 rounding units of r, and the rounding of a large sum, which matters near
//! zeros of V.

use super::exact::{Exact, turn};
use super::random;
use super::scenes::scenes;
use frictiongen::System;
use frictiongen::study::compiled::CompiledSystem;
use frictiongen::study::table::{FRICTION_SHARES, TableError};
use frictiongen_kernel::Float;
use fuzzing::Random;

/// Number of rounding units of r. If this change of r changes β_lim by more than the accuracy, the builder may refuse
/// the scene.
const UNKNOWN: f64 = 64.0;
/// Accuracy below which the builder may also refuse a scene of ten masses. The motion of the last mass is the
/// remainder of far larger terms that cancel.
const FINE: f64 = 1e-11;
const RANGE: std::ops::Range<f64> = 0.2..2.5;

/// Returns the number of random points for each scene: the environment variable POINTS, or `default`.
pub fn points(default: usize) -> usize {
    let asked = std::env::var("POINTS").ok();
    asked
        .and_then(|points| points.parse().ok())
        .unwrap_or(default)
}

/// Results of a test at one declared accuracy.
struct Tally {
    accuracy: f64,
    points: usize,
    compared: usize,
    /// Number of scenes in which β*_lim is not stored as a product.
    by_sums: usize,
    /// Number of points near a zero at which the exact result is too uncertain.
    skipped: usize,
    /// Largest errors of β_lim, β*_lim, amplitude and phase, each divided by the accuracy.
    worst: [f64; 4],
    failures: Vec<String>,
    /// Scenes for which no table could be built.
    unmet: Vec<String>,
}

impl Tally {
    fn of(accuracy: &f64) -> Self {
        Self {
            accuracy: *accuracy,
            points: 0,
            compared: 0,
            by_sums: 0,
            skipped: 0,
            worst: [0.0; 4],
            failures: Vec::new(),
            unmet: Vec::new(),
        }
    }

    /// Builds the table of a scene. Returns `None` if no table reaches the accuracy.
    fn table<'a, S: Float>(
        &mut self,
        name: &str,
        system: &'a System<S>,
        exact: &System<f64>,
    ) -> Option<CompiledSystem<'a, S>> {
        let accuracy = self.accuracy;
        match system.compile(RANGE, accuracy) {
            Ok(table) => {
                self.by_sums += usize::from(table.tables().sliding.is_none());
                Some(table)
            }
            Err(TableError::NotMet { reached, at, .. }) => {
                let known = moved_by_a_rounding(exact, at);
                let unmet = format!(
                    "{name} at {accuracy:e}: r = {at}, {reached:?}, a rounding of r moves β_lim by {known:.1e}"
                );
                // If the contact hardly touches an undamped mode, a subharmonic of the mode matters only in a
                // relative range of r of 10⁻⁹. No table can follow a function that changes if r changes by a few
                // rounding units.
                let unknown = accuracy < UNKNOWN * known;
                assert!(unknown || accuracy < FINE, "{unmet}");
                self.unmet.push(unmet);
                None
            }
            Err(error) => panic!("{name}: {error}"),
        }
    }

    /// Records one result by its relative error. If the error exceeds the accuracy, the method first subtracts the
    /// noise of the reference.
    fn answer(&mut self, which: usize, error: f64, noise: impl FnOnce() -> f64, place: &Place<'_>) {
        self.compared += 1;
        let mut error = error / self.accuracy;
        if !(error <= 1.0) {
            error -= noise() / self.accuracy;
        }
        self.worst[which] = self.worst[which].max(error);
        if !(error <= 1.0) {
            let which = ["beta_lim", "beta*_lim", "amplitude", "phase"][which];
            let accuracy = self.accuracy;
            let failure = format!("{accuracy:e}, {which}, {place:?}: {error} of the accuracy");
            self.failures.push(failure);
        }
    }

    /// Compares all results of a table at r, which may lie outside the range of the table.
    fn compare<S: Float>(
        &mut self,
        table: &CompiledSystem<'_, S>,
        exact: &Exact<'_>,
        place: &Place<'_>,
    ) {
        let Ok(at) = table.at(S::constant(place.r)) else {
            return;
        };
        self.points += 1;
        let answers = [at.continuous_limit(), at.sliding_limit()];
        for (which, answer) in answers.into_iter().enumerate() {
            let expected = exact.limits[which];
            if expected.is_finite() && expected != 0.0 {
                let error = (answer.to_f64() - expected).abs() / expected;
                let noise = || exact.noise().limits[which] / expected;
                self.answer(which, error, noise, place);
            }
        }
        let Some(asked) = &exact.motion else { return };
        let Ok(motion) = at.motion(S::constant(asked.beta)) else {
            if exact.noise().known {
                let failure = format!("{place:?}: no motion, limits {:?}", at.limits());
                self.failures.push(failure);
            }
            return;
        };
        let Some([amplitude, phase]) = asked.answer else {
            return;
        };
        let contact = motion.contact();
        let errors = [
            (contact.amplitude().to_f64() - amplitude).abs() / amplitude,
            turn(contact.phase().to_f64() - phase),
        ];
        if errors.iter().any(|error| !(*error <= self.accuracy)) && !exact.noise().known {
            return;
        }
        let noise = |which: usize| exact.noise().motion[which] / [amplitude, 1.0][which];
        self.answer(2, errors[0], || noise(0), place);
        self.answer(3, errors[1], || noise(1), place);
    }
}

/// Returns the largest relative change of β_lim if r changes by a rounding unit, near a given r.
fn moved_by_a_rounding(exact: &System<f64>, at: f64) -> f64 {
    let limit = |r: f64| {
        let at = exact.at(r).expect("in the domain");
        at.continuous_limit()
    };
    let moves = (-100..=100).map(|step| {
        let r = at * (1.0 + f64::from(step) * 4.0 * f64::EPSILON);
        (limit(r * (1.0 + f64::EPSILON)) / limit(r) - 1.0).abs()
    });
    moves.fold(0.0, f64::max)
}

/// A point at which tables are compared. `share` is β divided by the smaller limit.
#[derive(Debug)]
struct Place<'a> {
    #[expect(dead_code, reason = "printed")]
    scene: &'a str,
    r: f64,
    share: f64,
}

/// Compares the tables of a scene, one for each tally. All tables are compared at the same points, because the exact
/// results take most of the time.
fn check<S: Float>(name: &str, text: &str, points: usize, tallies: &mut [Tally]) {
    let exact: System<f64> = text.parse().expect("a scene");
    let system: System<S> = text.parse().expect("a scene");
    let tables: Vec<_> = tallies
        .iter_mut()
        .map(|tally| tally.table(name, &system, &exact))
        .collect();
    let mut random = Random(name.len() as u64 * 7919 + points as u64);
    let ratios = (0..points).map(|_| random.between(RANGE.start, RANGE.end));
    let mut ratios: Vec<f64> = ratios.collect();
    // The points are bounds, zeros, kinks and resonances, each with neighbours.
    let pieces = tables.iter().flatten().flat_map(|table| {
        let pieces = &table.tables().pieces;
        pieces.iter().map(|piece| piece.from.to_f64())
    });
    let resonances = exact
        .resonances()
        .iter()
        .flat_map(|r| [1.0, 3.0, 5.0, 7.0, 9.0].map(|order| r / order));
    for place in pieces.chain(resonances).chain([RANGE.start, RANGE.end]) {
        let epsilon = S::EPSILON;
        for beside in [
            0.0, epsilon, -epsilon, 1e-9, -1e-9, 1e-6, -1e-6, 1e-4, -1e-4,
        ] {
            ratios.push(place * (1.0 + beside));
        }
    }
    for r in ratios {
        let place = Place {
            scene: name,
            r: S::constant(r).to_f64(),
            share: FRICTION_SHARES[random.below(FRICTION_SHARES.len())],
        };
        if !tables
            .iter()
            .flatten()
            .any(|table| table.at(S::constant(place.r)).is_ok())
        {
            continue;
        }
        let found = Exact::at::<S>(&exact, place.r, place.share);
        for (tally, table) in tallies.iter_mut().zip(&tables) {
            match (&found, table) {
                (Some(found), Some(table)) => tally.compare(table, found, &place),
                (None, Some(_)) => tally.skipped += 1,
                (_, None) => {}
            }
        }
    }
}

fn told(what: &str, tally: &Tally) {
    let [limit, sliding, amplitude, phase] = tally.worst;
    println!(
        "{what}: {} points, {} skipped, {} answers compared; largest errors over the accuracy: limit {limit:.3}, sliding {sliding:.3}, amplitude {amplitude:.3}, phase {phase:.3}; {} without a table",
        tally.points,
        tally.skipped,
        tally.compared,
        tally.unmet.len(),
    );
    for unmet in &tally.unmet {
        println!("  no table: {unmet}");
    }
    for failure in tally.failures.iter().take(20) {
        println!("  {failure}");
    }
}

/// Checks every chain at `each` of the accuracies. From chain to chain the accuracies take turns.
fn chains<S: Float>(budgets: &[f64], each: usize, default: usize) {
    let count = points(default);
    let mut tallies: Vec<Tally> = budgets.iter().map(Tally::of).collect();
    let scalar = if S::EPSILON > 1e-10 { "f32" } else { "f64" };
    for (number, (name, text)) in scenes(scalar).into_iter().enumerate() {
        check::<S>(&name, &text, count, &mut tallies[..each]);
        // The kinds of chains repeat. An additional turn for every eleventh chain lets each accuracy meet every kind.
        let turn = each + usize::from(number % 11 == 10);
        tallies.rotate_left(turn % budgets.len());
    }
    for tally in tallies {
        let accuracy = tally.accuracy;
        told(&format!("44 chains, {scalar}, {accuracy:e}"), &tally);
        let chains = 44 * each / budgets.len();
        assert!(tally.compared >= (chains - 2) * 4 * count / 2);
        assert_eq!(tally.by_sums, 0);
        assert!(
            tally.failures.is_empty(),
            "{} answers are off",
            tally.failures.len()
        );
        // Near zeros of some undamped scenes, 1e-12 is beyond double precision.
        assert!(accuracy < FINE || tally.unmet.is_empty());
    }
}

fn random_scenes(scene: fn(&mut Random) -> String, budgets: &[f64], count: usize, default: usize) {
    let mut tallies: Vec<Tally> = budgets.iter().map(Tally::of).collect();
    let mut random = Random(20_211_122);
    for number in 0..count {
        let text = scene(&mut random);
        let name = format!("scene {number}");
        check::<f64>(&name, &text, points(default), &mut tallies);
    }
    for tally in tallies {
        let accuracy = tally.accuracy;
        told(&format!("{count} random scenes, {accuracy:e}"), &tally);
        println!("{} scenes with sums for β*_lim", tally.by_sums);
        assert!(tally.by_sums * 10 <= count, "{}", tally.by_sums);
        assert!(
            tally.failures.is_empty(),
            "{} answers are off",
            tally.failures.len()
        );
        let most = if accuracy < 1e-5 {
            count / 6
        } else {
            count / 50
        };
        assert!(
            tally.unmet.len() <= most,
            "{} without a table",
            tally.unmet.len()
        );
    }
}

#[test]
#[ignore = "a sweep, ten seconds or more: .ci/nightly"]
fn of_chains() {
    chains::<f64>(&[1e-2, 1e-4, 1e-6, 1e-9], 2, 50);
}

#[test]
#[ignore = "a sweep, ten seconds or more: .ci/nightly"]
fn of_chains_in_single_precision() {
    chains::<f32>(&[1e-2, 1e-3, 1e-4, 1e-5], 2, 50);
}

#[test]
fn of_random_scenes() {
    random_scenes(random::scene, &[1e-3, 1e-6], 10, 200);
}

/// Checks tables of scenes whose damping acts relative to the moving base.
#[test]
fn of_damping_from_the_base() {
    random_scenes(random::damped_from_base, &[1e-3, 1e-6], 8, 200);
}

#[test]
#[ignore = "a million points a scene: POINTS=1000000, ten times as long"]
fn of_chains_whole() {
    chains::<f64>(&[1e-2, 1e-3, 1e-4, 1e-6, 1e-9, 1e-12], 6, 100_000);
}

#[test]
#[ignore = "a million points a scene: POINTS=1000000, ten times as long"]
fn of_chains_in_single_precision_whole() {
    chains::<f32>(&[1e-2, 1e-3, 1e-4, 1e-5], 4, 100_000);
}

#[test]
#[ignore = "a hundred scenes"]
fn of_random_scenes_whole() {
    random_scenes(random::scene, &[1e-2, 1e-3, 1e-4, 1e-6, 1e-9], 100, 100_000);
}

/// Checks a mode that the contact drives and the load does not. Its resonance is a pole of H but not of V, so that
/// β*_lim vanishes at the resonance.
#[test]
fn of_a_mode_that_the_load_does_not_drive() {
    for damping in ["none", "modal(0.03)"] {
        let text = format!(
            "struct Symmetric {{ masses: {{ a: 1, c: 2, b: 1 }},
            springs: {{ base - a: 1, a - c: 1, c - b: 1, wall - b: 1 }},
            contact: a - wall, excitation: c, damping: {damping} }}"
        );
        let mut tallies = [Tally::of(&1e-4)];
        check::<f64>("Symmetric", &text, 2000, &mut tallies);
        let [tally] = tallies;
        told(&format!("a symmetric chain, {damping}"), &tally);
        assert_eq!((tally.by_sums, tally.unmet.len()), (0, 0));
        assert!(tally.failures.is_empty());
    }
}

/// Checks a chain in which one of several modes is undamped. β_lim vanishes at the subharmonics of that mode, whatever
/// the damping of the other modes.
#[test]
fn of_one_undamped_mode_among_damped_ones() {
    let text = "struct Mixed { masses: { a: 1, b: 2, c: 1 },
        springs: { base - a: 1, a - b: 1, b - c: 2 },
        contact: c - wall, excitation: a, damping: modal[0.02, 0, 0.05] }";
    let mut tallies = [1e-2, 1e-4, 1e-6].map(|accuracy| Tally::of(&accuracy));
    check::<f64>("Mixed", text, 2000, &mut tallies);
    for tally in tallies {
        let accuracy = tally.accuracy;
        told(&format!("one undamped mode of three, {accuracy:e}"), &tally);
        assert!(tally.unmet.is_empty() && tally.failures.is_empty());
    }
}

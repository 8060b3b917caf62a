//! Random scenes with one to eight masses and an elastic contact in every place.

use super::energy::unbalanced;
use frictiongen::{NoOrbit, System};
use rand::rngs::ChaCha8Rng;
use rand::{RngExt as _, SeedableRng};

/// Returns the text of a random chain, with r and β for it.
pub fn scene(random: &mut ChaCha8Rng) -> (String, f64, f64) {
    let count = random.random_range(1..=8_usize);
    let number =
        |random: &mut ChaCha8Rng, from: f64, to: f64| from * (to / from).powf(random.random());
    let masses: Vec<_> = (0..count)
        .map(|i| format!("m{i}: {:?}", number(random, 0.3, 3.0)))
        .collect();
    let springs: Vec<_> = (0..count)
        .map(|i| {
            let from = if i == 0 {
                "base".to_owned()
            } else {
                format!("m{}", i - 1)
            };
            format!("{from} - m{i}: {:?}", number(random, 0.3, 3.0))
        })
        .collect();
    let on = random.random_range(0..count);
    let other = match random.random_range(0..3) {
        0 => "wall".to_owned(),
        1 => "base".to_owned(),
        _ if count > 1 => format!("m{}", (on + 1) % count),
        _ => "wall".to_owned(),
    };
    let excitation = match random.random_range(0..2) {
        0 => "base".to_owned(),
        _ => format!("m{}", random.random_range(0..count)),
    };
    let damping = match random.random_range(0..4) {
        0 => "none".to_owned(),
        1 => format!("modal({:?})", number(random, 1e-3, 0.2)),
        2 => format!(
            "rayleigh({:?}, {:?})",
            number(random, 1e-3, 0.1),
            number(random, 1e-3, 0.1)
        ),
        _ => format!("modal({:?})", number(random, 0.3, 0.8)),
    };
    let stiction = if random.random() {
        1.0
    } else {
        number(random, 1.0, 1.5)
    };
    let stiffness = number(random, 0.03, 300.0);
    let text = format!(
        "struct Random {{ masses: {{ {} }}, springs: {{ {} }}, contact: m{on} - {other}, stiffness: {stiffness:?},
            excitation: {excitation}, damping: {damping}, stiction: {stiction:?}, provide: [orbit, simulation] }}",
        masses.join(", "),
        springs.join(", ")
    );
    (text, number(random, 0.2, 2.5), number(random, 0.02, 1.5))
}

fn balanced(seed: u64, count: usize) -> usize {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let (mut worst, mut events) = (0.0_f64, 0);
    for index in 0..count {
        let (text, r, beta) = scene(&mut random);
        let system: System = text.parse().expect("a scene");
        let (lacking, found) = unbalanced(&system, r, beta, 2.0);
        assert!(
            lacking < 1e-11,
            "scene {index}: {lacking:e} at r = {r}, beta = {beta}: {text}"
        );
        worst = worst.max(lacking);
        events += found;
    }
    println!("{count} scenes, {events} events: the energy balance lacks at most {worst:e}");
    events
}

#[test]
fn energy_is_balanced() {
    assert!(balanced(45, 40) > 100);
}

#[test]
#[ignore = "ten thousand scenes take minutes"]
fn energy_is_balanced_in_ten_thousand_scenes() {
    assert!(balanced(46, 10_000) > 25_000);
}

/// Reasons why a random scene has no steady state.
#[derive(Debug, Default)]
struct Ends {
    settled: usize,
    unsettled: usize,
    too_many_events: usize,
    unbounded: usize,
    undamped: usize,
    unstable: usize,
}

/// Asks random scenes for their steady states from rest, in both precisions. A scene without one gives a named reason.
/// Returns the numbers of answers, and the differences of amplitudes and sticking fractions between the precisions.
fn answered(seed: u64, count: usize) -> (Ends, Vec<f64>) {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let (mut ends, mut apart) = (Ends::default(), Vec::new());
    for index in 0..count {
        let (text, r, beta) = scene(&mut random);
        let double: System = text.parse().expect("a scene");
        let single: System<f32> = text.parse().expect("a scene");
        let answer = double.at(r).expect("in the domain").orbit(beta);
        let narrow = single
            .at(r as f32)
            .expect("in the domain")
            .orbit(beta as f32);
        match &answer {
            Ok(orbit) => {
                assert!(
                    orbit.contact().amplitude().is_finite(),
                    "scene {index}: {text}"
                );
                ends.settled += 1;
            }
            Err(NoOrbit::Unsettled) => ends.unsettled += 1,
            Err(NoOrbit::TooManyEvents) => ends.too_many_events += 1,
            Err(NoOrbit::Unbounded) => ends.unbounded += 1,
            Err(NoOrbit::Undamped(_)) => ends.undamped += 1,
            Err(NoOrbit::Unstable) => ends.unstable += 1,
            Err(other) => {
                panic!("scene {index}: {other} at r = {r}, beta = {beta}: {text}")
            }
        }
        let (Ok(wide), Ok(narrow)) = (answer, narrow) else {
            continue;
        };
        if (wide.stops(), wide.period()) == (narrow.stops(), narrow.period()) {
            let size = wide.contact().amplitude();
            let difference = f64::from(narrow.contact().amplitude()) / size - 1.0;
            let share = f64::from(narrow.stuck_fraction()) - wide.stuck_fraction();
            apart.push(difference.abs().max(share.abs()));
        }
    }
    apart.sort_by(f64::total_cmp);
    (ends, apart)
}

/// Half of the scenes agree to 1e-5 between the precisions, and 19 of 20 to 1e-2: near a resonance of an undamped scene,
/// the rounding of r alone moves the amplitude.
fn agree(seed: u64, count: usize) {
    let (ends, apart) = answered(seed, count);
    let at = |share: f64| apart[(share * (apart.len() - 1) as f64) as usize];
    println!(
        "{ends:?}; f32 against f64: {:e}, {:e}, {:e} at 50, 95, 100 %",
        at(0.5),
        at(0.95),
        at(1.0)
    );
    assert!(count * 9 / 10 < ends.settled);
    assert!(count * 3 / 4 < apart.len() && at(0.5) < 1e-5 && at(0.95) < 1e-2);
}

#[test]
fn every_scene_has_a_state_or_a_named_reason() {
    agree(47, 60);
}

#[test]
#[ignore = "ten thousand scenes take minutes"]
fn ten_thousand_scenes_have_a_state_or_a_named_reason() {
    agree(48, 10_000);
}

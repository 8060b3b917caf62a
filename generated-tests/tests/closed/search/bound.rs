//! Tests a scene's own bound on the number of evaluations of a search. No search exceeds the bound, few searches come
//! near it, and at usual frequencies every search ends with a result.

use crate::search::random::random_scene;
use frictiongen::study::System;
use frictiongen::{Effort, FrictionSystem, friction_system};
use frictiongen_kernel::modal_sum::search::{MAX_EVALUATIONS, Peak};
use fuzzing::Random;

/// Number of half turns of the fastest mode in a half period up to which every search must finish.
const USUAL: f64 = 1e5;

/// Numbers of evaluations in the searches for a limit or for an amplitude.
#[derive(Default)]
struct Counts {
    /// Number of evaluations of each search that was needed.
    all: Vec<u32>,
    /// Number of searches without a result. A search may fail only for more half turns than [`USUAL`].
    given_up: u32,
    /// Largest ratio of the evaluations of a search to the bound on them.
    nearest: f64,
}

impl Counts {
    fn add(&mut self, peak: &Peak<f64>, most: u32, usual: bool, what: &str) {
        let Peak {
            evaluations,
            exceeded,
            ..
        } = *peak;
        assert!(evaluations <= most, "{evaluations} of {most}: {what}");
        assert!(!(exceeded && usual), "{evaluations} of {most}: {what}");
        assert_eq!(exceeded, peak.effort() == Effort::Exceeded);
        self.given_up += u32::from(exceeded);
        if most > 0 && usual {
            self.all.push(evaluations);
            self.nearest = self.nearest.max(f64::from(evaluations) / f64::from(most));
        }
    }

    /// Returns the median, the 99 % quantile and the maximum of the numbers of evaluations.
    fn quantiles(&mut self) -> [u32; 3] {
        self.all.sort_unstable();
        let n = self.all.len();
        [n / 2, n * 99 / 100, n - 1].map(|at| self.all[at])
    }
}

/// Returns a frequency ratio at which searches are long: far below the resonances, near resonances and subharmonics,
/// or far above the resonances. Far above, the motion of a mass is a small remainder of large terms.
fn frequency(random: &mut Random, resonances: &[f64], kind: usize) -> f64 {
    let one = resonances[random.below(resonances.len())];
    let beside = 1.0 + random.signed() * random.log_uniform(1e-15, 1e-2);
    let last = resonances[resonances.len() - 1];
    match kind % 7 {
        0 => one * beside,
        1 => one / (2.0 + random.below(12) as f64) * beside,
        2 => one / (1.0 + random.below(40) as f64),
        3 => resonances[0] * random.log_uniform(1e-6, 1.0),
        4 => last * random.log_uniform(1.0, 1e3),
        5 => last * 0.5 * beside,
        _ => resonances[0] * random.log_uniform(1e-3, 10.0),
    }
}

fn run(scenes: usize, masses: usize) -> [Counts; 2] {
    let mut random = Random(20_261_122);
    let [mut limit, mut amplitude] = [Counts::default(), Counts::default()];
    let mut without = 0;
    for _ in 0..scenes {
        let text = random_scene(&mut random, masses);
        let system: System = text.parse().unwrap();
        for kind in 0..14 {
            let r = frequency(&mut random, system.resonances(), kind);
            let at = system.at(r).unwrap();
            let most = at.most_evaluations();
            assert!(most.limit.max(most.amplitude) <= MAX_EVALUATIONS);
            // The bound at r is valid for every larger r.
            let more = system.at(r * random.log_uniform(1.0, 10.0)).unwrap();
            let more = more.most_evaluations();
            assert!(more.limit <= most.limit && more.amplitude <= most.amplitude);
            let usual = at.modes().iter().all(|mode| mode.x < USUAL / 5.0);
            let what = format!("r = {r:?}, {text}");
            limit.add(&at.velocity_constraint(), most.limit, usual, &what);
            without += u32::from(most.limit == 0);
            let share = [1e-3, 0.5, 1.0 - 1e-9][kind % 3];
            let beta = share * at.continuous_limit().min(at.sliding_limit());
            let Ok(motion) = at.motion(beta) else {
                continue;
            };
            for index in 0..system.masses() {
                let Ok(mass) = motion.mass(&format!("m{index}")) else {
                    continue;
                };
                amplitude.add(&mass.peak(), most.amplitude, usual, &what);
            }
        }
    }
    for (name, counts) in [("β_lim", &mut limit), ("amplitude", &mut amplitude)] {
        let [median, most, worst] = counts.quantiles();
        println!(
            "{name}: {} searches, median {median}, 99 % at most {most}, worst {worst}, {:.3} of its bound; {} given up",
            counts.all.len(),
            counts.nearest,
            counts.given_up
        );
    }
    println!("{without} limits without a search");
    assert!(without > 0);
    [limit, amplitude]
}

/// Asserts the median, the 99 % quantile and the maximum that the documentation of `most_evaluations` states. The
/// asserted bounds are a quarter larger.
fn agreed([limit, amplitude]: &mut [Counts; 2]) {
    for (counts, said) in [(limit, [3, 110, 275]), (amplitude, [10, 40, 400])] {
        let found = counts.quantiles();
        assert!(
            found.iter().zip(said).all(|(found, said)| *found <= said),
            "{found:?}, not {said:?}"
        );
        assert!(counts.nearest < 0.5, "{}", counts.nearest);
    }
}

#[test]
fn no_search_exceeds_its_scenes_bound() {
    let mut found = run(400, 16);
    // Slow sweeps of undamped scenes reach the bound, which shows that it takes effect there.
    assert!(found[0].given_up > 0, "no search was stopped");
    agreed(&mut found);
}

#[test]
#[ignore = "twenty thousand scenes: some minutes"]
fn no_search_exceeds_its_scenes_bound_at_length() {
    agreed(&mut run(10_000, 16));
    agreed(&mut run(10_000, 4));
    // Scenes with more masses have more masses far from load and contact, so the quantiles are larger.
    let [limit, amplitude] = run(300, 64);
    assert!(limit.nearest < 0.5 && amplitude.nearest < 0.5);
}

friction_system! {
    struct Frame {
        masses: { a: 1, b: 0.7, c: 0.3 },
        springs: { base - a: 1, a - b: 2, b - c: 0.6 },
        contact: b - wall,
        excitation: base,
        damping: modal[0.02, 0.05, 1.4],
        scalar: f32,
    }
}

/// Checks that an emitted scene in single precision states one bound for a whole range of r.
#[test]
fn an_emitted_scene_says_it_for_its_range() {
    let most = Frame::at(0.05).unwrap().most_evaluations();
    // The fastest mode makes √λ_max(1 + 2·1.4)/0.05 half turns, and 16 half turns need one evaluation.
    let fastest = Frame::RESONANCES[2] * (1.0 + 2.0 * 1.4) / 0.05;
    let more = (fastest / 16.0) as u32;
    assert!(more > 5, "{more}");
    assert_eq!((most.limit, most.amplitude), (256 + more, 1024 + more));
    let (mut searched, mut worst) = (0, [0, 0]);
    for step in 0..4000 {
        let at = Frame::at(0.05 + 0.001 * step as f32).unwrap();
        let (limits, effort) = at.limits_searched();
        let Effort::Bounded(count) = effort else {
            panic!("{effort:?}");
        };
        worst[0] = worst[0].max(count);
        if let Ok(motion) = at.motion(0.5 * limits.continuous.min(limits.sliding)) {
            let Effort::Bounded(count) = motion.c().largest().effort else {
                panic!("given up");
            };
            worst[1] = worst[1].max(count);
            searched += 1;
        }
    }
    println!("{searched} motions; at most {worst:?} of {most:?}");
    assert!(searched > 3000 && worst[0] > 0 && worst[1] > 0);
    assert!(worst[0] <= most.limit && worst[1] <= most.amplitude);
}

/// Checks the bound at both limits of the range of r, and for an invalid r.
#[test]
fn a_bound_at_the_ends() {
    let ends = |r: f32| Frame::at(r).unwrap().most_evaluations();
    assert_eq!(ends(0.0).limit, MAX_EVALUATIONS);
    assert_eq!(ends(0.0).amplitude, MAX_EVALUATIONS);
    assert_eq!(ends(f32::INFINITY).limit, 256);
    assert_eq!(ends(f32::INFINITY).amplitude, 1024);
    assert!(Frame::at(f32::NAN).is_err() && Frame::at(-1.0).is_err());
}

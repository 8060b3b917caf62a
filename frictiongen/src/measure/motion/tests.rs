//! Tests fits to recordings that a stepper has computed.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use super::model::MotionProblem;
use super::{MotionFit, solve};
use crate::measure::{Channel, MeasureError, Recording, Unit};
use crate::study::optimum::Tunable;
use crate::study::sensitivity::Quantity;
use crate::study::{System, SystemInput};
use std::time::Instant;

/// Scene from which the tests compute recordings. The motion depends on every number of the scene.
const FRAME: &str = "struct Frame {
    masses: { lower: 3.0, upper: 2.0 }, springs: { base - lower: 1200, lower - upper: 900 },
    contact: upper - wall, excitation: base, damping: modal(0.02), stiction: 1.3,
}";
const FRICTION: f64 = 6.0;
const DT: f64 = 0.01;

/// Random numbers with approximately the standard normal distribution. Each number is the sum of twelve uniform
/// numbers, minus 6 (xorshift, Marsaglia 2003).
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        let uniform = |_| {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            (self.0 >> 11) as f64 / 9_007_199_254_740_992.0
        };
        (0..12).map(uniform).sum::<f64>() - 6.0
    }
}

fn channel(name: &str, unit: &str, samples: Vec<f64>) -> Channel {
    Channel {
        name: name.to_owned(),
        unit: unit.parse::<Unit>().unwrap(),
        samples,
    }
}

/// Returns a recording of the base in m/s, of the upper mass's displacement in mm and of the lower mass's velocity in
/// m/s. The noise of each mass has a standard deviation of `noise` times the largest value of its channel.
fn recorded(system: &System, samples: usize, noise: f64, seed: u64) -> Recording {
    // The velocity of the base in m/s has two components, of 11 and 17.3 rad/s. Their amplitudes decrease at 1.5 s.
    let velocity = |sample: usize| {
        let time = sample as f64 * DT;
        let size = if time < 1.5 { 0.15 } else { 0.1 };
        size * ((11.0 * time).sin() + 0.6 * (17.3 * time).sin()) * (time / 0.2).min(1.0)
    };
    let base: Vec<f64> = (0..samples).map(velocity).collect();
    let only_base =
        Recording::inputs(1.0 / DT, vec![channel("base", "m/s", base.clone())]).unwrap();
    let inputs = crate::measure::Inputs::of(&only_base, system, Some(FRICTION)).unwrap();
    let mut stepper = inputs.stepper(system).unwrap();
    let (mut upper, mut lower, mut events) = (vec![0.0], vec![0.0], 0);
    for sample in 1..samples {
        events += stepper.advance(inputs.at(sample)).unwrap().events;
        upper.push(1e3 * stepper.mass_at(1).displacement());
        lower.push(stepper.mass_at(0).velocity());
    }
    assert!(samples / 30 <= events as usize, "{events} events");
    let mut random = Noise(seed);
    for values in [&mut upper, &mut lower] {
        let most = values
            .iter()
            .fold(0.0_f64, |most, value| most.max(value.abs()));
        for value in values.iter_mut().skip(1) {
            *value += noise * most * random.next();
        }
    }
    let channels = vec![
        channel("base", "m/s", base),
        channel("upper", "mm", upper),
        channel("lower", "m/s", lower),
    ];
    Recording::inputs(1.0 / DT, channels).unwrap()
}

/// Returns a scene with wrong numbers as the first guess, and the numbers that the fit has to find.
fn guess(system: &System) -> (System, Vec<Tunable>) {
    let names = ["mu", "k2", "zeta", "m upper"];
    let vary: Vec<Tunable> = names.map(|name| system.tunable_named(name).unwrap()).into();
    let mut guess = system.clone();
    for (tunable, value) in vary.iter().zip([1.25, 930.0, 0.03, 2.05]) {
        guess = guess.with_value(*tunable, value).unwrap();
    }
    (guess, vary)
}

/// Prints the numbers of runs of a fit, and its time.
fn told(fit: &MotionFit, started: Instant) {
    println!(
        "{} runs, {} of them differences, {} exact derivatives, {:.3} s, scatter {:e}",
        fit.runs,
        fit.differences,
        fit.derivatives,
        started.elapsed().as_secs_f64(),
        fit.scatter
    );
}

/// Checks the exact derivatives of the residuals against central differences. Then fits once with exact derivatives and
/// once with finite differences, and prints the number of runs and the time of both fits.
#[test]
fn derivatives_and_differences() {
    let system: System = FRAME.parse().unwrap();
    let recording = recorded(&system, 300, 0.0, 1);
    let (guess, vary) = guess(&system);
    let problem =
        |exact| MotionProblem::new(&guess, &recording, (Some(5.2), &vary), exact).unwrap();
    let exact = problem(true);
    let start = exact.start().unwrap();
    let lines = exact.linearise(&start).unwrap();
    assert_eq!(exact.count().differences, 0);
    let mut worst = 0.0_f64;
    for (index, value) in start.iter().enumerate() {
        let step = 1e-6 * value;
        let at = |by: f64| {
            let mut moved = start.clone();
            moved[index] += by;
            exact.residuals(&moved).unwrap()
        };
        let expected = (at(step) - at(-step)) / (2.0 * step);
        let found = lines.jacobian.column(index);
        worst = worst.max((&expected - found).norm() / found.norm());
    }
    println!("largest relative difference of a column: {worst:e}");
    // The central differences have a relative error of about 1e-10 from rounding. Because the instants of stops,
    // break-aways and reversals change, a further relative error of 1e-6 results.
    assert!(worst < 1e-5, "{worst:e}");

    let solved = [true, false].map(|exact| {
        let started = Instant::now();
        let fit = solve(&problem(exact)).unwrap();
        told(&fit, started);
        fit
    });
    let [exact, differences] = solved;
    assert_eq!((exact.differences, differences.derivatives), (0, 0));
    for (fit, near) in [(&exact, 1e-9), (&differences, 1e-5)] {
        let found = std::iter::once(fit.friction.unwrap().value);
        let found = found.chain(fit.numbers.iter().map(|(_, number)| number.value));
        for (found, expected) in found.zip([FRICTION, 1.3, 900.0, 0.02, 2.0]) {
            assert!(
                (found - expected).abs() < near * expected,
                "{found} instead of {expected}"
            );
        }
    }
}

/// Number of noisy recordings whose intervals are counted.
const SEEDS: u64 = 24;

/// Checks that exact derivatives and finite differences lead to the same minimum of a noisy recording.
#[test]
fn one_minimum_under_noise() {
    let system: System = FRAME.parse().unwrap();
    let (guess, vary) = guess(&system);
    let recording = recorded(&system, 240, 0.018, 7919);
    let [fit, other] = [true, false].map(|exact| {
        let problem = MotionProblem::new(&guess, &recording, (Some(6.6), &vary), exact).unwrap();
        let started = Instant::now();
        let fit = solve(&problem).unwrap();
        told(&fit, started);
        fit
    });
    assert_eq!(fit.differences, 0);
    // A forward difference has a relative error of about 1e-6.
    assert!((fit.scatter / other.scatter - 1.0).abs() < 1e-6);
}

/// Checks that the 95 % intervals of fits to noisy recordings contain the true numbers in 95 % of the cases.
#[test]
fn intervals_under_noise() {
    let system: System = FRAME.parse().unwrap();
    let (guess, vary) = guess(&system);
    let truth = [FRICTION, 1.3, 900.0, 0.02, 2.0];
    let mut outside = [0_usize; 5];
    for seed in 1..=SEEDS {
        let recording = recorded(&system, 240, 0.018, 7919 * seed);
        let problem = MotionProblem::new(&guess, &recording, (Some(6.6), &vary), true).unwrap();
        let fit = solve(&problem).unwrap();
        // At the true numbers, only the noise remains in the residuals. A fit of only five unknowns reduces the
        // residuals by at most 3 %.
        let noise = problem.residuals(&truth).unwrap().norm() / (problem.data() as f64).sqrt();
        assert!((0.97..=1.0).contains(&(fit.scatter / noise)));
        let numbers = fit.numbers.iter().map(|(_, number)| *number);
        let all = std::iter::once(fit.friction.unwrap()).chain(numbers);
        for ((found, expected), missed) in all.zip(truth).zip(&mut outside) {
            let width = found.to - found.from;
            assert!(width < 0.2 * expected, "{found:?} for {expected}");
            *missed += usize::from(!found.holds(expected));
        }
    }
    println!("of {SEEDS} intervals of each number, these miss it: {outside:?}");
    // A number misses more than 5 of 24 intervals with a probability of 0.1 %, and none of the 120 intervals misses with
    // a probability of about 0.2 %.
    assert!(outside.iter().all(|missed| *missed <= 5), "{outside:?}");
    assert!(outside.iter().any(|missed| *missed >= 1), "{outside:?}");
}

/// Checks the fit if the force of the stuck contact just reaches μF. No derivative exists there, so that the fit must
/// use a finite difference and report it.
#[test]
fn a_motion_that_grazes_an_event() {
    let system: System = "struct Block {
        masses: { block: 1 }, springs: { base - block: 400 }, contact: block - wall, excitation: base,
        stiction: 1.25,
    }"
    .parse()
    .unwrap();
    // At 0.4 s the base reverses at about 10 mm, where the spring pulls with about 4 N. Later the base moves farther.
    let samples = 160;
    let base: Vec<f64> = (0..samples)
        .map(|sample| {
            let time = f64::from(sample) * DT;
            let turn = std::f64::consts::PI / 0.4;
            let slow = 5e-3 * turn * (turn * time).sin();
            if time < 0.8 { slow } else { 3.0 * slow }
        })
        .collect();
    // The base moves in parabolas under its velocities.
    let places = base.windows(2).scan(0.0, |place, pair| {
        *place += 0.5 * DT * (pair[0] + pair[1]);
        Some(*place)
    });
    let farthest = places.take((0.6 / DT) as usize).fold(0.0, f64::max);
    let motion = |friction: f64| {
        let only = vec![channel("base", "m/s", base.clone())];
        let only = Recording::inputs(1.0 / DT, only).unwrap();
        let inputs = crate::measure::Inputs::of(&only, &system, Some(friction)).unwrap();
        let mut stepper = inputs.stepper(&system).unwrap();
        let mut values = vec![0.0];
        for sample in 1..inputs.len() {
            stepper.advance(inputs.at(sample)).unwrap();
            values.push(stepper.mass_at(0).displacement());
        }
        values
    };
    let truth = 3.3;
    let channels = vec![
        channel("base", "m/s", base.clone()),
        channel("block", "m", motion(truth)),
    ];
    let recording = Recording::inputs(1.0 / DT, channels).unwrap();
    let touching = 400.0 * farthest / 1.25;
    let mut differences = 0;
    for share in [1.0 - 1e-12, 1.0, 1.02] {
        let fit = system
            .fit_motion(&recording, Some(touching * share), &[])
            .unwrap();
        let found = fit.friction.unwrap().value;
        assert!((found - truth).abs() < 1e-7, "{found} from {share}");
        println!(
            "from {share}: {} differences, {} exact",
            fit.differences, fit.derivatives
        );
        differences += fit.differences;
        if share == 1.02 {
            assert_eq!(fit.differences, 0, "no graze at the first guess");
        }
    }
    assert!(0 < differences, "no difference at a graze");
}

/// Checks the errors for recordings and requests that do not fit the scene.
#[test]
fn what_is_refused() {
    let system: System = FRAME.parse().unwrap();
    let recording = recorded(&system, 120, 0.0, 1);
    let with = |change: &dyn Fn(&mut Vec<Channel>)| {
        let mut channels = recording.channels().to_vec();
        change(&mut channels);
        Recording::inputs(1.0 / DT, channels).unwrap()
    };
    let mu = [Tunable::Quantity(Quantity::Stiction)];
    let fit = |recording: &Recording, friction, vary: &[Tunable]| -> Result<MotionFit, _> {
        system.fit_motion(recording, friction, vary)
    };
    let still = with(&|channels| channels[1].samples.fill(2.0));
    let error = fit(&still, Some(1.0), &mu).unwrap_err();
    assert_eq!(error, MeasureError::Constant("upper".to_owned()));
    let driven = with(&|channels| channels.truncate(1));
    assert_eq!(
        fit(&driven, Some(1.0), &mu).unwrap_err(),
        MeasureError::NoMass
    );
    assert_eq!(
        fit(&recording, None, &mu).unwrap_err(),
        MeasureError::NoFriction
    );
    let known = with(&|channels| {
        let samples = vec![FRICTION; channels[0].samples.len()];
        channels.push(channel("friction", "N", samples));
    });
    let error = fit(&known, Some(1.0), &mu).unwrap_err();
    assert_eq!(error, MeasureError::TwoFrictions);
    assert!(matches!(
        fit(&known, None, &[]),
        Err(MeasureError::Asked(_))
    ));
    let found = fit(&known, None, &mu).unwrap();
    assert!(found.friction.is_none() && (found.numbers[0].1.value - 1.3).abs() < 1e-12);
    let shaken = with(&|channels| channels[2].unit = "m/s2".parse().unwrap());
    let error = fit(&shaken, Some(1.0), &mu).unwrap_err();
    assert!(
        matches!(error, MeasureError::WrongDimension { .. }),
        "{error}"
    );
    let input = SystemInput::force(1.0).on("upper", 2.0).friction(3.0);
    let twice = SystemInput::force(2.0).on("upper", 4.0).friction(6.0);
    assert_eq!(input.map(|number| 2.0 * number), twice);
}

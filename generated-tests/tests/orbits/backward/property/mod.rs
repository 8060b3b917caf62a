//! Tests the backward error for random scenes of 1 to 16 masses, over the whole range of r, and near poles,
//! subharmonics and limits.
//!
//! This module has the runs and their bounds. `subject` draws scenes and points. `told` asks all questions at one
//! point. `brute_force` searches for values larger than the returned maxima.

mod brute_force;
mod subject;
mod told;

use crate::backward::tally::Tally;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use subject::{DOUBLE, Range, SINGLE, Subject};
use told::{Asking, told};

/// Largest accepted backward error, in rounding units of the inputs.
pub const BAR: f64 = 64.0;
const POINTS: u64 = 10;

/// Judges the answers for the scene with number `seed` at its points.
fn check<S: Float>(seed: u64, range: &Range, exact: impl Fn(S) -> Dd + Copy, tally: &mut Tally) {
    let Some(mut subject) = Subject::<S>::of(seed, range) else {
        tally.skip("a scene that is refused");
        return;
    };
    tally.scenes += 1;
    for point in 0..POINTS {
        let (r, at_limit) = subject.place(range);
        let at = subject.system.at(r).expect("a ratio in the domain");
        let limit = at.continuous_limit().min(at.sliding_limit());
        let place = at_limit(&mut subject, limit);
        let masses = subject.system.scene().masses.len();
        let mass = subject.random.below(masses);
        let asking = Asking {
            subject: &subject,
            point,
            mass,
        };
        let Some((judge, told)) = told(&asking, &place, exact, tally) else {
            continue;
        };
        let verdict = judge.verdict(&told);
        tally.note(&told, &verdict, BAR, || format!("seed {seed}: {place:?}"));
    }
}

fn run<S: Float>(scenes: &[u64], range: &Range, exact: impl Fn(S) -> Dd + Copy + Sync) -> Tally {
    let half = |parity: usize| {
        let mut tally = Tally::default();
        for seed in scenes.iter().skip(parity).step_by(2) {
            check(*seed, range, exact, &mut tally);
        }
        tally
    };
    std::thread::scope(|scope| {
        let other = scope.spawn(|| half(1));
        let mut tally = half(0);
        tally.join(other.join().expect("no panic"));
        tally
    })
}

/// Number of kinds of answers that occur in a long run.
const KINDS: usize = 17;
/// Upper bounds on the fractions of a run's points.
struct Shares {
    /// Points above the accepted error. The points are of two kinds: stuck responses that are differences of larger
    /// free responses, and points whose condition number is near the largest condition number at which one displacement
    /// must explain all answers.
    above: f64,
    /// Points at which no common displacement of the inputs explains all answers. All these points have a condition
    /// number above 100.
    disagreeing: f64,
    /// Points without any explanation, for one of two reasons. Either no digit of the contact's force is known, not
    /// even in double-double. Or r is within a rounding unit of a resonance, and this unit decides whether the
    /// contact moves.
    wrong: f64,
}
/// Bounds for a short run, in which one point is a larger fraction of all points than in a long run.
const FEW: Shares = Shares {
    above: 0.0,
    disagreeing: 0.04,
    wrong: 0.0,
};
const MANY: Shares = Shares {
    above: 0.01,
    disagreeing: 0.02,
    wrong: 1e-3,
};

/// Prints the results of a run, and asserts the bounds `most`.
fn report(title: &str, tally: &Tally, most: &Shares) {
    tally.print(title);
    // The limit per mode may be missing, because the test asks for it at few points.
    assert!(KINDS - 1 <= tally.counts().count(), "a kind is missing");
    let [above, disagreeing, wrong] = tally.shares();
    assert!(
        wrong <= most.wrong,
        "{wrong} of all places are wrong altogether"
    );
    assert!(
        above <= most.above,
        "{above} of all places are above the bar"
    );
    assert!(
        disagreeing <= most.disagreeing,
        "{disagreeing} of all places disagree"
    );
}

fn double(scenes: std::ops::Range<u64>, most: &Shares) {
    let scenes: Vec<u64> = scenes.collect();
    report("f64", &run::<f64>(&scenes, &DOUBLE, Dd::from), most);
}

fn single(scenes: std::ops::Range<u64>, most: &Shares) {
    let exact = |value: f32| Dd::from(f64::from(value));
    let scenes: Vec<u64> = scenes.collect();
    report("f32", &run::<f32>(&scenes, &SINGLE, exact), most);
}

#[test]
fn double_precision() {
    double(0..12, &FEW);
}

#[test]
fn single_precision() {
    single(0..12, &FEW);
}

/// Returns the range of scene numbers from the environment variable SCENES, which is a number of scenes or
/// `from..to`.
pub fn asked() -> std::ops::Range<u64> {
    let text = std::env::var("SCENES").unwrap_or_else(|_| "10000".to_owned());
    let (from, to) = text.split_once("..").unwrap_or(("0", &text));
    let number = |text: &str| text.parse().expect("SCENES=100 or SCENES=100..200");
    number(from)..number(to)
}

/// Run with `SCENES=100000 cargo test --release -p generated-tests --test orbits long_double -- --ignored --nocapture`.
#[test]
#[ignore = "takes long; the scenes are SCENES"]
fn long_double() {
    double(asked(), &MANY);
}

/// Checks the same scenes in single precision.
#[test]
#[ignore = "takes long; the scenes are SCENES"]
fn long_single() {
    single(asked(), &MANY);
}

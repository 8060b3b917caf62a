//! Backward error of random scenes of 1 to 16 masses, over the whole range of r, and near poles, subharmonics and
//! limits.
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

/// Bar for the backward error, in roundings of the inputs.
pub const BAR: f64 = 64.0;
const POINTS: u64 = 10;

/// Checks one scene at its points.
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
/// Upper bounds on fractions of the points of a run.
struct Shares {
    /// Points above the accepted error. There are two kinds: stuck responses that are differences of larger free
    /// responses, and points whose condition is near the largest one at which all answers must agree.
    above: f64,
    /// Points at which no displacement of the inputs explains all answers together. All of them have a condition above
    /// 100.
    disagreeing: f64,
    /// Points without any explanation, for one of two reasons. No digit of the contact's force may be known, not even
    /// in double-double. Or r lies within a rounding of a resonance, and this rounding decides whether the contact
    /// moves.
    wrong: f64,
}
/// Bounds of a short run. One point in a hundred is a larger fraction than one point in thousands.
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

/// Prints a run and asserts its bounds.
fn report(title: &str, tally: &Tally, most: &Shares) {
    tally.print(title);
    // The limit per mode may be missing, because few points ask for it.
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

/// Returns the range of scenes from the variable SCENES, which is a number of scenes or `from..to`.
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

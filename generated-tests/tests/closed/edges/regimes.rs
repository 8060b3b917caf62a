//! Tests the reported regime at friction ratios β near each limit: one rounding unit below the limit,
//! at the limit, and one rounding unit above it.
//!
//! Physics and documentation have the same rule. The contact is stuck for β ≥ β*_lim, even if β*_lim is below β_lim.
//! Otherwise the motion is continuous for β < β_lim, and stick-slip for β ≥ β_lim. A continuous motion on an undamped
//! resonance that the load drives is unbounded.

use crate::edges::scenes::{Rounded, SCENES, ratios, system};
use frictiongen::study::System;
use frictiongen::{
    ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, NotContinuous, Of, Regime,
};
use generated_tests::shown;

/// Returns the undamped resonances that the load drives, as frequency ratios.
fn unbounded<S: Rounded>(system: &System<S>) -> Vec<S> {
    let modal = system.modal();
    let driven = |i: &usize| modal.damping_ratios[*i].is_zero() && !modal.loads[*i].is_zero();
    let modes = (0..modal.resonances.len()).filter(driven);
    modes.map(|i| system.resonances()[i]).collect()
}

fn show<T>(got: &Result<T, NotContinuous>) -> String {
    match got {
        Ok(_) => String::from("a motion"),
        Err(error) => format!("{error:?}"),
    }
}

/// Numbers of tested and of skipped friction ratios, and the answers that break the rule of the regimes. The test
/// skips values that are no valid friction ratio: values below 0 (near a limit of 0), and infinity.
#[derive(Debug, Default)]
struct Told {
    asked: usize,
    skipped: usize,
    failures: Vec<String>,
}

fn check<S: Rounded, F: FrictionSystem<Scalar = S>>(
    name: &str,
    system: &F,
    ratios: Vec<S>,
    unbounded: &[S],
) -> Told
where
    for<'a> F::At<'a>: MotionAt<Scalar = S>,
{
    let [zero, half, two] = [0.0, 0.5, 2.0].map(S::constant);
    let mut all = Told::default();
    for r in ratios {
        let at = system.at(r).expect("in the domain");
        let (continuous, sliding) = (at.continuous_limit(), at.sliding_limit());
        let (lowest, highest) = (continuous.min(sliding), continuous.max(sliding));
        if !(zero <= lowest) || highest.to_f64().is_nan() {
            all.failures
                .push(format!("{name}, r = {r:?}: {continuous:?}, {sliding:?}"));
        }
        let betas = [continuous, sliding].map(|limit| [limit.down(), limit, limit.up()]);
        let others = [
            zero,
            half * lowest,
            half * (lowest + highest),
            two * highest,
        ];
        for beta in betas.into_iter().flatten().chain(others) {
            if !(zero <= beta && beta.is_finite()) {
                all.skipped += 1;
                continue;
            }
            all.asked += 1;
            let regime = match (beta < continuous, beta < sliding) {
                (true, true) => Regime::Continuous,
                (false, true) => Regime::StickSlip,
                (false, false) => Regime::Stuck,
                (true, false) => Regime::Bistable,
            };
            let told = at.regime(beta).expect("in the domain");
            let motion = at.motion(beta);
            let right = match (&motion, regime) {
                (Ok(_), Regime::Continuous | Regime::Bistable) => !unbounded.contains(&r),
                (Err(NotContinuous::Unbounded), Regime::Continuous | Regime::Bistable) => {
                    unbounded.contains(&r)
                }
                (Err(NotContinuous::StickSlip), Regime::StickSlip)
                | (Err(NotContinuous::Stuck), Regime::Stuck) => true,
                _ => false,
            };
            let margin = at.margin(beta).expect("in the domain");
            let inside = if regime == Regime::Continuous {
                margin < zero
            } else {
                zero <= margin
            };
            if told != regime || !right || !inside {
                all.failures.push(format!(
                    "{name}, r = {r:?}, beta = {beta:?} (limits {continuous:?}, {sliding:?}): \
                     {told:?}, margin {margin:?}, {}, should be {regime:?}",
                    show(&motion)
                ));
            }
            if let Ok(motion) = motion {
                let amplitude = motion.ask(Of::Contact, |contact| contact.amplitude());
                // Rounding may give a limit slightly below 0 only where the limit itself is 0.
                if !amplitude.is_some_and(|z| zero <= z && z.is_finite()) {
                    all.failures
                        .push(format!("{name}, r = {r:?}, beta = {beta:?}: {amplitude:?}"));
                }
            }
        }
    }
    all
}

/// Prints the total numbers, and asserts the numbers of tested and skipped friction ratios.
fn report(title: &str, results: Vec<Told>, counts: (usize, usize)) {
    let asked: usize = results.iter().map(|result| result.asked).sum();
    let skipped: usize = results.iter().map(|result| result.skipped).sum();
    let failures: Vec<String> = results.into_iter().flat_map(|told| told.failures).collect();
    println!(
        "{title}: {asked} friction ratios, {skipped} beside 0 or infinity skipped, {} failures",
        failures.len()
    );
    let first: Vec<&String> = failures.iter().take(20).collect();
    assert!(failures.is_empty(), "{first:#?}");
    assert_eq!((asked, skipped), counts, "{title}");
}

/// Returns the frequency ratios that `ratios` gives, and r = 0.
fn with_rest<S: Rounded>(resonances: &[S]) -> Vec<S> {
    let mut ratios = ratios(resonances);
    ratios.push(S::constant(0.0));
    ratios
}

fn at_run_time<S: Rounded>() -> Vec<Told> {
    let scenes = SCENES.iter();
    scenes
        .map(|(name, text)| {
            let system = system::<S>(text);
            let ratios = with_rest(system.resonances());
            check(name, &system, ratios, &unbounded(&system))
        })
        .collect()
}

#[test]
fn at_run_time_in_double_precision() {
    report("run time, f64", at_run_time::<f64>(), (101_319, 21));
}

#[test]
fn at_run_time_in_single_precision() {
    report("run time, f32", at_run_time::<f32>(), (49_463, 37));
}

/// Checks an emitted scene. The run-time system of the same text gives its unbounded resonances.
macro_rules! emitted {
    ($($name:ident),*) => {
        vec![$({
            let scene = shown::SCENES.iter().find(|scene| scene.0 == stringify!($name));
            let read = system(scene.expect(stringify!($name)).1);
            let ratios = with_rest(shown::$name.resonances());
            check(stringify!($name), &shown::$name, ratios, &unbounded(&read))
        }),*]
    };
}

#[test]
fn emitted() {
    report(
        "emitted",
        emitted![
            SdofWall, SdofDamped, PairBase, PairMasses, Thesis, Five, Single
        ],
        (42_167, 13),
    );
}

/// Checks that at r = ∞ the limits for r → ∞ decide the regime, not the sums at the largest r that the formulas
/// evaluate.
#[test]
fn at_infinity() {
    let infinity = || vec![f64::INFINITY];
    let results = SCENES.iter().map(|(name, text)| {
        let system = system::<f64>(text);
        check(name, &system, infinity(), &unbounded(&system))
    });
    report("r = ∞", results.collect(), (117, 33));
}

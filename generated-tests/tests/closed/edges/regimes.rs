//! Tests the reported regime and the motion at friction ratios β near each limit: one rounding unit below the limit,
//! at the limit, and one rounding unit above it.
//!
//! Physics and documentation have the same rule. The contact is stuck for β ≥ β*_lim, even if β*_lim is below β_lim.
//! Otherwise the motion is continuous for β < β_lim, and stick-slip for β ≥ β_lim. A continuous motion on an undamped
//! resonance that the load drives is unbounded.

use crate::edges::condition::{Asked, Question, along_place, answer, data, modal_condition};
use crate::edges::scenes::{Rounded, SCENES, ratios, system};
use frictiongen::study::System;
use frictiongen::{
    ContinuousMotion, FrictionSystem, LimitsAt, MotionAt, NotContinuous, Of, Regime,
};
use frictiongen_kernel::number::dd::Dd;
use generated_tests::shown;

/// Tolerance in rounding units of each input. All other answers have the same tolerance.
const BAR: f64 = 64.0;

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

/// Checks that the closed form has no step at a limit: neighbouring β on both sides of the limit give nearly the same
/// amplitude.
///
/// The bound is the change by `BAR` rounding units of each input. Near a pole or subharmonic the amplitude may be as
/// steep as a square root at its zero, where a first-order condition number means nothing. The effect of r and β is
/// therefore the spread of the double-double answer over r(1 ± kε), β(1 ± kε), with k = 64. The effect of the modal
/// data is 2kε Σ|x ∂f/∂x|, evaluated two rounding units below the limit.
fn amplitudes<S: Rounded>(counts: (usize, usize, usize)) {
    let (mut asked, mut skipped, mut public) = (0, 0, 0);
    let mut failures = Vec::new();
    for (name, text) in SCENES {
        let system = system::<S>(text);
        let modal = system.modal();
        let rounded = data(modal, |value| S::constant(value.hi) + S::constant(value.lo));
        let exact = data(modal, |value| value);
        let all = ratios(system.resonances());
        // The test uses every ninth ratio. Nine has no common divisor with the period of the grid.
        for r in all.into_iter().step_by(9) {
            let at = system.at(r).expect("in the domain");
            let limits = [at.continuous_limit(), at.sliding_limit()];
            for limit in limits {
                let low = limit.down().down();
                if !(S::constant(0.0) < low) {
                    skipped += 1;
                    continue;
                }
                let betas = [low, limit.down(), limit, limit.up()];
                let values =
                    betas.map(|beta| answer(&rounded, r, beta, Asked::ContactAmplitude).to_f64());
                // The public interface must return the same number.
                if let Ok(motion) = at.motion(betas[1]) {
                    assert_eq!(motion.contact().amplitude().to_f64(), values[1], "{name}");
                    public += 1;
                }
                asked += 1;
                let spread: Vec<f64> = [-BAR, 0.0, BAR]
                    .into_iter()
                    .flat_map(|a| [-BAR, 0.0, BAR].map(|b| (a, b)))
                    .map(|(a, b)| {
                        let moved = |value: S, k: f64| {
                            Dd::from(value.to_f64()) * Dd::sum(1.0, k * S::EPSILON)
                        };
                        let asked = Asked::ContactAmplitude;
                        answer(&exact, moved(r, a), moved(limit, b), asked).to_f64()
                    })
                    .collect();
                let most = |values: &[f64]| values.iter().copied().fold(f64::MIN, f64::max);
                let least = |values: &[f64]| values.iter().copied().fold(f64::MAX, f64::min);
                let spread = most(&spread) - least(&spread);
                let question = Question::at(r, low, Asked::ContactAmplitude);
                let condition = modal_condition(&system, question);
                let bound = spread + 2.0 * BAR * S::EPSILON * condition;
                let step = most(&values) - least(&values);
                if !(step <= bound) {
                    failures.push(format!(
                        "{name}, r = {r:?}, limit {limit:?}: {values:?} {step:e} > {bound:e}"
                    ));
                }
            }
        }
    }
    println!(
        "{asked} limits, {skipped} that are 0 skipped, {public} with a motion of the public face below them, {} failures",
        failures.len()
    );
    let first: Vec<&String> = failures.iter().take(20).collect();
    assert!(failures.is_empty(), "{first:#?}");
    assert_eq!((asked, skipped, public), counts);
}

#[test]
fn amplitude_on_both_sides_in_double_precision() {
    amplitudes::<f64>((2262, 0, 1164));
}

#[test]
fn amplitude_on_both_sides_in_single_precision() {
    amplitudes::<f32>((1110, 0, 572));
}

/// Checks that a change of β by one rounding unit changes the contact's amplitude Z by |∂Z/∂β| times this unit, plus
/// the rounding of Z itself. This change is far below the rounding of a limit.
#[test]
fn a_rounding_of_beta() {
    let (mut worst, mut compared) = (0.0_f64, 0);
    for (name, text) in SCENES {
        let system = system::<f64>(text);
        for r in [0.17, 0.83, 1.37, 2.9] {
            let at = system.at(r).expect("in the domain");
            let limit = at.continuous_limit().min(at.sliding_limit());
            for share in [0.1, 0.5, 0.9, 0.999] {
                let beta = limit * share;
                let amplitude = |beta: f64| {
                    let motion = at.motion(beta).expect("continuous");
                    motion.contact().amplitude()
                };
                let step = (amplitude(beta.next_up()) - amplitude(beta)).abs();
                let question = Question::at(r, beta, Asked::ContactAmplitude);
                let (value, _, slope) = along_place(&system, question);
                let one = slope.abs().to_f64() * (beta.next_up() - beta);
                // Sixteen roundings of half a unit each occur: in V, in U, in the sums for V and U, in the root and
                // in the products.
                let own = 8.0 * f64::EPSILON * modal_condition(&system, question);
                worst = worst.max((step - one) / own);
                assert!(step <= one + own, "{name}, r = {r}: {step:e}, {value}");
                compared += 1;
            }
        }
    }
    println!(
        "{compared} steps, none skipped; beyond the slope: {worst:.2} of the rounding allowed"
    );
    assert_eq!(compared, 16 * SCENES.len());
}

//! Tests that no search repeats the computation of a known limit, and that a search reports whether it finished.

use frictiongen::kernel::modal_sum::search::MAX_EVALUATIONS;
use frictiongen::{ContinuousMotion, FrictionSystem, MotionAt};
use frictiongen::{Effort, LimitsAt, Of, Steady, System, friction_system};

const TEXT: &str = "struct Three { masses: { a: 1, b: 0.7, c: 0.3 }, springs: { base - a: 1, a - b: 2, b - c: 0.6 },
    contact: b - wall, excitation: base, damping: modal[0.02, 0.05, 0.01], stiction: 1.3 }";

friction_system! {
    struct Three {
        masses: { a: 1, b: 0.7, c: 0.3 },
        springs: { base - a: 1, a - b: 2, b - c: 0.6 },
        contact: b - wall,
        excitation: base,
        damping: modal[0.02, 0.05, 0.01],
        stiction: 1.3,
    }
}

fn both<F>(system: &F) -> Vec<u64>
where
    F: FrictionSystem<Scalar = f64>,
    for<'a> F::At<'a>: MotionAt,
{
    let mut told = Vec::new();
    for step in 1..200 {
        let at = system.at(0.015 * f64::from(step)).expect("a ratio");
        let limits = at.limits();
        let alone = (at.continuous_limit(), at.sliding_limit());
        assert_eq!((limits.continuous, limits.sliding), alone);
        told.extend([limits.continuous.to_bits(), limits.sliding.to_bits()]);
        for beta in [0.0, 0.05, 0.3, 1.0, 5.0] {
            assert_eq!(limits.regime(beta), at.regime(beta));
            assert_eq!(limits.margin(beta), at.margin(beta));
            let Ok(motion) = at.motion(beta) else {
                continue;
            };
            for of in [Of::Contact, Of::Mass(0), Of::Mass(1), Of::Mass(2)] {
                let asked = |motion: &dyn Steady<Scalar = f64>| {
                    let largest = motion.largest();
                    assert_eq!(largest.amplitude, motion.amplitude());
                    assert_eq!(largest.phase, motion.phase());
                    assert!(
                        matches!(largest.effort, Effort::Bounded(count) if count < MAX_EVALUATIONS)
                    );
                    largest.amplitude.to_bits()
                };
                told.push(motion.ask(of, asked).expect("a motion"));
            }
        }
        assert!(limits.regime(f64::NAN).is_err() && limits.margin(-1.0).is_err());
    }
    told
}

#[test]
fn one_search_answers_for_all() {
    let system: System = TEXT.parse().expect("a sound scene");
    let (emitted, run_time) = (both(&Three), both(&system));
    println!("{} answers of each", emitted.len());
    assert_eq!(emitted, run_time);
    assert!(emitted.len() > 199 * 2 + 4 * 200, "{}", emitted.len());
}

#[test]
fn a_search_says_what_it_took() {
    let system: System = TEXT.parse().expect("a sound scene");
    let (mut most, mut searched) = (0, 0);
    for step in 1..400 {
        let r = 0.0075 * f64::from(step);
        let (at, emitted) = (
            system.at(r).expect("a ratio"),
            Three::at(r).expect("a ratio"),
        );
        let (limits, effort) = at.limits_searched();
        assert_eq!((limits, effort), emitted.limits_searched());
        assert_eq!(limits, at.limits());
        let Effort::Bounded(count) = effort else {
            panic!("{effort:?} at r = {r}");
        };
        assert_eq!(at.continuous_limit(), limits.continuous);
        most = most.max(count);
        searched += u32::from(count > 0);
    }
    println!("{searched} searches, at most {most} evaluations");
    assert!(searched > 100 && most < 2000);
}

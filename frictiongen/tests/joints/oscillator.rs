//! One mass, by formulas.

use crate::scene::{Scene, ground};
use frictiongen::kernel::joints::{Joint, Phase};

/// The friction oscillator of Siconos: m = k = F = 1 from (12, 6).  Each half swing about ∓1 loses 2.
#[test]
fn the_oscillator_of_siconos_comes_to_rest() {
    let scene = Scene {
        masses: vec![1.0],
        springs: vec![(ground(0), 1.0)],
        joints: vec![Joint {
            link: ground(0),
            stiffness: None,
            stiction: 1.0,
        }],
        levels: vec![1.0],
        forces: vec![0.0],
        ..Scene::default()
    };
    let (mut x, mut phase, mut stops) = (0.0, Phase::Free, 0);
    let followed = crate::scene::follow(
        &scene.chain(),
        &scene,
        (&[12.0], &[6.0]),
        40.0,
        |run, step, passed| {
            if passed {
                stops += usize::from(step.event);
                (x, phase) = (run.displacements()[0], run.joints()[0].phase);
            }
        },
    );
    followed.expect("a run");
    assert_eq!(phase, Phase::Stuck);
    // The first turn is at √205 − 1, and each of the seven further half swings ends 2 nearer.
    assert!(
        (x.abs() - (15.0 - 205.0f64.sqrt())).abs() < 1e-13,
        "{x} after {stops}"
    );
}

/// A loop of one elastic contact, k = 2, F = 3, that a motion of ±5 drives: force at its corners and area.
#[test]
fn a_full_slip_loop_has_the_area_of_its_formula() {
    // The mass is so heavy that the contact does not disturb it: it moves as 5 sin t to 1e-12.
    let (mass, k, level, amplitude) = (1e13, 2.0, 3.0, 5.0);
    let scene = Scene {
        masses: vec![mass],
        springs: vec![(ground(0), mass)],
        joints: vec![Joint {
            link: ground(0),
            stiffness: Some(k),
            stiction: 1.0,
        }],
        levels: vec![level],
        forces: vec![0.0],
        ..Scene::default()
    };
    let start: (&[f64], &[f64]) = (&[0.0], &[amplitude]);
    // From a quarter turn on the loop is closed.
    let [before, after] = [1.25, 2.25].map(|turns| {
        let (mut work, mut last) = (0.0, (0.0, 0.0));
        let until = turns * std::f64::consts::TAU;
        let followed =
            crate::scene::follow(&scene.chain(), &scene, start, until, |run, _, passed| {
                if !passed {
                    let now = (run.displacements()[0], run.joints()[0].force);
                    // The force is linear in the displacement between events, so the trapezium is exact.
                    work += 0.5 * (last.1 + now.1) * (now.0 - last.0);
                    last = now;
                }
            });
        followed.expect("a run");
        work
    });
    let area = 4.0 * level * (amplitude - level / k);
    // The mass loses 1e-12 of its energy in the loop.
    assert!(
        (after - before - area).abs() < 1e-10 * area,
        "{} {area}",
        after - before
    );
}

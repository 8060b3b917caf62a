//! The model CoupledClutches of the Modelica Standard Library, whose levels vary in time.

use crate::scene::{between, follow, phases};
use frictiongen::kernel::joints::{Chain, Drive, Joint, Series, harmonic};
use std::f64::consts::PI;

struct Clutches;

impl Drive<f64> for Clutches {
    fn force(&self, mass: usize, t: f64, span: f64, series: &mut Series<f64>) {
        if mass == 0 {
            harmonic(10.0, 10.0 * t - 0.5, 10.0 * PI * span, series);
        }
    }
    fn level(&self, joint: usize, t: f64, span: f64, series: &mut Series<f64>) {
        match joint {
            0 => harmonic(10.0, 0.4 * t, 0.4 * PI * span, series),
            1 if t >= 0.4 => series[0] = 10.0,
            2 if t >= 0.9 => series[0] = 10.0,
            _ => {}
        }
    }
    fn rate(&self) -> f64 {
        10.0 * PI
    }
    fn bend_after(&self, t: f64) -> Option<f64> {
        [0.4, 0.9].into_iter().find(|bend| *bend > t)
    }
}

/// The exact events and speeds of the model.  The published reference differs from them by up to 6.6e-5 in a speed.
#[test]
fn coupled_clutches_are_exact() {
    let joints = [0, 1, 2].map(|i| Joint {
        link: between(i, i + 1),
        stiffness: None,
        stiction: 1.1,
    });
    let chain = Chain {
        masses: &[1.0; 4],
        springs: &[],
        dampers: &[],
        damping: &[],
        joints: &joints,
    };
    let mut events = Vec::new();
    let mut before = Vec::new();
    let mut speeds = Vec::new();
    let start: (&[f64], &[f64]) = (&[0.0; 4], &[10.0, 0.0, 0.0, 0.0]);
    let followed = follow(&chain, Clutches, start, 1.5, |run, step, passed| {
        if passed {
            speeds = run.velocities().to_vec();
            let after = phases(run.joints());
            // At 0.4 and 0.9 clutches close, which is no event of the list.
            if after != before && ![0.4, 0.9].contains(&step.to) {
                events.push((step.to, before.clone(), after));
            }
        } else {
            before = phases(run.joints());
        }
    });
    followed.expect("a run");
    let listed = [
        0.709_621_474_693_7,
        0.791_662_359_154_8,
        0.831_108_506_137_6,
        0.906_850_192_797_9,
        1.000_295_859_894_6,
        1.143_967_492_473_1,
        // The level of the first clutch falls to 0.
        1.25,
    ];
    assert_eq!(events.len(), listed.len(), "{events:?}");
    for ((found, ..), listed) in events.iter().zip(listed) {
        assert!((found - listed).abs() < 1e-12, "{found} {listed}");
    }
    assert!((speeds[0] - 3.247_058_272_419).abs() < 1e-12, "{speeds:?}");
    for speed in &speeds[1..] {
        assert!((speed - 2.463_187_166).abs() < 1e-9, "{speeds:?}");
        // Angular momentum: the torque 10 sin 10πt has given the four inertias 10 + (1 − cos 15π)/π.
        let momentum = 10.0 + 2.0 / PI;
        assert!(
            (speeds[0] + 3.0 * speed - momentum).abs() < 1e-12,
            "{speeds:?}"
        );
    }
}

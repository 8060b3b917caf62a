//! Compares friction laws that equal or nearly equal Coulomb's law with a constant kinetic friction force.

use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, TEN, WALL, WALL_BASE};
use crate::stribeck::{follow, lined, scaled, units};
use frictiongen::System;

const ALL: [&str; 7] = [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE, TEN];

/// Returns the largest difference of two runs over several cycles, divided by the largest displacement or velocity, and
/// the number of events in each run.
fn apart(
    one: (&System, f64, f64),
    other: (&System, f64, f64),
    r: f64,
    cycles: u64,
) -> (f64, [usize; 2]) {
    let mut a = one.0.simulation_under(r, one.1, one.2).expect("a run");
    let mut b = other
        .0
        .simulation_under(r, other.1, other.2)
        .expect("a run");
    let (mut worst, mut largest, mut events) = ([0.0_f64; 2], [0.0_f64; 2], [0; 2]);
    for instant in 1..=64 * cycles {
        let (cycle, part) = (instant / 64, (instant % 64) as f64 / 64.0);
        events[0] += follow(&mut a, cycle, part);
        events[1] += follow(&mut b, cycle, part);
        for mass in 0..one.0.scene().masses.len() {
            let (a, b) = (a.run().mass(mass), b.run().mass(mass));
            let pairs = [
                [a.displacement(), b.displacement()],
                [a.velocity(), b.velocity()],
            ];
            for (side, [a, b]) in pairs.into_iter().enumerate() {
                worst[side] = worst[side].max((a - b).abs());
                largest[side] = largest[side].max(b.abs());
            }
        }
    }
    ((worst[0] / largest[0]).max(worst[1] / largest[1]), events)
}

/// Compares Coulomb's law with a law of five lines whose level is 1 at every speed. The power series of the law must
/// agree with the closed form. Both have rounding errors. Friction reduces earlier errors, but each event multiplies
/// them by a factor.
#[test]
fn a_constant_level() {
    let mut compared = 0;
    for text in ALL {
        for [r, beta] in [[0.13, 0.2], [0.4, 0.4], [1.0, 0.3], [2.2, 0.1]] {
            for mu in [1.0, 1.3] {
                let plain = lined(text, mu, &[]);
                let ([_, speed], amplitude) = units(&plain, r);
                let law = [0.05, 0.2, 0.4, 0.9, 3.0].map(|v| [v, 1.0]);
                let plain: System = plain.try_into().expect("a scene");
                let system: System = lined(text, mu, &scaled(&law, speed))
                    .try_into()
                    .expect("a scene");
                let (worst, events) =
                    apart((&system, beta, amplitude), (&plain, beta, amplitude), r, 10);
                println!(
                    "{}, {r}, {beta}, {mu}: {worst:.1e}, {events:?}",
                    &text[7..14]
                );
                assert_eq!(events[0], events[1]);
                assert!(worst < 2e-11, "{worst:e}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 56);
}

/// Compares a friction force that falls to 0.8 F between speed 0 and a small speed v with Coulomb's law for 0.8 F and
/// μ/0.8. The difference must be of the order of v.
#[test]
fn a_sudden_fall() {
    let mut compared = 0;
    for text in ALL {
        for [r, beta] in [[0.4, 0.4], [1.0, 0.3], [1.6, 0.2]] {
            let plain = lined(text, 1.2 / 0.8, &[]);
            let ([_, speed], amplitude) = units(&plain, r);
            let plain: System = plain.try_into().expect("a scene");
            let off = |v: f64| {
                let law = scaled(&[[v, 0.8]], speed);
                let system: System = lined(text, 1.2, &law).try_into().expect("a scene");
                apart(
                    (&system, beta, amplitude),
                    (&plain, 0.8 * beta, amplitude),
                    r,
                    10,
                )
                .0
            };
            let [coarse, fine] = [1e-3, 1e-4].map(off);
            println!("{}, {r}, {beta}: {coarse:.1e}, {fine:.1e}", &text[7..14]);
            assert!(fine < 1e-3 && fine < coarse / 4.0, "{coarse:e}, {fine:e}");
            compared += 1;
        }
    }
    assert_eq!(compared, 21);
}

//! The bound on a free motion's third derivative, which says how far a walk may step.

use super::*;
use crate::testing::Lcg;

fn part(zeta: f64, x: f64) -> Part<f64> {
    let mut part = Part::empty();
    part.kind = if zeta == 0.0 {
        Kind::Undamped
    } else if zeta < 1.0 {
        Kind::Light
    } else if zeta == 1.0 {
        Kind::Critical
    } else {
        Kind::Over
    };
    (part.x, part.zeta) = (x, zeta);
    part.q2 = (1.0 - zeta) * (1.0 + zeta);
    part.q = if zeta == 1.0 {
        1.0
    } else {
        part.q2.abs().sqrt()
    };
    part
}

#[test]
fn third_derivatives_stay_within_their_bound() {
    let mut random = Lcg(29);
    let mut compared = 0;
    for zeta in [
        0.0, 1e-3, 0.3, 0.96, 0.98, 0.999, 1.0, 1.001, 1.5, 4.0, 30.0,
    ] {
        let mut most = 0.0_f64;
        for _ in 0..400 {
            let mut part = part(zeta, random.log_uniform(0.05, 20.0));
            let size = random.log_uniform(1e-3, 1e3);
            part.free = [random.signed(), random.signed()].map(|part| size * part);
            part.weight = [random.signed(), random.signed()];
            part.aim();
            let [a, b] = part.derived(part.derived(part.slope));
            for k in 0..40 {
                let tau = 0.15 * f64::from(k) / part.x;
                let turn = part.turn(tau / core::f64::consts::PI, tau);
                let share = (a * turn.c + b * turn.s).abs() / (part.bound * turn.kept);
                assert!(
                    share <= 1.0 + 1e-9,
                    "ζ {zeta}, x {}, τ {tau}: {share}",
                    part.x
                );
                most = most.max(share);
                compared += 1;
            }
        }
        println!("ζ {zeta}: {most} of the bound");
        // No looser than it need be, or walks are slow.
        assert!(most > 0.3, "ζ {zeta}: {most}");
    }
    println!("{compared} derivatives compared, none skipped");
    assert_eq!(compared, 11 * 400 * 40);
}

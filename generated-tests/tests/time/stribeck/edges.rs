//! Tests friction laws that depend on the speed: speeds that just reach a point of the law, extreme numbers, and
//! refused numbers.

use crate::stepper::scenes::{BASE, ONE, ONE_ON_BASE, PAIR, TEN, WALL, WALL_BASE};
use crate::stribeck::{follow, lined, scaled, units};
use frictiongen::kernel::Plain;
use frictiongen::{Given, OutOfDomain, System, Unsupported};

/// Returns the largest speed of the contact over the first cycles, the position of the mass after them, and the number
/// of events.
fn peak(text: &str, law: &[[f64; 2]], [r, beta]: [f64; 2]) -> (f64, f64, usize) {
    let ([_, speed], amplitude) = units(&lined(text, 1.2, &[]), r);
    let scene = lined(text, 1.2, &scaled(law, speed));
    let system: System = scene.try_into().expect("a scene");
    let mut run = system.simulation_under(r, beta, amplitude).expect("a run");
    let (mut largest, mut calls) = (0.0_f64, 0);
    for instant in 1..=6 * 2000 {
        calls += follow(&mut run, instant / 2000, (instant % 2000) as f64 / 2000.0);
        largest = largest.max(run.relative().1.abs());
    }
    (largest, run.run().mass(0).displacement(), calls)
}

/// Checks a motion whose largest speed is that of a point of the law. If rounding or a little more shifts the point,
/// the motion may change only by the effect of the shift.
#[test]
fn a_grazed_point() {
    let mut compared = 0;
    for text in [ONE, WALL, ONE_ON_BASE] {
        let at = [0.8, 0.3];
        let law = |v: f64| [[v, 0.7], [v + 0.5, 0.9]];
        // The largest speed depends little on the point. A fixed-point iteration therefore finds a point that this
        // speed just reaches.
        let mut v = 0.5;
        for _ in 0..60 {
            v += 0.5 * (peak(text, &law(v), at).0 - v);
        }
        let (speed, x, _) = peak(text, &law(v), at);
        println!("{}: {v} for {speed}", &text[7..14]);
        assert!((speed - v).abs() < 1e-6, "{speed}, {v}");
        for off in [0.0, 1e-16, 2e-16, 4e-16, 1e-15, 1e-14, 1e-12, 1e-9] {
            for v in [v * (1.0 + off), v * (1.0 - off)] {
                let (_, there, _) = peak(text, &law(v), at);
                assert!(
                    (there - x).abs() < 1e-12 + 100.0 * off,
                    "{off:e}: {there}, {x}"
                );
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 48);
}

fn sound<S: Plain>(
    text: &str,
    law: &[[f64; 2]],
    [r, beta, load]: [f64; 3],
) -> Result<usize, OutOfDomain> {
    let ([_, speed], amplitude) = units(&lined(text, 1.2, &[]), r);
    let system: System<S> = lined(text, 1.2, &scaled(law, speed))
        .try_into()
        .expect("a scene");
    let number = S::constant;
    let mut run = system.simulation_under(number(r), number(beta), number(load * amplitude))?;
    let mut events = 0;
    for _ in 0..40 {
        let segment = run.next().expect("no end");
        events += usize::from(segment.event.is_some());
        let (z, rate) = run.relative();
        assert!(z.is_finite() && rate.is_finite() && run.friction().is_finite());
        assert!(segment.length.is_finite() && S::constant(0.0) <= segment.length);
        // The terms of the force in a stuck contact are as large as the load.
        let most = 1.2 * beta * (1.0 + 1e-5) + 64.0 * S::EPSILON * (1.0 + r * r);
        let force = run.friction().to_f64().abs();
        assert!(
            force <= most,
            "{text}, {law:?}, {r}, {beta}, {load}, {}: {force}, {most}, {:?}, {rate:?} {segment:?}",
            S::EPSILON,
            run.contact()
        );
        for mass in 0..system.scene().masses.len() {
            assert!(run.run().mass(mass).displacement().is_finite());
        }
    }
    Ok(events)
}

/// Runs frequencies, friction forces and loads over many decades, in both precisions. No result may be NaN, the
/// friction force must stay within its bounds, and every call must end. The function runs one of `one_in` cases.
fn far(one_in: usize) -> [usize; 3] {
    let (mut runs, mut refused, mut events) = (0, 0, 0);
    let mut turn = 0;
    for text in [WALL, BASE, PAIR, ONE, ONE_ON_BASE, WALL_BASE, TEN] {
        for law in [
            &[[0.3, 0.7], [0.8, 0.5]][..],
            &[[0.1, 0.0]],
            &[[1e-3, 1.2], [10.0, 0.2]],
        ] {
            for r in [0.02, 0.5, 1.0, 1e2, 1e6] {
                for beta in [0.0, 1e-6, 0.3, 1.0, 50.0] {
                    for load in [1e-4, 1.0, 1e4] {
                        turn += 1;
                        if turn % one_in != 0 {
                            continue;
                        }
                        let at = [r, beta, load];
                        for found in [sound::<f64>(text, law, at), sound::<f32>(text, law, at)] {
                            match found {
                                Ok(found) => (runs, events) = (runs + 1, events + found),
                                Err(error) => {
                                    assert_eq!(error, OutOfDomain::Steepness);
                                    refused += 1;
                                }
                            }
                        }
                    }
                }
            }
        }
    }
    println!("{runs} runs with {events} events, {refused} refused");
    [runs, events, refused]
}

/// Runs every eleventh case. Eleven has no common divisor with the numbers of cases in the loops, so all kinds of
/// cases occur.
#[test]
fn extremes() {
    let [runs, events, refused] = far(11);
    assert!(
        230 < runs && 500 < events && 3 < refused,
        "{runs}, {events}, {refused}"
    );
}

#[test]
#[ignore = "a minute; one in eleven runs in every run of the tests"]
fn all_extremes() {
    let [runs, events, refused] = far(1);
    assert!(
        2500 < runs && 10_000 < events && 50 < refused,
        "{runs}, {events}, {refused}"
    );
}

#[test]
fn refused() {
    let text = WALL;
    let law = [[0.3, 0.7]];
    let system: System = lined(text, 1.2, &law).try_into().expect("a scene");
    let refused = |r, beta, amplitude| {
        let run = system.simulation_under(r, beta, amplitude);
        run.map(drop).expect_err("none")
    };
    for amplitude in [0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(
            refused(0.5, 0.3, amplitude),
            OutOfDomain::LoadAmplitude(Given::of(amplitude))
        );
    }
    // With this load amplitude, the speed of a point of the law divided by the load's speed overflows.
    assert_eq!(
        refused(0.5, 0.3, 1e-320),
        OutOfDomain::LoadAmplitude(Given::Positive)
    );
    // Under this load the speeds of the law are tiny compared with the motion, so the law is too steep.
    assert_eq!(refused(0.5, 0.3, 1e308), OutOfDomain::Steepness);
    for r in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let given = Given::of(r);
        let ratio = match given {
            Given::NotANumber | Given::Negative => OutOfDomain::FrequencyRatio(given),
            _ => OutOfDomain::FrequencyRatioInTime(given),
        };
        assert_eq!(refused(r, 0.3, 1.0), ratio);
    }
    for beta in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(
            refused(0.5, beta, 1.0),
            OutOfDomain::FrictionRatio(Given::of(beta))
        );
    }
    let state = [0.0, f64::NAN, 0.0];
    let from = |x: &[f64], v: &[f64]| {
        let run = system.simulation_under_from(0.5, 0.3, 1.0, (x, v));
        run.map(drop).expect_err("none")
    };
    assert_eq!(from(&state, &[0.0; 3]), OutOfDomain::State);
    assert_eq!(from(&[0.0; 3], &state), OutOfDomain::State);
    assert_eq!(from(&[0.0; 2], &[0.0; 3]), OutOfDomain::State);
    // These functions need a constant kinetic friction force.
    let constant = OutOfDomain::Unsupported(Unsupported::FrictionLaw);
    assert_eq!(
        system.simulation(0.5, 0.3).map(drop).expect_err("none"),
        constant
    );
    let none = system.simulation_from(0.5, 0.3, (&[0.0; 3], &[0.0; 3]));
    assert_eq!(none.map(drop).expect_err("none"), constant);
    assert_eq!(system.at(0.5).map(drop).expect_err("none"), constant);
    // This law is nearly vertical.
    let steep: System = lined(text, 1.2, &[[1e-9, 1.2]])
        .try_into()
        .expect("a scene");
    let error = steep
        .simulation_under(0.5, 0.3, 1.0)
        .map(drop)
        .expect_err("none");
    assert_eq!(error, OutOfDomain::Steepness);
    assert!(error.to_string().contains("4096 times"));
    let mut run = system.simulation_under(0.5, 0.3, 10.0).expect("a run");
    for reach in [-1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(
            run.advance(reach).expect_err("none"),
            OutOfDomain::Duration(Given::of(reach))
        );
    }
    // Without points of the law the amplitude does not matter, but it is still checked.
    let plain: System = lined(text, 1.2, &[]).try_into().expect("a scene");
    assert!(plain.simulation_under(0.5, 0.3, f64::NAN).is_err());
    let (a, b) = (
        plain.simulation_under(0.5, 0.3, 7.0),
        plain.simulation(0.5, 0.3),
    );
    let (a, b) = (a.expect("a run"), b.expect("a run"));
    assert_eq!(
        a.take(50).collect::<Vec<_>>(),
        b.take(50).collect::<Vec<_>>()
    );
}

/// Checks a start in which the contact slides with the speed of a point of the law, and then becomes slower or
/// faster. The point itself must decide nothing: a law with its point next to that speed must give the same motion,
/// in a run and in a stepper.
#[test]
fn from_a_point() {
    let (x, v) = ([0.002], [0.01]);
    let (mut compared, mut slower) = (0, 0);
    for force in [-9.0, -3.0, 0.0, 3.0, 9.0] {
        let system = |point: f64| -> System {
            let text = ONE.replace("excitation", "damping: modal(0.02), excitation");
            let law = [[0.005, 0.9], [point, 0.8], [0.5, 0.7]];
            lined(&text, 1.2, &law).try_into().expect("a scene")
        };
        let run = |point: f64| {
            let system = system(point);
            // In this scene P/k₁ and ω are 1 up to roundings.
            let (r, scale) = (0.5, 1e-2);
            let speed = scale * r * 20.0;
            let state = ([x[0] / scale], [v[0] / speed]);
            let run = system.simulation_under_from(r, 0.3, scale * 600.0, (&state.0, &state.1));
            let mut run = run.expect("a run");
            follow(&mut run, 0, 0.02);
            let events = follow(&mut run, 2, 0.0);
            (
                [
                    run.run().mass(0).displacement(),
                    run.run().mass(0).velocity(),
                ],
                events,
            )
        };
        let step = |point: f64| {
            let system = system(point);
            let mut stepper = system.stepper_from(1e-3, (&x, &v)).expect("a step");
            let mut events = 0;
            for _ in 0..400 {
                let input = frictiongen::study::SystemInput::force(force).friction(1.0);
                events += stepper.advance(input).expect("an input").events;
            }
            assert_eq!(stepper.exceeded(), 0);
            let now = stepper.mass_at(0);
            slower += u32::from(now.velocity() < 0.01);
            ([now.displacement(), now.velocity()], events as usize)
        };
        let mut step = step;
        for (on, beside) in [
            (run(0.01), run(0.01 * (1.0 + 1e-7))),
            (step(0.01), step(0.01 * (1.0 + 1e-7))),
        ] {
            assert_eq!(on.1, beside.1, "{force}");
            for (a, b) in on.0.iter().zip(&beside.0) {
                assert!((a - b).abs() < 1e-6, "{force}: {on:?}, {beside:?}");
                compared += 1;
            }
        }
    }
    assert_eq!(compared, 20);
    assert!(0 < slower);
}

//! Tests the commands on scenes with stops, moving surfaces and constant forces.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{column, failure, output, texts, words};

/// A gear: a motor and a load with play between them, a bumper, and a belt below the motor.
const GEAR: &str = "struct Gear { masses: { motor: 1.0, load: 2.0 },
    springs: { wall - motor: 100.0, motor - load: 30.0 },
    contacts: { seal: motor - wall { share: 0.2, speed: 0.1 }, pads: load - wall },
    stops: { bumper: load - wall { gap: 0.02, stiffness: 1e4, damping: 5 },
        tooth: load - motor { gap: 0.01, restitution: 0.6 } },
    constant: { load: 0.3 }, excitation: motor, damping: modal(0.02) }";

/// A block on a belt.
const BELT: &str = "struct Belt { masses: { block: 2.0 }, springs: { block - wall: 50.0 },
    contacts: { pads: block - wall { speed: 0.1, stiction: 1.5 } } }";

#[test]
fn commands_with_a_load_agree() {
    let line = "--hz 1 --force 2 --friction 0.5 --of load --csv";
    let orbit = output(GEAR, &words(&format!("orbit {line}")));
    for command in ["response", "map"] {
        let other = output(GEAR, &words(&format!("{command} {line}")));
        let name = "load.amplitude_m";
        assert_eq!(
            column(&other, name)[0],
            column(&orbit, name)[0],
            "{command}"
        );
    }
    // The bumper shuts and the tooth collides.
    assert_eq!(texts(&orbit, "tooth.regime"), ["impacts"]);
    assert!(column(&orbit, "tooth.stops")[0] > 0.0);
    let events = output(
        GEAR,
        &words("time --hz 1 --force 2 --friction 0.5 --cycles 20 --events --csv"),
    );
    let kinds = texts(&events, "event");
    assert!(kinds.contains(&"impact"), "{kinds:?}");
}

#[test]
fn the_limit_cycle_of_a_block_on_a_belt() {
    let line = output(BELT, &words("limit-cycle --friction 1 --csv"));
    // It slips about x = F/k between two instants of the speed V, and sticks until the force has risen by 2(μ − 1)F.
    let rate = 5.0_f64;
    let (drop, slope) = (0.5 / 50.0, 0.1 / rate);
    let slips = (std::f64::consts::TAU - 2.0 * (drop / slope).atan()) / rate;
    let period = slips + 2.0 * drop / 0.1;
    assert!((column(&line, "period_s")[0] - period).abs() < 1e-10);
    let json = output(BELT, &words("limit-cycle --friction 0 --json"));
    let value: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(value["cycles"].as_array().expect("a list").len(), 0);
    assert!(value["without"].as_str().expect("a reason").contains("0 N"));
}

#[test]
fn what_needs_a_closed_form_is_refused() {
    let message = failure(GEAR, &words("limits --hz 1 --force 1")).join("\n");
    assert!(message.contains("no closed form"), "{message}");
    let message = failure(GEAR, &words("orbit --r 1 --beta 0.1")).join("\n");
    assert!(
        message.contains("the amplitude of the load is needed"),
        "{message}"
    );
}

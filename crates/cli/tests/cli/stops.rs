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

/// `check` lists what the numbers of contacts and springs do not tell. The report shows the same.
#[cfg(feature = "report")]
#[test]
fn stops_and_belts_are_shown() {
    let scene = GEAR.replace("excitation", "dampers: { load - motor: 2.5 }, excitation");
    let text = output(&scene, &["check"]);
    for line in [
        "moving surface (m/s)       seal: 0.1",
        "stop (m, N/m, N s/m)       bumper: load - wall, gap 0.02, stiffness 10000.0, damping 5.0",
        "stop (m, N/m, N s/m)       tooth: load - motor, gap 0.01, restitution 0.6",
        "dashpot (N s/m)            load - motor: 2.5",
        "constant force (N)         load: 0.3",
    ] {
        assert!(
            text.lines().any(|printed| printed == line),
            "{line}\n{text}"
        );
    }
    let checked: serde_json::Value =
        serde_json::from_str(&output(&scene, &["check", "--json"])).expect("JSON");
    assert_eq!(checked["stops"][1]["restitution"], 0.6);
    assert_eq!(checked["stops"][0]["stiffness_N_m"], 1e4);
    assert!(checked["stops"][1]["stiffness_N_m"].is_null());
    assert_eq!(checked["moving_surfaces"][0]["speed_m_s"], 0.1);
    assert_eq!(checked["dashpots"][0]["coefficient_N_s_m"], 2.5);
    assert_eq!(checked["constant_forces"][0]["force_N"], 0.3);
    // A scene without them has none of the fields.
    let plain = output("", &["check", "--json", crate::common::FRAME]);
    assert!(!plain.contains("\"stops\"") && !plain.contains("moving_surfaces"));
    let tiny = "struct Tiny { masses: { m: 1 }, springs: { m - wall: 100 }, excitation: m,
        contacts: { seal: m - wall { speed: 0.1 } }, damping: modal(0.05), constant: { m: 1 },
        stops: { bumper: m - wall { gap: 0.2, stiffness: 1e3 } } }";
    let page = output(tiny, &words("report - --hz 1:2 --friction 1 --force 2"));
    for shown in [
        "<caption>Stops</caption>",
        "<caption>Constant forces</caption>",
        "surface speed (m/s)",
        "bumper, gap 0.2 m",
        "seal, 0.1 m/s",
    ] {
        assert!(page.contains(shown), "{shown}");
    }
}

//! Tests the commands on a scene with an elastic contact.

#![allow(clippy::indexing_slicing, reason = "a test may fail")]

use crate::common::{column, failure, output, texts};

/// Description of two floors with a damper on a brace.
const BRACED: &str = "struct Braced { masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, stiffness: 5.0e3,
    excitation: base, damping: modal[0.010, 0.012], provide: [orbit, simulation] }";

fn split(line: &str) -> Vec<&str> {
    line.split(' ').collect()
}

/// Checks that the commands agree with each other at one operating point. A difference over a millionth of the stiffness
/// has an error of about 1e-6 of the derivative.
#[test]
fn commands_agree() {
    let point = "--r 0.9 --beta 0.3 --of lower --csv";
    let asked = |command: &str, scene: &str| output(scene, &split(&format!("{command} {point}")));
    let amplitude = |scene: &str| column(&asked("orbit", scene), "lower.amplitude")[0];
    let orbit = asked("orbit", BRACED);
    assert_eq!(texts(&orbit, "regime"), ["stick-slip"]);
    assert_eq!(column(&orbit, "stops"), [2.0]);
    let response = asked("response", BRACED);
    assert_eq!(column(&response, "lower.amplitude")[0], amplitude(BRACED));
    let map = asked("map", BRACED);
    assert_eq!(column(&map, "lower.amplitude")[0], amplitude(BRACED));
    let limits = output(BRACED, &split("limits --r 0.9 --csv"));
    assert_eq!(column(&limits, "continuous_limit"), [0.0]);
    let sliding = column(&limits, "sliding_limit")[0];
    let line = format!("response --r 0.9 --beta {:?} --csv", 4.0 * sliding);
    assert_eq!(texts(&output(BRACED, &split(&line)), "regime"), ["stuck"]);

    let sensitivity = asked("sensitivity", BRACED);
    let parameters = texts(&sensitivity, "parameter");
    let place = parameters.iter().position(|name| *name == "stiffness");
    let derivative = place.map(|place| column(&sensitivity, "amplitude.derivative")[place]);
    let [above, below] = ["5000.5", "4999.5"].map(|k| amplitude(&BRACED.replace("5.0e3", k)));
    let difference = above - below;
    assert!(
        derivative.is_some_and(|one| (one - difference).abs() < 1e-6 * one.abs()),
        "{derivative:?} for {difference}"
    );
    let curve = output(
        BRACED,
        &split("curve --r 0.8:1.0 --beta 0.3 --of lower --accuracy 1e-2 --csv"),
    );
    let largest = column(&curve, "lower.amplitude")
        .into_iter()
        .fold(0.0, f64::max);
    assert!(amplitude(BRACED) <= largest, "{largest}");
}

/// Checks that commands without an answer for an elastic contact name the field and another command.
#[test]
fn other_commands_are_refused_by_name() {
    for line in ["features", "compile --accuracy 1e-4 --r 0.2:2.5"] {
        let told = failure(BRACED, &split(line));
        assert!(
            told[0].contains("has `stiffness`") && told[0].contains("`frictiongen orbit`"),
            "{told:?}"
        );
    }
}

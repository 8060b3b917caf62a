//! Tests `frictiongen orbit`.

use crate::common::{BLOCK, FRAME, cells, failure, json, output};

#[test]
fn table() {
    let arguments = [
        "orbit", FRAME, "--r", "0.3", "--beta", "0.1,3.0", "--mass", "lower",
    ];
    let text = output("", &arguments);
    let table = text.split("\n\n").nth(2).unwrap();
    let expected = "
  r  beta  regime      state      symmetry      period  stops  reversals         stuck    multiplier        offset  motion      amplitude         phase   fundamental
                                              (cycles)                     (of period)     (largest)        (of Y)                 (of Y)         (rad)         (rad)
---  ----  ----------  ---------  ----------  --------  -----  ---------  ------------  ------------  ------------  -------  ------------  ------------  ------------
0.3   0.1  stick-slip  stable     symmetric          1      2          0      0.016053      0.727854             0  contact      1.330410   -9.61382e-4      0.240597
                                                                                                                    lower        1.231456     -0.063372      0.148277
0.3   3.0  stuck       marginal   symmetric          1      0          0      1.000000      1.000000             0  contact             0             0
                                                                                                                    lower        0.494612    4.77119e-3    4.77119e-3
";
    assert_eq!(format!("\n{table}"), expected);
}

#[test]
fn stops_and_reversals_are_counted() {
    let arguments = ["orbit", "--r", "0.2,0.3", "--beta", "0.005,0.4", "--csv"];
    let text = output(BLOCK, &arguments);
    let cells = cells(&text);
    let value = |line: usize, name: &str| {
        let place = cells[0].iter().position(|cell| *cell == name);
        cells[line][place.unwrap()]
    };
    // At r = 1/5, β = 0.005 the motion has no stop, although β exceeds β_lim.
    assert_eq!((value(1, "stops"), value(1, "reversals")), ("0", "6"));
    let amplitude: f64 = value(1, "block.amplitude").parse().unwrap();
    assert!((amplitude - 0.993_884_883).abs() < 1e-9);
    // At r = 0.3, β = 0.4 the motion has two stops.
    assert_eq!((value(4, "stops"), value(4, "reversals")), ("2", "0"));
    let amplitude: f64 = value(4, "block.amplitude").parse().unwrap();
    assert!((amplitude - 0.856_729_778_057_8).abs() < 1e-12);
    assert_eq!(value(4, "symmetry"), "symmetric");
}

#[test]
fn a_point_without_a_steady_state_says_why() {
    let text = output(BLOCK, &["orbit", "--r", "1", "--beta", "0.4", "--csv"]);
    let line = text.lines().nth(1).unwrap();
    assert_eq!(line, "1.0,0.4,unbounded,unbounded,,,,,,,,,,,,,,,,");
    let text = output(BLOCK, &["orbit", "--r", "1", "--beta", "0.4", "--json"]);
    let point = &json(&text)["points"][0];
    assert_eq!(point["state"], "unbounded");
    assert!(point["stops"].is_null() && point.get("contacts").is_none());
}

#[test]
fn json_has_everything() {
    let arguments = [
        "orbit",
        "--r",
        "0.3",
        "--beta",
        "0.4",
        "--harmonics",
        "3",
        "--json",
    ];
    let json = json(&output(BLOCK, &arguments));
    let point = &json["points"][0];
    let stuck = point["stuck_fraction"].as_f64().unwrap();
    let intervals = point["sticking_intervals"].as_array().unwrap();
    let sum: f64 = intervals.iter().map(|pair| pair[1].as_f64().unwrap()).sum();
    assert!((sum / std::f64::consts::TAU - stuck).abs() < 1e-15);
    let largest = point["largest_multiplier"].as_f64().unwrap();
    let multipliers = point["multipliers"].as_array().unwrap();
    let moduli = multipliers
        .iter()
        .map(|pair| pair[0].as_f64().unwrap().hypot(pair[1].as_f64().unwrap()));
    assert_eq!(moduli.fold(0.0, f64::max), largest);
    let harmonics = point["masses"][0]["harmonics"].as_array().unwrap();
    assert_eq!(harmonics.len(), 4);
    // A symmetric motion has neither a mean nor even harmonics.
    for even in [0, 2] {
        assert!(harmonics[even]["amplitude"].as_f64().unwrap() < 1e-14);
    }
    assert!(harmonics[1]["amplitude"].as_f64().unwrap() > 0.8);
}

#[test]
fn an_asymmetric_state_has_a_mean() {
    let arguments = [
        "orbit",
        "--r",
        "0.5",
        "--beta",
        "0.2",
        "--harmonics",
        "2",
        "--csv",
    ];
    let text = output(BLOCK, &arguments);
    let cells = cells(&text);
    assert_eq!(cells[1][3..5], ["marginal", "asymmetric"]);
    let place = cells[0]
        .iter()
        .position(|cell| *cell == "block.X2.amplitude");
    let second: f64 = cells[1][place.unwrap()].parse().unwrap();
    assert!(second > 0.1, "{text}");
}

#[test]
fn r_must_be_positive_and_finite() {
    for (grid, entry) in [("0", "0"), ("0.5,inf", "inf"), ("0:0.1:1", "0:0.1:1")] {
        let lines = failure(BLOCK, &["orbit", "--r", grid, "--beta", "1"]);
        assert_eq!(
            lines,
            [format!(
                "frictiongen: --r `{entry}`: a motion in time needs a frequency ratio above 0 and below infinity; at 0 and infinity, use `limits` or `response`"
            )]
        );
    }
    let lines = failure(
        BLOCK,
        &["orbit", "--r", "1", "--beta", "1", "--mass", "brick"],
    );
    assert_eq!(lines.len(), 1, "{lines:?}");
}

const STUBBORN: &str = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
    contact: block - base, excitation: base, stiction: 2 }";

/// Checks that `--states` returns the closed form and the stuck state, one of which motion from rest reaches. Without
/// `--states` the command returns only the state that motion from rest reaches.
#[test]
fn states_beside_each_other() {
    let asked = ["orbit", "--r", "1.1", "--beta", "0.65", "--json"];
    let states = json(&output(STUBBORN, &[&asked[..], &["--states"]].concat()));
    let points = states["points"].as_array().unwrap();
    let of = |regime: &str| {
        let found: Vec<_> = points
            .iter()
            .filter(|point| point["regime"] == regime)
            .collect();
        assert_eq!(found.len(), 1, "{regime}");
        found[0]
    };
    assert_eq!(points.len(), 2);
    let (sliding, stuck) = (of("continuous"), of("stuck"));
    // The expected amplitude is that of Den Hartog's closed form.
    let amplitude = sliding["contacts"][0]["amplitude"].as_f64().unwrap();
    assert!((amplitude - CLOSED_FORM).abs() < 1e-9, "{amplitude}");
    assert_eq!(sliding["marginal"], false);
    assert_eq!(stuck["marginal"], true);
    let from_rest = points.iter().filter(|point| point["from_rest"] == true);
    assert_eq!(from_rest.count(), 1);
    let alone = json(&output(STUBBORN, &asked));
    assert_eq!(alone["points"].as_array().unwrap().len(), 1);
    assert_eq!(alone["points"][0], points[0]);
}

/// Checks motions from rest that do not settle. If the search finds a stable state, the output says so. If it finds
/// none, the list of `--states` contains the reason.
#[test]
fn motion_from_rest_that_does_not_settle() {
    let beside = "struct Block { masses: { m: 2.0236 }, springs: { base - m: 2.1892 }, contact: m - base, excitation: m,
        damping: modal[0.01283], stiction: 2.0819 }";
    let alone =
        "struct Block { masses: { block: 1 }, springs: { base - block: 1 }, contact: block - base,
        excitation: base, stiction: 3 }";
    let stable = "The line belongs to a stable state that Newton's method found";
    let none =
        "The search finds no stable state from rest, from the stuck contact, from the closed form";
    let most = 4096;
    for (scene, r, beta, state, note) in [
        (
            beside,
            "0.2721313546000634",
            "0.15681663485432779",
            "stable",
            stable,
        ),
        (alone, "0.3333333333333333", "0.01395", "unsettled", none),
    ] {
        let asked = ["orbit", "--r", r, "--beta", beta, "--states"];
        let found = json(&output(scene, &[&asked[..], &["--json"]].concat()));
        let points = found["points"].as_array().unwrap();
        // Newton's method also finds an unstable state.
        assert_eq!(points.len(), 2, "{found}");
        assert_eq!(points[1]["state"], "unstable");
        assert_eq!(points[0]["state"], state);
        assert_eq!(points[0]["from_rest"], state == "unsettled");
        let cycles = points[0]["cycles_followed"].as_u64().unwrap();
        assert!((most..most + 256).contains(&cycles), "{cycles}");
        let text = output(scene, &asked);
        let told = format!("Motion from rest does not settle in {cycles} cycles. {note}");
        assert!(text.contains(&told), "{text}");
    }
}

/// Amplitude over Y of the closed form, from z̄₀² = V² − β²U² at r = 1.1, β = 0.65, with the load r²Y.
const CLOSED_FORM: f64 = 4.038_387_375_443_518;

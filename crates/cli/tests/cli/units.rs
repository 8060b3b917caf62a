//! Tests answers in Hz, N, m and degrees, in place of non-dimensional groups.

#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{FRAME, cells, column_with_gaps as column, json, output};
use std::f64::consts::{PI, TAU};

/// Description of one undamped mass of 2 kg on a spring of 50 N/m.
const BLOCK: &str = "struct Block { masses: { block: 2 }, springs: { base - block: 50 },
    contact: block - wall, excitation: block }";

fn close(value: f64, expected: f64) {
    assert!(
        (value - expected).abs() <= 1e-12 * expected.abs(),
        "{value} {expected}"
    );
}

/// Compares with newtons and metres computed by hand, for P = 10 N, F = 2 N, 1.5 Hz.
#[test]
fn one_mass_by_hand() {
    let (mass, stiffness, force, friction, hz) = (2.0_f64, 50.0_f64, 10.0, 2.0, 1.5);
    let (omega, natural) = (TAU * hz, (stiffness / mass).sqrt());
    let v = force / (stiffness - mass * omega * omega);
    let u = friction * (PI * natural / (2.0 * omega)).tan() * natural / (stiffness * omega);
    let amplitude = (v * v - u * u).sqrt();
    let phase = ((-u).atan2(amplitude) + PI).to_degrees();
    for frequency in [["--hz", "1.5"], ["--omega", &format!("{omega:?}")]] {
        let rest = ["--friction", "2", "--force", "10", "--csv"];
        let text = output(
            BLOCK,
            &[&["response"][..], &frequency, &rest, &["--harmonics", "1"]].concat(),
        );
        for part in ["block", "contact"] {
            close(column(&text, &format!("{part}.amplitude_m"))[0], amplitude);
            close(column(&text, &format!("{part}.phase_deg"))[0], phase);
            let estimate = format!("{part}.amplitude_monoharmonic_m");
            assert!((column(&text, &estimate)[0] / amplitude - 1.0).abs() < 0.02);
        }
        close(column(&text, "frequency_Hz")[0], hz);
        close(column(&text, "r")[0], omega / natural);
        close(column(&text, "friction_N")[0], friction);
        close(column(&text, "beta")[0], friction / force);
        let limits = [&["limits"][..], &frequency, &rest[2..]].concat();
        let limits = output(BLOCK, &limits);
        // Without damping and with μ = 1 the block slides under any friction below P.
        close(column(&limits, "sliding_limit_N")[0], force);
        close(column(&limits, "sliding_limit")[0], 1.0);
        let header = limits.lines().next().unwrap();
        assert_eq!(header.contains("omega_rad_s"), frequency[0] == "--omega");
    }
}

/// Checks a frame solved by hand. If the upper floor sticks, the lower one is a mass on both springs, and the base
/// drives it by k₁Y.
#[test]
fn the_frame_by_hand() {
    let scene = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190, lower - upper: 1323 }, contact: upper - wall, excitation: base }";
    let arguments = "response - --hz 3:1:6 --friction 50 --base 0.002 --csv";
    let text = output(scene, &arguments.split(' ').collect::<Vec<_>>());
    let amplitudes = column(&text, "lower.amplitude_m");
    let phases = column(&text, "lower.phase_deg");
    assert_eq!(amplitudes.len(), 4);
    for ((hz, amplitude), phase) in (3_u8..).zip(amplitudes).zip(phases) {
        let omega = TAU * f64::from(hz);
        let expected = 1190.0 * 0.002 / (1190.0 + 1323.0 - 3.27 * omega * omega);
        close(amplitude, expected.abs());
        let lag: f64 = if expected < 0.0 { 180.0 } else { 0.0 };
        assert!((phase.abs() - lag).abs() < 1e-12, "{phase} {lag}");
    }
    close(column(&text, "beta")[0], 50.0 / (1190.0 * 0.002));
}

/// Checks that every physical column is a column of groups in other units, in every regime.
#[test]
fn columns_beside_those_of_the_groups() {
    let mut compared = 0;
    for (command, orders) in [("response", "3"), ("orbit", "2")] {
        let grids = ["--r", "0.3:0.3:1.5", "--beta", "0.05,0.4,3"];
        let rest = ["--harmonics", orders, "--csv"];
        let arguments = [&[command, FRAME][..], &grids, &rest].concat();
        let groups = output("", &arguments);
        let physical = output("", &[&arguments[..], &["--base", "0.002"]].concat());
        let names: Vec<String> = cells(&physical)[0]
            .iter()
            .map(|name| (*name).to_owned())
            .collect();
        for name in names {
            let (plain, unit) = match name.as_str() {
                "friction_N" => ("beta", 0.002 * 1190.0),
                "frequency_Hz" => ("r", (1190.0_f64 / 3.27).sqrt() / TAU),
                // Groups have no column in seconds. The test `stops_in_seconds` covers these columns.
                "regime" | "answer" | "state" | "symmetry" | "longest_stop_s" => continue,
                name => match (name.strip_suffix("_m"), name.strip_suffix("_deg")) {
                    (Some(plain), _) => (plain, 0.002),
                    (_, Some(plain)) => (plain, 180.0 / PI),
                    _ => (name, 1.0),
                },
            };
            let (values, plain) = (column(&physical, &name), column(&groups, plain));
            assert_eq!(values.len(), plain.len());
            for (value, plain) in values.into_iter().zip(plain) {
                assert_eq!(value.is_nan(), plain.is_nan());
                if !plain.is_nan() {
                    assert!(
                        (value - plain * unit).abs() <= 1e-13 * value.abs(),
                        "{name}"
                    );
                    compared += 1;
                }
            }
        }
    }
    println!("{compared} values");
    assert!(compared > 500);
}

/// Checks that sticking intervals are given in seconds, in addition to the phase of the excitation.
#[test]
fn stops_in_seconds() {
    let arguments = "orbit - --r 0.3 --beta 0.4 --force 10";
    let arguments: Vec<_> = arguments.split(' ').collect();
    let found = json(&output(BLOCK, &[&arguments[..], &["--json"]].concat()));
    let point = &found["points"][0];
    let pairs = |name: &str| -> Vec<[f64; 2]> {
        let pairs = point[name].as_array().unwrap().iter();
        let number = |value: &serde_json::Value| value.as_f64().unwrap();
        pairs
            .map(|pair| [number(&pair[0]), number(&pair[1])])
            .collect()
    };
    let omega = 0.3 * (50.0_f64 / 2.0).sqrt();
    let (angles, seconds) = (pairs("sticking_intervals"), pairs("sticking_intervals_s"));
    assert_eq!((angles.len(), seconds.len()), (2, 2));
    for (angles, seconds) in angles.iter().flatten().zip(seconds.iter().flatten()) {
        assert!(
            (seconds * omega - angles).abs() < 1e-14,
            "{seconds} {angles}"
        );
    }
    let text = output(BLOCK, &[&arguments[..], &["--csv"]].concat());
    let longest = seconds[0][1].max(seconds[1][1]);
    assert_eq!(column(&text, "longest_stop_s"), [longest]);
    close(column(&text, "frequency_Hz")[0], omega / TAU);
}

#[test]
fn table_of_limits() {
    let arguments = "limits - --hz 0.5,1.5,inf --force 10";
    let text = output(BLOCK, &arguments.split(' ').collect::<Vec<_>>());
    let expected = "\
Block: 1 mass, contact block - wall, force on block, undamped, stiction 1.0

natural frequencies (rad/s)      5.000000
natural frequencies (Hz)         0.795775
resonances r                     1.000000
groups                       r = omega sqrt(m1/k1), beta = F/P
load                         P = 10.000000 N, P/k1 = 0.200000 m

";
    let (preamble, table) = text.split_at(expected.len());
    assert_eq!(preamble, expected);
    let lines: Vec<&str> = table.lines().collect();
    let words = |line: usize| lines[line].split_whitespace().collect::<Vec<_>>();
    assert_eq!(words(0)[..3], ["frequency", "r", "continuous"]);
    assert_eq!(words(1)[..5], ["(Hz)", "(N)", "(N)", "(N)", "(N)"]);
    assert_eq!(
        words(1)[5..],
        ["beta_lim", "beta_lim", "beta_lim", "beta*_lim"]
    );
    assert_eq!(words(3)[0], "0.5");
    assert_eq!(words(4)[5], "10.000000");
    assert_eq!(words(5)[..2], ["inf", "inf"]);
}

#[test]
fn tables_of_motions() {
    let arguments = "--omega 6 --friction 0.3 --base 0.001 --harmonics 1";
    for command in ["response", "orbit"] {
        let arguments = arguments.split(' ');
        let arguments: Vec<&str> = [command, FRAME].into_iter().chain(arguments).collect();
        let text = output("", &arguments);
        assert!(
            text.contains("\nload                         Y = 1.00000e-3 m, k1 Y = 1.190000 N\n")
        );
        for unit in ["(Hz)", "(rad/s)", "(N)", "(m)", "(deg)"] {
            assert!(text.contains(unit), "{text}");
        }
        assert!(
            !text.contains("(of Y)") && !text.contains("(rad) "),
            "{text}"
        );
    }
}

#[test]
fn json_names_hold_units() {
    let arguments = "--omega 6 --friction 0.3 --base 0.001 --harmonics 1 --json";
    for command in ["response", "orbit"] {
        let arguments = arguments.split(' ');
        let arguments: Vec<&str> = [command, FRAME].into_iter().chain(arguments).collect();
        let json = json(&output("", &arguments));
        close(
            json["natural_frequencies_Hz"][0].as_f64().unwrap(),
            11.980_928_093_791_238 / TAU,
        );
        close(json["load"]["force_N"].as_f64().unwrap(), 1.19);
        close(json["load"]["length_m"].as_f64().unwrap(), 0.001);
        let point = &json["points"][0];
        for name in ["frequency_Hz", "omega_rad_s", "r", "friction_N", "beta"] {
            assert!(point[name].is_number(), "{name}: {point}");
        }
        for part in [&point["contacts"][0], &point["masses"][1]] {
            assert!(part["amplitude_m"].as_f64().unwrap() < 0.01, "{part}");
            assert!(part["phase_deg"].as_f64().unwrap() > 5.0, "{part}");
            assert!(part.get("amplitude").is_none() && part.get("phase").is_none());
            let fundamental = part["harmonics"].as_array().unwrap();
            let fundamental = fundamental
                .iter()
                .find(|harmonic| harmonic["n"] == 1)
                .unwrap();
            let field = |name: &str| fundamental[name].as_f64().unwrap();
            close(field("amplitude_m"), field("re_m").hypot(field("im_m")));
            close(
                field("phase_deg"),
                -field("im_m").atan2(field("re_m")).to_degrees(),
            );
        }
    }
}

/// Checks that physical quantities do not depend on the order of masses and springs, although r and β refer to the
/// first ones.
#[test]
fn no_order_of_a_description_changes_a_physical_answer() {
    let masses = ["lower: 3.27", "upper: 3.25"];
    let springs = ["base - lower: 1190", "lower - upper: 1323"];
    let (mut compared, mut negligible) = (0, 0);
    for (contact, excitation, load) in [
        ("upper - wall", "base", ["--base", "0.001"]),
        ("lower - upper", "base", ["--base", "0.001"]),
        ("upper - wall", "lower", ["--force", "1.19"]),
    ] {
        let scene = |swap_masses: bool, swap_springs: bool| {
            let order = |swap: bool, list: [&str; 2]| match swap {
                true => format!("{}, {}", list[1], list[0]),
                false => list.join(", "),
            };
            format!(
                "struct Frame {{ masses: {{ {} }}, springs: {{ {} }}, contact: {contact},
                 excitation: {excitation}, damping: modal[0.010, 0.012], stiction: 1.2 }}",
                order(swap_masses, masses),
                order(swap_springs, springs)
            )
        };
        for command in ["limits", "response", "orbit"] {
            let mut arguments = vec![command, "-", "--hz", "1.1,2.7,4.3", "--csv"];
            arguments.extend(load);
            if command != "limits" {
                arguments.extend(["--friction", "0.1,0.45,9", "--harmonics", "3"]);
                arguments.extend(["--mass", "lower", "--mass", "upper"]);
            }
            let expected = output(&scene(false, false), &arguments);
            for (swap_masses, swap_springs) in [(true, false), (false, true), (true, true)] {
                let text = output(&scene(swap_masses, swap_springs), &arguments);
                assert_ne!(column(&text, "r"), column(&expected, "r"));
                let names = cells(&expected)[0].clone();
                for name in names.into_iter().filter(|name| {
                    ["_m", "_N", "_Hz", "_deg"]
                        .iter()
                        .any(|unit| name.ends_with(unit))
                }) {
                    // A motion that vanishes has no meaningful phase, so its phase is not compared.
                    let size = name
                        .replace("fundamental_phase_deg", "amplitude_m")
                        .replace("phase_deg", "amplitude_m");
                    let sizes = column(&expected, &size);
                    let pairs = column(&text, name).into_iter().zip(column(&expected, name));
                    for ((value, expected), size) in pairs.zip(sizes) {
                        if value.is_nan() || size.abs() < 1e-12 {
                            assert_eq!(value.is_nan(), expected.is_nan());
                            negligible += 1;
                            continue;
                        }
                        let turn = if name.ends_with("_deg") {
                            360.0
                        } else {
                            f64::INFINITY
                        };
                        let difference = (value - expected).abs();
                        let difference = difference.min((turn - difference).abs());
                        // The error of a small harmonic is relative to the motion that contains it.
                        let scale = match name.rsplit('_').next() {
                            Some("deg") => 180.0 * (0.001 / size).max(1.0),
                            Some("m") => expected.abs().max(0.001),
                            _ => expected.abs(),
                        };
                        assert!(
                            difference <= 1e-12 * scale,
                            "{contact} {command} {name}: {value} {expected}"
                        );
                        compared += 1;
                    }
                }
            }
        }
    }
    println!("{compared} values, {negligible} of what does not move");
    assert!(compared > 1500);
}

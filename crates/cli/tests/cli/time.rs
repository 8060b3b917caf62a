//! Tests `frictiongen time`.

#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{
    BLOCK, FRAME, cells, column, column_with_gaps, failure, json, output, texts, words,
};
use frictiongen::study::{history::HistoryRequest, units::Load};
use frictiongen::{Of, System};
use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::PathBuf;

fn frame() -> System {
    fs::read_to_string(FRAME).unwrap().parse().unwrap()
}

fn temporary(name: &str) -> PathBuf {
    let folder =
        std::env::temp_dir().join(format!("frictiongen-time-{}-{name}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Checks that the samples equal those of the library to the last bit.
#[test]
fn samples_are_those_of_the_library() {
    let line = "time FILE --r 0.9 --beta 0.6 --cycles 4 --skip 3 --samples 50 --csv";
    let arguments = line.replace("FILE", FRAME);
    let csv = output("", &words(&arguments));
    let header = "tau,contact.displacement,contact.velocity,lower.displacement,lower.velocity,\
                  upper.displacement,upper.velocity,contact.friction,contact.state";
    assert_eq!(csv.lines().next().unwrap(), header);
    let request = HistoryRequest {
        skip: 3,
        cycles: 4,
        samples: 50,
        ..HistoryRequest::new(&[Of::Contact, Of::Mass(0), Of::Mass(1)])
    };
    let history = frame().history(0.9, 0.6, &request).unwrap();
    let expected: Vec<f64> = (0..history.len()).map(|index| history.tau(index)).collect();
    assert_eq!(column(&csv, "tau"), expected);
    for (name, track) in ["contact", "lower", "upper"].iter().zip(&history.tracks) {
        assert_eq!(
            column(&csv, &format!("{name}.displacement")),
            track.displacement
        );
        assert_eq!(column(&csv, &format!("{name}.velocity")), track.velocity);
    }
    assert_eq!(column(&csv, "contact.friction"), history.friction);
    let states = texts(&csv, "contact.state");
    for state in ["stuck", "forward", "backward"] {
        assert!(states.contains(&state), "{state}");
    }
    // The events must equal those of the library.
    let csv = output("", &words(&format!("{arguments} --events --of lower")));
    let header = "tau,event,contact.state,lower.displacement";
    assert_eq!(csv.lines().next().unwrap(), header);
    let expected: Vec<f64> = history.events.iter().map(|event| event.tau).collect();
    assert_eq!(column(&csv, "tau"), expected);
    let events = texts(&csv, "event");
    assert!(events.contains(&"stop") && events.contains(&"break-away"));
}

/// Checks that every physical column is a column of groups in other units.
#[test]
fn columns_beside_those_of_the_groups() {
    let system = frame();
    let omega = TAU * 2.7;
    let r = system.frequency_ratio_at_hertz(2.7);
    let scale = system.load_scale(Load::Base(0.002)).unwrap();
    let beta = scale.friction_ratio(1.9);
    let groups = format!("time {FRAME} --r {r:?} --beta {beta:?} --csv");
    let physical = format!("time {FRAME} --hz 2.7 --friction 1.9 --base 0.002 --csv");
    let mut compared = 0;
    for rest in [
        "--cycles 6",
        "--cycles 4 --skip 7 --events",
        "--steady --samples 100",
        "--steady --spectrum --samples 20",
        "--cycles 2 --skip 300 --spectrum --samples 20",
    ] {
        let groups = output("", &words(&format!("{groups} {rest}")));
        let physical = output("", &words(&format!("{physical} {rest}")));
        for name in cells(&physical)[0].clone() {
            let (plain, unit) = match name {
                "event" | "contact.state" => {
                    assert_eq!(texts(&physical, name), texts(&groups, name));
                    continue;
                }
                "time_s" => ("tau", 1.0 / omega),
                "frequency_Hz" => ("order", 2.7),
                "contact.friction_N" => ("contact.friction", 0.002 * 1190.0),
                name => match (
                    name.strip_suffix("_m"),
                    name.strip_suffix("_m_s"),
                    name.strip_suffix("_deg"),
                ) {
                    (Some(plain), ..) => (plain, 0.002),
                    (_, Some(plain), _) => (plain, 0.002 * omega),
                    (.., Some(plain)) => (plain, 180.0 / PI),
                    _ => (name, 1.0),
                },
            };
            let pairs = column(&physical, name)
                .into_iter()
                .zip(column(&groups, plain));
            for (value, plain) in pairs {
                let expected = plain * unit;
                assert!((value - expected).abs() <= 1e-12 * expected.abs(), "{name}");
                compared += 1;
            }
        }
    }
    println!("{compared} values");
    assert!(compared > 10_000);
}

/// Checks that the exact spectrum has the harmonics of `response`.
#[test]
fn a_steady_spectrum_has_the_harmonics_of_the_response() {
    let point = format!("{FRAME} --omega 16 --friction 0.3 --base 0.001");
    let spectrum = output(
        "",
        &words(&format!(
            "time {point} --steady --spectrum --csv --samples 12"
        )),
    );
    let response = output("", &words(&format!("response {point} --harmonics 5 --csv")));
    assert_eq!(
        column(&spectrum, "order"),
        [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    );
    for part in ["contact", "lower", "upper"] {
        for what in ["amplitude_m", "phase_deg"] {
            let lines = column(&spectrum, &format!("{part}.{what}"));
            for order in [1, 3, 5] {
                let expected = column(&response, &format!("{part}.X{order}.{what}"))[0];
                assert_eq!(lines[order], expected, "{part} {what} {order}");
            }
        }
    }
}

#[test]
fn json_says_what_is_meant() {
    let line = format!("time {FRAME} --hz 2.7 --friction 1.9 --base 0.002 --json --samples 4");
    let run = json(&output("", &words(&format!("{line} --cycles 2 --skip 1"))));
    assert_eq!(
        (&run["version"], &run["scene"]),
        (&1.into(), &"Frame".into())
    );
    for (name, value) in [("cycles", 2), ("skipped", 1), ("samples_per_cycle", 4)] {
        assert_eq!(run[name], value);
    }
    assert_eq!(
        (&run["motion"], run["regime"].is_null()),
        (&"from rest".into(), true)
    );
    assert!(run["frequency_Hz"] == 2.7 && run["friction_N"] == 1.9 && run["beta"].is_number());
    let points = run["points"].as_array().unwrap();
    assert_eq!(points.len(), 9);
    let point = &points[3];
    assert!(point["time_s"].is_number() && point["tau"].is_number());
    for name in ["displacement_m", "velocity_m_s", "friction_N"] {
        assert!(point["contacts"][0][name].is_number(), "{name}");
    }
    assert!(point["contacts"][0]["state"].is_string());
    assert_eq!(point["masses"][1]["name"], "upper");
    assert!(point["masses"][1]["velocity_m_s"].is_number());
    let steady = json(&output("", &words(&format!("{line} --steady --events"))));
    assert_eq!(
        (&steady["motion"], &steady["regime"]),
        (&"steady".into(), &"stuck".into())
    );
    assert_eq!(steady["points"].as_array().unwrap().len(), 0);
}

#[test]
fn a_table_for_people() {
    let arguments = "time - --hz 0.5 --beta 0.4 --force 10 --cycles 1 --samples 2";
    let text = output(BLOCK, &words(arguments));
    let expected = "\
load                         P = 10.000000 N, P/k1 = 10.000000 m
at                           frequency_Hz = 0.500000, r = 3.141593, friction_N = 4.000000, beta = 0.400000
motion                       from rest, cycles 0 to 1, 2 samples a cycle

        time           tau       contact       contact         block         block       contact  contact
         (s)                displacement      velocity  displacement      velocity      friction  state
                                     (m)         (m/s)           (m)         (m/s)           (N)
";
    assert!(text.contains(expected), "{text}");
    assert_eq!(
        text.lines().filter(|line| line.ends_with("ward")).count(),
        3
    );
}

/// Checks that the initial state is in the units of the load.
#[test]
fn from_a_state() {
    let line = "time - --r 0.7 --beta 0.2 --cycles 2 --samples 10 --csv";
    let groups = output(BLOCK, &words(&format!("{line} --from -0.5;1.25")));
    assert_eq!(column(&groups, "block.displacement")[0], -0.5);
    assert_eq!(column(&groups, "block.velocity")[0], 1.25);
    // The units are 4 m for a displacement (P/k₁), and ω = 0.7 rad/s for a velocity.
    let physical = output(BLOCK, &words(&format!("{line} --force 4 --from -2;3.5")));
    assert_eq!(column(&physical, "time_s")[10], TAU / 0.7);
    let pairs = column(&physical, "block.displacement_m").into_iter();
    for (value, plain) in pairs.zip(column(&groups, "block.displacement")) {
        assert!((value - 4.0 * plain).abs() < 1e-13);
    }
}

/// Returns the turning points of an undamped block with Coulomb friction in free vibration, each with its instant. The
/// block vibrates about −F/k while it moves forward and about F/k while it moves backward. Its last turning point is
/// where the friction holds it.
fn turns([mass, spring, friction]: [f64; 3], [x, v]: [f64; 2]) -> Vec<(f64, f64)> {
    let omega = (spring / mass).sqrt();
    let (centre, mut side) = (friction / spring, v.signum());
    let about = x + side * centre;
    let mut turns = vec![(
        (side * v / omega).atan2(side * about) / omega,
        side * (about.hypot(v / omega) - centre),
    )];
    while let Some((time, place)) = turns.last().copied() {
        if place.abs() <= centre {
            break;
        }
        side = -side;
        turns.push((time + PI / omega, -place - 2.0 * side * centre));
    }
    turns
}

/// Free vibrations follow the closed form, with both solvers (that for several contacts with a share of one half), with and without an excitation in the description, and
/// under a load that is too small to matter.
#[test]
fn free_vibrations_lose_four_times_the_friction_over_the_stiffness_in_a_cycle() {
    let mut compared = 0;
    // The first one is the friction oscillator of Siconos, which comes to rest at 15 − √205.
    for (block, state) in [
        ([1.0, 1.0, 1.0], [12.0, 6.0]),
        ([1.0, 0.3, 0.5], [1.0, 2.0]),
        ([2e-3, 4e5, 3e-7], [-1e-11, 0.5e-6]),
        ([5e3, 2e6, 7e4], [0.9, -1.0]),
    ] {
        let [mass, spring, friction] = block;
        let expected = turns(block, state);
        let until = expected.last().unwrap().0 * 1.01;
        let contact = [
            ("contact: block - wall", friction),
            (
                "contacts: { pads: block - wall { share: 0.5 } }",
                2.0 * friction,
            ),
        ];
        let excited = ["", ", excitation: block", ", excitation: base"];
        let all = contact.iter().flat_map(|c| excited.map(|e| (c, e)));
        for ((contact, common), excited) in all {
            let scene = format!(
                "struct B {{ masses: {{ block: {mass} }}, springs: {{ base - block: {spring} }}, {contact}{excited} }}"
            );
            let [x, v] = state;
            let line = format!("time - --from {x};{v} --friction {common} --csv");
            let free = format!("{line} --until {until}");
            let mut runs = vec![(free.clone(), until)];
            if excited == ", excitation: block" && friction == 0.5 {
                // One cycle of the load is 10 s.
                for force in ["1e-12", "1e-160", "1e-250"] {
                    runs.push((format!("{line} --hz 0.1 --cycles 1 --force {force}"), 10.0));
                }
            }
            for (line, end) in runs {
                let events = output(&scene, &words(&format!("{line} --events")));
                let found = column(&events, "time_s").into_iter();
                let found = found.zip(column(&events, "block.displacement_m"));
                let found: Vec<(f64, f64)> = found.collect();
                assert_eq!(found.len(), expected.len(), "{line}: {events}");
                for ((time, place), (at, there)) in found.iter().zip(&expected) {
                    // The load of 1e-12 N moves the block by about its share of the friction.
                    let size = expected[0].1.abs();
                    assert!((time - at).abs() < 1e-11 * until, "{line}: {time} for {at}");
                    assert!(
                        (place - there).abs() < 1e-11 * size,
                        "{line}: {place} for {there}"
                    );
                    compared += 1;
                }
                assert_eq!(texts(&events, "event").last(), Some(&"stop"), "{line}");
                let samples = output(&scene, &words(&line));
                assert_eq!(column(&samples, "time_s").last(), Some(&end));
                let last = *column(&samples, "block.displacement_m").last().unwrap();
                let (_, rest) = expected.last().unwrap();
                assert!(
                    (last - rest).abs() < 1e-11 * expected[0].1.abs(),
                    "{line}: {last}"
                );
                assert_eq!(column(&samples, "block.velocity_m_s").last(), Some(&0.0));
            }
            assert!(!output(&scene, &words(&free)).contains("tau"));
        }
    }
    println!("{compared} events");
}

/// A damped frame with a rigid or elastic contact, with two independent solvers.
#[test]
fn free_vibrations_of_a_frame() {
    let head = "struct F { masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190, lower - upper: 1323 }, damping: modal(0.01)";
    for (one, many) in [
        (
            "contact: upper - wall, stiction: 1.2",
            "pads: upper - wall { stiction: 1.2, share: 0.5 }",
        ),
        (
            "contact: lower - upper, stiffness: 4e3, provide: [orbit]",
            "pads: lower - upper { stiffness: 4e3, share: 0.5 }",
        ),
    ] {
        let line = "time - --from 0.01,0.004;0.1,-0.2 --until 3 --friction 2 --samples 300 --csv";
        let one = output(&format!("{head}, {one} }}"), &words(line));
        let twice = line.replace("--friction 2", "--friction 4");
        let many = output(
            &format!("{head}, contacts: {{ {many} }} }}"),
            &words(&twice),
        );
        for name in ["lower.displacement_m", "upper.velocity_m_s"] {
            for (one, many) in column(&one, name).into_iter().zip(column(&many, name)) {
                // The displacements are about 0.01 m, and the velocities 0.2 m/s.
                assert!((one - many).abs() < 1e-12, "{name}: {one} {many}");
            }
        }
        let sticks = texts(&one, "contact.state")
            .into_iter()
            .map(|state| state == "stuck");
        let others = texts(&many, "pads.sticks")
            .into_iter()
            .map(|text| text == "true");
        assert!(sticks.eq(others));
    }
}

/// Checks that a file has the content of standard output, and that no other file remains next to it.
#[test]
fn files_are_whole() {
    let folder = temporary("whole");
    for ending in ["csv", "json"] {
        let path = folder.join(format!("motion.{ending}"));
        let shown = path.to_str().unwrap();
        fs::write(&path, "what was there before, and longer than nothing").unwrap();
        let line = format!("time {FRAME} --r 0.9 --beta 0.6 --cycles 2");
        let written = output("", &[&words(&line)[..], &["-o", shown]].concat());
        assert_eq!(written, "");
        let expected = output("", &words(&format!("{line} --{ending}")));
        assert_eq!(fs::read_to_string(&path).unwrap(), expected);
    }
    // A command that fails leaves an existing file unchanged.
    let path = folder.join("motion.csv");
    let before = fs::read_to_string(&path).unwrap();
    let shown = path.to_str().unwrap();
    let line = "time - --r 0.7 --beta 0.2 --from 0;0,0 -o";
    failure(BLOCK, &[&words(line)[..], &[shown]].concat());
    assert_eq!(fs::read_to_string(&path).unwrap(), before);
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 2);
    fs::remove_dir_all(&folder).unwrap();
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = temporary("full");
    let link = folder.join("full.csv");
    std::os::unix::fs::symlink("/dev/full", &link).unwrap();
    let shown = link.to_str().unwrap();
    let arguments = ["time", FRAME, "--r", "0.9", "--beta", "0.6", "-o", shown];
    let message = format!("frictiongen: cannot write {shown}: no space is left");
    assert_eq!(failure("", &arguments), [message]);
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
    fs::remove_dir_all(&folder).unwrap();
}

/// The area of the hysteresis loop of a steady state is the energy that the contact dissipates in a cycle. A polygon
/// through 20,000 samples misses a corner of the loop by less than 1e-4 of the area: at a reversal the slip changes by
/// (2π/20,000)² of its amplitude, and where the contact slips again the force changes by the static friction.
#[test]
fn the_loop_has_the_dissipated_energy() {
    let point = ["--friction", "0.4", "--base", "0.001", "--csv"];
    let table = |arguments: &[&str]| output("", &[arguments, &point].concat());
    for hertz in ["1.2", "1.7", "2.5"] {
        let samples = table(&[
            "time",
            FRAME,
            "--hz",
            hertz,
            "--steady",
            "--samples",
            "20000",
        ]);
        let slip = column(&samples, "contact.displacement_m");
        let force = column(&samples, "contact.friction_N");
        let area: f64 = (0..slip.len())
            .map(|index| {
                let next = (index + 1) % slip.len();
                0.5 * (force[index] + force[next]) * (slip[next] - slip[index])
            })
            .sum();
        let band = format!("{hertz}:{}", hertz.parse::<f64>().unwrap() + 0.1);
        let curve = table(&["curve", FRAME, "--hz", &band]);
        let power = column_with_gaps(&curve, "friction_power_W")[0];
        let energy = power / column(&curve, "frequency_Hz")[0];
        assert!(
            (area.abs() / energy - 1.0).abs() < 1e-4,
            "{hertz}: {area} {energy}"
        );
    }
}

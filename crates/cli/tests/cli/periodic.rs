//! Tests of `frictiongen periodic`: tables of one period, harmonics, and loads that mean nothing.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{FRAME, column, failure, file, json, output, texts};
use std::fs;

/// A block of 2 kg under a force.
const PUSHED: &str =
    "struct Block { masses: { m: 2 }, springs: { base - m: 800 }, contact: m - wall,
    excitation: m, damping: modal(0.05) }";

const TRIANGLE: &str = "time_s,force_N\n0,0\n0.2,30\n0.4,0\n0.6,-30\n0.8,0\n";

/// A table gives the steady state, its energy balance, and the motion over a period with the same extremes.
#[test]
fn a_table_of_one_period() {
    let block = file("block.friction", PUSHED);
    let table = file("triangle.csv", TRIANGLE);
    let asked = ["periodic", &block, &table, "--friction", "4,8,100"];
    let text = output("", &[&asked[..], &["--csv"]].concat());
    assert_eq!(texts(&text, "state"), ["stable", "stable", "marginal"]);
    assert_eq!(column(&text, "period"), [1.0; 3]);
    let [loads, frictions, dampings] =
        ["load", "friction", "damping"].map(|name| column(&text, &format!("{name}_work_J")));
    for ((load, friction), damping) in loads.iter().zip(frictions).zip(dampings).take(2) {
        assert!(0.0 < friction && 0.0 < damping);
        assert!((load - friction - damping).abs() < 1e-10 * load);
    }
    // With 100 N the contact never slides.
    assert_eq!(column(&text, "stuck_fraction")[2], 1.0);
    assert_eq!(column(&text, "m.largest_m")[2], 0.0);
    let largest = column(&text, "m.largest_m")[1];
    let least = column(&text, "m.least_m")[1];
    assert!(
        (largest + least).abs() < 1e-9 * largest,
        "{least} {largest}"
    );
    let motion = [
        "periodic",
        &block,
        &table,
        "--friction",
        "8",
        "--motion",
        "--csv",
    ];
    let motion = output("", &motion);
    let places = column(&motion, "m.displacement_m");
    let most = places.iter().copied().fold(0.0, f64::max);
    assert!((most / largest - 1.0).abs() < 1e-3 && most <= largest * (1.0 + 1e-12));
    assert!((places[0] - places[places.len() - 1]).abs() < 1e-10 * largest);
    let all = json(&output("", &[&asked[..], &["--json"]].concat()));
    let multipliers = &all["points"][0]["multipliers"];
    assert_eq!(multipliers.as_array().unwrap().len(), 2);
}

/// A square wave needs `--hold`, without which the table is a trapezium. Harmonics need no file.
#[test]
fn a_square_wave_and_harmonics() {
    let block = file("square.friction", PUSHED);
    let table = file(
        "square.csv",
        "time_s,force_N\n0,40\n0.2,40\n0.4,-40\n0.6,-40\n0.8,40\n",
    );
    let work = |more: &[&str]| {
        let asked = ["periodic", &block, &table, "--friction", "6", "--csv"];
        column(&output("", &[&asked[..], more].concat()), "load_work_J")[0]
    };
    let (held, joined) = (work(&["--hold"]), work(&[]));
    assert!(joined < 0.99 * held, "{held} {joined}");
    // The work of a sum of harmonics is the same whatever the shift of its phases in time.
    let sum = |list: &str| {
        let asked = [
            "periodic",
            &block,
            "--harmonics",
            list,
            "--hz",
            "1.25",
            "--friction",
            "6",
            "--csv",
        ];
        column(&output("", &asked), "friction_work_J")[0]
    };
    let (here, later) = (sum("1:40@0, 3:15@45"), sum("1:40@10,3:15@75"));
    assert!((here / later - 1.0).abs() < 1e-8, "{here} {later}");
    // The base may follow harmonics, and motions are then relative to the base.
    let frame = [
        "periodic",
        FRAME,
        "--harmonics",
        "1:0.001,2:0.0004@90",
        "--hz",
        "1.2",
        "--friction",
        "0.4",
    ];
    let text = output("", &frame);
    assert!(
        text.contains("upper-base") && text.contains("stable"),
        "{text}"
    );
}

/// Each load that means nothing is one line that names the way out.
#[test]
fn loads_that_mean_nothing() {
    let block = file("wrong.friction", PUSHED);
    let tables = [
        (
            TRIANGLE.trim_end_matches("0.8,0\n"),
            "the period does not close: its first sample is 0 and its last one -30",
        ),
        (
            "time_s,force_N\n0,0\n0.2,30\n0.45,0\n0.6,-30\n0.8,0\n",
            "not evenly",
        ),
        (
            "time_s,force_mm\n0,0\n0.2,30\n0.4,0\n",
            "the column `force` is in mm: the excitation of the scene is a mass",
        ),
        (
            "time_s,base_mm\n0,0\n0.2,30\n0.4,0\n",
            "the column `base` is in mm: the excitation of the scene is a mass",
        ),
        (
            "time_s,force_N,friction_N\n0,0,1\n0.2,30,1\n0.4,0,1\n",
            "a table of one period has the time and the load alone",
        ),
    ];
    for (place, (text, message)) in tables.into_iter().enumerate() {
        let table = file(&format!("wrong{place}.csv"), text);
        let found = failure("", &["periodic", &block, &table, "--friction", "4"]);
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].contains(message), "{text}: {found:?}");
    }
    let table = file("drifts.csv", "time_s,base_m_s2\n0,0\n0.2,3\n0.4,1\n0.6,0\n");
    let found = failure("", &["periodic", FRAME, &table, "--friction", "4"]).join("\n");
    assert!(
        found.contains("the mean acceleration of the base is"),
        "{found}"
    );
    let asked: [(&[&str], &str); 6] = [
        (
            &[],
            "give the load: the file of a table over one period, or --harmonics with --hz",
        ),
        (
            &["--harmonics", "1:3"],
            "--harmonics needs the frequency of the first order: give --hz",
        ),
        (
            &["--harmonics", "1", "--hz", "2"],
            "--harmonics `1`: ORDER:AMPLITUDE@DEGREES is needed",
        ),
        (
            &["--harmonics", "1:a", "--hz", "2"],
            "ORDER:AMPLITUDE@DEGREES is needed",
        ),
        (
            &["--harmonics", "1:3", "--hz", "0"],
            "one frequency above 0 is needed",
        ),
        (
            &["--harmonics", "5000:3", "--hz", "2"],
            "the order 5000 of a harmonic is above 1000",
        ),
    ];
    for (more, message) in asked {
        let found = failure(
            "",
            &[&["periodic", &block, "--friction", "4"], more].concat(),
        );
        assert!(found[0].contains(message), "{more:?}: {found:?}");
    }
    let table = file("motion.csv", TRIANGLE);
    let two = ["periodic", &block, &table, "--friction", "4,5", "--motion"];
    assert!(failure("", &two)[0].contains("--motion prints one motion"));
    let rate = [
        "periodic",
        &block,
        &table,
        "--friction",
        "4",
        "--of",
        "accel(m)",
    ];
    assert!(failure("", &rate)[0].contains("displacements and forces of springs only"));
}

/// A picture has the motions, the friction force and the loop of the contact. It needs --motion.
#[test]
fn a_picture_of_one_period() {
    let block = file("drawn.friction", PUSHED);
    let table = file("drawn.csv", TRIANGLE);
    let path = file("drawn.svg", "");
    let asked = ["periodic", &block, &table, "--friction", "8", "-o", &path];
    let refusal = failure("", &asked);
    assert!(
        refusal[0].ends_with("a picture shows the motion over a period: add --motion"),
        "{refusal:?}"
    );
    output("", &[&asked[..], &["--motion"]].concat());
    let picture = fs::read_to_string(&path).unwrap();
    for text in [
        "hysteresis loop of the contact",
        "the motion repeats after one period of the load",
        "friction force 8.000000 N",
    ] {
        assert!(picture.contains(text), "{text}");
    }
    for path in [block, table, path] {
        fs::remove_file(path).unwrap();
    }
}

//! Tests physical options that are missing, wrong or too many. Each must give one clear line.

#![allow(
    clippy::expect_used,
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{failure, output};

/// Description of one undamped mass of 2 kg on a spring of 50 N/m.
const BLOCK: &str = "struct Block { masses: { block: 2 }, springs: { base - block: 50 },
    contact: block - wall, excitation: block }";

#[test]
fn what_is_missing_or_wrong_is_named() {
    let base = BLOCK.replace("excitation: block", "excitation: base");
    let told = |scene: &str, line: &str| {
        let lines = failure(scene, &line.split(' ').collect::<Vec<_>>());
        assert_eq!(lines.len(), 1, "{lines:?}");
        lines[0].clone()
    };
    let driven = "--force: the scene is driven by its base; its load is given by --base";
    let pushed = "--base: the scene is driven by a force on `block`; its load is given by --force";
    for command in ["response", "orbit"] {
        for (scene, options, message) in [
            (
                BLOCK,
                "--friction 1",
                "--friction needs the amplitude of the load: give --force",
            ),
            (
                &base,
                "--friction 1",
                "--friction needs the amplitude of the load: give --base",
            ),
            (&base, "--friction 1 --force 1", driven),
            (&base, "--beta 1 --force 1 --base 1", driven),
            (BLOCK, "--friction 1 --base 1", pushed),
            (BLOCK, "--beta 1 --force 1 --base 1", pushed),
            (
                BLOCK,
                "--friction -1 --force 1",
                "--friction `-1`: a friction force must not be negative",
            ),
            (
                BLOCK,
                "--friction inf --force 1",
                "--friction `inf`: a friction force must be finite",
            ),
            (
                BLOCK,
                "--friction 1e300 --force 1e-300",
                "--friction `1e300`: with this load its friction ratio is too small or too large to compute with",
            ),
            (
                BLOCK,
                "--beta 1e300 --force 1e300",
                "--beta `1e300`: with this load its friction force is too small or too large to compute with",
            ),
        ] {
            let line = told(scene, &format!("{command} - --hz 1 {options}"));
            assert_eq!(line, format!("frictiongen: {message}"));
        }
        let line = told(
            BLOCK,
            &format!("{command} --hz 1:1:9999 --friction 1:1:9999 --force 1"),
        );
        let message = "--hz and --friction: together they have more than 10000000 points, the largest possible number";
        assert_eq!(line, format!("frictiongen: {message}"));
    }
    for (scene, option) in [(BLOCK, "--force"), (&base, "--base")] {
        for amplitude in ["0", "-1", "nan", "inf", "-inf", "1e400", "1e-400"] {
            let line = told(scene, &format!("limits --hz 1 {option} {amplitude}"));
            let message = format!(
                "{option} `{amplitude}`: the amplitude of a load must be above 0 and finite"
            );
            assert_eq!(line, format!("frictiongen: {message}"));
        }
        let line = told(scene, &format!("limits --r 1 {option} much"));
        assert_eq!(
            line,
            format!("frictiongen: {option} `much`: it is not a number")
        );
        let extreme = if option == "--base" {
            "1e308"
        } else {
            "5e-324"
        };
        let line = told(scene, &format!("limits --r 1 {option} {extreme}"));
        let start = format!(
            "frictiongen: {option} `{extreme}`: with the stiffness of the first spring, this load makes"
        );
        assert!(line.starts_with(&start), "{line}");
    }
}

#[test]
fn frequencies_that_are_none() {
    let told = |line: &str| failure(BLOCK, &line.split(' ').collect::<Vec<_>>())[0].clone();
    let in_time = "and below infinity; at 0 and infinity, use `limits` or `response`";
    for (line, message) in [
        (
            "limits --hz -1",
            "--hz `-1`: a frequency must not be negative".to_owned(),
        ),
        (
            "limits --omega -1",
            "--omega `-1`: an angular frequency must not be negative".to_owned(),
        ),
        ("limits --hz x", "--hz `x`: `x` is not a number".to_owned()),
        (
            "limits --hz 1e400",
            "--hz `1e400`: `1e400` is too large; write inf for infinity".to_owned(),
        ),
        (
            "limits --hz 1e308",
            "--hz `1e308`: its frequency ratio is too small or too large to compute with"
                .to_owned(),
        ),
        (
            "limits --omega 5e-324",
            "--omega `5e-324`: its frequency ratio is too small or too large to compute with"
                .to_owned(),
        ),
        (
            "orbit --hz 0 --beta 1",
            format!("--hz `0`: a motion in time needs a frequency above 0 {in_time}"),
        ),
        (
            "orbit --omega inf --beta 1",
            format!("--omega `inf`: a motion in time needs an angular frequency above 0 {in_time}"),
        ),
    ] {
        assert_eq!(told(line), format!("frictiongen: {message}"));
    }
    for (line, message) in [
        (
            "limits --r 1 --hz 1",
            "error: the argument '--r <GRID>' cannot be used with '--hz <GRID>'",
        ),
        (
            "limits --force 1",
            "error: the following required arguments were not provided:",
        ),
        (
            "orbit --hz 1 --beta 1 --friction 1",
            "error: the argument '--beta <GRID>' cannot be used with '--friction <GRID>'",
        ),
        (
            "response --hz 1 --force 1",
            "error: the following required arguments were not provided:",
        ),
    ] {
        assert_eq!(told(line), message);
    }
    output(BLOCK, &["limits", "--hz", "0,inf"]);
}

#[test]
fn help_tells_the_units() {
    for command in ["limits", "response", "orbit"] {
        let help = output("", &[command, "--help"]);
        for part in [
            "--hz",
            "--omega",
            "--force",
            "--base",
            "masses in kg",
            "another order",
        ] {
            assert!(help.contains(part), "{command}: {part}");
        }
        assert_eq!(help.contains("--friction"), command != "limits");
    }
}

//! Tests that every bad input gets a clear message of one line and exit status 2.

use crate::common::{BLOCK, FRAME, failure, run_with};
use std::process::{Command, Stdio};

#[test]
fn grids() {
    let cases = [
        ("", "--r ``: a number is missing"),
        ("0:0:1", "--r `0:0:1`: the step must not be 0"),
        (
            "1:0.1:0",
            "--r `1:0.1:0`: from 1.0 to 0.0 the step must be negative",
        ),
        (
            "0:-1:1",
            "--r `0:-1:1`: from 0.0 to 1.0 the step must be positive",
        ),
        ("nan", "--r `nan`: a number is needed, not NaN"),
        ("0:1:inf", "--r `0:1:inf`: a range needs finite numbers"),
        (
            "0:1e-9:1",
            "--r `0:1e-9:1`: more than 10000000 points, the largest possible number",
        ),
        ("-1", "--r `-1`: a frequency ratio must not be negative"),
        ("1,two", "--r `two`: `two` is not a number"),
        (
            "1:2:3:4",
            "--r `1:2:3:4`: a grid is a number, or a range a:step:b",
        ),
        ("--csv", "--r `--csv`: `--csv` is not a number"),
    ];
    for (grid, message) in cases {
        let message = format!("frictiongen: {message}");
        assert_eq!(failure(BLOCK, &["limits", "--r", grid]), [message.as_str()]);
        let arguments = ["response", "--r", grid, "--beta", "1"];
        assert_eq!(failure(BLOCK, &arguments), [message]);
    }
}

#[test]
fn friction_ratios() {
    let cases = [
        (
            "inf",
            "frictiongen: --beta `inf`: a friction ratio must be finite",
        ),
        (
            "-0.5",
            "frictiongen: --beta `-0.5`: a friction ratio must not be negative",
        ),
    ];
    for (grid, message) in cases {
        let arguments = ["response", "--r", "1", "--beta", grid];
        assert_eq!(failure(BLOCK, &arguments), [message]);
    }
    let arguments = ["response", "--r", "0:1:9999", "--beta", "0:1:1000"];
    let message = "frictiongen: --r and --beta: together they have more than 10000000 points, the largest possible number";
    assert_eq!(failure(BLOCK, &arguments), [message]);
}

#[test]
fn masses_and_harmonics() {
    let arguments = ["response", FRAME, "--r", "1", "--beta", "1"];
    let message = "frictiongen: --of: there is no mass `roof`; the masses are lower, upper";
    let unknown = [&arguments[..], &["--mass", "lower", "--mass", "roof"]].concat();
    assert_eq!(failure("", &unknown), [message]);
    for orders in ["0", "-3", "10000", "2.5", "x", "99999999999999999999"] {
        let message =
            format!("frictiongen: --harmonics `{orders}`: a whole number from 1 to 9999 is needed");
        let wrong = [&arguments[..], &["--harmonics", orders]].concat();
        assert_eq!(failure("", &wrong), [message]);
    }
}

#[test]
fn files() {
    let missing = "frictiongen: cannot read no-such.friction: there is no such file or folder";
    let folder = env!("CARGO_MANIFEST_DIR");
    for command in [&["limits", "--r", "1"][..], &["expand"]] {
        let with = |file| [command, &[file]].concat();
        assert_eq!(failure("", &with("no-such.friction")), [missing]);
        let lines = failure("", &with(folder));
        assert_eq!(lines.len(), 1, "{lines:?}");
        let start = format!("frictiongen: cannot read {folder}: ");
        assert!(lines[0].starts_with(&start), "{lines:?}");
    }
    assert_eq!(
        failure(b"struct \xff", &["limits", "--r", "1"]),
        ["frictiongen: <stdin> is not a description: it is not UTF-8 text (byte 7)"]
    );
    assert_eq!(
        failure(vec![b' '; (16 << 20) + 1], &["expand"]),
        ["frictiongen: <stdin> is not a description: it is longer than 16 MiB"]
    );
}

#[test]
fn every_error_of_a_description_is_on_its_own_line() {
    let scene = "struct Block {\n    masses: { block: 1, block: x },\n    springs: { base - block: 1 },\n    contact: roof - wall,\n    excitation: block,\n}";
    let expected = [
        "<stdin>:2:25: two masses are called `block`; give this one a name of its own",
        "<stdin>:2:32: `x` is not a number, and a description cannot use constants of Rust; write the number itself, or literals joined by `+ - * / ( )`, for example `2.0 * 3.27`",
        "<stdin>:4:14: there is no mass `roof`; the masses are block",
    ];
    assert_eq!(failure(scene, &["limits", "--r", "1"]), expected);
    assert_eq!(failure(scene, &["expand", "-"]), expected);
    let arguments = ["response", "--r", "1", "--beta", "1", "--json"];
    assert_eq!(failure(scene, &arguments), expected);

    let path = std::env::temp_dir().join(format!("frictiongen-cli-{}-bad", std::process::id()));
    std::fs::write(&path, scene).unwrap();
    let shown = path.to_str().unwrap();
    let lines = failure("", &["limits", shown, "--r", "1"]);
    std::fs::remove_file(&path).unwrap();
    assert_eq!(lines[0], expected[0].replace("<stdin>", shown));
}

#[test]
fn arguments() {
    let cases: &[(&[&str], &str)] = &[
        (&["chart"], "error: unrecognized subcommand 'chart'"),
        (
            &["limits"],
            "error: the following required arguments were not provided:",
        ),
        (
            &["limits", "--r", "1", "--json", "--csv"],
            "error: the argument '--json' cannot be used with '--csv'",
        ),
        (
            &["limits", "--r", "1", "--beta", "1"],
            "error: unexpected argument '--beta' found",
        ),
    ];
    for (arguments, first) in cases {
        assert_eq!(failure(BLOCK, arguments)[0], *first);
    }
    assert!(!failure(BLOCK, &[]).is_empty());
}

#[test]
fn help_is_no_error() {
    for arguments in [
        &["--help"][..],
        &["limits", "-h"],
        &["response", "--help"],
        &["--version"],
    ] {
        let run = run_with("", arguments);
        assert_eq!((run.status, run.err.as_str()), (Some(0), ""));
        assert!(!run.out.is_empty());
    }
}

#[test]
fn a_reader_that_leaves_is_no_error() {
    for format in ["--csv", "--json"] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_frictiongen"))
            .args(["limits", FRAME, "--r", "1:0.0001:3", format])
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_one() {
    for arguments in [&["limits", FRAME, "--r", "1"][..], &["expand", FRAME]] {
        let full = std::fs::OpenOptions::new()
            .write(true)
            .open("/dev/full")
            .unwrap();
        let output = Command::new(env!("CARGO_BIN_EXE_frictiongen"))
            .args(arguments)
            .stdout(full)
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2));
        let message = "frictiongen: cannot write the output: no space is left\n";
        assert_eq!(String::from_utf8(output.stderr).unwrap(), message);
    }
}

/// Checks that every command of the closed forms refuses a kinetic friction level that depends on the speed, and that
/// commands of steady states need the load. `expand` accepts this friction.
#[test]
fn a_friction_law_without_a_constant_level() {
    let stribeck = BLOCK.replace(
        "excitation: block,",
        "excitation: block, friction: stribeck(0.1: 0.8), provide: [stepper],",
    );
    let default = stribeck.replace(", provide: [stepper]", "");
    let told = "frictiongen: <stdin>: the exact response needs a constant kinetic level, but this scene has `friction: stribeck`; use `frictiongen orbit`, `curve`, `map` or `time`, or write `friction: coulomb`";
    let units = "frictiongen: the scene has lengths, speeds or constant forces, so that the amplitude of the load is needed; give the frequency in Hz or rad/s, the load in N or m and the friction in N";
    let commands: [(&[&str], &str); 10] = [
        (&["limits", "--r", "1"], told),
        (&["compile", "--accuracy", "1e-2", "--r", "0.5:2"], told),
        (&["features"], told),
        (&["response", "--r", "1", "--beta", "1"], units),
        (&["orbit", "--r", "1", "--beta", "1"], units),
        (&["curve", "--r", "1:1:2", "--beta", "1"], units),
        (&["map", "--r", "1:1:2", "--beta", "0:1:1", "--csv"], units),
        (&["time", "--r", "1", "--beta", "1", "--steady"], units),
        (&["optimum", "--of", "block", "--r", "1:2"], units),
        (
            &["sensitivity", "--of", "block", "--r", "1", "--beta", "1"],
            units,
        ),
    ];
    for (arguments, told) in commands {
        assert_eq!(failure(&stribeck, arguments), [told], "{arguments:?}");
        // Only `compile` emits code, for which `provide` must fit the scene.
        if arguments[0] != "compile" {
            assert_eq!(failure(&default, arguments), [told], "{arguments:?}");
        }
    }
    let without = "frictiongen: <stdin>: the scene has lengths, speeds or constant forces, so that the load is needed; give it by --force";
    let time = ["time", "--r", "1", "--beta", "1"];
    assert_eq!(failure(&stribeck, &time), [without]);
    let expanded = run_with(&stribeck, &["expand"]);
    assert_eq!(expanded.status, Some(0), "{}", expanded.err);
    assert!(expanded.out.contains("pub fn stepper("));
}

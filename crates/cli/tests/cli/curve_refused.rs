//! Tests the requests that `frictiongen curve` and `frictiongen map` refuse, and files that cannot be written.

#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::common::{BLOCK, failure};

#[test]
fn what_cannot_be_asked() {
    let folder = std::env::temp_dir().join(format!("frictiongen-curve-{}-bad", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let there = folder.join("there.csv");
    std::fs::write(&there, "kept").unwrap();
    let nowhere = folder.join("no/where.csv");
    let (folder_name, nowhere) = (folder.to_str().unwrap(), nowhere.to_str().unwrap());
    let cases: Vec<(Vec<&str>, String)> = vec![
        (
            vec!["curve", "--r", "0.5:0.5", "--beta", "1"],
            "--r `0.5:0.5`: the range from 0.5 to 0.5 has no width".to_owned(),
        ),
        (
            vec!["curve", "--r", "0:1", "--beta", "1"],
            "--r `0:1`: a motion in time needs a frequency ratio above 0 and below infinity; at 0 and infinity, use `limits` or `response`".to_owned(),
        ),
        (
            vec!["curve", "--hz", "1", "--beta", "1"],
            "--hz `1`: a range a:b or a:step:b is needed".to_owned(),
        ),
        (
            vec!["curve", "--r", "0.5:0:1", "--beta", "1"],
            "--r `0.5:0:1`: the step must not be 0".to_owned(),
        ),
        (
            vec!["curve", "--r", "0.5:1e-9:1", "--beta", "1"],
            "--r `0.5:1e-9:1`: more than 10000000 points, the largest possible number".to_owned(),
        ),
        (
            vec!["curve", "--r", "0.5:1", "--friction", "-2", "--force", "1"],
            "--friction `-2`: a friction force must not be negative".to_owned(),
        ),
        (
            vec!["curve", "--r", "0.5:1", "--friction", "2"],
            "--friction needs the amplitude of the load: give --force".to_owned(),
        ),
        (
            vec!["curve", "--r", "0.5:1", "--beta", "1", "--of", "roof"],
            "--of: there is no mass `roof`; the masses are block".to_owned(),
        ),
        (
            vec!["curve", "--r", "0.5:1", "--beta", "1", "--accuracy", "0"],
            "the accuracy of a curve must be between 1e-9 and 1".to_owned(),
        ),
        (
            vec!["curve", "--r", "0.5:1", "--beta", "1", "-o", "curve.txt"],
            "--output `curve.txt`: the name of the file must end in .csv, .json or .svg".to_owned(),
        ),
        #[cfg(not(feature = "png"))]
        (
            vec!["curve", "--r", "0.5:1", "--beta", "1", "-o", "curve.png"],
            "--output `curve.png`: this program writes .svg but not .png; for .png build it with `--features png`".to_owned(),
        ),
        (
            vec!["curve", "--r", "0.5:1", "--beta", "1", "-o", nowhere],
            format!("cannot write {nowhere}: there is no such file or folder"),
        ),
        (
            vec!["map", "--r", "0.5", "--beta", "1", "-o", "map.svg"],
            "a picture of a map needs two frequencies and two frictions".to_owned(),
        ),
        (
            vec!["map", "--r", "0.5", "--beta", "0:0.1:1", "--boundaries", "40"],
            "--boundaries `40`: a whole number from 1 to 12 is needed".to_owned(),
        ),
        (
            vec!["map", "--r", "inf", "--beta", "1"],
            "the frequency ratio r is infinite; it must be finite here".to_owned(),
        ),
    ];
    for (arguments, message) in cases {
        assert_eq!(
            failure(BLOCK, &arguments),
            [format!("frictiongen: {message}")],
            "{arguments:?}"
        );
    }
    assert_eq!(std::fs::read_to_string(&there).unwrap(), "kept");
    let names: Vec<_> = std::fs::read_dir(folder_name).unwrap().collect();
    assert_eq!(names.len(), 1, "nothing else is left");
    std::fs::remove_dir_all(folder).unwrap();
}

/// Checks that a device without space gives one line on standard error, and no incomplete file.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk() {
    let arguments = ["limits", "--r", "0.1:0.001:2", "--csv"];
    let full = std::fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let mut command = std::process::Command::new(env!("CARGO_BIN_EXE_frictiongen"));
    command
        .args(arguments)
        .stdout(full)
        .stderr(std::process::Stdio::piped())
        .stdin(std::process::Stdio::piped());
    let mut run = command.spawn().unwrap();
    std::io::Write::write_all(&mut run.stdin.take().unwrap(), BLOCK.as_bytes()).unwrap();
    let output = run.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    let lines = String::from_utf8(output.stderr).unwrap();
    assert_eq!(
        lines,
        "frictiongen: cannot write the output: no space is left\n"
    );
}

//! Tests the requests that `frictiongen time` refuses.

#![allow(clippy::indexing_slicing, reason = "a test may fail")]

use crate::common::{FRAME, failure, words};

#[test]
fn what_cannot_be_asked() {
    let in_time = "a motion in time needs a frequency ratio above 0 and below infinity; at 0 and infinity, use `limits` or `response`";
    let too_many = "--cycles and --samples: all motions together have more than 10000000 samples, the largest possible number";
    let cases: &[(&str, &str)] = &[
        ("--r 0 --beta 1", &format!("--r `0`: {in_time}")),
        ("--r inf --beta 1", &format!("--r `inf`: {in_time}")),
        (
            "--r 0.5,0.6 --beta 1",
            "--r: one frequency ratio is needed, but this is a grid of 2",
        ),
        (
            "--r 0.5 --beta 0:0.5:2",
            "--beta: one friction ratio is needed, but this is a grid of 5",
        ),
        (
            "--r 0.5 --beta 1 --samples 0",
            "--samples `0`: a whole number from 2 to 10000000 is needed",
        ),
        (
            "--r 0.5 --beta 1 --samples 1e9",
            "--samples `1e9`: a whole number from 2 to 10000000 is needed",
        ),
        (
            "--r 0.5 --beta 1 --samples 7",
            "--samples `7`: an even number is needed",
        ),
        ("--r 0.5 --beta 1 --samples 10000000", too_many),
        ("--r 0.5 --beta 1 --cycles 10000000", too_many),
        (
            "--r 0.5 --beta 1 --cycles 0",
            "--cycles `0`: a whole number from 1 to 10000000 is needed",
        ),
        (
            "--r 0.5 --beta 1 --skip -1",
            "--skip `-1`: a whole number from 0 to 10000000 is needed",
        ),
        (
            "--r 0.5 --beta 1 --skip 10000001",
            "--skip `10000001`: a whole number from 0 to 10000000 is needed",
        ),
        (
            "--from 1,2;1,2 --until 0 --friction 1",
            "--until `0`: a time in s above 0 is needed",
        ),
        (
            "--from 1,2;1,2 --until 10s --friction 1",
            "--until `10s`: a time in s above 0 is needed; write `10`, because numbers here are in N, m, s, Hz or rad/s, without a unit",
        ),
        (
            "--hz 1 --friction 1 --base 0 --from 1,2;1,2",
            "--base `0`: the amplitude of a load must be above 0 and finite; for a motion without a load, give --from and --until in place of the load and its frequency",
        ),
        (
            "--from 1;1 --until 1 --friction 1",
            "--from `1;1`: the number of displacements is 1, but the number of masses is 2",
        ),
        (
            "--r 0.5 --beta 1 --from 1,2",
            "--from `1,2`: write rest, or x1,...;v1,...: the displacements of all masses, a semicolon, their velocities",
        ),
        (
            "--r 0.5 --beta 1 --from 1,2,3;1,2",
            "--from `1,2,3;1,2`: the number of displacements is 3, but the number of masses is 2",
        ),
        (
            "--r 0.5 --beta 1 --from 1,2;1",
            "--from `1,2;1`: the number of velocities is 1, but the number of masses is 2",
        ),
        (
            "--r 0.5 --beta 1 --from 1,nan;0,0",
            "--from `1,nan;0,0`: `nan` is not a finite number",
        ),
        (
            "--r 0.5 --beta 1 --from 1,2;0,-inf",
            "--from `1,2;0,-inf`: `-inf` is not a finite number",
        ),
        (
            "--r 0.5 --beta 1 --from 1,;0,0",
            "--from `1,;0,0`: a number is missing",
        ),
        (
            "--r 0.5 --beta 1 --base 1e-200 --from 1e200,0;0,0",
            "--from `1e200,0;0,0`: with this load `1e200` is too large",
        ),
        (
            "--r 0.5 --beta 1 --of roof",
            "--of: there is no mass `roof`; the masses are lower, upper",
        ),
        (
            "--r 0.5 --beta 1 --of upper --of contact --of upper",
            "--of `upper`: it is given twice",
        ),
        (
            "--r 0.5 --friction 1",
            "--friction needs the amplitude of the load: give --base",
        ),
        (
            "--r 0.5 --beta 1 -o motion.txt",
            "--output `motion.txt`: the name of the file must end in .csv, .json or .svg",
        ),
        (
            "--r 0.5 --beta 1 --events -o motion.svg",
            "--output `motion.svg`: the name of the file must end in .csv or .json",
        ),
        (
            "--r 0.5 --beta 1 -o motion.csv --json",
            "--output `motion.csv`: the name means CSV, but --json is given; leave one of the two out",
        ),
        (
            "--r 0.5 --beta 1 -o no-such-folder/motion.csv",
            "cannot write no-such-folder/motion.csv: there is no such file or folder",
        ),
    ];
    for (line, message) in cases {
        let arguments = [&["time", FRAME], &words(line)[..]].concat();
        assert_eq!(
            failure("", &arguments),
            [format!("frictiongen: {message}")],
            "{line}"
        );
    }
    for (line, message) in [
        (
            "--steady --cycles 3",
            "error: the argument '--steady' cannot be used with '--cycles <N>'",
        ),
        (
            "--events --spectrum",
            "error: the argument '--events' cannot be used with '--spectrum'",
        ),
    ] {
        let line = format!("--r 0.5 --beta 1 {line}");
        let arguments = [&["time", FRAME], &words(&line)[..]].concat();
        assert_eq!(failure("", &arguments)[0], message);
    }
    // The motion of this scene has no steady state.
    let restless = "struct Block { masses: { block: 1 }, springs: { base - block: 1 },
        contact: block - base, excitation: base, stiction: 3 }";
    let lines = failure(
        restless,
        &words("time --r 0.3333333333333333 --beta 0.01395 --steady"),
    );
    assert_eq!(lines.len(), 1);
    assert!(
        lines[0].ends_with("leave --steady out to see a run"),
        "{lines:?}"
    );
}

//! Tests `frictiongen compile`.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may fail")]

use crate::common::{BLOCK, FRAME, failure, json, output, run_with};
use std::path::PathBuf;
use std::{fs, process};

fn temporary(name: &str) -> PathBuf {
    std::env::temp_dir().join(format!("frictiongen-cli-{}-{name}", process::id()))
}

#[test]
fn the_figures() {
    let text = output(
        "",
        &["compile", FRAME, "--accuracy", "1e-4", "--r", "0.2:2.5"],
    );
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "scene           Frame");
    assert_eq!(lines[1], "range           r from 0.2 to 2.5");
    assert_eq!(lines[2], "accuracy        1e-4");
    assert!(
        lines[3].starts_with("table           beta_lim, a, g, arg V and |V|: "),
        "{text}"
    );
    assert!(
        lines[5].starts_with("largest error   ") && lines[5].contains("checked at"),
        "{text}"
    );
    let safe = output(
        "",
        &[
            "compile",
            FRAME,
            "--accuracy",
            "1e-4",
            "--r",
            "0.2:2.5",
            "--safe",
        ],
    );
    assert!(
        safe.contains("accuracy        1e-4, never above\n"),
        "{safe}"
    );
}

/// Checks that without `--prove` the output states that the tables are checked, at how many points, and which option
/// proves them.
#[test]
fn checked_or_proven() {
    let with = |more: &[&str]| {
        let asked = ["compile", FRAME, "--accuracy", "1e-4", "--r", "0.2:2.5"];
        output("", &[&asked, more].concat())
    };
    let (checked, proven) = (with(&[]), with(&["--prove"]));
    let line = |text: &str, name: &str| {
        let line = text.lines().find_map(|line| line.strip_prefix(name));
        line.unwrap_or_else(|| panic!("no {name}: {text}"))
            .trim()
            .to_owned()
    };
    let largest = line(&checked, "largest error");
    let points = largest.split_once("checked at ").unwrap().1;
    let points = points.split_whitespace().next().unwrap();
    for name in ["beta_lim", "motion"] {
        let expected = format!(
            "Checked at {points} points, not proven: between them an error may be larger; --prove proves it."
        );
        assert_eq!(line(&checked, name), expected);
        assert!(
            line(&proven, name).starts_with("Proven at every r: "),
            "{proven}"
        );
    }
    assert!(!proven.contains("not proven"), "{proven}");
    let asked = ["compile", FRAME, "--accuracy", "1e-8", "--r", "0.2:2.5"];
    let fine = output("", &asked);
    assert!(
        line(&fine, "beta_lim").ends_with("; --prove proves accuracies down to 1e-6."),
        "{fine}"
    );
}

/// Checks that `compile` prints the regimes that the declared friction ratios reach.
#[test]
fn regimes() {
    let with = |beta: &str| {
        let fields = "excitation: block, damping: modal(0.05), accuracy: 1e-3,";
        let range = format!("{fields} range: {{ r: 0.7..1.3{beta} }}");
        output(&BLOCK.replace("excitation: block,", &range), &["compile"])
    };
    let told = |text: &str| {
        let line = text.lines().find(|line| line.starts_with("regimes"));
        line.map(|line| {
            line.split_whitespace()
                .skip(1)
                .collect::<Vec<_>>()
                .join(" ")
        })
    };
    assert_eq!(told(&with("")), None);
    let slides = Some("continuous at every r, for every beta up to 0.3".to_owned());
    assert_eq!(told(&with(", beta: 0..0.3")), slides);
    let moves = Some("continuous or stick-slip at every r, for every beta up to 0.9".to_owned());
    assert_eq!(told(&with(", beta: 0..0.9")), moves);
    assert_eq!(told(&with(", beta: 0..3")), None);
    // With μ = 2 a stuck state may exist below β_lim.
    let with = |beta: &str| {
        let fields = "excitation: block, damping: modal(0.05), stiction: 2, accuracy: 1e-3,";
        let range = format!("{fields} range: {{ r: 0.9..1.1, beta: 0..{beta} }}");
        output(&BLOCK.replace("excitation: block,", &range), &["compile"])
    };
    let both = Some("continuous or bistable at every r, for every beta up to 0.52".to_owned());
    assert_eq!(told(&with("0.52")), both);
    let slides = Some("continuous at every r, for every beta up to 0.4".to_owned());
    assert_eq!(told(&with("0.4")), slides);
}

/// Checks that the declarations of the description apply if no option overrides them.
#[test]
fn a_description_that_declares() {
    let declared = BLOCK.replace(
        "excitation: block,",
        "excitation: block, accuracy: 1e-2, range: { r: 0.5..2 }",
    );
    let text = output(&declared, &["compile"]);
    assert!(
        text.contains("r from 0.5 to 2\naccuracy        1e-2\n"),
        "{text}"
    );
    let text = output(&declared, &["compile", "--accuracy", "1e-6"]);
    assert!(
        text.contains("r from 0.5 to 2\naccuracy        1e-6\n"),
        "{text}"
    );
    // β_lim cannot be proven to 1e-9, whatever proof the description requests.
    let proven = declared.replace("0.5..2 }", "0.5..2 }, proof: whole");
    let text = output(&proven, &["compile", "--accuracy", "1e-9", "--prove"]);
    assert!(
        text.contains("beta_lim        Checked, not proven"),
        "{text}"
    );
    let text = output(&declared, &["compile", "--budget", "2000"]);
    let bytes = text
        .lines()
        .find_map(|line| line.strip_prefix("bytes           "))
        .unwrap();
    assert!(bytes.parse::<usize>().unwrap() <= 2000, "{text}");
}

#[test]
fn the_data() {
    let text = output(
        "",
        &[
            "compile",
            FRAME,
            "--accuracy",
            "1e-3",
            "--r",
            "0.2:2.5",
            "--prove",
            "--format",
            "json",
        ],
    );
    let data = json(&text);
    assert_eq!(data["version"], 1);
    assert_eq!(
        data["functions"],
        serde_json::json!(["beta_lim", "a", "g", "arg_V", "abs_V"])
    );
    // The test finds the value at this r in the polynomial pieces.
    let r = 0.9;
    let pieces = data["pieces"].as_array().unwrap();
    let piece = pieces
        .iter()
        .rfind(|piece| piece["from"].as_f64().unwrap() <= r)
        .unwrap();
    let t = r - piece["origin"].as_f64().unwrap();
    let of = piece["coefficients"][0].as_array().unwrap();
    let limit = of
        .iter()
        .rev()
        .fold(0.0, |sum, c| sum * t + c.as_f64().unwrap());
    let exact = json(&output("", &["limits", FRAME, "--r", "0.9", "--json"]));
    let exact = exact["points"][0]["continuous_limit"].as_f64().unwrap();
    assert!((limit / exact - 1.0).abs() < 1e-3, "{limit} for {exact}");
    // The table of two damped masses is proven over its whole range.
    let proof = &data["proof"];
    assert_eq!(proof["evidence"], "proven", "{proof}");
    assert_eq!(proof["open"], serde_json::json!([]));
    let bound = proof["bound"]["value"].as_f64().unwrap();
    let seen = data["largest_error"]["value"].as_f64().unwrap();
    assert!(
        0.5 * seen < bound && bound <= 1e-3,
        "{bound:e}, seen {seen:e}"
    );
}

const FIVE: &str = "struct Five {
    masses: { a: 1, b: 1, c: 1, d: 1, e: 1 },
    springs: { base - a: 1, a - b: 1, b - c: 1, c - d: 1, d - e: 1 },
    contact: e - wall, excitation: a, damping: modal(0.02), provide: [limits, stuck],
    budget: 2000, range: { r: 1.5..2.5 },
}";

/// Checks that stuck responses are reported and written if the description provides them. The force is |V/H| = μβ*_lim.
#[test]
fn stuck_responses() {
    let scene = fs::read_to_string(FRAME).unwrap();
    let scene = scene.replace(
        "stiction: 1.2,",
        "stiction: 1.2, provide: [limits, stuck], accuracy: 1e-4, range: { r: 0.2..2.5 },",
    );
    let text = output(&scene, &["compile"]);
    let told = text
        .lines()
        .find(|line| line.starts_with("stuck  "))
        .unwrap();
    assert!(
        told.contains("not proven: after subtraction of ") && told.ends_with(" bytes"),
        "{told}"
    );
    let data = json(&output(&scene, &["compile", "--format", "json"]));
    let stuck = &data["stuck"];
    let worst = stuck["largest_error"]["value"].as_f64().unwrap();
    assert!(worst < 1e-14 && stuck["checked_points"].as_u64() > Some(100));
    assert_eq!(stuck["masses"]["upper"]["fixed"], 0.0);
    assert!(stuck["masses"]["lower"]["damped"].is_object());
    let force = &stuck["contact_force"]["damped"];
    for r in [0.3, 0.9, 1.7] {
        let size = |roots: &serde_json::Value| -> f64 {
            let of = roots.as_array().unwrap().iter().map(|root| {
                if let Some(rate) = root["real"][0].as_f64() {
                    return rate.hypot(r);
                }
                let number = |at: usize| root["pair"][at].as_f64().unwrap();
                let re = number(2) - (r - number(0) - number(1)) * (r + number(0));
                re.hypot(number(3) * r)
            });
            of.product()
        };
        let gain = force["gain"].as_f64().unwrap().abs();
        let limit = gain * size(&force["numerator"]) / size(&force["denominator"]) / 1.2;
        let exact = json(&output(
            "",
            &["limits", FRAME, "--r", &r.to_string(), "--json"],
        ));
        let exact = exact["points"][0]["sliding_limit"].as_f64().unwrap();
        assert!((limit / exact - 1.0).abs() < 1e-12, "{limit} for {exact}");
    }
    let code = output(&scene, &["compile", "--format", "rust"]);
    for function in ["stuck_lower", "stuck_upper", "holding_force"] {
        let declared = format!("pub fn {function}(r: f64) -> Result<(f64, f64), Error>");
        assert!(code.contains(&declared), "{code}");
    }
    let code = output(&scene, &["compile", "--format", "c"]);
    assert!(
        code.contains("enum frame_status frame_stuck_lower(double r, double *re, double *im);")
    );
    // The form of these stuck responses needs more than a quarter of the bytes, so code without the library does not
    // contain it.
    let told = failure(FIVE, &["compile", "--format", "c"]);
    assert_eq!(
        told,
        [
            "frictiongen: the stuck responses have no table here: their zeros are too close together, their rounding errors exceed half the accuracy, or they need more than a quarter of the bytes; leave `stuck` out of `provide`, or use the macro or the library"
        ]
    );
    // This description does not provide stuck responses, so the data contain none.
    let without = json(&output(
        "",
        &[
            "compile",
            FRAME,
            "--accuracy",
            "1e-2",
            "--r",
            "0.5:2",
            "--format",
            "json",
        ],
    ));
    assert!(without["stuck"].is_null());
}

#[test]
fn code_in_files() {
    let path = temporary("frame.c");
    let shown = path.to_str().unwrap();
    let arguments = [
        "compile",
        FRAME,
        "--accuracy",
        "1e-3",
        "--r",
        "0.2:2.5",
        "--format",
        "c",
        "-o",
        shown,
    ];
    assert_eq!(output("", &arguments), "");
    let source = fs::read_to_string(&path).unwrap();
    let header = path.with_extension("h");
    let name = header.file_name().unwrap().to_str().unwrap().to_owned();
    let numbers_name = name.replace(".h", "_tables.h");
    let includes = format!("#include \"{name}\"\n#include \"{numbers_name}\"\n");
    assert!(source.contains(&includes), "{source}");
    let declared = fs::read_to_string(&header).unwrap();
    let numbers = header.with_file_name(&numbers_name);
    let tables = fs::read_to_string(&numbers).unwrap();
    for file in [&path, &header, &numbers] {
        fs::remove_file(file).unwrap();
    }
    // Every file begins with the description and the command. The code has no coefficient.
    let folder = path.parent().unwrap().to_str().unwrap();
    for text in [&source, &declared, &tables] {
        assert!(text.starts_with("/* frictiongen "), "{text}");
        let head = text.split("*/").next().unwrap();
        for part in [
            "generated: change the description, not this file",
            "Command: frictiongen compile frame.friction --accuracy 1e-3 --r 0.2:2.5 --format c -o ",
            "1190.0",
            "3.27",
        ] {
            assert!(head.contains(part), "{head}");
        }
        assert!(!text.contains(folder), "{head}");
    }
    assert!(tables.contains("static const struct piece pieces[PIECES] = {"));
    assert!(!source.contains("pieces[PIECES] = {"));
    let limits = "enum frame_status frame_limits(double r, double *continuous, double *sliding);";
    assert!(declared.contains(limits), "{declared}");
    let rust = output(
        "",
        &[
            "compile",
            FRAME,
            "--accuracy",
            "1e-3",
            "--r",
            "0.2:2.5",
            "--format",
            "rust",
        ],
    );
    assert!(rust.contains("pub fn limits(r: f64) -> Result<(f64, f64), Error>"));
    assert!(rust.contains("pub fn contact(r: f64, beta: f64)"));
}

/// Checks that a name for the C functions lets a program use two tables of one scene.
#[test]
fn a_name() {
    let declared = BLOCK.replace(
        "excitation: block,",
        "excitation: block, accuracy: 1e-2, range: { r: 0.5..2 }",
    );
    let of = |arguments: &[&str]| output(&declared, &[&["compile"], arguments].concat());
    let code = of(&["--format", "c", "--name", "fine"]);
    for text in ["fine_limits(", "fine_contact(", "FINE_OK", "FINE_TABLES_H"] {
        assert!(code.contains(text), "{code}");
    }
    assert!(!code.contains("block_limits"), "{code}");
    assert!(of(&["--format", "c"]).contains("block_limits("));
    let told = |arguments: &[&str]| failure(&declared, &[&["compile"], arguments].concat());
    for (arguments, message) in [
        (
            &["--name", "fine"][..],
            "--name is the prefix of names in C",
        ),
        (
            &["--name", "fine", "--format", "rust"],
            "--name is the prefix of names in C",
        ),
        (
            &["--name", "2nd", "--format", "c"],
            "--name is `2nd`, which cannot begin a name in C",
        ),
        (
            &["--name", "", "--format", "c"],
            "--name is ``, which cannot begin a name in C",
        ),
        (
            &["--name", "zähler", "--format", "c"],
            "--name is `zähler`, which cannot begin a name in C",
        ),
    ] {
        let lines = told(arguments);
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(lines[0].contains(message), "{lines:?}");
    }
}

/// Checks that `compile` lists on standard error the items of `provide` that no table contains.
#[test]
fn what_is_left_out() {
    let with = |provide: &str| {
        let fields = format!("excitation: block, provide: [{provide}],");
        BLOCK.replace("excitation: block,", &fields)
    };
    let told = |provide: &str, format: &[&str]| {
        let options = ["compile", "--accuracy", "1e-2", "--r", "0.5:2"];
        let run = run_with(with(provide), &[&options[..], format].concat());
        assert_eq!(run.status, Some(0), "{}", run.err);
        run.err
    };
    for format in ["c", "rust", "json"] {
        let format = ["--format", format];
        assert_eq!(told("limits, motion, stuck", &format), "");
        let err = told("limits, motion(block), orbit, simulation, stepper", &format);
        let left_out = "frictiongen: `compile` leaves out motion(block), orbit, simulation, stepper of `provide`, because it writes only limits, the motion of the contact and stuck responses; use the macro or the library for the rest\n";
        assert_eq!(err, left_out);
        assert!(told("limits, stepper", &format).contains("leaves out stepper of"));
    }
    assert_eq!(told("limits, stepper", &[]), "");
}

#[test]
fn what_is_wrong() {
    let told = |arguments: &[&str]| failure(BLOCK, &[&["compile"], arguments].concat());
    for (arguments, message) in [
        (
            &["--accuracy", "1e-4"][..],
            "an accuracy or a budget needs a range",
        ),
        (
            &["--r", "0.2:2"],
            "the accuracy of the tables is missing; give --accuracy 1e-4",
        ),
        (&[], "the accuracy of the tables is missing"),
        (
            &["--accuracy", "good", "--r", "0.2:2"],
            "--accuracy is `good`, which is not a number",
        ),
        (
            &["--accuracy", "0", "--r", "0.2:2"],
            "an accuracy is a relative error from 1e-12 to 0.1, not 0.0",
        ),
        (
            &["--accuracy", "1e-20", "--r", "0.2:2"],
            "an accuracy is a relative error from 1e-12 to 0.1, not 1e-20",
        ),
        (
            &["--accuracy", "1", "--r", "0.2:2"],
            "an accuracy is a relative error",
        ),
        (
            &["--accuracy", "1e-3", "--r", "2:0.2"],
            "a range a..b of frequency ratios needs 0 < a < b",
        ),
        (
            &["--accuracy", "1e-3", "--r", "0:2"],
            "a range a..b of frequency ratios needs 0 < a < b",
        ),
        (
            &["--accuracy", "1e-3", "--r", "0.2:inf"],
            "a range a..b of frequency ratios needs 0 < a < b",
        ),
        (
            &["--accuracy", "1e-3", "--r", "0.2:0.1:2"],
            "which is not a range a:b",
        ),
        (
            &["--accuracy", "1e-3", "--r", "a:b"],
            "--r is `a`, which is not a number",
        ),
        (
            &["--budget", "64", "--r", "0.2:2"],
            "no table fits into 64 bytes",
        ),
        (
            &["--budget", "0", "--r", "0.2:2"],
            "a budget must be a whole number of bytes",
        ),
    ] {
        let lines = told(arguments);
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(
            lines[0].starts_with("frictiongen: ") && lines[0].contains(message),
            "{lines:?}"
        );
    }
}

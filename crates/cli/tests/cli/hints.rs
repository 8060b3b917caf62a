//! Tests of the advice for mistakes of a first hour, and of the shorter ways to ask.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may fail")]

use crate::common::{BLOCK, FRAME, failure, output, run_with};

/// The description of the block with a damping.
fn damped(damping: &str) -> String {
    BLOCK.replace(
        "excitation: block,",
        &format!("excitation: block,\n    damping: {damping},"),
    )
}

#[test]
fn a_decimal_comma_and_a_unit() {
    let base = |text: &str| {
        let arguments = ["limits", FRAME, "--hz", "2", "--base", text];
        failure("", &arguments).concat()
    };
    assert_eq!(
        base("0,001"),
        "frictiongen: --base `0,001`: it is not a number; write `0.001`, because a decimal fraction has a point"
    );
    assert_eq!(
        base("0.2G"),
        "frictiongen: --base `0.2G`: the unit of a base motion is m, mm, m/s, m/s2 or g, not `G`; a number without a unit is in m"
    );
    // Every unit that the message names is a unit that the option takes.
    let answered = |text: &str| output("", &["limits", FRAME, "--hz", "2", "--base", text]);
    for (text, metres) in [("1mm", "0.001"), ("1.2 mm", "0.0012"), ("0.001m", "0.001")] {
        assert_eq!(answered(text), answered(metres), "{text}");
    }
    assert_eq!(
        base("much"),
        "frictiongen: --base `much`: it is not a number"
    );
    let arguments = ["limits", FRAME, "--hz", "2Hz"];
    assert_eq!(
        failure("", &arguments),
        [
            "frictiongen: --hz `2Hz`: `2Hz` is not a number; write `2`, because numbers here are in N, m, s, Hz or rad/s, without a unit"
        ]
    );
}

#[test]
fn a_damping_ratio_in_per_cent_is_warned_about() {
    for (damping, meant) in [
        ("modal(2)", "write `0.02` if you mean 2 %"),
        ("modal[1]", "write `0.01` if you mean 1 %"),
        ("rayleigh(5, 0)", "mode 1 has a damping ratio of 2.500"),
    ] {
        let run = run_with(damped(damping), &["check"]);
        assert_eq!(run.status, Some(0), "{damping}");
        assert!(
            run.out
                .starts_with("<stdin>: no errors; 1 mass, 1 spring\n"),
            "{}",
            run.out
        );
        assert!(run.err.starts_with("warning: "), "{}", run.err);
        assert!(run.err.contains(meant), "{}", run.err);
        assert!(run.err.contains("<stdin>:6"), "{}", run.err);
    }
    for damping in ["modal(0.999)", "modal[0.02]", "rayleigh(1.9, 0)", "none"] {
        let said = output(&damped(damping), &["check"]);
        let first = said.lines().next();
        assert_eq!(first, Some("<stdin>: no errors; 1 mass, 1 spring"));
    }
}

/// Only emitted code has methods with the names of masses and contacts.
#[test]
fn names_of_methods_and_keywords_name_masses() {
    let scene = "struct S { masses: { box: 1, type: 2, move: 1, loop: 1, final: 1, step: 1, crate: 1 }, springs:
        { base - box: 9, box - type: 9, type - move: 9, move - loop: 9, loop - final: 9, final - step: 9, step - crate: 9 },
        contacts: { contact: final - wall, orbit: type - base { stiffness: 2 } }, excitation: box }";
    let asked = ["orbit", "--r", "0.5", "--beta", "0.1", "--csv"];
    assert!(output(scene, &asked).contains("final.amplitude"));
    let single = scene.replace(
        "contacts: { contact: final - wall, orbit: type - base { stiffness: 2 } }",
        "contact: final - wall",
    );
    assert!(output(&single, &asked).contains("final.amplitude"));
    let checked = output(&single, &["check"]);
    let told = "\nthe macro emits no code for this scene: 1:22: `box` is a keyword of Rust";
    assert!(checked.contains(told), "{checked}");
    assert!(failure(&single, &["expand"])[0].contains("`box` is a keyword of Rust"));
}

/// A band has the end points and the decimal steps of the grid that writes its step.
#[test]
fn a_band_is_a_hundred_steps() {
    let limits = |r: &str| output("", &["limits", FRAME, "--r", r, "--csv"]);
    assert_eq!(limits("0.2:2.2"), limits("0.2:0.02:2.2"));
    assert_eq!(limits("2.2:0.2,3"), limits("2.2:-0.02:0.2,3"));
    let hertz = |hz: &str| output("", &["limits", FRAME, "--hz", hz, "--csv"]);
    assert_eq!(hertz("1:7"), hertz("1:0.06:7"));
    let map = |r: &str, beta: &str| {
        output(
            "",
            &[
                "map", FRAME, "--r", r, "--beta", beta, "--of", "lower", "--csv",
            ],
        )
    };
    assert_eq!(map("0.9:1", "0.9"), map("0.9:0.001:1", "0.9"));
    assert_eq!(map("0.9", "0:1"), map("0.9", "0:0.01:1"));
    let refused = [
        (
            vec!["limits", "--r", "1:1"],
            "--r `1:1`: the range from 1.0 to 1.0 has no width",
        ),
        (
            vec!["limits", "--r", "0:inf"],
            "--r `0:inf`: a range needs finite numbers",
        ),
        (
            vec!["response", "--r", "1", "--beta", "0:1"],
            "--beta `0:1`: a range of frictions needs its step in the middle, a:step:b; without a step, `map` takes 100 equal steps",
        ),
    ];
    for (arguments, message) in refused {
        assert_eq!(
            failure(BLOCK, &arguments),
            [format!("frictiongen: {message}")]
        );
    }
}

/// `--of` selects masses in every command, and `--mass` is its other name.
#[test]
fn of_selects_masses() {
    for command in ["response", "orbit"] {
        let with = |more: &[&str]| {
            let asked = [command, FRAME, "--r", "0.9", "--beta", "0.2", "--csv"];
            output("", &[&asked, more].concat())
        };
        let of = with(&["--of", "lower"]);
        assert_eq!(of, with(&["--mass", "lower"]));
        assert_eq!(of, with(&["--of", "contact", "--of", "lower"]));
        let names = of.lines().next().unwrap();
        assert!(names.contains("lower.amplitude") && !names.contains("upper"));
        let contact = with(&["--of", "contact"]);
        let names = contact.lines().next().unwrap();
        assert!(names.contains("contact.amplitude") && !names.contains("lower"));
    }
}

/// Tables over a band in Hz are those over the same band of r.
#[test]
fn tables_over_a_band_in_hertz() {
    let with = |range: &[&str]| {
        let asked = ["compile", FRAME, "--accuracy", "1e-3", "--format", "json"];
        output("", &[&asked, range].concat())
    };
    // r = ω√(m₁/k₁) by hand.
    let r = |hz: f64| hz * core::f64::consts::TAU * (3.27_f64 / 1190.0).sqrt();
    let ratios = with(&["--r", &format!("{:?}:{:?}", r(2.0), r(6.0))]);
    let close = |one: &serde_json::Value, other: &serde_json::Value| {
        let (one, other) = (one.as_f64().unwrap(), other.as_f64().unwrap());
        (one / other - 1.0).abs() < 1e-14
    };
    let read = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
    let (ratios, hertz) = (read(&ratios), read(&with(&["--hz", "2:6"])));
    let turns = core::f64::consts::TAU;
    let omega = read(&with(&[
        "--omega",
        &format!("{:?}:{:?}", 2.0 * turns, 6.0 * turns),
    ]));
    for end in 0..2 {
        assert!(close(&hertz["range"]["r"][end], &ratios["range"]["r"][end]));
        assert!(close(&omega["range"]["r"][end], &ratios["range"]["r"][end]));
    }
    let arguments = ["compile", FRAME, "--accuracy", "1e-3", "--hz", "4"];
    assert_eq!(
        failure("", &arguments),
        ["frictiongen: --hz is `4`, which is not a range a:b; write, for example, 1:7"]
    );
    let lines = failure("", &["compile", FRAME, "--hz", "1:7"]);
    assert!(
        lines
            .concat()
            .contains("give --accuracy 1e-4 or --budget 4096"),
        "{lines:?}"
    );
}

/// Motion from rest with so much friction that the contact never slides: the contact stays where it started, at 0 on a
/// wall and at −Y on a moving base, without rounding.
#[test]
fn a_contact_that_never_slides_stays_where_it_was() {
    let tower = "struct Tower {
        masses: { a: 1200, b: 1000, c: 800 },
        springs: { base - a: 1.2e6, a - b: 1.0e6, b - c: 0.8e6 },
        contact: b - base, excitation: base, damping: modal(0.02), stiction: 1.2,
    }";
    for (scene, arguments, offset) in [
        ("", [FRAME, "--hz", "1:0.2:7", "--friction", "30"], "0.0"),
        (
            tower,
            ["-", "--hz", "1:0.7:15", "--friction", "1e6"],
            "-0.001",
        ),
    ] {
        let arguments = [&["response"], &arguments[..], &["--base", "0.001", "--csv"]].concat();
        let text = output(scene, &arguments);
        let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let names = rows.next().unwrap();
        let column = |name: &str| names.iter().position(|known| *known == name).unwrap();
        let [regime, at] = ["regime", "offset_m"].map(column);
        let mut stuck = 0;
        for row in rows.filter(|row| row[regime] == "stuck") {
            assert_eq!(row[at], offset, "{row:?}");
            stuck += 1;
        }
        assert!(20 <= stuck, "{stuck}");
    }
}

/// A contact that slides before it sticks for ever rests where a long run from rest leaves it. The run follows events
/// one by one and knows no steady state.
#[test]
fn a_contact_rests_where_a_run_leaves_it() {
    let load = ["--base", "0.001", "--csv"];
    let frictions = "0.6,0.8,1,1.3";
    let asked = [
        "response",
        FRAME,
        "--hz",
        "0.6:0.4:3.4",
        "--friction",
        frictions,
    ];
    let text = output("", &[&asked[..], &load[..]].concat());
    let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let names = rows.next().unwrap();
    let column = |name: &str| names.iter().position(|known| *known == name).unwrap();
    let [hz, friction, regime, at] =
        ["frequency_Hz", "friction_N", "regime", "offset_m"].map(column);
    let mut compared = 0;
    for row in rows.filter(|row| row[regime] == "stuck" && row[at] != "0.0") {
        let asked = ["time", FRAME, "--hz", row[hz], "--friction", row[friction]];
        let span = [
            "--skip",
            "600",
            "--cycles",
            "1",
            "--samples",
            "2",
            "--of",
            "contact",
        ];
        let run = output("", &[&asked[..], &span[..], &load[..]].concat());
        let mut lines = run.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let names = lines.next().unwrap();
        let displacement = |name: &&str| name.starts_with("contact.displacement");
        let place = names.iter().position(displacement).unwrap();
        let rests: f64 = lines.next_back().unwrap()[place].parse().unwrap();
        let offset: f64 = row[at].parse().unwrap();
        // 600 cycles add roundings of 1 mm, not more.
        assert!((rests - offset).abs() < 1e-13, "{row:?}: {rests}");
        compared += 1;
    }
    assert!(8 <= compared, "{compared}");
}

#[cfg(feature = "report")]
#[test]
fn a_report_is_a_web_page() {
    for (name, advice) in [
        ("x.svg", "; for a picture, use `frictiongen curve`"),
        ("x.csv", "; for numbers, use `frictiongen curve`"),
        ("x.PDF", "; a browser prints the page as PDF"),
        ("x", ""),
    ] {
        let lines = failure(BLOCK, &["report", "-", "-o", name]);
        let start = format!(
            "frictiongen: --output `{name}`: a report is a web page, so that the name of the file must end in .html{advice}"
        );
        assert!(lines.concat().starts_with(&start), "{lines:?}");
        assert!(!std::path::Path::new(name).exists());
    }
}

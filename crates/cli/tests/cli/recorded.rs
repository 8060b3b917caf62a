//! Tests `transmissibility`, `identify` and `fit`: files, columns, formats, and inputs that they refuse.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::common::{cells, failure, file, json, output};
use std::fmt::Write as _;

fn plate() -> String {
    file(
        "plate.friction",
        "struct Plate { masses: { plate: 2 }, springs: { base - plate: 752 }, contact: plate - wall, excitation: base }",
    )
}

/// Returns a recording of 10 s at 100 Hz, driven at 4 Hz: a base of 1.75 mm and a plate of 2 mm with a lag of 2.6 rad.
/// `change` formats each value.
fn recording(head: &str, change: impl Fn(usize, f64) -> String) -> String {
    let mut text = format!("{head}\n");
    for i in 0..1000 {
        let t = f64::from(i) / 100.0;
        let turn = std::f64::consts::TAU * 4.0 * t;
        // A small component at other frequencies acts as noise.
        let rest = 1e-3 * (f64::from(i * i % 997) - 498.0) / 288.0;
        let (base, plate) = (1.75 * turn.cos() + rest, 2.0 * (turn - 2.6).cos() - rest);
        let _ = writeln!(text, "{t:.2},{},{}", change(0, base), change(1, plate));
    }
    text
}

fn plain(_: usize, value: f64) -> String {
    format!("{value:.5}")
}

#[test]
fn forms_and_columns() {
    let plate = plate();
    let own = file("own.csv", &recording("time_s,base_mm,plate_mm", plain));
    let other = file("other.csv", &recording("clock,AI0,AI1", plain));
    let own = output("", &["transmissibility", &plate, &own, "--csv"]);
    let channels = [
        "--channel",
        "base=AI0:mm",
        "--channel",
        "plate=3:mm",
        "--rate",
        "100",
    ];
    let asked = [
        ["transmissibility", &plate, &other, "--csv"].as_slice(),
        &channels,
    ]
    .concat();
    let other = output("", &asked);
    let rows = cells(&own);
    assert_eq!(
        rows[0][3..6],
        ["plate.transmissibility", "plate.lag_deg", "plate.deviation"]
    );
    let numbers = |row: &[&str]| {
        row.iter()
            .map(|cell| cell.parse::<f64>().unwrap())
            .collect::<Vec<_>>()
    };
    let (first, second) = (numbers(&rows[1]), numbers(&cells(&other)[1]));
    for (a, b) in first.iter().zip(&second) {
        // A rate given as an option agrees with that of a time column up to the rounding of the column.
        assert!((a - b).abs() <= 1e-9 * a.abs().max(1e-3), "{own}\n{other}");
    }
    assert!(
        (first[0] - 4.0).abs() < 1e-4 && (first[3] - 2.0 / 1.75).abs() < 1e-3,
        "{own}"
    );
    assert!((first[4] - 2.6_f64.to_degrees()).abs() < 0.1, "{own}");
}

#[test]
fn friction_as_table_and_json() {
    let (plate, own) = (
        plate(),
        file("json.csv", &recording("time_s,base_mm,plate_mm", plain)),
    );
    let table = output("", &["identify", &plate, &own, "--by", "phase"]);
    assert!(
        table.contains("verdict")
            && table.contains("the measurement determines the friction force"),
        "{table}"
    );
    let json = json(&output(
        "",
        &["identify", &plate, &own, "--by", "phase", "--json"],
    ));
    let force = json["points"]
        .as_array()
        .unwrap()
        .iter()
        .find(|point| point["quantity"] == "friction force")
        .unwrap();
    let [value, from, to] = ["value", "from", "to"].map(|name| force[name].as_f64().unwrap());
    assert!(from < value && value < to && 0.0 < from, "{force}");
    let picture = file("residuals.svg", "");
    output(
        "",
        &["identify", &plate, &own, "--by", "phase", "-o", &picture],
    );
    let drawn = std::fs::read_to_string(picture).unwrap();
    assert!(drawn.contains("<svg") && drawn.contains("residual over deviation"));
}

/// Checks that each bad recording gives one clear error on one line, with the name of the file.
#[test]
fn bad_recordings() {
    let plate = plate();
    let head = "time_s,base_mm,plate_mm";
    let told = |name: &str, text: &str, words: &str| {
        let path = file(name, text);
        let lines = failure("", &["identify", &plate, &path]);
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(
            lines[0].contains(name) || lines[0].contains("`plate`"),
            "{lines:?}"
        );
        assert!(lines[0].contains(words), "{lines:?}");
    };
    let constant = |place: usize, value: f64| {
        if place == 1 {
            "0.5".to_owned()
        } else {
            plain(0, value)
        }
    };
    told(
        "constant.csv",
        &recording(head, constant),
        "the channel `plate` never changes",
    );
    let clip = |_: usize, value: f64| plain(0, value.clamp(-1.2, 1.2));
    told("clipped.csv", &recording(head, clip), "is clipped at");
    told(
        "two.csv",
        &format!("{head}\n0,1,2\n0.1,2,1\n"),
        "too short: 2 samples",
    );
    let broken = |place: usize, value: f64| {
        if place == 1 && 1.99 < value {
            "NaN".to_owned()
        } else {
            plain(0, value)
        }
    };
    told(
        "nan.csv",
        &recording(head, broken),
        "`NaN` of `plate_mm` is not a finite number",
    );
    told(
        "column.csv",
        &recording("time_s,base_mm,plat_mm", plain),
        "`plat` does not belong to this scene",
    );
    told(
        "unit.csv",
        &recording("time_s,base_mm,plate", plain),
        "the channel `plate` has no unit",
    );
    let mixed = recording(head, plain).replace("\n5.00,", "\n5.004,");
    told("mixed.csv", &mixed, "not evenly spaced");
    told(
        "thousand.csv",
        &recording("time_s,base_mm,plate_m", plain),
        "a unit is wrong by this factor",
    );
    let empty = file("empty.csv", "");
    assert!(failure("", &["fit", &plate, &empty])[0].contains("the file is empty"));
    let nothing = failure("", &["identify", &plate, "there-is-none.csv"]);
    assert!(nothing[0].contains("there is no such file"), "{nothing:?}");
    assert!(
        failure("", &["identify", &plate])
            .iter()
            .any(|line| line.contains("RECORDING"))
    );
}

#[test]
fn a_drive_that_drifts() {
    let mut text = "time_s,base_mm,plate_mm\n".to_owned();
    for i in 0..2000 {
        let t = f64::from(i) / 100.0;
        let turn = std::f64::consts::TAU * (4.0 * t + 0.01 * t * t);
        let _ = writeln!(
            text,
            "{t:.2},{:.6},{:.6}",
            1.75 * turn.cos(),
            2.0 * (turn - 2.6).cos()
        );
    }
    let (plate, path) = (plate(), file("drift.csv", &text));
    let lines = failure("", &["identify", &plate, &path]);
    assert!(
        lines[0].contains("the frequency of the excitation drifts from 4."),
        "{lines:?}"
    );
}

/// Writes a steady recording of the plate with μ = 1 and F = 0.4 kY, made from the library's response with noise.
fn made(scene: &str, hertz: f64, late: f64) -> String {
    let system: frictiongen::System = scene.parse().unwrap();
    let load = frictiongen::study::units::Load::Base(1.75e-3);
    let beta = system.load_scale(load).unwrap().friction_ratio(0.53);
    let at = system.at(system.frequency_ratio_at_hertz(hertz)).unwrap();
    let response = at.response(beta).unwrap();
    let orders = [1, 3, 5, 7, 9];
    let harmonics = orders.map(|order| {
        let of = frictiongen::Of::Mass(0);
        (order, response.harmonic(of, order).unwrap())
    });
    let mut text = "time_s,base_mm,plate_mm\n".to_owned();
    for i in 0..2000_u32 {
        let t = f64::from(i) / 100.0;
        let tau = std::f64::consts::TAU * hertz * t;
        let rest = 2e-3 * (f64::from(i * (i % 1009) % 997) - 498.0) / 288.0;
        let other = 2e-3 * (f64::from(i * (i % 887) % 991) - 495.0) / 286.0;
        let moved: f64 = harmonics
            .iter()
            .map(|(order, x)| {
                (x * frictiongen::Complex::from_polar(1.0, f64::from(*order) * (tau - late))).re
            })
            .sum();
        let _ = writeln!(
            text,
            "{t:.2},{:.5},{:.5}",
            1.75 * tau.cos() + rest,
            1.75 * moved + other
        );
    }
    text
}

/// Checks that the output begins with a warning, in text and in JSON, if noise does not explain the misfit.
#[test]
fn a_late_channel_is_not_explained() {
    let scene = std::fs::read_to_string(plate()).unwrap();
    let late = [1.2, 1.6].map(|hertz: f64| {
        let hertz = 3.086 * hertz;
        file(
            "late.csv",
            &made(&scene, hertz, std::f64::consts::TAU * hertz * 0.004),
        )
    });
    let arguments = ["identify", &plate(), &late[0], &late[1]];
    let table = output("", &arguments);
    let first = table.lines().find(|line| line.starts_with("verdict"));
    assert!(
        first.is_some_and(|line| line.contains("does not explain the measurement")),
        "{table}"
    );
    assert!(!table.contains("determines the friction force"), "{table}");
    let json = json(&output("", &[&arguments[..], &["--json"]].concat()));
    assert!(
        json["verdict"]
            .as_str()
            .unwrap()
            .contains("does not explain")
    );
    assert_eq!(json["points"][0]["value"], "not explained");
}

/// Checks that without a stop μ is reported as not determined, and that the interval of the force is as narrow as
/// without μ.
#[test]
fn stiction_without_a_stop_is_not_determined() {
    let scene = std::fs::read_to_string(plate()).unwrap();
    let good = [1.2, 1.6].map(|hertz| file("good.csv", &made(&scene, 3.086 * hertz, 0.0)));
    let plate = plate();
    let arguments = ["identify", &plate, &good[0], &good[1], "--json"];
    let force = |json: &serde_json::Value| {
        let point = &json["points"][1];
        assert_eq!(point["quantity"], "friction force");
        ["value", "from", "to"].map(|name| point[name].as_f64().unwrap())
    };
    let alone = force(&json(&output("", &arguments)));
    let with = json(&output(
        "",
        &[&arguments[..], &["--also", "stiction"]].concat(),
    ));
    assert!(
        with["not determined"].as_str().unwrap().starts_with("mu: "),
        "{with}"
    );
    // This fit takes steps instead of golden sections. Its results agree to a hundredth of the interval.
    for (a, b) in alone.iter().zip(force(&with)) {
        assert!(
            (a - b).abs() < 0.01 * (alone[2] - alone[1]),
            "{alone:?} {with}"
        );
    }
    assert!(alone[1] < 0.53 && 0.53 < alone[2], "{alone:?}");
}

/// Fits the whole motion of a plate that sticks and slides, which a stepper has computed.
#[test]
fn a_whole_motion() {
    use frictiongen::study::{System, SystemInput};
    let text = "struct Plate { masses: { plate: 2 }, springs: { base - plate: 752 }, contact: plate - wall,
        excitation: base, damping: modal(0.02), stiction: 1.3 }";
    let system: System = text.parse().unwrap();
    let mut step = system.stepper(0.01).unwrap();
    let mut csv = "time_s,base_mm,plate_mm\n".to_owned();
    let base = |sample: u32| {
        let time = 0.01 * f64::from(sample);
        3.0 * time.min(1.0).powi(4) * (13.0 * time).sin()
    };
    for sample in 0..300_u32 {
        let place = base(sample);
        // The base moves in straight lines between the samples.
        let velocity = (place - base(sample.saturating_sub(1))) / 0.01;
        let input = SystemInput::base(1e-3 * place, 1e-3 * velocity).friction(0.8);
        let input = input.starting_at(1e-3 * velocity);
        if sample == 0 {
            step.begin(input).unwrap();
        } else {
            step.advance(input).unwrap();
        }
        let plate = 1e3 * step.mass_at(0).displacement();
        let _ = writeln!(csv, "{:.2},{place:?},{plate:?}", 0.01 * f64::from(sample));
    }
    let recording = file("whole.csv", &csv);
    let guess = text
        .replace("1.3", "1.2")
        .replace("modal(0.02)", "modal(0.03)");
    let scene = file("guess.friction", &guess);
    let asked = [
        "fit",
        &scene,
        &recording,
        "--friction",
        "0.6",
        "--vary",
        "mu",
        "--vary",
        "zeta",
    ];
    let answer = json(&output("", &[&asked[..], &["--json"]].concat()));
    assert_eq!(answer["derivatives"], "exact", "{answer}");
    let value = |key: &str| {
        let points = answer["points"].as_array().unwrap();
        let point = points.iter().find(|point| point["key"] == key);
        point.unwrap()["value"].as_f64().unwrap()
    };
    for (key, expected, near) in [
        ("friction_N", 0.8, 1e-3),
        ("mu", 1.3, 5e-3),
        ("zeta", 0.02, 1e-3),
    ] {
        assert!((value(key) - expected).abs() < near, "{key}: {answer}");
    }
    assert!(
        value("scatter") < 1e-3 && value("exact_derivatives") > 6.0,
        "{answer}"
    );
    assert_eq!(value("differences"), 0.0);
    // A scene that cannot move as the recording does.
    let stiff = file("stiff.friction", &guess.replace("752", "1900"));
    let table = output("", &["fit", &stiff, &recording, "--friction", "0.6"]);
    let verdict = table.lines().find(|line| line.starts_with("verdict"));
    assert!(
        verdict.unwrap().contains("does not explain the recording"),
        "{table}"
    );

    for (more, said) in [
        (
            &["--friction", "0"][..],
            "--friction `0`: a force in N above 0",
        ),
        (&["--vary", "m3"], "--vary `m3`: there is no number `m3`"),
        (&["--vary", "mu"], "whole.csv: no friction force is given"),
        (&["--friction", "1", "--damping"], "cannot be used with"),
    ] {
        let asked = [&["fit", &scene, &recording][..], more].concat();
        let told = failure("", &asked).join("\n");
        assert!(told.contains(said), "{told}");
    }
    let still = csv.replace("plate_mm", "plate_N");
    let told = failure(
        "",
        &["fit", &scene, &file("still.csv", &still), "--friction", "1"],
    );
    assert!(
        told[0].contains("no motion of a mass was recorded"),
        "{told:?}"
    );
}

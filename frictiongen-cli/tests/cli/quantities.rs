//! Tests of `--of` with relative motions, forces, velocities and accelerations.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{FRAME, failure, output};

/// The load and the friction of the frame.
const POINT: [&str; 6] = [
    "--hz",
    "1.8:0.1:2.2",
    "--friction",
    "0.5",
    "--base",
    "0.002",
];

fn table(command: &str, of: &[&str]) -> Vec<Vec<String>> {
    let mut arguments = vec![command, FRAME, "--csv"];
    arguments.extend(POINT);
    for name in of {
        arguments.extend(["--of", name]);
    }
    let text = output("", &arguments);
    let row = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().map(row).collect()
}

fn column(table: &[Vec<String>], name: &str) -> Vec<f64> {
    let place = table[0].iter().position(|found| found == name);
    let place = place.unwrap_or_else(|| panic!("no column {name} in {:?}", table[0]));
    table[1..]
        .iter()
        .map(|row| row[place].parse().unwrap())
        .collect()
}

/// A spring force is the stiffness times the elongation. The largest acceleration of a motion of one harmonic is ω²
/// times its amplitude.
#[test]
fn forces_and_accelerations_fit_the_displacements() {
    let of = [
        "upper-lower",
        "spring(lower-upper)",
        "accel(upper)",
        "vel(upper)",
        "upper",
        "shear",
        "lower-base",
    ];
    let found = table("curve", &of);
    let drift = column(&found, "upper-lower.amplitude_m");
    let force = column(&found, "spring(lower-upper).amplitude_N");
    assert!(drift.len() > 2);
    for (drift, force) in drift.iter().zip(&force) {
        assert!(
            (force / drift / 1323.0 - 1.0).abs() < 1e-12,
            "{force} N, {drift} m"
        );
    }
    // One spring alone is at the base, and the base moves.
    let drift = column(&found, "lower-base.amplitude_m");
    let shear = column(&found, "shear.amplitude_N");
    for (drift, shear) in drift.iter().zip(&shear) {
        assert!(
            (shear / drift / 1190.0 - 1.0).abs() < 1e-12,
            "{shear} N, {drift} m"
        );
    }
    let rates = [
        column(&found, "vel(upper).amplitude_m_s"),
        column(&found, "accel(upper).amplitude_m_s2"),
    ];
    let sizes = column(&found, "upper.amplitude_m");
    for (index, hertz) in column(&found, "frequency_Hz").iter().enumerate() {
        let omega = std::f64::consts::TAU * hertz;
        let [velocity, acceleration] = [rates[0][index], rates[1][index]];
        // Friction adds harmonics, which count more in the acceleration.
        let size = sizes[index];
        assert!(
            (velocity / (omega * size) - 1.0).abs() < 0.2,
            "{hertz} Hz: {velocity}"
        );
        assert!(
            (acceleration / (omega * omega * size) - 1.0).abs() < 0.7,
            "{hertz} Hz: {acceleration}"
        );
    }
}

/// Other commands have the same columns for the same names.
#[test]
fn every_command_reads_the_names() {
    let map = table("map", &["upper-base", "shear"]);
    assert!(
        column(&map, "shear.amplitude_N")
            .iter()
            .all(|force| 0.0 < *force)
    );
    let point = [
        "--hz",
        "1.5",
        "--friction",
        "1.5",
        "--base",
        "0.002",
        "--of",
        "upper-base",
        "--of",
        "shear",
    ];
    let time = output("", &[&["time", FRAME, "--csv"][..], &point].concat());
    let names = time.lines().next().unwrap();
    assert!(
        names.contains("upper-base.displacement_m,upper-base.velocity_m_s,shear.force_N"),
        "{names}"
    );
    let sensitivity = output("", &[&["sensitivity", FRAME][..], &point[..8]].concat());
    assert!(sensitivity.contains("upper-base"), "{sensitivity}");
    let optimum = [
        "optimum",
        FRAME,
        "--hz",
        "1:6",
        "--base",
        "0.002",
        "--of",
        "upper-lower",
    ];
    assert!(output("", &optimum).contains("largest amplitude of upper-lower"));
}

/// Names that mean nothing, each with the way out.
#[test]
fn names_that_mean_nothing() {
    let point = [
        "--hz",
        "1.5:0.5:2.5",
        "--friction",
        "1.5",
        "--base",
        "0.002",
        "--of",
    ];
    for (name, message) in [
        (
            "roof-base",
            "--of: there is no mass `roof`; the masses are lower, upper",
        ),
        (
            "base-upper",
            "--of: the base is the reference; write `upper-base`",
        ),
        (
            "upper-upper",
            "--of: `upper` does not move relative to itself; write two different masses, or one mass and `base`",
        ),
        (
            "spring(base-upper)",
            "--of: there is no spring `base-upper`; the springs are spring(base-lower), spring(lower-upper)",
        ),
        (
            "accel(shear)",
            "--of: `shear` is a force, which has neither a velocity nor an acceleration",
        ),
        (
            "slip(upper)",
            "--of: `upper` is no contact; write `slip(contact)`",
        ),
        (
            "jerk(upper)",
            "--of: there is no quantity `jerk(…)`; write the name of a mass, `contact`, `mass-base`, `mass-mass`, `spring(a-b)`, `shear`, `vel(…)` or `accel(…)`",
        ),
        (
            "accel(upper",
            "--of: `accel(upper`: write one closing bracket, at the end",
        ),
    ] {
        let found = failure("", &[&["curve", FRAME][..], &point, &[name]].concat()).join("\n");
        assert!(found.contains(message), "{name}: {found}");
    }
    let found = failure(
        "",
        &[&["map", FRAME][..], &point, &["accel(upper)"]].concat(),
    )
    .join("\n");
    assert!(
        found.contains("--of `accel(upper)`: this command has displacements and forces only"),
        "{found}"
    );
    let found = failure(
        "",
        &[&["sensitivity", FRAME][..], &point, &["shear"]].concat(),
    )
    .join("\n");
    assert!(
        found.contains("a spring force has no derivatives here"),
        "{found}"
    );
}

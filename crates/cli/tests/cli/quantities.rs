//! Tests of `--of` with relative motions, forces, velocities and accelerations.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::common::{BLOCK, FRAME, failure, output};
use frictiongen::study::response::MotionQuantity;
use frictiongen::{Of, System};

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

/// The equivalent damping ratio is E_d/(4πE_s), with the strain energy of all springs or of one. `response` has the
/// closed form, `orbit` the motion from event to event, and `curve` the closed form and the motion.
#[test]
fn equivalent_damping_is_that_of_its_formula() {
    let of = [
        "zeta_eq",
        "zeta_eq(upper-lower)",
        "energy(contact)",
        "spring(base-lower)",
        "spring(lower-upper)",
    ];
    let mut compared = 0;
    for command in ["response", "orbit", "curve"] {
        let found = table(command, &of);
        let energy = column(&found, "energy(contact).cycle_J");
        let forces = [
            column(&found, "spring(base-lower).amplitude_N"),
            column(&found, "spring(lower-upper).amplitude_N"),
        ];
        let whole = column(&found, "zeta_eq.ratio");
        let storey = column(&found, "zeta_eq(upper-lower).ratio");
        for (row, energy) in energy.iter().enumerate() {
            let strain = [
                0.5 * forces[0][row].powi(2) / 1190.0,
                0.5 * forces[1][row].powi(2) / 1323.0,
            ];
            let ratio = |stored: f64| energy / (4.0 * std::f64::consts::PI * stored);
            for (got, want) in [
                (whole[row], ratio(strain[0] + strain[1])),
                (storey[row], ratio(strain[1])),
            ] {
                assert!((got / want - 1.0).abs() < 1e-12, "{command}: {got} {want}");
                assert!(1e-3 < got && got < 1.0, "{got}");
                compared += 1;
            }
        }
    }
    assert!(compared > 30, "{compared}");
    // The textbooks' 2F/(πkX) of one mass on one spring: a loop of area 4FX over 4π·½kX².
    let system: System = BLOCK.parse().unwrap();
    let response = system.at(0.6).unwrap().response(0.3).unwrap();
    let size = response.swing(Of::Contact).unwrap().amplitude;
    for name in ["zeta_eq", "zeta_eq(base-block)"] {
        let (of, size_of) = system.quantity_named(name).unwrap();
        assert_eq!(size_of, MotionQuantity::Damping);
        let ratio = response.largest(of, size_of).unwrap();
        let want = 2.0 * 0.3 / (std::f64::consts::PI * size);
        assert!((ratio / want - 1.0).abs() < 1e-13, "{ratio} {want}");
    }
    // A stuck contact takes no energy, and a search for the least ratio would end with a stuck contact. The block on
    // its only spring has no ratio then, because nothing moves.
    let frame: System = std::fs::read_to_string(FRAME).unwrap().parse().unwrap();
    for (system, ratio) in [(&system, None), (&frame, Some(0.0))] {
        let stuck = system.at(0.6).unwrap().response(9.0).unwrap();
        assert_eq!(stuck.largest(Of::Contact, MotionQuantity::Damping), ratio);
    }
    let message = failure(
        "",
        &[
            "optimum", FRAME, "--of", "zeta_eq", "--hz", "1:7", "--base", "0.002",
        ],
    )
    .join(" ");
    assert!(
        message.contains("`zeta_eq` is best where it is large"),
        "{message}"
    );
    let message = failure(
        "",
        &[
            "curve",
            FRAME,
            "--of",
            "zeta_eq(upper)",
            "--r",
            "0.5:1",
            "--beta",
            "0.3",
        ],
    )
    .join(" ");
    assert!(
        message.contains("the springs are spring(base-lower)"),
        "{message}"
    );
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
            "--of: there is no quantity `jerk(…)`; write the name of a mass, `contact`, `mass-base`, `mass-mass`, `spring(a-b)`, `shear`, `vel(…)`, `accel(…)`, `slip(contact)`, `force(contact)`, `energy(contact)`, `zeta_eq` or `zeta_eq(a-b)`",
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
        found.contains(
            "--of `accel(upper)`: this command has displacements and forces of springs only"
        ),
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

/// Every point of a curve under a base motion of constant acceleration and velocity agrees with a single response at its
/// frequency, whose load is computed by hand. Both come from the same solver, so a unique steady state agrees to rounding
/// of the load, which the solver amplifies by less than 1e6.
#[test]
fn every_point_of_a_curve_under_a_load_over_frequency() {
    let text = std::fs::read_to_string(FRAME).unwrap();
    let system: System = text.parse().unwrap();
    let (mass, stiffness) = (
        system.scene().masses[0].value,
        system.scene().springs[0].stiffness,
    );
    let friction = 1.5;
    let (mut regimes, mut compared) = (std::collections::BTreeSet::new(), 0);
    for (base, power) in [("0.4 m/s2", 2), ("0.03 m/s", 1)] {
        let size: f64 = base.split(' ').next().unwrap().parse().unwrap();
        let text = output(
            "",
            &[
                "curve",
                FRAME,
                "--csv",
                "--hz",
                "1.8:2.6",
                "--friction",
                "1.5",
                "--base",
                base,
                "--of",
                "upper",
                "--of",
                "accel(upper)",
                "--of",
                "force(contact)",
                "--of",
                "energy(contact)",
            ],
        );
        let row = |line: &str| line.split(',').map(str::to_owned).collect();
        let found: Vec<Vec<String>> = text.lines().map(row).collect();
        let places = column(&found, "frequency_Hz");
        assert!(30 < places.len(), "{}", places.len());
        let names = [
            "beta",
            "upper.amplitude_m",
            "accel(upper).amplitude_m_s2",
            "force(contact).amplitude_N",
            "energy(contact).cycle_J",
        ];
        let columns = names.map(|name| column(&found, name));
        // All points are computed alike, so every fifth one is compared.
        for (index, hertz) in places.into_iter().enumerate().step_by(5) {
            let omega = 2.0 * std::f64::consts::PI * hertz;
            let length = size / omega.powi(power);
            let beta = friction / (stiffness * length);
            let at = system.at(omega * (mass / stiffness).sqrt()).unwrap();
            let response = at.response(beta).unwrap();
            if !response.is_settled() {
                continue;
            }
            regimes.insert(format!("{:?}", response.regime()));
            let upper = Of::Mass(1);
            let by_hand = [
                beta,
                length * response.swing(upper).unwrap().amplitude,
                length
                    * omega
                    * omega
                    * response
                        .largest(upper, MotionQuantity::Acceleration)
                        .unwrap(),
                stiffness * length * response.contact_force(),
                stiffness * length * length * response.friction_work(),
            ];
            for ((column, by_hand), name) in columns.iter().zip(by_hand).zip(names) {
                let value = column[index];
                compared += 1;
                let scale = by_hand.abs().max(1e-9);
                assert!(
                    (value - by_hand).abs() < 1e-9 * scale,
                    "{base} {hertz} Hz {name}: {value} {by_hand}"
                );
            }
        }
    }
    assert!(2 <= regimes.len(), "{regimes:?}");
    assert!(300 < compared, "{compared}");
}

/// In a motion with one loop in a cycle, the energy that the contact takes is the area of the loop, 2F(z_max − z_min).
/// In a motion that does not stop it is 4FZ.
#[test]
fn energy_is_the_area_of_the_loop() {
    for command in ["response", "orbit"] {
        let found = table(command, &["contact", "energy(contact)", "force(contact)"]);
        let amplitude = column(&found, "contact.amplitude_m");
        let energy = column(&found, "energy(contact).cycle_J");
        let force = column(&found, "force(contact).amplitude_N");
        assert_eq!(energy.len(), 5);
        for ((amplitude, energy), force) in amplitude.iter().zip(&energy).zip(&force) {
            assert!(
                (energy - 4.0 * 0.5 * amplitude).abs() < 1e-12,
                "{command}: {energy} {amplitude}"
            );
            assert!(0.5 <= *force, "{command}: {force}");
        }
    }
}

/// Wrong loads and quantities each give one line that says what to write.
#[test]
fn mistakes_of_loads() {
    let curve = ["curve", FRAME, "--hz", "1.8:2.2", "--friction", "0.5"];
    let optimum = ["optimum", FRAME, "--hz", "1.8:2.2", "--of", "upper"];
    let features = ["features", FRAME, "--hz", "1.8:2.2"];
    let cases: [(&[&str], &[&str], &str); 6] = [
        (
            &curve,
            &["--base", "0.2x"],
            "--base `0.2x`: the unit of a base motion is m, mm, m/s, m/s2 or g, not `x`",
        ),
        (
            &curve,
            &["--force", "0.2g"],
            "--force `0.2g`: it is not a number",
        ),
        (
            &curve,
            &["--unbalance", "0.2"],
            "--unbalance: the scene is driven by its base; its load is given by --base",
        ),
        (
            &["curve", FRAME, "--hz", "1.8:2.2", "--beta", "0.5"],
            &["--base", "0.2g"],
            "--beta: the amplitude of this load depends on frequency",
        ),
        (
            &features,
            &["--base", "0.2g"],
            "--base: the amplitude of this load depends on frequency",
        ),
        (
            &optimum,
            &["--base", "0.2 J"],
            "the unit of a base motion is m, mm, m/s, m/s2 or g, not `J`",
        ),
    ];
    for (command, options, message) in cases {
        let lines = failure("", &[command, options].concat());
        assert_eq!(lines.len(), 1, "{lines:?}");
        assert!(lines[0].contains(message), "{lines:?}");
    }
    let block = [
        "curve",
        "--hz",
        "1:2",
        "--friction",
        "0.5",
        "--base",
        "0.2g",
    ];
    let lines = failure(BLOCK, &block);
    assert!(
        lines[0].contains("--base: the scene is driven by a force on"),
        "{lines:?}"
    );
}

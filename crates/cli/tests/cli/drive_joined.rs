//! Tests `frictiongen drive` for scenes with several contacts.
#![allow(clippy::unwrap_used, reason = "a test fails by it")]
#![allow(clippy::indexing_slicing, reason = "a test may fail")]

use crate::common::{column, failure, file, json, output, texts};
use std::fs;

/// Returns a recording with samples at intervals of 0.01 s.
fn samples(head: &str, count: u32, of: impl Fn(f64) -> String) -> String {
    let lines = (0..count).map(|sample| {
        let time = 0.01 * f64::from(sample);
        format!("{time},{}\n", of(time))
    });
    format!("{head}\n{}", lines.collect::<String>())
}

/// Runs `drive` on a scene from standard input.
fn drive(scene: &str, path: &str, options: &[&str]) -> String {
    let mut command = vec!["drive", "-", path];
    command.extend(options);
    output(scene, &command)
}

/// A frame with one contact, with damping proportional to the stiffness, and with the same damping by dashpots. The two
/// solvers are independent: the solver for one contact has modes in closed form, and the solver for several contacts and
/// dashpots has power series.
#[test]
fn one_contact_moves_as_with_the_solver_of_one_contact() {
    let chain = "masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 }, provide: [stepper]";
    let dashpots = "dampers: { base - lower: 1.19, lower - upper: 1.323 }";
    let rigid = "upper - wall, stiction: 1.2";
    let listed = "pads: upper - wall { stiction: 1.2 }";
    let elastic = (
        "lower - upper, stiffness: 4.0e3",
        "pads: lower - upper { stiffness: 4.0e3 }",
    );
    let base = samples("time_s,base_m_s2", 300, |t| {
        format!("{}", 3.0 * (9.0 * t).sin() * f64::from(u8::from(t < 2.0)))
    });
    // The force begins above the friction, so that the contact breaks away at once.
    let force = samples("time_s,force_N,friction_N", 300, |t| {
        format!("{},{}", 9.0 * (8.0 * t).cos(), 4.0 + (3.0 * t).sin())
    });
    let mut largest = 0.0_f64;
    for (name, record, excitation, friction, contact) in [
        ("base", &base, "base", Some("4"), (rigid, listed)),
        ("base elastic", &base, "base", Some("6"), elastic),
        ("force", &force, "upper", None, (rigid, listed)),
        ("force elastic", &force, "lower", None, elastic),
    ] {
        let path = file(&name.replace(' ', "-"), record);
        let mut options = vec![
            "--csv",
            "--of",
            "upper",
            "--of",
            "lower",
            "--of",
            "upper-lower",
        ];
        options.extend(["--of", "spring(base-lower)", "--of", "shear"]);
        options.extend(friction.into_iter().flat_map(|f| ["--friction", f]));
        // The solver of one contact holds the friction during a step, also with linear input.
        let input = if friction.is_none() { "hold" } else { "linear" };
        let scene = |contact: &str| {
            format!(
                "struct Frame {{ {chain}, {contact}, input: {input}, excitation: {excitation} }}"
            )
        };
        let (one, other) = contact;
        let damped = match excitation {
            "base" => "damping: rayleigh(0, 1e-3), damping_from: base",
            _ => "damping: rayleigh(0, 1e-3)",
        };
        let one = scene(&format!("contact: {one}, {damped}"));
        let one = drive(&one, &path, &options);
        let many = scene(&format!("contacts: {{ {other} }}, {dashpots}"));
        let many = drive(&many, &path, &options);
        fs::remove_file(path).unwrap();
        // The solver of one contact counts a break-away before the first step as an event of this step. If the friction
        // rises, it also counts that an elastic contact stops to slide at the start of a step.
        let events = |csv: &str| {
            column(csv, "events")
                .into_iter()
                .skip(2)
                .collect::<Vec<f64>>()
        };
        if name != "force elastic" {
            assert_eq!(events(&one), events(&many), "{name}");
        }
        let stops = column(&one, "events").into_iter().fold(0.0, f64::max);
        assert!(0.0 < stops, "{name}: no events");
        for (of_one, of_many) in [
            ("upper.displacement_m", "upper.displacement_m"),
            ("lower.velocity_m_s", "lower.velocity_m_s"),
            ("upper-lower.displacement_m", "upper-lower.displacement_m"),
            ("spring(base-lower).force_N", "spring(base-lower).force_N"),
            ("shear.force_N", "shear.force_N"),
            ("contact.friction_N", "pads.force_N"),
        ] {
            let (one, many) = (column(&one, of_one), column(&many, of_many));
            let size = one.iter().copied().map(f64::abs).fold(0.0, f64::max);
            for (sample, (one, many)) in one.iter().zip(&many).enumerate() {
                let apart = (one - many).abs() / size;
                largest = largest.max(apart);
                // The rounding of 300 steps of two different formulas.
                assert!(apart < 1e-11, "{name}, {of_one}, {sample}: {one} {many}");
            }
        }
        let stuck = texts(&one, "contact.state").into_iter();
        let stuck: Vec<&str> = stuck
            .map(|state| if state == "stuck" { "true" } else { "false" })
            .collect();
        assert_eq!(stuck, texts(&many, "pads.sticks"), "{name}");
    }
    println!("largest difference {largest:.1e}");
}

/// The friction of each contact is its share of the common friction. Slip, energy and displacements relative to the base
/// follow from their definitions.
#[test]
fn columns_for_each_contact() {
    let frame = "struct Frame { masses: { lower: 2.0, upper: 1.5 },
        springs: { base - lower: 1500.0, lower - upper: 1200.0 },
        contacts: { brace: base - lower { stiffness: 4.0e3 }, pads: lower - upper { share: 0.6 } },
        dampers: { lower - upper: 1.5 }, damping: modal(0.01), excitation: base }";
    let record = samples("time_s,base_m_s2", 400, |t| {
        format!("{}", 6.0 * (11.0 * t).sin())
    });
    let path = file("frame.csv", &record);
    let csv = drive(frame, &path, &["--friction", "5", "--csv"]);
    let text = drive(frame, &path, &["--friction", "5"]);
    let whole = json(&drive(frame, &path, &["--friction", "5", "--json"]));
    let head = csv.lines().next().unwrap();
    assert_eq!(
        head,
        "time_s,brace.displacement_m,brace.velocity_m_s,pads.displacement_m,pads.velocity_m_s,\
         lower-base.displacement_m,lower-base.velocity_m_s,upper-base.displacement_m,upper-base.velocity_m_s,\
         brace.force_N,brace.slip_m,brace.energy_J,brace.sticks,pads.force_N,pads.slip_m,pads.energy_J,pads.sticks,events"
    );
    for (name, friction) in [("brace", 5.0), ("pads", 3.0)] {
        let of = |quantity: &str| column(&csv, &format!("{name}.{quantity}"));
        let (slip, energy) = (of("slip_m"), of("energy_J"));
        let most = of("force_N").into_iter().map(f64::abs).fold(0.0, f64::max);
        assert!((most - friction).abs() < 1e-12, "{name}: {most}");
        assert!(slip.windows(2).all(|pair| pair[0] <= pair[1]), "{name}");
        let (last, spent) = (slip.last().unwrap(), energy.last().unwrap());
        assert!(0.0 < *last, "{name}");
        assert!(
            (spent - friction * last).abs() < 1e-12 * spent,
            "{name}: {spent}"
        );
        assert_eq!(
            whole["friction_energy"][format!("{name}_J")].as_f64(),
            Some(*spent)
        );
        assert!(text.contains(&format!("{name} ")), "{text}");
    }
    let drawn = format!("{path}.svg");
    drive(frame, &path, &["--friction", "5", "-o", &drawn]);
    let svg = fs::read_to_string(&drawn).unwrap();
    fs::remove_file(drawn).unwrap();
    for word in [
        "pads: hysteresis loop",
        "the contact sticks",
        "friction energy",
    ] {
        assert!(svg.contains(word), "{word}");
    }
    // The brace connects the base and the lower mass: its elongation is their distance, z = x_base − x_lower.
    let (brace, lower) = (
        column(&csv, "brace.displacement_m"),
        column(&csv, "lower-base.displacement_m"),
    );
    for (brace, lower) in brace.iter().zip(&lower) {
        assert!((brace.abs() - lower.abs()).abs() < 1e-12, "{brace} {lower}");
    }
    fs::remove_file(path).unwrap();
}

/// Names, options and units that do not fit are refused in one line.
#[test]
fn what_does_not_fit_is_refused() {
    let pair = "struct Pair { masses: { a: 1.0, b: 1.0 }, springs: { base - a: 100.0 },
        contacts: { left: a - b, right: b - wall { stiffness: 50.0 } }, excitation: a }";
    let path = file("pair.csv", "time_s,force_N\n0,0\n0.01,1\n0.02,1\n");
    for (options, told) in [
        (&["--of", "c"][..], "the contacts are left, right"),
        (
            &["--of", "contact"],
            "several contacts; name one of them: left, right",
        ),
        (&["--of", "left", "--of", "left"], "it is given twice"),
        (&["--of", "accel(a)"], "this command has displacements"),
        (&["--spectrum", "0.05"], "--spectrum has no answer"),
    ] {
        let mut command = vec!["drive", "-", path.as_str()];
        command.extend(options);
        if options[0] != "--spectrum" {
            command.extend(["--friction", "1"]);
        }
        let lines = failure(pair, &command);
        assert!(lines.len() == 1 && lines[0].contains(told), "{lines:?}");
    }
    let lines = failure(pair, &["drive", "-", &path]);
    assert!(lines[0].contains("no friction force is given"), "{lines:?}");
    fs::remove_file(path).unwrap();
}

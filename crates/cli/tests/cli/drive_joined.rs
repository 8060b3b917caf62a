//! Tests the solver of `frictiongen drive`, and scenes with several contacts.
#![allow(clippy::unwrap_used, reason = "a test fails by it")]
#![allow(clippy::indexing_slicing, reason = "a test may fail")]

use crate::common::{column, failure, file, json, output, texts};
use frictiongen::answer::Contact;
use frictiongen::measure::{CsvRequest, Inputs, Recording};
use frictiongen::{Of, System};
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

/// The command has the solver for several contacts, whose motion has power series. The stepper for one contact has modes
/// in closed form.
#[test]
fn one_contact_moves_as_with_the_stepper_of_one_contact() {
    let chain = "masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 }, provide: [stepper]";
    let base = samples("time_s,base_m_s2", 300, |t| {
        format!("{}", 3.0 * (9.0 * t).sin() * f64::from(u8::from(t < 2.0)))
    });
    // The force begins above the friction, so that the contact breaks away at once.
    let force = samples("time_s,force_N,friction_N", 300, |t| {
        format!("{},{}", 9.0 * (8.0 * t).cos(), 4.0 + (3.0 * t).sin())
    });
    let elastic = "contact: lower - upper, stiffness: 4.0e3, stiction: 1.3";
    let falling = "contact: upper - wall, friction: stribeck(0.05: 0.7, 0.3: 0.5)";
    let damped = "damping: rayleigh(0.1, 1e-3), damping_from: base, excitation: base";
    // The stepper of one contact holds the friction during a step, also with linear input.
    let pushed = "damping: modal(0.02), input: hold, excitation";
    let (mut largest, mut events) = (0.0_f64, 0.0);
    for (name, record, friction, fields) in [
        (
            "rigid",
            &base,
            Some(4.0),
            format!("contact: upper - wall, stiction: 1.2, {damped}"),
        ),
        (
            "reversed",
            &base,
            Some(1.0),
            format!("contact: upper - lower, {damped}"),
        ),
        ("elastic", &base, Some(6.0), format!("{elastic}, {damped}")),
        ("falling", &base, Some(4.0), format!("{falling}, {damped}")),
        (
            "force",
            &force,
            None,
            format!("contact: upper - wall, stiction: 1.2, {pushed}: upper"),
        ),
        (
            "force elastic",
            &force,
            None,
            format!("{elastic}, {pushed}: lower"),
        ),
    ] {
        let path = file(&name.replace(' ', "-"), record);
        let scene = format!("struct Frame {{ {chain}, {fields} }}");
        let given = friction.map_or(String::new(), |force| format!("--friction={force}"));
        let options = ["--csv", "--of=upper", "--of=spring(base-lower)", &given];
        let options = options.into_iter().filter(|option| !option.is_empty());
        let csv = drive(&scene, &path, &options.collect::<Vec<_>>());
        fs::remove_file(path).unwrap();
        let system: System = scene.parse().unwrap();
        let recording = Recording::inputs_from_csv(record, &CsvRequest::default()).unwrap();
        let inputs = Inputs::of(&recording, &system, friction).unwrap();
        let mut step = inputs.stepper(&system).unwrap();
        let sign = if name == "reversed" { -1.0 } else { 1.0 };
        let shear = Of::Spring(0);
        let found = [
            ("upper.displacement_m", 0.1),
            ("upper.velocity_m_s", 1.0),
            ("spring(base-lower).force_N", 50.0),
            ("contact.friction_N", 4.0),
            ("contact.energy_J", 5.0),
        ];
        let found = found.map(|(name, size)| (name, size, column(&csv, name)));
        for (sample, state) in texts(&csv, "contact.state").iter().enumerate() {
            if 0 < sample {
                step.advance(inputs.at(sample)).unwrap();
            }
            let upper = step.mass("upper").unwrap();
            let expected = [
                upper.displacement(),
                upper.velocity(),
                step.motion_of(shear).unwrap().0,
                sign * step.contact().force(),
                step.work().friction,
            ];
            for ((column, size, found), expected) in found.iter().zip(expected) {
                let apart = (found[sample] - expected).abs() / size;
                largest = largest.max(apart);
                // The rounding of 300 steps of two different formulas.
                assert!(
                    apart < 1e-11,
                    "{name}, {column}, {sample}: {expected} {}",
                    found[sample]
                );
            }
            let stuck = step.contact().contact() == Contact::Stuck;
            assert_eq!(*state == "stuck", stuck, "{name}, {sample}: {state}");
        }
        events += column(&csv, "events").into_iter().sum::<f64>();
    }
    println!("{events} events, largest difference {largest:.1e}");
    assert!(50.0 < events);
}

/// The friction of the record is a straight line between two samples, unless the scene holds its input.
#[test]
fn recorded_friction_changes_between_samples() {
    let path = file(
        "line.csv",
        "time_s,force_N,friction_N\n0,2,0\n0.5,2,0.5\n1,2,1\n1.5,2,1.5\n2,2,2\n",
    );
    // Without a spring, the acceleration is 2 − t, and x = t² − t³/6. With held friction it is 2, 1.5, 1 and 0.5.
    for (input, expected) in [("linear", 8.0 / 3.0), ("hold", 3.125)] {
        let block = format!(
            "struct Block {{ masses: {{ m: 1 }}, springs: {{}}, contacts: {{ pad: m - wall }},
            excitation: m, input: {input} }}"
        );
        let csv = drive(&block, &path, &["--csv", "--of", "m"]);
        let x = column(&csv, "m.displacement_m");
        assert!((x[4] - expected).abs() < 1e-13, "{input}: {x:?}");
    }
    fs::remove_file(path).unwrap();
}

/// The motion after a record is that under a longer record, whose further samples are 0 or repeat the last one.
#[test]
fn motion_after_the_record() {
    let masses =
        "struct Pair { masses: { a: 1.0, b: 1.0 }, springs: { base - a: 100.0, a - b: 100.0 }";
    let contact = "contact: b - base, stiction: 1.2";
    let wave = |time: f64| (2.0 * time + 0.3).sin();
    for (excitation, column, size, rest) in [
        ("base", "base_mm", 900.0, None),
        ("base", "base_m_s", 1.0, Some(0.0)),
        ("base", "base_m_s2", 3.0, Some(0.0)),
        ("a", "force_N", 40.0, Some(0.0)),
    ] {
        for input in ["linear", "hold"] {
            let record = |count: u32| {
                let lines = (0..count).map(|sample| {
                    let [time, last] =
                        [sample, sample.min(9)].map(|sample| 0.25 * f64::from(sample));
                    let value = rest.filter(|_| 9 < sample).unwrap_or(size * wave(last));
                    format!("{time},{value},{}\n", 5.0 + last)
                });
                format!("time_s,{column},friction_N\n{}", lines.collect::<String>())
            };
            let scene = format!("{masses}, {contact}, excitation: {excitation}, input: {input} }}");
            let [short, long] = [10, 18].map(|count| file("after.csv", &record(count)));
            let found = drive(&scene, &short, &["--csv", "--after", "1.9"]);
            assert_eq!(found, drive(&scene, &long, &["--csv"]), "{column} {input}");
            for (after, told) in [
                ("-1", "a time in s that is not negative is needed"),
                ("1 s", "write `1`"),
                (
                    "1e9",
                    "--after: the motion would have more than 10000000 samples",
                ),
            ] {
                let lines = failure(&scene, &["drive", "-", &short, "--after", after]);
                assert!(lines.len() == 1 && lines[0].contains(told), "{lines:?}");
            }
            for path in [short, long] {
                fs::remove_file(path).unwrap();
            }
        }
    }
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
         brace.friction_N,brace.state,brace.slip_m,brace.energy_J,pads.friction_N,pads.state,pads.slip_m,pads.energy_J,events"
    );
    for (name, friction) in [("brace", 5.0), ("pads", 3.0)] {
        let of = |quantity: &str| column(&csv, &format!("{name}.{quantity}"));
        let (slip, energy) = (of("slip_m"), of("energy_J"));
        let most = of("friction_N")
            .into_iter()
            .map(f64::abs)
            .fold(0.0, f64::max);
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

/// Peaks of a block under a force of 5 N from rest: it slides to 2(P − F)/k, back by 2(P − F) less than that, and sticks.
#[test]
fn peaks_of_a_block() {
    let block = "struct Block { masses: { m: 1.0 }, springs: { base - m: 100.0 }, contact: m - wall, excitation: m }";
    let path = file(
        "step.csv",
        &samples("time_s,force_N", 83, |_| "5".to_owned()),
    );
    let options = ["--of=m", "--of=contact", "--of=vel(m)", "--of=accel(m)"];
    let options = [
        &options[..],
        &["--of=force(contact)", "--of=energy(contact)", "--peaks"],
    ]
    .concat();
    let csv = drive(
        block,
        &path,
        &[&options[..], &["--friction=1.2", "--csv"]].concat(),
    );
    assert!(
        csv.starts_with("friction_N,quantity,peak,time_s,end,unit\n"),
        "{csv}"
    );
    let half = std::f64::consts::PI / 10.0;
    let expected = [
        ("m", 0.076, half, 0.048, "m"),
        ("contact", 0.076, half, 0.048, "m"),
        ("vel(m)", 0.38, 0.5 * half, 0.0, "m/s"),
        ("accel(m)", 3.8, 0.0, 0.0, "m/s2"),
        ("force(contact)", 1.2, 0.0, 0.2, "N"),
        ("energy(contact)", 1.2 * 0.104, 2.0 * half, 1.2 * 0.104, "J"),
    ];
    let [peaks, times, ends] = ["peak", "time_s", "end"].map(|name| column(&csv, name));
    for (row, (name, peak, time, end, unit)) in expected.into_iter().enumerate() {
        assert_eq!(
            (texts(&csv, "quantity")[row], texts(&csv, "unit")[row]),
            (name, unit)
        );
        for (found, expected) in [(peaks[row], peak), (times[row], time), (ends[row], end)] {
            // The instant of a flat peak has the square root of the rounding error.
            let apart = (found - expected).abs();
            assert!(
                apart < 1e-12 || (expected == time && apart < 1e-7),
                "{name}: {csv}"
            );
        }
    }
    let several = json(&drive(
        block,
        &path,
        &["--peaks", "--friction=0,1.2,9", "--json"],
    ));
    let rows = several["points"].as_array().unwrap();
    // Slip, force and energy of the contact, displacement and acceleration of the mass, and the base shear.
    assert_eq!(rows.len(), 3 * 6);
    assert!(
        rows.iter()
            .any(|row| row["quantity"] == "shear" && row["friction_N"] == 9.0)
    );
    let drawn = format!("{path}.svg");
    for (options, told) in [
        (&["--friction=-1"][..], "--friction"),
        (
            &["--friction=1", "--of=zeta_eq"],
            "a quantity is a displacement",
        ),
        (&["--friction=1", "--of=m2"], "the contacts are contact"),
        (&["--friction=1", "-o", &drawn], ".svg"),
    ] {
        let lines = failure(
            block,
            &[&["drive", "-", &path, "--peaks"], options].concat(),
        );
        assert!(lines.len() == 1 && lines[0].contains(told), "{lines:?}");
    }
    fs::remove_file(path).unwrap();
}

/// The peaks are those of a record with 50 samples on each line between two samples, up to the curvature between these.
#[test]
fn peaks_between_samples() {
    let frame = "struct Frame { masses: { lower: 2.0, upper: 1.5 },
        springs: { base - lower: 1500.0, lower - upper: 1200.0 },
        contacts: { brace: base - lower { stiffness: 4.0e3 }, pads: upper - lower { share: 0.6 } },
        dampers: { lower - upper: 1.5 }, damping: modal(0.01), excitation: base }";
    let at = |sample: u32| 6.0 * (0.33 * f64::from(sample)).sin();
    let record = |parts: u32| {
        let lines = (0..=40 * parts).map(|sample| {
            let (whole, rest) = (sample / parts, f64::from(sample % parts) / f64::from(parts));
            let value = (1.0 - rest) * at(whole) + rest * at(whole + 1);
            format!("{},{value}\n", 0.03 * f64::from(sample) / f64::from(parts))
        });
        format!("time_s,base_m_s2\n{}", lines.collect::<String>())
    };
    let [rough, fine] = [1, 50].map(|parts| file("peaks.csv", &record(parts)));
    let peaks = drive(frame, &rough, &["--peaks", "--friction=5", "--csv"]);
    let csv = drive(
        frame,
        &fine,
        &[
            "--friction=5",
            "--csv",
            "--of=lower-base",
            "--of=upper-base",
            "--of=upper-lower",
            "--of=shear",
            "--of=brace",
            "--of=pads",
        ],
    );
    for path in [rough, fine] {
        fs::remove_file(path).unwrap();
    }
    let mut compared = 0;
    let rows = texts(&peaks, "quantity")
        .into_iter()
        .zip(column(&peaks, "peak"));
    for ((name, peak), end) in rows.zip(column(&peaks, "end")) {
        let of = match name.split(['(', ')']).collect::<Vec<_>>()[..] {
            ["slip", contact, _] => format!("{contact}.displacement_m"),
            ["force", contact, _] => format!("{contact}.friction_N"),
            ["energy", contact, _] => format!("{contact}.energy_J"),
            ["shear"] => "shear.force_N".to_owned(),
            [motion] => format!("{motion}.displacement_m"),
            _ => continue,
        };
        let values = column(&csv, &of);
        let most = values.iter().copied().fold(0.0, |most: f64, value| {
            if most.abs() < value.abs() {
                value
            } else {
                most
            }
        });
        assert!(
            (peak - most).abs() < 1e-4 * most.abs(),
            "{name}: {peak} {most}"
        );
        assert!(
            most.abs() <= peak.abs() * (1.0 + 1e-12),
            "{name}: {peak} {most}"
        );
        let last = values.last().unwrap();
        assert!(
            (end - last).abs() < 1e-10 * most.abs(),
            "{name}: {end} {last}"
        );
        compared += 1;
    }
    assert_eq!(compared, 10);
}

/// Names, options and units that do not fit are refused in one line.
#[test]
fn what_does_not_fit_is_refused() {
    let pair = "struct Pair { masses: { a: 1.0, b: 1.0 }, springs: { base - a: 100.0 },
        contacts: { left: a - b, right: b - wall { stiffness: 50.0 } }, excitation: a }";
    let path = file("pair.csv", "time_s,force_N\n0,0\n0.01,1\n0.02,1\n");
    for (options, told) in [
        (&["--of", "c"][..], "the contacts are left, right"),
        (&["--of", "contact"], "the contacts are left, right"),
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

/// A chain of 70 masses under steps of its base. The expected displacements are those of the solver for one contact, which
/// has modes in closed form.
#[test]
fn a_long_chain_moves_as_by_its_modes() {
    let masses: Vec<String> = (1..=70).map(|mass| format!("m{mass}: 1")).collect();
    let springs = (2..=70).map(|mass| format!("m{} - m{mass}: 1000", mass - 1));
    let springs: Vec<String> = springs.collect();
    let scene = format!(
        "struct Long {{ masses: {{ {} }}, springs: {{ base - m1: 1000, {} }}, contact: m70 - wall, excitation: base,
            damping: modal(0.02) }}",
        masses.join(", "),
        springs.join(", ")
    );
    let lines = (0..=40).map(|sample| {
        let up = sample / 10 % 2;
        format!("{},{}\n", 0.05 * f64::from(sample), 0.01 * f64::from(up))
    });
    let record = format!("time_s,base_m\n{}", lines.collect::<String>());
    let path = file("long.csv", &record);
    let of = ["--friction", "0.01", "--of", "m5", "--of", "m20", "--csv"];
    let table = drive(&scene, &path, &of);
    for (name, expected) in [
        ("m5", 0.009_837_376_098_858_392),
        ("m20", 0.000_165_695_040_709_207_8),
    ] {
        let last = *column(&table, &format!("{name}.displacement_m"))
            .last()
            .unwrap();
        assert!((last - expected).abs() < 1e-14, "{name}: {last}");
    }
}

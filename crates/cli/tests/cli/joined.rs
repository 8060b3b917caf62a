//! Tests the commands on scenes with several contacts, dashpots, and masses that no spring holds.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{cells, column, column_with_gaps, json, output, texts, words};

/// Two floors with a brace, a pair of pads and a dashpot.
const FRAME: &str = "struct Frame { masses: { lower: 2.0, upper: 1.5 },
    springs: { base - lower: 1500.0, lower - upper: 1200.0 },
    contacts: { brace: base - lower { stiffness: 4.0e3 }, pads: lower - upper { share: 0.6 } },
    dampers: { lower - upper: 1.5 }, damping: modal(0.01), excitation: base }";

/// A block on a floor, without a spring.
const BLOCK: &str = "struct Block { masses: { block: 2.0 }, contacts: { floor: block - wall },
    excitation: block }";

/// The five storeys of the scene in `scenes/`.
const STOREYS: &str = include_str!("../../scenes/storeys.friction");

/// Returns the message of a run that must fail.
fn failure(scene: &str, arguments: &[&str]) -> String {
    crate::common::failure(scene, arguments).join("\n")
}

/// Orbit, response, curve and map have the same rows. In SI units the numbers are those of the groups times P/k₁ and P.
#[test]
fn commands_agree() {
    let groups = output(FRAME, &words("orbit --r 0.6 --beta 0.3 --csv"));
    let response = output(FRAME, &words("response --r 0.6 --beta 0.3 --csv"));
    assert_eq!(response, groups);
    // A map has amplitudes alone.
    let map = output(FRAME, &words("map --r 0.6 --beta 0.3 --csv"));
    for name in cells(&map)[0].iter() {
        assert_eq!(texts(&map, name), texts(&groups, name), "{name}");
    }
    let curve = output(
        FRAME,
        &words("curve --r 0.5:0.1:0.7 --beta 0.3 --of lower --csv"),
    );
    let place = column(&curve, "r")
        .iter()
        .position(|r| (r - 0.6).abs() < 1e-12);
    let amplitude = column(&curve, "lower.amplitude")[place.expect("r = 0.6")];
    let expected = column(&groups, "lower.amplitude")[0];
    assert!(
        (amplitude - expected).abs() < 1e-12,
        "{amplitude} {expected}"
    );
    // k₁Y = 3 N, so that β = 0.3 is 0.9 N.
    let physical = output(
        FRAME,
        &words("orbit --r 0.6 --friction 0.9 --base 2e-3 --csv"),
    );
    for (name, factor, group) in [
        ("lower.amplitude_m", 2e-3, "lower.amplitude"),
        ("brace.force_N", 3.0, "brace.force"),
        ("pads.energy_J", 6e-3, "pads.energy"),
        ("stuck_from_N", 3.0, "stuck_from"),
    ] {
        let (got, expected) = (
            column(&physical, name)[0],
            factor * column(&groups, group)[0],
        );
        assert!(
            (got - expected).abs() < 1e-9 * expected.abs(),
            "{name}: {got} {expected}"
        );
    }
    assert_eq!(texts(&groups, "regime"), ["stick-slip"]);
}

/// Text and JSON name each contact, and the contact that slides first.
#[test]
fn contacts_are_named() {
    let text = output(FRAME, &words("orbit --r 0.6 --beta 0.3"));
    for word in [
        "brace",
        "pads",
        "slides_first",
        "dashpot lower - upper of 1.5",
    ] {
        assert!(text.contains(word), "{word}: {text}");
    }
    let json = output(FRAME, &words("orbit --r 0.6 --beta 0.3 --states --json"));
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    let point = &json["points"][0];
    assert!(
        point["contacts"][0]["stops"]
            .as_u64()
            .is_some_and(|stops| stops > 0),
        "{point}"
    );
    assert_eq!(point["contacts"][1]["name"], "pads");
    assert_eq!(point["masses"][0]["name"], "lower");
    assert!(
        point["masses"][0]["amplitude"].as_f64().is_some(),
        "{point}"
    );
}

/// Events and samples over time. Their forces are within the friction of each contact.
#[test]
fn motions_over_time() {
    let line = "time --r 0.6 --beta 0.3 --steady --samples 40 --csv";
    let samples = output(FRAME, &words(line));
    let force = column(&samples, "pads.force").into_iter().map(f64::abs);
    let largest = force.fold(0.0, f64::max);
    assert!(0.0 < largest && largest <= 0.18 + 1e-12, "{largest}");
    let events = output(
        FRAME,
        &words("time --r 0.6 --beta 0.3 --cycles 2 --events --csv"),
    );
    assert!(texts(&events, "contact").contains(&"brace"), "{events}");
    let from = "time --r 0.6 --beta 0.3 --cycles 1 --samples 10 --from 0.5,0;0,0 --csv";
    assert_eq!(
        column(&output(FRAME, &words(from)), "lower.displacement")[0],
        0.5
    );
}

/// Without a spring, r and β have no k₁, and the message names the units to use.
#[test]
fn a_scene_without_springs_needs_physical_units() {
    let told = failure(BLOCK, &words("orbit --r 0.5 --beta 0.3"));
    assert!(
        told.contains("no spring") && told.contains("Hz or rad/s"),
        "{told}"
    );
    let line = "orbit --omega 7 --friction 3 --force 10 --csv";
    let orbit = output(BLOCK, &words(line));
    // Sliding all the time, the block moves as P/(mω²) against square waves of F: below P/(mω²).
    let amplitude = column(&orbit, "block.amplitude_m")[0];
    assert!(0.05 < amplitude / (10.0 / (2.0 * 49.0)) && amplitude < 10.0 / (2.0 * 49.0));
    assert!(output(BLOCK, &["check"]).contains("1 contact, 0 dashpots"));
}

/// The scene of five storeys: every damper slides under a moderate friction, none under a large one.
#[test]
fn five_storeys() {
    let line = "orbit --hz 1.2 --friction 1e4,1e7 --base 0.02 --csv";
    let orbit = output(STOREYS, &words(line));
    assert_eq!(texts(&orbit, "regime"), ["stick-slip", "stuck"]);
    assert!(output(STOREYS, &["check"]).contains("5 contacts, 0 dashpots"));
}

/// A frame with a friction absorber on it. Its best common friction is no worse than its neighbours.
#[test]
fn the_best_common_friction() {
    let scene = "struct Absorbed { masses: { main: 1.0, absorber: 0.1 },
        springs: { base - main: 100.0, main - absorber: 8.0 }, contacts: { pads: main - absorber },
        dampers: { base - main: 0.4 }, excitation: main }";
    let best = output(scene, &words("optimum --r 0.7:1.3 --of main --json"));
    let best = crate::common::json(&best);
    let (friction, amplitude) = (value(&best, "beta"), value(&best, "amplitude"));
    for factor in [0.0, 0.8, 1.0, 1.25] {
        let line = format!(
            "curve --r 0.7:0.02:1.3 --beta {} --of main --csv",
            factor * friction
        );
        let peak = column(&output(scene, &words(&line)), "main.amplitude");
        let peak = peak.into_iter().fold(0.0, f64::max);
        // The curve's grid misses a peak by less than two hundredths.
        assert!(amplitude < 1.02 * peak, "{factor}: {amplitude} {peak}");
        assert!(
            factor != 1.0 || peak < amplitude * (1.0 + 1e-9),
            "{amplitude} {peak}"
        );
    }
}

/// Returns the value of a line in the JSON result of `optimum`, by its key.
fn value(best: &serde_json::Value, key: &str) -> f64 {
    let lines = best["points"].as_array().expect("lines");
    let line = lines.iter().find(|line| line["key"] == key);
    let value = line.and_then(|line| line["value"].as_f64());
    value.expect(key)
}

/// Phases, offsets and harmonics are those of the solver for a single contact. The dashpot is too weak to change them.
#[test]
fn phases_and_harmonics_are_those_of_a_single_contact() {
    let single = "struct Frame { masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 }, contact: upper - wall, excitation: base,
        damping: modal[0.010, 0.012] }";
    let damped = single.replace(
        " excitation",
        " dampers: { base - lower: 1e-9 }, excitation",
    );
    let line = words("orbit --r 0.3:0.2:1.3 --beta 0.2,0.5 --harmonics 3 --csv");
    let (one, several) = (output(single, &line), output(&damped, &line));
    let names = [
        "phase",
        "fundamental_phase",
        "X0.amplitude",
        "X1.amplitude",
        "X1.phase",
        "X3.amplitude",
    ];
    for motion in ["contact", "lower", "upper"] {
        for name in names {
            let name = format!("{motion}.{name}");
            for (one, several) in column(&one, &name).iter().zip(column(&several, &name)) {
                assert!((one - several).abs() < 2e-6, "{name}: {one} {several}");
            }
        }
    }
    for offset in column(&several, "contact.offset") {
        assert!(offset.abs() < 1e-9, "{offset}");
    }
    let response = output(
        &damped,
        &words("response --r 0.5 --beta 0.2 --harmonics 3 --json"),
    );
    let orders: Vec<_> = json(&response)["points"][0]["masses"][0]["harmonics"]
        .as_array()
        .expect("harmonics")
        .iter()
        .map(|harmonic| harmonic["n"].as_u64())
        .collect();
    assert_eq!(orders, [Some(1), Some(3)]);
}

/// The code of a scene with several contacts is that of the macro: by default the steady state, or what it names.
#[test]
fn expands_several_contacts() {
    let code = output(FRAME, &["expand"]);
    assert!(
        code.contains("impl Frame") && code.contains("fn orbit"),
        "{code}"
    );
    let scene = FRAME.replace(
        "excitation: base",
        "excitation: base, provide: [simulation]",
    );
    let code = output(&scene, &["expand"]);
    assert!(code.contains("fn simulation") && !code.contains("fn orbit"));
}

/// Commands and options without an answer name the fields and another command, in one line.
#[test]
fn the_rest_is_refused_by_name() {
    for line in ["features --beta 0.3", "compile --accuracy 1e-4 --r 0.2:2.5"] {
        let told = failure(FRAME, &words(line));
        assert!(
            told.contains("`contacts`") && told.lines().count() == 1,
            "{line}: {told}"
        );
    }
    for line in [
        "curve --r 0.5:1 --beta 0.3 --rates",
        "map --r 0.5 --beta 0.3 --boundaries 4",
        "time --r 0.5 --beta 0.3 --spectrum",
        "map --r 0.5:1 --beta 0.3,0.4 --shade stuck",
    ] {
        let told = failure(FRAME, &words(line));
        assert!(
            told.contains("`contacts`") && told.lines().count() == 1,
            "{line}: {told}"
        );
    }
}

/// An unknown mass is named, and a quantity that a motion does not have.
#[test]
fn unknown_masses_and_quantities() {
    for (name, told) in [
        (
            "roof-lower",
            ": there is no mass `roof`; the masses are lower, upper".to_owned(),
        ),
        (
            "roof",
            ": there is no mass `roof`; the masses are lower, upper".to_owned(),
        ),
        (
            "energy(lower)",
            ": `lower` is no contact; write `energy(brace)` or `energy(pads)`".to_owned(),
        ),
    ] {
        let line = format!("orbit --r 0.5 --beta 0.3 --of {name}");
        let expected = format!("frictiongen: --of{told}");
        assert_eq!(failure(FRAME, &words(&line)), expected);
    }
    let told = failure(FRAME, &words("time --r 0.5 --beta 0.3 --of accel(lower)"));
    let expected = "frictiongen: --of `accel(lower)`: a motion in time of several contacts has masses and differences of two masses, such as f2-f1";
    assert_eq!(told, expected);
}

/// A quantity of a contact stands in its own columns, too.
#[test]
fn quantities_are_those_of_contacts() {
    let csv = output(
        FRAME,
        &words(
            "response --r 0.5:0.3:1.4 --beta 0.3 --of slip(pads) --of force(brace) --of energy(pads) --of zeta_eq --csv",
        ),
    );
    for (quantity, own) in [
        ("slip(pads).amplitude", "pads.amplitude"),
        ("force(brace).amplitude", "brace.force"),
        ("energy(pads).amplitude", "pads.energy"),
    ] {
        assert_eq!(column(&csv, quantity), column(&csv, own));
    }
    let ratios = column(&csv, "zeta_eq.amplitude");
    assert!(
        ratios.iter().all(|ratio| 0.0 < *ratio && *ratio < 1.0),
        "{ratios:?}"
    );
}

/// The best friction keeps a bound on the force of one of several contacts.
#[test]
fn the_best_friction_bounds_the_force_of_a_contact() {
    let band = "optimum --r 0.4:1.2 --of upper";
    let free = output(FRAME, &words(&format!("{band} --json")));
    let free: serde_json::Value = serde_json::from_str(&free).expect("JSON");
    let force = |friction: f64| {
        let line = format!("curve --r 0.4:0.01:1.2 --beta {friction} --of force(brace) --csv");
        let forces = column(&output(FRAME, &words(&line)), "force(brace).amplitude");
        forces.into_iter().fold(0.0, f64::max)
    };
    let bound = 0.7 * force(value(&free, "beta"));
    let keep = format!("force(brace) <= {bound}");
    let asked = format!("{band} --json --keep");
    let mut line = words(&asked);
    line.push(&keep);
    let kept: serde_json::Value = serde_json::from_str(&output(FRAME, &line)).expect("JSON");
    assert!(value(&free, "amplitude") < value(&kept, "amplitude"));
    let reached = force(value(&kept, "beta"));
    assert!(
        0.95 * bound < reached && reached <= 1.001 * bound,
        "{reached} {bound}"
    );
}

/// A relative motion is the displacement of the contact between its two masses, and the best friction lowers its peak.
#[test]
fn motions_are_those_of_contacts() {
    let csv = output(
        FRAME,
        &words("orbit --r 0.5:0.3:1.4 --beta 0.3 --of upper-lower --of shear --csv"),
    );
    assert_eq!(column(&csv, "upper-lower.amplitude").len(), 4);
    let (motion, contact) = (
        column(&csv, "upper-lower.amplitude"),
        column(&csv, "pads.amplitude"),
    );
    for (one, other) in motion.iter().zip(contact) {
        assert!((one - other).abs() < 1e-10 * other, "{one} {other}");
    }
    let best = output(FRAME, &words("optimum --r 0.4:1.2 --of shear --json"));
    let best: serde_json::Value = serde_json::from_str(&best).expect("JSON");
    let (beta, peak) = (value(&best, "beta"), value(&best, "amplitude"));
    let at = |beta: f64| {
        let csv = output(
            FRAME,
            &words(&format!(
                "curve --r 0.4:0.02:1.2 --beta {beta} --of shear --csv"
            )),
        );
        column(&csv, "shear.amplitude")
            .into_iter()
            .fold(0.0, f64::max)
    };
    assert!(at(beta) < peak * (1.0 + 1e-9), "{peak}");
    for factor in [0.8, 1.25] {
        assert!(at(factor * beta) > peak * (1.0 - 1e-3), "{factor}");
    }
}

/// Below the continuous limit all contacts slide all the time, above the limit of sliding none does.
#[test]
fn limits_separate_regimes() {
    let rigid = FRAME.replace("{ stiffness: 4.0e3 }", "");
    let csv = output(&rigid, &words("limits --r 0.5,1,1.7 --csv"));
    let first = texts(&csv, "slides_first");
    assert!(first.iter().all(|name| ["brace", "pads"].contains(name)));
    let limits = column(&csv, "continuous_limit");
    for (r, (low, high)) in [0.5, 1.0, 1.7]
        .iter()
        .zip(limits.iter().zip(column(&csv, "sliding_limit")))
    {
        let frictions = format!("{},{},{}", 0.999 * low, 1.001 * low, 1.001 * high);
        let csv = output(
            &rigid,
            &words(&format!("orbit --r {r} --beta {frictions} --csv")),
        );
        let regimes = texts(&csv, "regime");
        assert_eq!((regimes[0], regimes[2]), ("continuous", "stuck"), "r {r}");
        assert_ne!(regimes[1], "continuous", "r {r}");
    }
}

/// `sensitivity` has one line for each parameter, and its derivatives agree with differences of `orbit`.
#[test]
fn derivatives_agree_with_differences_of_orbits() {
    let point = "--hz 2.6 --friction 0.9 --base 2e-3";
    let line = format!("sensitivity {point} --of upper --csv");
    let csv = output(FRAME, &words(&line));
    let parameters = texts(&csv, "parameter");
    let expected = "m lower|m upper|k base - lower|k lower - upper|zeta 1|zeta 2|c lower - upper|share brace|\
        stiffness brace|mu brace|share pads|mu pads|F|Y|f";
    assert_eq!(parameters.join("|"), expected);
    let units = texts(&csv, "unit");
    assert_eq!(units.join("|"), "kg|kg|N/m|N/m|||N s/m||N/m||||N|m|Hz");
    let place = parameters.iter().position(|name| *name == "share pads");
    let place = place.expect("the share");
    let derivative = column(&csv, "amplitude_m.derivative")[place];
    let amplitude = |share: &str| {
        let scene = FRAME.replace("share: 0.6", &format!("share: {share}"));
        let orbit = output(&scene, &words(&format!("orbit {point} --csv")));
        column(&orbit, "upper.amplitude_m")[0]
    };
    let difference = (amplitude("0.6001") - amplitude("0.5999")) / 2e-4;
    // The error of the difference is the square of 1e-4 times a third derivative.
    assert!(
        (derivative - difference).abs() < 1e-8,
        "{derivative} {difference}"
    );
    assert!(
        texts(&csv, "answer")
            .iter()
            .all(|answer| *answer == "exact")
    );
    // The energy of a contact has derivatives in every format.
    let json = output(
        FRAME,
        &words(&format!("sensitivity {point} --of pads --json")),
    );
    let json: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert!(
        json["points"][0]["energy_J"]
            .as_f64()
            .is_some_and(|energy| energy > 0.0),
        "{json}"
    );
    let text = output(FRAME, &words(&format!("sensitivity {point} --of pads")));
    assert!(
        text.contains("energy pads") && text.contains("stiffness brace"),
        "{text}"
    );
    // Contacts that never slide stay in the middle of their intervals, and the friction has no effect.
    let stuck = output(
        FRAME,
        &words("sensitivity --hz 2.6 --friction 90 --base 2e-3 --of upper --csv"),
    );
    let place = texts(&stuck, "parameter")
        .iter()
        .position(|name| *name == "F");
    let friction = column(&stuck, "amplitude_m.derivative")[place.expect("the friction")];
    assert_eq!(friction, 0.0, "{stuck}");
    let told = failure(FRAME, &words("sensitivity --r 0.6 --beta 0.3 --of roof"));
    assert!(
        told.contains("lower, upper") && told.contains("brace, pads"),
        "{told}"
    );
}

/// Returns the visible text of a picture that a command writes.
fn picture(line: &str, name: &str) -> String {
    let path = std::env::temp_dir().join(format!("frictiongen-{}-{name}.svg", std::process::id()));
    let shown = path.to_str().expect("a path");
    let mut arguments = words(line);
    arguments.extend(["-o", shown]);
    output(FRAME, &arguments);
    let drawn = std::fs::read_to_string(&path).expect("a picture");
    std::fs::remove_file(path).expect("a file");
    assert!(!drawn.contains("NaN"), "{name}");
    let pieces = drawn.split('<').filter_map(|tag| tag.split_once('>'));
    pieces.map(|(_, text)| text).collect()
}

/// Pictures show a loop of each contact, and say how many contacts slide.
#[test]
fn pictures_of_several_contacts() {
    let motion = picture("time --r 0.6 --beta 0.3 --steady --samples 60", "motion");
    for word in [
        "brace: hysteresis loop, area = energy",
        "pads: hysteresis loop",
        "the contact sticks",
        "r = 0.6; β = 0.3; steady state, one period",
    ] {
        assert!(motion.contains(word), "{word}: {motion}");
    }
    let curve = "curve --r 0.4:0.2:1.2 --beta 0,0.3,2 --of upper";
    let curve = picture(curve, "curve");
    for word in [
        "upper",
        "contact brace",
        "stuck fraction of the period",
        "all contacts slide",
        "some contacts stick",
        "all contacts are stuck",
    ] {
        assert!(curve.contains(word), "{word}: {curve}");
    }
    let map = "map --r 0.4:0.2:1.2 --beta 0.1:0.4:1.7 --of upper";
    let regimes = picture(map, "map");
    for word in [
        "all contacts are stuck",
        "some contacts stick",
        "stuck state above",
    ] {
        assert!(regimes.contains(word), "{word}: {regimes}");
    }
    let sizes = picture(&format!("{map} --shade amplitude"), "sizes");
    assert!(sizes.contains("upper: amplitude"), "{sizes}");
    let told = failure(FRAME, &words("map --r 0.5 --beta 0.3,0.4 -o frame.svg"));
    assert!(told.contains("needs two frequencies"), "{told}");
}

/// One contact has the same answers in the fields `contact` and `contacts`. Another name of the contact changes nothing
/// but this name.
#[test]
fn one_contact_has_the_same_answers_in_both_fields() {
    let frame = "masses: { lower: 3.27, upper: 3.25 }, springs: { base - lower: 1190.0, lower - upper: 1323.0 }";
    let scenes = [
        (
            "damping: modal[0.010, 0.012], excitation: base",
            "contact: upper - wall, stiction: 1.2",
            "upper - wall { stiction: 1.2 }",
        ),
        (
            "damping: modal(0.02), excitation: upper",
            "contact: lower - wall, stiffness: 4e3",
            "lower - wall { stiffness: 4e3 }",
        ),
        (
            "damping: modal(0.05), excitation: base, friction: stribeck(0.01: 0.9)",
            "contact: upper - wall",
            "upper - wall",
        ),
    ];
    let mut compared = 0;
    for (fields, contact, sides) in scenes {
        let scene = |contact: &str| format!("struct Frame {{ {frame}, {fields}, {contact} }}");
        let listed = |name: &str| scene(&format!("contacts: {{ {name}: {sides} }}"));
        let (load, many) = match fields.contains("stribeck") {
            true => ("--hz 2.6,3 --friction 0.9 --base 2e-3", false),
            false => ("--r 0.5,0.9 --beta 0.3,0.6", true),
        };
        let mut lines = vec![
            format!("orbit {load}"),
            format!("map {load}"),
            format!("response {load}"),
            format!(
                "time {}",
                load.replace(",0.9", "")
                    .replace(",0.6", "")
                    .replace(",3", "")
            ),
        ];
        if many {
            lines.push("curve --r 0.4:1.2 --beta 0.4".to_owned());
            lines.push("optimum --r 0.4:1.2 --of lower".to_owned());
        }
        if many && !sides.contains("stiffness") {
            lines.push("limits --r 0.2:0.1:1".to_owned());
        }
        for line in &lines {
            for form in ["--csv", "--json"] {
                let line = format!("{line} {form}");
                let one = output(&scene(contact), &words(&line));
                assert_eq!(output(&listed("contact"), &words(&line)), one, "{line}");
                let named = output(&listed("pads"), &words(&line));
                assert_eq!(named.replace("pads", "contact"), one, "{line}");
                assert!(
                    line.starts_with("limits")
                        || named.contains("pads")
                        || line.contains("optimum")
                );
                compared += 1;
            }
        }
    }
    println!("{compared} outputs");
}

/// With a load, the displacement of a contact `a - b` has the same sign with the solver for several contacts, in both
/// orders. With a share of one half, this solver needs twice the friction.
#[test]
fn signs_are_those_of_a_single_contact() {
    for ends in ["upper - lower", "lower - upper"] {
        let scene = |contact: String| {
            format!(
                "struct Frame {{ masses: {{ lower: 2.0, upper: 1.5 }}, excitation: base, damping: modal(0.01), {contact},
                springs: {{ base - lower: 1500.0, lower - upper: 1200.0 }} }}"
            )
        };
        for (load, twice) in [
            ("--base 2e-3 --friction 0.6", "--base 2e-3 --friction 1.2"),
            ("--beta 0.2", "--beta 0.4"),
        ] {
            let line = |load| format!("time --hz 3 {load} --cycles 2 --samples 20 --csv");
            let one = output(&scene(format!("contact: {ends}")), &words(&line(load)));
            let several = scene(format!("contacts: {{ pads: {ends} {{ share: 0.5 }} }}"));
            let several = output(&several, &words(&line(twice)));
            let unit = if load.contains("base") { "_m" } else { "" };
            let single = column(&one, &format!("contact.displacement{unit}"));
            let pads = column(&several, &format!("pads.displacement{unit}"));
            let most = pads.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            for (a, b) in single.iter().zip(&pads) {
                assert!((a - b).abs() < 1e-9 * most, "{ends} {load}: {a} {b}");
            }
            assert!(most > 0.0, "{ends}");
        }
    }
}

/// `orbit -o` writes the table, or draws one period with a sketch of the scene.
#[test]
fn orbits_in_files() {
    let orbit = picture("orbit --r 0.6 --beta 0.3", "orbit");
    let motion = picture("time --r 0.6 --beta 0.3 --steady", "period");
    assert_eq!(orbit, motion);
    // The text of the load is only in the sketch.
    assert!(orbit.contains("Y cos ωt"), "{orbit}");
    let told = failure(
        FRAME,
        &words("orbit --r 0.6 --beta 0.3 --states -o orbit.svg"),
    );
    assert!(told.contains("one period of one steady state"), "{told}");
    let told = failure(FRAME, &words("orbit --r 0.6,0.7 --beta 0.3 -o orbit.svg"));
    assert!(told.contains("--r"), "{told}");
    let file = std::env::temp_dir().join(format!("frictiongen-orbit-{}.csv", std::process::id()));
    let path = file.to_str().expect("a path");
    let line = words("orbit --r 0.6 --beta 0.3");
    output(FRAME, &[line.as_slice(), &["-o", path]].concat());
    let written = std::fs::read_to_string(&file).expect("a file");
    std::fs::remove_file(&file).expect("a file");
    assert_eq!(
        written,
        output(FRAME, &[line.as_slice(), &["--csv"]].concat())
    );
}

/// The best share of one contact. A description with this share has the same largest amplitude.
#[test]
fn the_best_share_of_a_contact() {
    let block = |share: f64| {
        format!(
            "struct Block {{ masses: {{ block: 1.0 }}, springs: {{ base - block: 1.0 }}, contacts: {{
            brace: base - block {{ stiffness: 2.0 }}, pads: block - wall {{ share: {share:?}, stiffness: 1.0 }} }},
            damping: modal(0.02), excitation: block }}"
        )
    };
    let mut line = words("optimum --r 0.8:2.3 --of block --json --vary");
    line.push("share pads=0.2:0.3");
    let best = crate::common::json(&output(&block(0.2), &line));
    let share = value(&best, "pads");
    assert_eq!(value(&best, "brace"), 1.0);
    let (amplitude, before) = (value(&best, "amplitude"), value(&best, "amplitude_before"));
    assert!(
        (0.2..=0.3).contains(&share) && amplitude <= before,
        "{best}"
    );
    let (r, friction) = (value(&best, "r"), value(&best, "beta"));
    let line = format!("orbit --r {r} --beta {friction:?} --csv");
    let again = output(&block(share), &words(&line));
    let again = column(&again, "block.amplitude")[0];
    assert!(
        (again - amplitude).abs() < 1e-9 * amplitude,
        "{again} {amplitude}"
    );
    for (text, told) in [
        (
            "share k=1:2",
            "there is no number `share k` in the description; the numbers are m block,",
        ),
        (
            "share clutch=1:2",
            "there is no number `share clutch` in the description; the numbers are m block,",
        ),
        ("share pads", "an interval are needed, NAME=a:b"),
        ("share pads=2", "an interval a:b is needed"),
        ("share pads=0:1", "a share must be greater than zero"),
    ] {
        let mut line = words("optimum --r 0.8:1.4 --of block --vary");
        line.push(text);
        let lines = failure(&block(0.2), &line);
        assert!(
            lines.contains(told) && lines.lines().count() == 1,
            "{lines}"
        );
    }
}

/// Returns the two floors with a friction that depends on the speed.
fn with_stribeck() -> String {
    FRAME.replace(
        "excitation: base",
        "excitation: base, friction: stribeck(0.01: 0.9, 0.05: 0.8)",
    )
}

/// Here a step of Newton's method leads to a state from which events follow each other without any time between them.
/// The motion itself has no such events, so that the search goes on.
#[test]
fn a_step_of_newtons_method_may_stall() {
    let scene = with_stribeck();
    let line = "--hz 2.6291666666666664 --friction 1.5648546580148726 --base 2e-3";
    let orbit = output(&scene, &words(&format!("orbit {line} --csv")));
    assert_ne!(texts(&orbit, "state"), ["no state"], "{orbit}");
}

/// With `stribeck`, the answers need a load in units. Steady states are then those of the motion after many cycles, and
/// the friction of the rigid contact falls below its level.
#[test]
fn friction_may_depend_on_the_speed() {
    let scene = with_stribeck();
    let told = failure(&scene, &words("orbit --r 0.6 --beta 0.3"));
    assert!(
        told.contains("the amplitude of the load is needed") && told.lines().count() == 1,
        "{told}"
    );
    let orbit = output(
        &scene,
        &words("orbit --hz 2.6 --friction 0.9 --base 2e-3 --csv"),
    );
    let time = output(
        &scene,
        &words(
            "time --hz 2.6 --friction 0.9 --base 2e-3 --skip 200 --cycles 1 --samples 200 --csv",
        ),
    );
    let largest = column(&time, "lower.displacement_m")
        .iter()
        .fold(0.0_f64, |most, x| most.max(x.abs()));
    let amplitude = column(&orbit, "lower.amplitude_m")[0];
    // The samples have a distance of 1/200 of a cycle.
    assert!(
        (largest - amplitude).abs() < 3e-4 * amplitude,
        "{largest} {amplitude}"
    );
    let constant = output(
        FRAME,
        &words("orbit --hz 2.6 --friction 0.9 --base 2e-3 --csv"),
    );
    assert_ne!(amplitude, column(&constant, "lower.amplitude_m")[0]);
    let curve = output(
        &scene,
        &words("curve --hz 2:0.3:2.6 --friction 0.9 --base 2e-3 --of lower --csv"),
    );
    let last = column(&curve, "lower.amplitude_m");
    assert!((last[last.len() - 1] - amplitude).abs() < 1e-9 * amplitude);
}

/// Checks that the amplitude of an optimum is that of the orbit at its friction and frequency.
#[test]
#[ignore = "minutes: motions with stribeck take long to settle"]
fn an_optimum_with_friction_that_depends_on_the_speed() {
    let scene = with_stribeck();
    let best = output(
        &scene,
        &words("optimum --hz 2.4:2.8 --of lower --base 2e-3 --json"),
    );
    let best = crate::common::json(&best);
    let line = format!(
        "orbit --hz {} --friction {} --base 2e-3 --csv",
        value(&best, "frequency_Hz"),
        value(&best, "friction_N")
    );
    let peak = column(&output(&scene, &words(&line)), "lower.amplitude_m")[0];
    let amplitude = value(&best, "amplitude_m");
    assert!(
        (peak - amplitude).abs() < 1e-6 * amplitude,
        "{peak} {amplitude}"
    );
}

/// The printed modes of a block are those of its closed form, free and stuck: √(k/m)/2π and c/(2√(km)).
#[test]
fn check_prints_damped_modes_once() {
    let scene = "struct Block { masses: { block: 2 }, springs: { base - block: 50 },
        contacts: { pads: block - wall { stiffness: 150 } }, dampers: { base - block: 4 }, excitation: block }";
    let printed = output(scene, &words("check"));
    let table: Vec<&str> = printed.lines().skip(1).take(3).collect();
    assert_eq!(
        table,
        [
            "damped modes                     f (Hz)          zeta",
            "free                           0.795775      0.200000",
            "pads stuck                     1.591549      0.100000",
        ]
    );
    assert!(!printed.contains("natural frequencies") && !printed.contains("modal damping"));
    let read = crate::common::json(&output(scene, &words("check --json")));
    let sets = read["damped_modes"].as_array().expect("sets");
    assert_eq!(
        (sets.len(), &sets[0]["stuck"], &sets[1]["stuck"][0]),
        (2, &serde_json::json!([]), &"pads".into())
    );
    let mode = &sets[1]["modes"][0];
    for (name, wanted) in [
        ("frequency_Hz", 5.0 / std::f64::consts::PI),
        ("damping_ratio", 0.1),
        ("decay_rate_per_s", 1.0),
    ] {
        let found = mode[name].as_f64().expect(name);
        assert!((found - wanted).abs() < 1e-12, "{name}: {found}");
    }
    // A block with modal damping has its modal numbers, which the contact does not change.
    let modal =
        "struct Block { masses: { block: 2 }, springs: { base - block: 50 }, contact: block - wall,
        damping: modal(0.02), excitation: block }";
    assert!(output(modal, &words("check")).contains("modal damping ratios       "));
    let read = crate::common::json(&output(modal, &words("check --json")));
    assert!(read.get("damped_modes").is_none());
}

/// An overdamped mode is two decays, and a mass without a spring has the frequency 0.
#[test]
fn check_prints_decays_and_rigid_bodies() {
    let scene = "struct Block { masses: { block: 2, tail: 1 }, springs: { base - block: 50 },
        contacts: { pads: block - tail }, dampers: { base - block: 52 }, excitation: block }";
    let printed = output(scene, &words("check"));
    let rows: Vec<Vec<&str>> = printed
        .lines()
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(rows[2], ["free", "0", "0"]);
    assert_eq!(rows[3], ["decay", "1.000000", "1/s"]);
    assert_eq!(rows[4], ["decay", "25.000000", "1/s"]);
    let read = crate::common::json(&output(scene, &words("check --json")));
    let mode = &read["damped_modes"][0]["modes"][1];
    assert!(mode["damping_ratio"].is_null() && mode["frequency_Hz"] == 0.0);
    assert!((mode["decay_rate_per_s"].as_f64().expect("a rate") - 1.0).abs() < 1e-12);
}

/// `features` lists the resonances of all sets, the friction from which no contact slides, and antiresonances. The three
/// formats agree, and the frictions are those of `orbit`.
#[test]
fn features_of_several_contacts() {
    let undamped = FRAME.replace(
        "dampers: { lower - upper: 1.5 }, damping: modal(0.01), ",
        "",
    );
    let line = "features --hz 1:20 --base 2e-3 --of lower";
    let csv = output(&undamped, &words(&format!("{line} --csv")));
    let (of, detail) = (texts(&csv, "of"), texts(&csv, "detail"));
    let features = texts(&csv, "feature");
    let count = |name: &str| features.iter().filter(|feature| **feature == name).count();
    assert_eq!(count("resonance"), 2 + 2 + 1 + 1, "{csv}");
    assert_eq!(count("antiresonance"), 1);
    assert_eq!(count("limit of sliding"), 1);
    let sets: Vec<&str> = of.iter().take(6).copied().collect();
    let expected = [
        "free",
        "free",
        "brace stuck",
        "brace stuck",
        "pads stuck",
        "brace + pads stuck",
    ];
    assert_eq!(sets, expected);
    assert_eq!(detail[5], "mode 1: undamped; slides whatever the friction");
    let [hertz, friction] = ["frequency_Hz", "friction_N"].map(|name| column_with_gaps(&csv, name));
    // All contacts stuck: 5500 N/m and 3.5 kg. The lower mass rests where the upper one is an absorber.
    let of_ratio = |ratio: f64| ratio.sqrt() / std::f64::consts::TAU;
    assert!((hertz[5] - of_ratio(5500.0 / 3.5)).abs() < 1e-9 && friction[5].is_infinite());
    let place = features
        .iter()
        .position(|feature| *feature == "antiresonance");
    let place = place.expect("an antiresonance");
    assert!((hertz[place] - of_ratio(1200.0 / 1.5)).abs() < 1e-9);
    let orbit = format!("orbit --hz {:?} --friction 1 --base 2e-3 --csv", hertz[0]);
    let stuck = column(&output(&undamped, &words(&orbit)), "stuck_from_N")[0];
    assert!(
        (stuck / friction[0] - 1.0).abs() < 1e-9,
        "{stuck} {}",
        friction[0]
    );
    let read = crate::common::json(&output(&undamped, &words(&format!("{line} --json"))));
    let points = read["points"].as_array().expect("points");
    assert_eq!(points.len(), features.len());
    for (point, hertz) in points.iter().zip(&hertz) {
        assert_eq!(point["frequency_Hz"].as_f64(), Some(*hertz));
    }
    let printed = output(&undamped, &words(line));
    assert!(
        printed.contains("not listed ") && !printed.contains("with damping"),
        "{printed}"
    );
    let damped = output(FRAME, &words("features"));
    assert!(
        damped.contains("there are no antiresonances") && damped.contains(": zeta 0.0"),
        "{damped}"
    );
    let rigid = FRAME.replace(" { stiffness: 4.0e3 }", "");
    let limits = output(&rigid, &words("features --csv"));
    assert!(
        texts(&limits, "feature").contains(&"limit of continuous motion"),
        "{limits}"
    );
}

/// A belt has modes, and the output says why it has no friction from which no contact slides. A scene without springs
/// needs units.
#[test]
fn features_of_a_belt_and_without_springs() {
    let belt = "struct Belt { masses: { block: 1 }, springs: { block - wall: 1 },
        contacts: { pads: block - wall { speed: 0.3 } }, dampers: { block - wall: 0.1 }, excitation: block }";
    let without_load = output(belt, &words("features"));
    assert!(without_load.contains("the amplitude of the load is needed"));
    let printed = output(belt, &words("features --force 1"));
    let reason = "without frictions            with stops, moving surfaces or constant forces";
    assert!(
        printed.contains(reason) && printed.contains("mode 1: zeta 0.050000"),
        "{printed}"
    );
    assert!(failure(BLOCK, &words("features")).contains("the scene has no spring"));
    let csv = output(BLOCK, &words("features --force 2 --hz 0.1:2 --csv"));
    assert_eq!(texts(&csv, "detail")[0], "mode 1: rigid body");
}

/// Requests without an answer name the option and the reason, in one line.
#[test]
fn features_that_several_contacts_do_not_have() {
    for (line, words_of) in [
        ("features --beta 0.3", "--beta has no answer"),
        (
            "features --friction 0.3 --base 1",
            "--friction has no answer",
        ),
        (
            "features --of pads",
            "`pads` is no mass, and this answer has masses only",
        ),
        (
            "features --of upper-lower",
            "`upper-lower` is no mass, and this answer has masses only",
        ),
        ("features --of roof", "there is no mass `roof`"),
        ("features --of vel(upper)", "`vel(upper)` is no mass"),
        ("features --r 2:1", "write 1:2"),
        ("features --r 0:1", "--r"),
        ("features --force 1", "--force"),
    ] {
        let undamped = FRAME.replace(
            "dampers: { lower - upper: 1.5 }, damping: modal(0.01), ",
            "",
        );
        let told = failure(&undamped, &words(line));
        assert!(
            told.contains(words_of) && told.lines().count() == 1,
            "{line}: {told}"
        );
    }
}

//! Tests the comparison of steppers by `frictiongen diff`.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::output;
use crate::diff::{Written, json};
use serde_json::Value;

const ONE: &str =
    "struct One { masses: { a: 1, b: 2 }, springs: { base - a: 100, a - b: 50 }, contact: b - wall,
    excitation: a, damping: modal(0.02), stiction: 1.3, provide: [stepper], step: 0.01 }";
const SEVERAL: &str =
    "struct Several { masses: { a: 1, b: 2 }, springs: { base - a: 100, a - b: 50 },
    contacts: { low: a - base, high: a - b { stiffness: 30 } }, excitation: b, damping: modal(0.02),
    provide: [stepper] }";

/// Returns the compared answer with this name.
fn answer<'j>(found: &'j Value, name: &str) -> &'j Value {
    let all = found["stepper"]["answers"]["differences"]
        .as_array()
        .unwrap();
    let mut all = all.iter();
    all.find(|answer| answer["name"] == name).unwrap()
}

/// Checks scenes with twice the masses and twice the stiffnesses under the same force and the same friction. Every
/// displacement is then exactly half of the old displacement. Friction forces and events do not change.
#[test]
fn half_of_each_displacement() {
    for (name, text, contacts) in [
        ("steps-one", ONE, &["contact"][..]),
        ("steps-several", SEVERAL, &["low", "high"]),
    ] {
        let new = text
            .replace("a: 1, b: 2", "a: 2, b: 4")
            .replace("100, a - b: 50", "200, a - b: 100")
            .replace("stiffness: 30", "stiffness: 60");
        let found = json(name, text, &new);
        let compared = &found["stepper"]["answers"];
        assert!(
            compared["events"]["old"].as_u64().unwrap() > 20,
            "{compared:#}"
        );
        assert_eq!(compared["events"]["old"], compared["events"]["new"]);
        let displacements = contacts
            .iter()
            .map(|contact| format!("displacement in {contact}"));
        let masses = ["a", "b"].map(|mass| format!("displacement of {mass}"));
        for name in displacements.chain(masses) {
            let answer = answer(&found, &name);
            let (old, new) = (
                answer["old"].as_f64().unwrap(),
                answer["new"].as_f64().unwrap(),
            );
            // All factors are powers of two, so that only the positions of events could differ by roundings.
            assert!((new - old / 2.0).abs() <= 1e-12 * old.abs(), "{answer}");
            let relative = answer["relative"].as_f64().unwrap();
            assert!((relative - 0.5).abs() < 1e-12, "{answer}");
        }
        for contact in contacts {
            let answer = answer(&found, &format!("friction force in {contact}"));
            assert!(answer["relative"].as_f64().unwrap() < 1e-12, "{answer}");
        }
        assert!(
            found["stepper"]["not_compared"]
                .as_array()
                .unwrap()
                .is_empty()
        );
    }
}

/// Checks that the run shows a changed stiction of each contact. If the seal stuck, no load would reach the pads.
#[test]
fn a_changed_stiction_shows() {
    let scene = "struct Drive { masses: { motor: 0.8, load: 2.5 },
        springs: { base - motor: 400, motor - load: 9000 }, excitation: motor, contacts: {
        seal: motor - base { share: 0.5 }, pads: load - wall { stiction: 1.3 } } }";
    let found = json("shielded", scene, &scene.replace("1.3", "1.9"));
    let pads = answer(&found, "friction force in pads");
    assert!(pads["relative"].as_f64().unwrap() > 1e-2, "{pads}");
    assert_eq!(found["without_effect"], serde_json::json!([]));
    // A contact that the load does not reach.
    let idle = scene.replace(", motor - load: 9000", ", base - load: 9000");
    let found = json("idle", &idle, &idle.replace("1.3", "1.9"));
    assert_eq!(
        found["without_effect"],
        serde_json::json!(["stiction of pads"])
    );
}

/// Compares the bounds and the number of table entries with the text of the emitted code.
#[test]
fn bounds_and_tables_are_those_of_the_emitted_code() {
    let found = json("steps-bound", ONE, &ONE.replace("100", "101"));
    let emitted = output(ONE, &["expand", "-"]);
    let stated = |before: &str| -> u64 {
        let rest = emitted.split_once(before).unwrap().1;
        let rest = rest.trim_start_matches([' ', '/', '\n']);
        let digits = rest.split(|letter: char| !letter.is_ascii_digit());
        digits.into_iter().next().unwrap().parse().unwrap()
    };
    let operations = &found["stepper"]["operations"]["old"];
    assert_eq!(
        operations["without_events"],
        stated("A step of `STEP` has at most ")
    );
    assert_eq!(
        operations["with_one_event"],
        stated("such products, about ")
    );
    assert_eq!(operations["worst_case"], stated("more than "));
    // Each number of the tables follows a `:`, a `,` or a `[` and ends before a `,` or a `]`.
    let tables = emitted.split_once("= FixedTables {").unwrap().1;
    let tables = tables.split_once("};").unwrap().0;
    let lines = tables.lines().filter(|line| !line.trim().starts_with("//"));
    let code: String = lines.collect();
    let words = code.split([',', '[', ']', ' ', '{', '}']);
    let numbers = words.filter(|word| {
        word.trim_start_matches('-')
            .starts_with(|c: char| c.is_ascii_digit())
    });
    let tables = &found["stepper"]["tables"];
    assert_eq!(tables["numbers"], numbers.count());
    let differing = tables["differing"].as_u64().unwrap();
    assert!(
        differing > 0 && differing < tables["numbers"].as_u64().unwrap(),
        "{tables}"
    );
    assert!(
        tables["largest"]["relative"].as_f64().unwrap() < 0.05,
        "{tables}"
    );
}

#[test]
fn steppers_in_words() {
    let new = Written::new(
        "steps-words",
        &ONE.replace("stiction: 1.3", "stiction: 1.4"),
    );
    let text = output(ONE, &["diff", "-", new.path()]);
    for part in [
        "\nstepper\n  declared step  0.01 s, unchanged\n  operations of a step\n",
        ", unchanged\n  step tables    0 of ",
        "    displacement of a: differs by ",
        "    events: ",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let renamed = Written::new("steps-renamed", &ONE.replace("struct One", "struct Other"));
    let text = output(ONE, &["diff", "-", renamed.path()]);
    assert_eq!(
        text.matches(": unchanged, to rounding\n").count(),
        4,
        "{text}"
    );
}

/// Checks that the command names what it cannot compare, and compares the rest.
#[test]
fn steppers_that_cannot_be_compared() {
    for (name, old, new, reason) in [
        (
            "steps-only",
            ONE.to_owned(),
            ONE.replace("[stepper], step: 0.01", "[limits]"),
            "only the old description provides one; write `stepper` in `provide` of the new description too",
        ),
        (
            "steps-dt",
            ONE.to_owned(),
            ONE.replace("step: 0.01", "step: 0.02"),
            "the old stepper takes steps of 0.01 s, and the new stepper steps of 0.02 s; declare the same `step`",
        ),
        (
            "steps-constant",
            ONE.replace(", step: 0.01", ""),
            ONE.to_owned(),
            "only the new description declares a `step`",
        ),
        (
            "steps-contacts",
            SEVERAL.to_owned(),
            SEVERAL.replace("low:", "brace:"),
            "the old scene has the contacts low, high, and the new scene has brace, high",
        ),
        (
            "steps-load",
            ONE.to_owned(),
            ONE.replace("excitation: a", "excitation: base"),
            "answers of a step: a force drives one scene, and the base the other",
        ),
    ] {
        let found = json(name, &old, &new);
        let reasons = found["stepper"]["not_compared"].to_string();
        assert!(reasons.contains(reason), "{reason}: {reasons}");
        assert!(found["code"].is_object() && !found["natural_frequencies_Hz"][0].is_null());
    }
    // With another number of masses, the tables differ in size, but the shared masses can be compared.
    let longer = ONE
        .replace("b: 2", "b: 2, c: 1")
        .replace("a - b: 50", "a - b: 50, b - c: 50");
    let found = json("steps-longer", ONE, &longer);
    let reasons = found["stepper"]["not_compared"].to_string();
    assert!(
        reasons.contains("the modes or the inputs differ"),
        "{reasons}"
    );
    assert!(
        answer(&found, "displacement of b")["relative"]
            .as_f64()
            .unwrap()
            > 0.0
    );
    let worst = |which: &str| found["stepper"]["operations"][which]["worst_case"].as_u64();
    assert!(worst("old") < worst("new"));
    let limits = ONE.replace("[stepper], step: 0.01", "[limits]");
    assert!(json("steps-none", &limits, &limits.replace("100", "101"))["stepper"].is_null());
}

/// Checks that each number of several contacts and dashpots is a parameter.
#[test]
fn parameters_of_several_contacts() {
    let new = SEVERAL.replace("stiffness: 30", "stiffness: 33, stiction: 1.5, share: 0.5");
    let new = new.replace("excitation", "dampers: { a - wall: 0.3 }, excitation");
    let found = json("steps-parameters", SEVERAL, &new);
    let parameters = found["parameters"].as_array().unwrap();
    let names = parameters
        .iter()
        .map(|change| change["name"].as_str().unwrap());
    assert_eq!(
        names.collect::<Vec<_>>(),
        [
            "stiffness of high",
            "stiction of high",
            "share of high",
            "damper a - wall"
        ]
    );
    assert_eq!(parameters[3]["new"], 0.3);
}

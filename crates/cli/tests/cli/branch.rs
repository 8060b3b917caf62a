//! Tests `branch`, and `orbit --states` where a state is unstable.

#![allow(
    clippy::expect_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{column, failure, output, texts, words};

/// One mass with three steady states at r = 0.55 and β = 0.1.
const BLOCK: &str = "struct Block { masses: { m: 1 }, springs: { base - m: 1 },
    contact: m - base, excitation: base, stiction: 1.5 }";
/// The scene of [`BLOCK`], in which the contact is called `pads`.
const PADS: &str = "struct Block { masses: { m: 1 }, springs: { base - m: 1 },
    contacts: { pads: m - base { stiction: 1.5 } }, excitation: base }";
/// Two masses, a belt and a stop, which give the scene a length.
const BELT: &str = "struct Belt { masses: { block: 1, mass: 2 },
    springs: { wall - block: 40, block - mass: 30 },
    contacts: { pads: block - wall { speed: 0.4 } },
    stops: { bumper: mass - wall { gap: 0.05, stiffness: 1e3, damping: 2 } },
    excitation: mass, damping: modal(0.05) }";

#[test]
fn states_are_stable_unstable_and_mirror_images() {
    for (scene, name) in [(BLOCK, "contact"), (PADS, "pads")] {
        let table = output(scene, &words("orbit --r 0.55 --beta 0.1 --states --csv"));
        let amplitudes = column(&table, &format!("{name}.amplitude"));
        let stable: Vec<bool> = texts(&table, "state")
            .iter()
            .map(|word| *word == "stable")
            .collect();
        let mut states: Vec<(f64, bool)> = amplitudes.into_iter().zip(stable).collect();
        states.sort_by(|one, other| one.0.total_cmp(&other.0));
        // 12 and 9 digits of an independent program.
        let expected = [
            (0.436_472_360_457, false),
            (0.472_891_905, true),
            (0.472_891_905, true),
        ];
        assert_eq!(states.len(), expected.len(), "{table}");
        for (state, expected) in states.iter().zip(expected) {
            assert!(
                (state.0 - expected.0).abs() < 1e-9 && state.1 == expected.1,
                "{table}"
            );
        }
    }
}

#[test]
fn a_branch_has_its_events() {
    let table = output(BLOCK, &words("branch --along r 0.8:0.5 --beta 0.1 --csv"));
    let events = texts(&table, "event");
    assert!(events.contains(&"symmetry breaking"), "{events:?}");
    assert_eq!(column(&table, "value").last(), Some(&0.5));
    let json = output(
        PADS,
        &words("branch --along r 0.8:0.5 --beta 0.1 --json --switch 1"),
    );
    let value: serde_json::Value = serde_json::from_str(&json).expect("JSON");
    assert_eq!(value["along"], "r");
    let branches = value["branches"].as_array().expect("branches");
    assert_eq!(
        (branches.len(), &branches[1]["parent"]),
        (2, &serde_json::json!(0))
    );
    let points = value["points"].as_array().expect("points");
    let last = points.last().expect("a point");
    assert_eq!(
        (&last["branch"], &last["contacts"][0]["name"]),
        (&serde_json::json!(1), &serde_json::json!("pads"))
    );
}

#[test]
fn a_branch_in_units_agrees_with_single_states() {
    let point = "--hz 0.8 --force 2 --of mass --csv";
    for (along, parameter) in [("speed 0.4:0.6", "speed"), ("friction 0.5:1", "friction")] {
        let friction = if parameter == "friction" {
            ""
        } else {
            "--friction 0.7"
        };
        let table = output(
            BELT,
            &words(&format!("branch --along {along} {friction} {point}")),
        );
        let value = column(&table, "value");
        let amplitudes = column(&table, "mass.amplitude_m");
        let last = value.len() - 1;
        let (scene, friction) = match parameter {
            "friction" => (BELT.to_owned(), value[last]),
            _ => (
                BELT.replace("speed: 0.4", &format!("speed: {}", value[last])),
                0.7,
            ),
        };
        let single = output(
            &scene,
            &words(&format!("orbit --friction {friction} {point}")),
        );
        let amplitude = column(&single, "mass.amplitude_m")[0];
        assert!((amplitudes[last] / amplitude - 1.0).abs() < 1e-9, "{along}");
    }
}

#[test]
fn wrong_requests() {
    for (line, expected) in [
        (
            "--along r --beta 0.1",
            "--along r --beta: an interval a:b is needed",
        ),
        (
            "--along r 1 --beta 0.1",
            "--along r 1: an interval a:b is needed",
        ),
        (
            "--along r 1:b --beta 0.1",
            "--along r 1:b: a and b must be numbers",
        ),
        (
            "--along r 1:1 --beta 0.1",
            "--along r 1:1: a and b must differ",
        ),
        ("--along r 1:2", "give one of --beta and --friction"),
        (
            "--along mu 1.5:2 --beta 0.1",
            "give one of --r, --hz and --omega",
        ),
        (
            "--along r 1:2 --r 1 --beta 0.1",
            "--along r: the frequency varies; leave --r, --hz and --omega out",
        ),
        (
            "--along beta 1:2 --r 1 --beta 0.1",
            "--along beta: the friction varies; leave --beta and --friction out",
        ),
        (
            "--along friction 1:2 --r 1",
            "--friction needs the amplitude of the load: give --base",
        ),
        (
            "--along m.roof 1:2 --r 1 --beta 0.1",
            "--along m.roof: there is no parameter `m.roof`; the parameters are m m, k base - m, mu contact, beta, r",
        ),
    ] {
        let message = failure(BLOCK, &words(&format!("branch {line}"))).join("\n");
        assert!(message.contains(expected), "{line}: {message}");
    }
}

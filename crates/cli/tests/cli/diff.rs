//! Tests `frictiongen diff`.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use crate::common::{BLOCK, FRAME, output, run_with};
use serde_json::Value;
use std::path::PathBuf;
use std::{fs, process};

/// A description in a file that is deleted at the end.
pub struct Written(PathBuf);

impl Written {
    pub fn new(name: &str, text: &str) -> Self {
        let name = format!("frictiongen-diff-{}-{name}", process::id());
        let path = std::env::temp_dir().join(name);
        fs::write(&path, text).unwrap();
        Self(path)
    }

    pub fn path(&self) -> &str {
        self.0.to_str().unwrap()
    }
}

impl Drop for Written {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

fn frame() -> String {
    fs::read_to_string(FRAME).unwrap()
}

/// Compares two texts as JSON.
pub fn json(name: &str, old: &str, new: &str) -> Value {
    let new = Written::new(name, new);
    let text = output(old, &["diff", "-", new.path(), "--json"]);
    serde_json::from_str(&text).unwrap()
}

#[test]
fn a_changed_spring() {
    let found = json("spring", &frame(), &frame().replace("1190.0", "1201.9"));
    let parameters = found["parameters"].as_array().unwrap();
    assert_eq!(parameters.len(), 1);
    assert_eq!(parameters[0]["name"], "spring base - lower");
    assert_eq!(parameters[0]["old"], 1190.0);
    assert_eq!(parameters[0]["new"], 1201.9);
    assert!((parameters[0]["relative"].as_f64().unwrap() - 0.01).abs() < 1e-12);
    assert_eq!(found["natural_frequencies_Hz"].as_array().unwrap().len(), 2);
    assert!(found["code"]["lines"]["removed"].as_u64().unwrap() > 0);
    assert!(found["not_compared"].as_array().unwrap().is_empty());
}

/// Checks a scene with twice the masses and twice the stiffnesses. Frequencies and shapes do not change. The force of
/// the base is twice as large, so twice the friction limits the motion. The printed difference is relative to the
/// larger value.
#[test]
fn twice_the_masses_and_springs() {
    let old = "struct S { masses: { a: 1, b: 2 }, springs: { base - a: 100, a - b: 50 }, contact: b - wall,
               excitation: base, damping: modal(0.02) }";
    let new = old
        .replace("a: 1, b: 2", "a: 2, b: 4")
        .replace("base - a: 100, a - b: 50", "base - a: 200, a - b: 100");
    let found = json("twice", old, &new);
    for pair in found["natural_frequencies_Hz"].as_array().unwrap() {
        let (old, new) = (pair["old"].as_f64().unwrap(), pair["new"].as_f64().unwrap());
        assert!((old / new - 1.0).abs() < 1e-14);
    }
    let answers = found["answers"].as_array().unwrap();
    assert_eq!(answers.len(), 5);
    for answer in &answers[..2] {
        assert_eq!(answer["unit"], "N/m");
        assert!(
            (answer["relative"].as_f64().unwrap() - 0.5).abs() < 1e-12,
            "{answer}"
        );
        assert!(
            (answer["median"].as_f64().unwrap() - 0.5).abs() < 1e-12,
            "{answer}"
        );
        assert_eq!(answer["compared"], 400);
    }
    // The new scene needs twice the friction for an equal motion. An equal friction therefore damps its contact less.
    assert_eq!(answers[2]["name"], "amplitude of contact over Y");
    assert!(answers[2]["new"].as_f64() > answers[2]["old"].as_f64());
}

#[test]
fn the_same_scene_in_other_words() {
    let other = frame().replace("1190.0", "1000.0 + 190.0");
    let other = Written::new("words", &other);
    let text = output("", &["diff", FRAME, other.path()]);
    assert!(
        text.ends_with("\nThe descriptions describe the same scene.\n"),
        "{text}"
    );
}

/// Answers and frequencies that do not change are called so. The numbers of a change have their unit.
#[test]
fn in_words() {
    let other = Written::new(
        "scalar",
        &frame().replace("stiction: 1.2,", "stiction: 1.2, scalar: f32,"),
    );
    let text = output("", &["diff", FRAME, other.path()]);
    for part in [
        "  scalar  f64 -> f32\n",
        "  mode 1  1.906824, unchanged\n",
        "  limit of continuous motion F_lim/Y\n    unchanged, to rounding\n",
    ] {
        assert!(text.contains(part), "{text}");
    }
    assert!(!text.contains("0e0"), "{text}");
    let stiffer = Written::new("stiffer", &frame().replace("1190.0", "1201.9"));
    let text = output("", &["diff", FRAME, stiffer.path()]);
    assert!(
        text.contains("  spring base - lower  1190.0 -> 1201.9 (+1.00 %)\n"),
        "{text}"
    );
    assert!(text.contains(" N/m; median "), "{text}");
    for part in [
        " removed, ",
        " added\n",
        "\nanswers at 400 frequencies, logarithmically spaced from ",
        "\n  Default range: 0.2 times the lowest to 1.5 times the highest natural frequency ",
        "\n  The answers of both scenes come from the exact formulas in f64, not from tables.\n",
        "\n  Lines and bytes include documentation comments, but not the header comment of `expand`.\n",
        " writes its numbers to NAME_tables.h.\n",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

/// A mass under another name is no other mass. Fields of one scene alone are called so.
#[test]
fn renamed_and_added() {
    let renamed = frame().replace("lower", "low");
    let renamed = Written::new("renamed", &renamed);
    let text = output("", &["diff", FRAME, renamed.path()]);
    let parameters = "\nparameters\n  name of mass 1  lower -> low\n\n";
    assert!(text.contains(parameters), "{text}");
    assert!(
        text.contains("amplitude of low over Y\n    unchanged, to rounding\n"),
        "{text}"
    );
    let swapped = frame()
        .replace("lower", "@")
        .replace("upper", "lower")
        .replace('@', "upper");
    let swapped = Written::new("swapped", &swapped);
    let text = output("", &["diff", FRAME, swapped.path()]);
    assert!(!text.contains("name of mass"), "{text}");
    let tabled = frame().replace(
        "stiction: 1.2,",
        "scalar: f32, accuracy: 1e-3, range: { r: 0.2..2.5 },",
    );
    let tabled = Written::new("tabled", &tabled);
    let text = output("", &["diff", FRAME, tabled.path()]);
    for part in [
        "  stiction    1.2 -> 1.0 (-16.67 %)\n",
        "  accuracy    added, 1e-3\n",
        "  range of r  added, 0.2..2.5\n",
        "  The answers of both scenes come from the exact formulas in f64, not from tables.\n",
        "  The new emitted code computes in f32 and uses tables of relative accuracy 1e-3.\n",
        "  operations of `tabled_sliding_limit`\n    function added, has 1",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let text = output("", &["diff", tabled.path(), FRAME]);
    assert!(text.contains("  accuracy    removed, was 1e-3\n"), "{text}");
}

/// Checks that the comparison stays where the emitted code answers, and names the results that the code leaves out. The
/// natural frequencies are 1.907 and 5.5 Hz, so that the declared range cuts the band at both ends.
#[test]
fn within_the_declared_range() {
    let declared = frame().replace(
        "stiction: 1.2,",
        "accuracy: 1e-3, range: { r: 0.5..1.5 }, provide: [limits, motion(upper)],",
    );
    let changed = Written::new("range", &declared.replace("1190.0", "1201.9"));
    let old = Written::new("range-old", &declared);
    let text = output("", &["diff", old.path(), changed.path()]);
    // r = ω√(m₁/k₁): from 0.5 of the stiffer scene to 1.5 of the softer one.
    let hertz = |r: f64, k: f64| r * (k / 3.27_f64).sqrt() / std::f64::consts::TAU;
    let band = format!(
        "answers at 400 frequencies, logarithmically spaced from {:.6} to {:.6} Hz\n",
        hertz(0.5, 1201.9),
        hertz(1.5, 1190.0)
    );
    assert!(text.contains(&band), "{band}: {text}");
    let stiffer = (1201.9_f64 / 1190.0).sqrt();
    let ratios = format!(
        "\n  Frequency ratio r: {:.6} to 1.500000 (old scene), 0.500000 to {:.6} (new scene).\n",
        0.5 * stiffer,
        1.5 / stiffer
    );
    assert!(text.contains(&ratios), "{ratios}: {text}");
    assert!(
        text.contains("\n  The declared `range` narrows it. "),
        "{text}"
    );
    assert!(
        text.contains("  amplitude of lower over Y (the emitted code does not provide it)\n"),
        "{text}"
    );
    assert!(text.contains("  amplitude of upper over Y\n"), "{text}");
    let apart = declared.replace("0.5..1.5", "2.0..2.5");
    let found = json("apart", &declared, &apart);
    assert!(
        found["not_compared"]
            .to_string()
            .contains(" Hz is in each `range`")
    );
    assert!(found["answers"].as_array().unwrap().is_empty());
}

/// Checks that the noise at an exact zero is no value. The limit of one undamped mass is 0 at r = 1/5, at which the band
/// begins.
#[test]
fn a_zero_is_zero() {
    let block = "struct Block { masses: { block: 2.0 }, springs: { base - block: 800.0 }, contact: block - wall,
                 excitation: base }";
    let found = json("zero", block, &block.replace("800", "808"));
    let limit = &found["answers"][0];
    assert_eq!(limit["name"], "limit of continuous motion F_lim/Y");
    assert_eq!(limit["old"], 0.0, "{limit}");
}

#[test]
fn scenes_of_different_kinds() {
    let found = json("kinds", &frame(), BLOCK);
    let reasons = found["not_compared"].to_string();
    assert!(
        reasons.contains("a force drives one scene, and the base the other"),
        "{reasons}"
    );
    assert!(found["natural_frequencies_Hz"][1]["new"].is_null());
    assert!(found["code"]["lines"]["old"].as_u64() > found["code"]["lines"]["new"].as_u64());
    let falling = BLOCK.replace(
        "excitation: block,",
        "excitation: block, friction: stribeck(0.1: 0.8),",
    );
    let found = json("law", BLOCK, &falling);
    assert!(
        found["not_compared"]
            .to_string()
            .contains("constant kinetic level")
    );
    // The steppers of the two scenes show what the law changes.
    let answers = found["stepper"]["answers"]["differences"].as_array();
    assert!(answers.unwrap()[0]["relative"].as_f64() > Some(1e-3));
    let grown = frame().replace("upper: 3.25 }", "upper: 3.25, top: 1.0 }");
    let grown = grown.replace(
        "lower - upper: 1323.0 }",
        "lower - upper: 1323.0, upper - top: 500.0 }",
    );
    let grown = grown.replace("modal[0.010, 0.012]", "modal(0.01)");
    let found = json("grown", &frame(), &grown);
    assert!(
        found["not_compared"]
            .to_string()
            .contains("amplitude of top: only one scene has this mass")
    );
    assert_eq!(found["answers"].as_array().unwrap().len(), 5);
}

/// Checks that scenes with more masses than a macro accepts have answers, but no code.
#[test]
fn scenes_without_code() {
    let masses: Vec<String> = (0..65).map(|index| format!("m{index}: 1")).collect();
    let springs: Vec<String> = (0..65).map(|index| format!("base - m{index}: 1")).collect();
    let comb = format!(
        "struct Comb {{ masses: {{ {} }}, springs: {{ {} }}, contact: m0 - wall, excitation: m0 }}",
        masses.join(", "),
        springs.join(", ")
    );
    let found = json("comb", &comb, &comb.replace("m3: 1,", "m3: 1.1,"));
    assert!(found["code"].is_null());
    assert!(
        found["not_compared"]
            .to_string()
            .contains("the macro refuses the old description")
    );
    assert_eq!(found["parameters"].as_array().unwrap().len(), 2);
}

/// Checks that a faulty description is compared as a text, and that all its errors are printed.
#[test]
fn a_description_with_errors() {
    let faulty = frame()
        .replace("springs", "sprungs")
        .replace("stiction", "friktion");
    let faulty = Written::new("faulty", &faulty);
    let run = run_with("", &["diff", FRAME, faulty.path()]);
    assert_eq!(run.status, Some(2));
    assert!(
        run.out.contains("-    springs:") && run.out.contains("+    sprungs:"),
        "{}",
        run.out
    );
    let errors: Vec<&str> = run.err.lines().collect();
    assert!(
        errors.iter().all(|error| error.starts_with(faulty.path())),
        "{errors:?}"
    );
    assert!(run.err.contains("did you mean `springs`?"), "{errors:?}");
    for (arguments, message) in [
        (["diff", "-", "-"], "only one of both descriptions"),
        (
            ["diff", FRAME, "nowhere.friction"],
            "cannot read nowhere.friction",
        ),
    ] {
        let run = run_with(BLOCK, &arguments);
        assert_eq!((run.status, run.out.as_str()), (Some(2), ""));
        assert!(run.err.contains(message), "{}", run.err);
    }
}

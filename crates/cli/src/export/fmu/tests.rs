//! Tests of the files that an FMU contains.
#![allow(clippy::unwrap_used, reason = "a test may fail")]

use super::archive::{Archive, checksum};
use super::variables::Variables;
use super::{binary, description, sources};
use frictiongen::System;
use frictiongen::study::scene::Scene;

/// Compares a zip archive with the layout of APPNOTE.TXT 6.3, field by field.
#[test]
fn an_archive_of_one_file() {
    // The expected number is the check value of CRC-32 (ISO-HDLC) in the catalogue of CRC algorithms.
    assert_eq!(checksum(b"123456789"), 0xcbf4_3926);
    let mut archive = Archive::default();
    archive.add("a/b", b"123456789");
    let local = b"PK\x03\x04\x0a\x00\x00\x08\x00\x00\x00\x00\x21\x00\x26\x39\xf4\xcb\x09\x00\x00\x00\x09\x00\x00\x00\x03\x00\x00\x00a/b123456789";
    let central = b"PK\x01\x02\x0a\x00\x0a\x00\x00\x08\x00\x00\x00\x00\x21\x00\x26\x39\xf4\xcb\x09\x00\x00\x00\x09\x00\x00\x00\x03\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00a/b";
    let end = b"PK\x05\x06\x00\x00\x00\x00\x01\x00\x01\x00\x31\x00\x00\x00\x2a\x00\x00\x00\x00\x00";
    let expected = [&local[..], &central[..], &end[..]].concat();
    assert_eq!(archive.finish(), expected);
}

/// A scene with a letter outside ASCII, two forces, and single precision.
const ODD: &str = "struct Odd {
    masses: { int: 1, double: 0.5, größe: 0.25 },
    springs: { wall - int: 10, int - double: 10, double - größe: 10 },
    contact: int - größe, excitation: int, damping: modal(0.02), stiction: 1.25,
    scalar: f32, provide: [stepper], force: { größe }, input: hold, step: 1e-3,
}";

fn scene(text: &str) -> Scene {
    text.parse::<System>().unwrap().scene().clone()
}

/// Returns the values of an XML attribute in the order of the lines.
fn attributes<'a>(text: &'a str, name: &str) -> Vec<&'a str> {
    let mark = format!(" {name}=\"");
    let parts = text.split(&mark).skip(1);
    parts
        .filter_map(|part| part.split_once('"').map(|(value, _)| value))
        .collect()
}

/// Checks that the description and the Rust file give each variable the same value reference.
#[test]
fn both_files_number_the_variables_alike() {
    let shaken = ODD
        .replace("excitation: int", "excitation: base")
        .replace("wall - int: 10", "base - int: 10");
    for (text, inputs) in [
        (ODD, ["int.force", "größe.force", "friction"]),
        (
            &shaken,
            ["base.displacement", "base.velocity", "größe.force"],
        ),
    ] {
        let scene = scene(text);
        let variables = Variables::of(&scene);
        let xml = description::write(&scene, &variables, ("odd", "token", 1e-3));
        let listed = xml.split_once("<ModelVariables>").unwrap().1;
        let (listed, structure) = listed.split_once("</ModelVariables>").unwrap();
        let names = attributes(listed, "name");
        let references = attributes(listed, "valueReference");
        let expected: Vec<String> = (0..names.len()).map(|index| index.to_string()).collect();
        assert_eq!(references, expected);
        assert_eq!(names[..4], [&["time"], &inputs[..]].concat());
        // The Rust file lists the variables that depend on the scene in the same order.
        let rust = sources::scene(&scene, &variables, ("Odd", "token"));
        let lists = rust.split_once("VARIABLES").unwrap().1;
        let lists = lists.split_once("/// Returns a number").unwrap().0;
        let quoted = lists.split('"').skip(1).step_by(2);
        let units = ["", "m", "m/s", "N"];
        let quoted: Vec<&str> = quoted.filter(|text| !units.contains(text)).collect();
        // The last five outputs are the same for every scene, so the list of the Rust file leaves them out.
        let reals = names.len() - 5;
        assert_eq!(quoted, names[1..reals]);
        // A scene with 3 masses has 3 or 4 inputs, stiction, 6 initial values, and 6 + 3 + 4 + 5 outputs.
        let inputs = variables.inputs;
        assert_eq!(names.len(), 1 + inputs + 1 + 6 + 18);
        // The description lists each output twice: as an output, and as an initial unknown.
        let outputs = attributes(structure, "valueReference");
        let first = 1 + inputs + 1 + 6;
        assert_eq!(outputs.len(), 36);
        assert_eq!(outputs[..18], references[first..]);
        assert_eq!(outputs[18..], references[first..]);
        assert!(xml.contains("variableNamingConvention=\"flat\""), "{xml}");
        let ascii = scene_of_ascii(text);
        let xml = description::write(&ascii, &Variables::of(&ascii), ("odd", "token", 1e-3));
        assert!(
            xml.contains("variableNamingConvention=\"structured\""),
            "{xml}"
        );
    }
}

fn scene_of_ascii(text: &str) -> Scene {
    scene(&text.replace("größe", "size"))
}

#[test]
fn start_values_and_limits() {
    let scene = scene(ODD);
    let xml = description::write(&scene, &Variables::of(&scene), ("odd", "token", 1e-3));
    let line = |name: &str| {
        let mark = format!(" name=\"{name}\"");
        xml.lines().find(|line| line.contains(&mark)).unwrap()
    };
    let stiction = line("stiction");
    assert!(
        stiction.contains("variability=\"tunable\" start=\"1.25\" min=\"1.0\""),
        "{stiction}"
    );
    let friction = line("friction");
    assert!(friction.contains("causality=\"input\""), "{friction}");
    assert!(
        friction.contains("start=\"0.0\" unit=\"N\" min=\"0.0\""),
        "{friction}"
    );
    assert!(line("int.velocity").contains("unit=\"m/s\""));
    assert!(xml.contains("fixedInternalStepSize=\"0.001\""), "{xml}");
}

/// Checks that the path of the binary comes from the line of cargo's output that describes the shared library.
#[test]
fn finds_the_binary() {
    let ending = std::env::consts::DLL_EXTENSION;
    let line = |kind: &str| {
        format!(
            "{{\"reason\":\"compiler-artifact\",\"target\":{{\"kind\":[\"{kind}\"]}},\"filenames\":[\"a/b.pdb\",\"a/b.{ending}\"]}}"
        )
    };
    assert_eq!(
        binary(&line("cdylib")),
        Some(format!("a/b.{ending}").into())
    );
    assert_eq!(binary(&line("lib")), None);
    assert_eq!(
        binary("{\"reason\":\"build-finished\",\"success\":true}"),
        None
    );
    assert_eq!(binary("not JSON"), None);
}

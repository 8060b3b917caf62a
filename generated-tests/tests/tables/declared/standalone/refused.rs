//! Tests that the emitted files refuse the same scenes as the macro, and with the same names.

use super::{cc, folder, run, rustc, source, write_c};
use frictiongen::study::table::Tables;
use frictiongen::{NotContinuous, System, friction_system};
use frictiongen_codegen::SceneTables;
use frictiongen_codegen::standalone::{c_header, rust_source};
use frictiongen_codegen::{SizeLimits, parse_text};
use std::process::Command;

/// Passes a scene to the macro, and keeps its text.
macro_rules! scene {
    ($text:ident: struct $name:ident { $($body:tt)* }) => {
        friction_system! { struct $name { $($body)* } }
        const $text: &str = stringify!(struct $name { $($body)* });
    };
}

scene! { UNDAMPED: struct Undamped {
    masses: { block: 1 },
    springs: { base - block: 1 },
    contact: block - wall,
    excitation: block,
    accuracy: 1e-4,
    range: { r: 0.2..2.5 },
} }

scene! { FEW: struct Few {
    masses: { a: 2, b: 1 },
    springs: { base - a: 50, a - b: 20 },
    contact: b - base,
    excitation: base,
    stiction: 1.5,
    accuracy: 1e-4,
    range: { r: 0.3..2.5, beta: 0.1..0.4 },
} }

/// Returns the tables that the macro makes of a text, with its scene.
fn tables(text: &str) -> (frictiongen::study::scene::Scene, Tables<f64>) {
    let scene = parse_text(text, &SizeLimits::MACRO).expect("a scene").scene;
    match SceneTables::of(&scene).expect("tables") {
        Some(SceneTables::Double(tables)) => (scene, tables),
        _ => unreachable!("tables in double precision"),
    }
}

fn number<T>(answer: &Result<T, NotContinuous>) -> i32 {
    match answer {
        Ok(_) => 0,
        Err(NotContinuous::StickSlip) => 1,
        Err(NotContinuous::Stuck) => 2,
        Err(NotContinuous::Unbounded) => 3,
        Err(_) => -1,
    }
}

/// Returns the return codes of C and Rust at given points (r, β).
fn answers(name: &str, text: &str, places: &[(f64, f64)]) -> [Vec<i32>; 2] {
    let (scene, tables) = tables(text);
    let folder = folder(&format!("refused_{name}"));
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("written");
    let hexadecimal = |value: f64| format!("{:#018x}", value.to_bits());
    let list = places
        .iter()
        .map(|(r, beta)| format!("{}, {}", hexadecimal(*r), hexadecimal(*beta)));
    let list: Vec<String> = list.collect();
    let list = list.join(", ");
    let source = source(&scene, &tables);
    write_c(&folder, "scene", &source, "scene");
    let main = "#include <stdio.h>\n#include <string.h>\n#include \"scene.h\"\n\
        static const unsigned long long places[] = { LIST };\n\
        int main(void);\n        int main(void) {\n    for (unsigned i = 0; i < sizeof places / 8; i += 2) {\n        \
        double r, beta, a = 7, p = 7;\n        memcpy(&r, &places[i], 8);\n        memcpy(&beta, &places[i + 1], 8);\n        \
        const enum scene_status status = scene_contact(r, beta, &a, &p);\n        \
        if (status != SCENE_OK && (a < 7 || a > 7 || p < 7 || p > 7)) return 1;\n        printf(\"%d\\n\", (int)status);\n    }\n    return 0;\n}\n";
    write("main.c", &main.replace("LIST", &list));
    cc(&folder, &["-o", "program", "main.c", "scene.c", "-lm"]);
    let rust = rust_source(&source).expect("a form of its own");
    write("tables.rs", &rust);
    let main = "mod tables;\nfn main() {\n    let places: &[u64] = &[LIST];\n    for place in places.chunks(2) {\n        \
        let answer = tables::contact(f64::from_bits(place[0]), f64::from_bits(place[1]));\n        \
        println!(\"{}\", answer.map_or_else(|error| error as i32, |_| 0));\n    }\n}\n";
    write("main.rs", &main.replace("LIST", &list));
    rustc(&folder, &["main.rs", "-o", "program_rs"]);
    ["program", "program_rs"].map(|program| {
        let output = run(&mut Command::new(folder.join(program)));
        let numbers = output.lines().map(|line| line.parse().expect("a number"));
        numbers.collect()
    })
}

#[test]
fn as_the_macro_refuses() {
    let betas = [
        -1.0,
        0.0,
        0.1,
        0.099_999_999,
        0.2,
        0.4,
        0.400_000_001,
        0.8,
        1.0,
        3.0,
        1e300,
        f64::INFINITY,
        f64::NAN,
    ];
    let (few, _) = tables(FEW);
    let few: System = System::try_from(few).expect("a scene");
    let mut ratios = vec![0.19, 0.2, 0.3, 0.7, 1.0, 1.0_f64.next_up(), 1.7, 2.5, 2.6];
    // The points include the resonances of both scenes, as exact numbers.
    ratios.extend(few.resonances());
    let pairs = |r: f64| betas.map(|beta| (r, beta));
    let places: Vec<(f64, f64)> = ratios.iter().flat_map(|r| pairs(*r)).collect();
    let undamped = places.iter().map(|(r, beta)| match Undamped::at(*r) {
        Ok(at) => number(&at.motion(*beta)),
        Err(_) => -1,
    });
    let undamped: Vec<i32> = undamped.collect();
    assert_eq!(
        Undamped::at(1.0).unwrap().motion(0.1).map(drop),
        Err(NotContinuous::Unbounded)
    );
    let few = places.iter().map(|(r, beta)| match Few::at(*r) {
        Ok(at) => number(&at.motion(*beta)),
        Err(_) => -1,
    });
    let few: Vec<i32> = few.collect();
    let out = Err(NotContinuous::OutOfDomain);
    for beta in [0.0, 0.099, 0.401] {
        assert_eq!(Few::at(0.7).unwrap().motion(beta).map(drop), out, "{beta}");
    }
    for status in -1..=3 {
        assert!(undamped.contains(&status), "{status} in {undamped:?}");
    }
    for status in [-1, 0, 3] {
        assert!(few.contains(&status), "{status} in {few:?}");
    }
    for (name, text, expected) in [("undamped", UNDAMPED, &undamped), ("few", FEW, &few)] {
        for own in answers(name, text, &places) {
            let wrong = places.iter().zip(expected).zip(&own);
            let wrong = wrong.filter(|((_, expected), own)| expected != own);
            let wrong: Vec<_> = wrong.collect();
            assert!(wrong.is_empty(), "{name}: {wrong:?}");
            assert_eq!(own.len(), expected.len());
        }
    }
}

/// Checks that the file names the load. On a base that moves by Y it is k₁Y.
#[test]
fn the_load_is_named() {
    for (text, beta, other) in [(UNDAMPED, "F/P", "F/(k1 Y)"), (FEW, "F/(k1 Y)", "F/P")] {
        let (scene, tables) = tables(text);
        let source = source(&scene, &tables);
        let header = c_header(&source, "scene");
        let rust = rust_source(&source).expect("a form of its own");
        for text in [header, rust] {
            assert!(text.contains(&format!("= {beta}")), "{text}");
            assert!(!text.contains(other), "{text}");
        }
    }
}

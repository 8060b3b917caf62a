//! Tests a program that contains two tables of one scene.

use super::{cc, folder, run, source, write_c};
use frictiongen::System;
use frictiongen_codegen::standalone::c_name;
use std::process::Command;

#[test]
fn two_accuracies_in_one_program() {
    let text = "struct TwoStorey { masses: { a: 1 }, springs: { base - a: 1 }, contact: a - wall, excitation: a, damping: modal(0.05) }";
    let system: System = text.parse().expect("a scene");
    let scene = system.scene();
    assert_eq!(c_name(scene), "two_storey");
    let folder = folder("names");
    let write = |file: &str, text: &str| std::fs::write(folder.join(file), text).expect("written");
    let main = |names: [&str; 2]| {
        let [fine, coarse] = names;
        format!(
            "#include <stdio.h>\n#include \"fine.h\"\n#include \"coarse.h\"\n#include \"fine.h\"\nint main(void);\nint main(void) {{\n    \
             double fine, coarse, s;\n    if ({fine}_limits(0.9, &fine, &s) || {coarse}_limits(0.9, &coarse, &s)) return 1;\n    \
             printf(\"%.17g %.17g\\n\", fine, coarse);\n    return 0;\n}}\n"
        )
    };
    let both = |names: [&str; 2]| {
        let files = [("fine", 1e-9), ("coarse", 1e-2)];
        for ((file, accuracy), name) in files.into_iter().zip(names) {
            let compiled = system.compile(0.5..2.0, accuracy).expect("tables");
            write_c(&folder, file, &source(scene, compiled.tables()), name);
        }
        write("main.c", &main(names));
    };
    both(["two_storey", "two_storey_coarse"]);
    let sources = ["main.c", "fine.c", "coarse.c", "-lm"];
    cc(&folder, &[&["-o", "program"][..], &sources].concat());
    let output = run(&mut Command::new(folder.join("program")));
    let numbers = output.split_whitespace().map(|word| word.parse().unwrap());
    let numbers: Vec<f64> = numbers.collect();
    let exact = system.at(0.9).unwrap().continuous_limit();
    assert!((numbers[0] / exact - 1.0).abs() < 1e-9, "{numbers:?}");
    let apart = (numbers[1] / exact - 1.0).abs();
    assert!(1e-9 < apart && apart < 1e-2, "{numbers:?}");
    // If both tables have the same name, the preprocessor must not leave out the second header silently.
    both(["two_storey", "two_storey"]);
    let mut command = Command::new("cc");
    let refused = command.current_dir(&folder).args(["-c", "main.c"]).output();
    let refused = refused.expect("cc runs");
    let told = String::from_utf8_lossy(&refused.stderr);
    let message =
        "two different tables are both called two_storey: compile one of them with --name";
    assert!(
        !refused.status.success() && told.contains(message),
        "{told}"
    );
}

//! Writes a crate that compares straight-line code with loops over the modes ("passes"). `scripts/passes-trial` runs
//! this program.

use frictiongen_codegen::{SizeLimits, emit_in_passes, formatted, parse_text};
use std::fmt::Write;
use std::path::PathBuf;

const MASSES: [usize; 7] = [2, 3, 4, 5, 6, 8, 16];

fn scene(name: &str, masses: usize, damping: &str) -> String {
    let mut text = format!("pub struct {name} {{ masses: {{");
    for mass in 1..=masses {
        write!(text, " m{mass}: {},", 1.0 + 0.1 * (mass * 7 % 10) as f64).expect("a string");
    }
    text.push_str("}, springs: { base - m1: 1.0,");
    for mass in 2..=masses {
        write!(
            text,
            " m{} - m{mass}: {},",
            mass - 1,
            1.0 + 0.1 * (mass * 3 % 10) as f64
        )
        .expect("a string");
    }
    write!(
        text,
        "}}, contact: m{masses} - wall, excitation: m1, damping: {damping} }}"
    )
    .expect("a string");
    text
}

fn main() {
    let folder = PathBuf::from(std::env::args().nth(1).expect("a folder"));
    let mut source = String::from(
        "use std::hint::black_box;\nuse std::time::Instant;\n\
         fn time(f: impl Fn(f64) -> f64) -> f64 {\n    let mut best = f64::INFINITY;\n\
         for _ in 0..15 { let clock = Instant::now(); let mut sum = 0.0;\n\
         for i in 0..20_000 { sum += f(black_box(0.3 + 1e-4 * f64::from(i))); }\n\
         black_box(sum); best = best.min(clock.elapsed().as_secs_f64() / 20_000.0); }\n    best * 1e9\n}\n",
    );
    let mut main = String::from(
        "fn main() {\n    println!(\"both limits without search, ns: straight lines, passes, ratio\");\n",
    );
    for (kind, damping) in [("Undamped", "none"), ("Damped", "modal(0.02)")] {
        for masses in MASSES {
            let mut names = Vec::new();
            for (way, passes_from) in [("Lines", usize::MAX), ("Passes", 1)] {
                let name = format!("{kind}{masses}{way}");
                let text = scene(&name, masses, damping);
                let description = parse_text(&text, &SizeLimits::MACRO).expect("a valid scene");
                let emitted = formatted(emit_in_passes(&description, passes_from)).expect("Rust");
                write!(source, "mod {} {{\n{emitted}\n}}\n", name.to_lowercase())
                    .expect("a string");
                names.push(format!("{}::{name}", name.to_lowercase()));
            }
            let call = |name: &str| {
                format!(
                    "time(|r| {name}::at(r).map_or(0.0, |at| at.continuous_limit_without_search() + at.sliding_limit()))"
                )
            };
            writeln!(
                main,
                "    let (lines, passes) = ({}, {});\n    println!(\"{kind:8} {masses:2} modes {{lines:8.1}} {{passes:8.1}} {{:6.2}}\", lines / passes);",
                call(&names[0]),
                call(&names[1]),
            )
            .expect("a string");
        }
    }
    source.push_str(&main);
    source.push_str("}\n");
    std::fs::create_dir_all(folder.join("src")).expect("a folder");
    std::fs::write(folder.join("src/main.rs"), source).expect("a file");
}

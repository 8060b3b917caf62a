//! Tests which check finds a wrong digit in which constant of emitted Rust.
//!
//! A snapshot finds every one, because it compares bytes. The self-check finds every one in its last digit by a
//! checksum. Its known answers find a wrong third digit where an answer at a frequency depends on the constant; the
//! known answers would also find a generator that writes a wrong number together with its checksum.

use frictiongen_codegen::{SizeLimits, parse_text, pretty};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

const EXACT: &str = "pub struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall, excitation: base, damping: modal[0.010, 0.012], stiction: 1.2,
    provide: [limits, motion, stuck, stepper, self_check], step: 1e-3,
}";

const TABLED: &str = "pub struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall, excitation: base, damping: modal[0.010, 0.012], scalar: f32,
    provide: [limits, motion, stuck, self_check], accuracy: 1e-3, range: { r: 0.2..2.5, beta: 0..4 },
}";

/// A number of a scene: marks in the text, the last of which precedes it; the name in the fault of the checksum; and
/// true if the known answers find a wrong third digit.
type Case = (&'static [&'static str], &'static str, bool);

const OF_EXACT: [Case; 21] = [
    (&["SCENE_HASH: ", "0x"], "SCENE_HASH", false),
    (&["const K1", " = "], "K1, M1 and frequencies", false),
    (&["const M1", " = "], "K1, M1 and frequencies", false),
    (&["const REFERENCE", " = "], "K1, M1 and frequencies", false),
    (
        &["const NATURAL_FREQUENCIES_HZ", " = "],
        "K1, M1 and frequencies",
        false,
    ),
    (
        &["const RESONANCES", " = "],
        "K1, M1 and frequencies",
        false,
    ),
    (&["const MODE_SHAPES", " = "], "MODE_SHAPES", true),
    (&["const CHAIN", "stiction: "], "CHAIN", true),
    (&["const MODES", "resonance: "], "MODES", true),
    (&["const MODES", "zeta: "], "MODES", true),
    (&["const MODES", "residue: "], "MODES", true),
    (
        &["const NUMBERS", "sliding_at_infinity: "],
        "NUMBERS",
        false,
    ),
    (
        &["fn inverse_ratio_range", "{"],
        "inverse_ratio_range",
        false,
    ),
    (
        &["const DYNAMICS", "held: &[", "frequency: "],
        "DYNAMICS",
        false,
    ),
    (&["const DYNAMICS", "participations: &["], "DYNAMICS", false),
    (&["const DYNAMICS", "weights: &["], "DYNAMICS", false),
    (&["const STEP_SCENE", "support: "], "STEP_SCENE", false),
    (&["const STEP:", " = "], "STEP", false),
    (&["const STEP_TABLES", "turn: Row"], "STEP_TABLES", false),
    (
        &["const STEP_TABLES", "held_loads: ["],
        "STEP_TABLES",
        false,
    ),
    (&["const KNOWN", "limits: ["], "KNOWN", true),
];

const OF_TABLED: [Case; 7] = [
    (&["const TABLE:", "low: "], "TABLE", true),
    (&["const TABLE:", "buckets: &["], "TABLE", false),
    // No known answer lies in the first piece.
    (&["const TABLE:", "coefficients: ["], "TABLE", false),
    (&["const SLIDING_LIMIT", "gain: "], "SLIDING_LIMIT", true),
    (&["const STUCK_POLES", "at: "], "STUCK_1", true),
    (&["const STUCK_1", "gain: "], "STUCK_1", true),
    (&["fn domain", "r: ("], "domain", true),
];

/// Returns the text with one digit changed in the number after the marks: the last digit, or the digit at `place`.
fn with_a_wrong_digit(text: &str, marks: &[&str], place: Option<usize>) -> String {
    let start = marks.iter().fold(0, |from, mark| {
        let found = text[from..].find(mark);
        from + found.unwrap_or_else(|| panic!("no {mark} of {marks:?}")) + mark.len()
    });
    let start = start + text[start..].find(|c: char| c.is_ascii_digit()).unwrap();
    let is_part =
        |letter: char| letter.is_ascii_hexdigit() && letter != 'e' || "._".contains(letter);
    let end = start + text[start..].find(|c: char| !is_part(c)).unwrap();
    let digits = (start..end).filter(|at| text[*at..=*at].chars().all(|c| c.is_ascii_digit()));
    let digits: Vec<usize> = digits.collect();
    let significant = digits.iter().skip_while(|at| &text[**at..=**at] == "0");
    let significant: Vec<usize> = significant.copied().collect();
    // A change of the 17th digit alone may round to the same number.
    let last = if significant.len() > 16 {
        digits.len() - 2
    } else {
        digits.len() - 1
    };
    let third = place.and_then(|place| significant.get(place).copied());
    let at = third.unwrap_or(digits[last]);
    let digit: u8 = text[at..=at].parse().unwrap();
    let other = ((digit + 5) % 10).to_string();
    let mut wrong = text.to_owned();
    wrong.replace_range(at..=at, &other);
    wrong
}

/// Returns the emitted source without the comparison of checksums.
fn answers_alone(source: &str) -> String {
    let (before, rest) = source.split_once("pub fn self_check()").expect("a check");
    let (body, after) = rest.split_once("Ok(())").expect("an end");
    let from = body
        .find("::core::hint::black_box(&Self::KNOWN)")
        .expect("answers");
    let open = body.find('{').expect("a body");
    format!(
        "{before}pub fn self_check(){} {} Ok(()){after}",
        &body[..=open],
        &body[from..]
    )
}

/// Compiles a program with the library that the test itself uses.
fn compiled(folder: &Path) -> PathBuf {
    let program = std::env::current_exe().expect("a program");
    let libraries = program.parent().expect("the folder of the libraries");
    let mut found: Vec<_> = std::fs::read_dir(libraries)
        .expect("libraries")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("libfrictiongen-") && name.ends_with(".rlib")
        })
        .collect();
    found.sort_by_key(|path| path.metadata().and_then(|data| data.modified()).ok());
    let mut said = String::new();
    // The folder may also contain older libraries from other builds.
    for library in found.iter().rev() {
        let output = Command::new("rustc")
            .current_dir(folder)
            .args([
                "--edition=2021",
                "-Cdebuginfo=0",
                "main.rs",
                "-o",
                "program",
            ])
            .arg("--extern")
            .arg(format!("frictiongen={}", library.display()))
            .arg("-L")
            .arg(format!("dependency={}", libraries.display()))
            .output()
            .expect("rustc");
        if output.status.success() {
            return folder.join("program");
        }
        said = String::from_utf8_lossy(&output.stderr).into_owned();
    }
    panic!("the emitted code does not compile:\n{said}");
}

#[test]
fn which_check_finds_which_digit() {
    let (mut modules, mut calls, mut cases) = (String::new(), String::new(), Vec::new());
    let mut add = |source: &str, case: String| {
        let number = cases.len();
        let _ = writeln!(modules, "mod scene_{number} {{\n{source}\n}}");
        let _ = writeln!(
            calls,
            "    println!(\"{{:?}}\", scene_{number}::Frame::self_check());"
        );
        cases.push(case);
    };
    let mut expected = Vec::new();
    for (text, list) in [(EXACT, &OF_EXACT[..]), (TABLED, &OF_TABLED[..])] {
        let description = parse_text(text, &SizeLimits::MACRO).expect("a valid scene");
        let source = pretty(&description).expect("emitted Rust");
        let alone = answers_alone(&source);
        for right in [&source, &alone] {
            add(right, "no fault".to_owned());
            expected.push("Ok(())".to_owned());
        }
        for (marks, name, by_answers) in list {
            let wrong = with_a_wrong_digit(&source, marks, None);
            // A snapshot compares bytes.
            assert_ne!(wrong, source);
            add(&wrong, format!("{marks:?}, last digit, all checks"));
            expected.push(format!("Err(Numbers({name:?}))"));
            let wrong = with_a_wrong_digit(&alone, marks, Some(2));
            add(&wrong, format!("{marks:?}, third digit, answers alone"));
            expected.push(if *by_answers { "Err(Answer(" } else { "Ok(())" }.to_owned());
        }
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("wrong_digits");
    std::fs::create_dir_all(&folder).expect("a folder");
    let main = format!("{modules}\nfn main() {{\n{calls}}}\n");
    std::fs::write(folder.join("main.rs"), main).expect("written");
    let output = Command::new(compiled(&folder)).output().expect("a run");
    let told = String::from_utf8(output.stdout).expect("text");
    let told: Vec<&str> = told.lines().collect();
    assert_eq!(told.len(), cases.len());
    let all = cases.iter().zip(&expected).zip(&told);
    let other: Vec<String> = all
        .filter(|((_, expected), told)| !told.starts_with(expected.as_str()))
        .map(|((case, expected), told)| format!("{case}: {told}, expected {expected}"))
        .collect();
    assert!(other.is_empty(), "{}", other.join("\n"));
}

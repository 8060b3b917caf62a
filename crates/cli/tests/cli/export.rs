//! Tests `frictiongen export`.
#![allow(clippy::unwrap_used, clippy::expect_used, reason = "a test may fail")]

use crate::common::{BLOCK, FRAME, failure, run_with};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{fs, process};

/// A folder that is removed at the end of a test.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir();
        Self(path.join(format!("frictiongen-export-{}-{name}", process::id())))
    }

    fn text(&self, name: &str) -> String {
        fs::read_to_string(self.0.join(name)).unwrap()
    }

    /// Exports a description into the folder. Returns standard error.
    fn export(&self, description: &str, more: &[&str]) -> String {
        let folder = self.0.to_str().unwrap();
        let asked = ["export", "--to", "c", "-o", folder];
        let run = run_with(description, &[&asked, more].concat());
        assert_eq!((run.status, run.out.as_str()), (Some(0), ""), "{}", run.err);
        run.err
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Returns a scene on a moving base whose export has all functions.
fn whole() -> String {
    let frame = fs::read_to_string(FRAME).unwrap();
    let provide = "stiction: 1.2,\n    provide: [limits, motion(lower), stuck, orbit, simulation, stepper, self_check],";
    frame.replace("stiction: 1.2,", provide)
}

/// Names that C reserves, letters outside ASCII, single precision, an elastic contact and a friction law.
const ODD: [&str; 2] = [
    "struct Odd {
        masses: { int: 1, double: 0.5, größe: 0.25 },
        springs: { wall - int: 10, int - double: 10, double - größe: 10 },
        contact: int - größe, excitation: int, damping: modal(0.02), stiffness: 200,
        scalar: f32, provide: [orbit, simulation, stepper], force: { double, größe }, input: hold,
    }",
    "struct Law {
        masses: { block: 1 }, springs: { base - block: 1 }, contact: block - wall, excitation: block,
        damping: modal(0.02), friction: stribeck(0.1: 0.8), provide: [simulation, stepper],
    }",
];

/// Checks a folder's C by a compiler, if there is one: the header as C99 and C++, and the example.
fn compiles(folder: &Path, header: &str) {
    let strict = [
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Wconversion",
        "-Werror",
        "-fsyntax-only",
    ];
    let runs: [(&str, &[&str]); 3] = [
        ("gcc", &["-std=c99", "main.c"]),
        ("gcc", &["-std=c99", "-x", "c", header]),
        ("g++", &["-x", "c++", header]),
    ];
    for (compiler, more) in runs {
        let found = Command::new(compiler)
            .arg("--version")
            .stdout(Stdio::null())
            .status();
        if found.is_err() {
            eprintln!("SKIPPED: {compiler} is missing");
            continue;
        }
        let run = Command::new(compiler)
            .args(strict)
            .args(more)
            .current_dir(folder)
            .output()
            .unwrap();
        let told = String::from_utf8_lossy(&run.stderr);
        assert!(
            run.status.success() && told.is_empty(),
            "{compiler} {more:?}: {told}"
        );
    }
}

/// Returns the names of the functions in a header.
fn functions<'a>(header: &'a str, prefix: &str) -> Vec<&'a str> {
    let lines = header
        .lines()
        .filter_map(|line| line.strip_prefix("int32_t "));
    lines
        .filter_map(|line| {
            line.strip_prefix(prefix)?
                .split_once('(')
                .map(|(name, _)| name)
        })
        .collect()
}

#[test]
fn the_files() {
    let folder = Folder::new("whole");
    assert_eq!(folder.export(&whole(), &[]), "");
    let header = folder.text("frame.h");
    assert!(header.contains(" *     pub struct Frame {\n"), "{header}");
    let expected = [
        "limits",
        "regime",
        "margin",
        "motion",
        "motion_harmonic",
        "motion_at",
        "stuck",
        "orbit",
        "orbit_from",
        "orbit_multiplier",
        "orbit_motion",
        "orbit_harmonic",
        "orbit_at",
        "self_check",
        "simulation_start",
        "simulation_start_from",
        "simulation_advance",
        "simulation_masses",
        "simulation_contact",
        "simulation_progress",
        "stepper_start",
        "stepper_start_from",
        "stepper_begin",
        "stepper_advance",
        "stepper_set_stiction",
        "stepper_masses",
        "stepper_contact",
        "stepper_work",
        "stepper_progress",
        "stepper_save",
        "stepper_restore",
        "stepper_image",
        "stepper_start_from_image",
    ];
    let found = functions(&header, "frame_");
    for name in expected {
        assert!(found.contains(&name), "{name}: {found:?}");
    }
    // The header and the Rust file declare the same functions.
    let rust = folder.text("src/lib.rs");
    let declared = rust.matches("pub extern \"C\" fn frame_").count();
    assert_eq!(
        declared,
        found.len() + 1,
        "the functions, and frame_status_text"
    );
    // `motion(lower)` gives no motion of the upper floor.
    let motion = header.split_once("struct frame_motion {").unwrap().1;
    let motion = motion.split_once('}').unwrap().0;
    assert!(
        motion.contains("mass_lower") && !motion.contains("mass_upper"),
        "{motion}"
    );
    let manifest = folder.text("Cargo.toml");
    let version = format!(
        "frictiongen = {{ version = \"={}\", default-features = false }}",
        env!("CARGO_PKG_VERSION")
    );
    assert!(manifest.contains(&version), "{manifest}");
    assert!(folder.text("Makefile").contains("libframe_solver.a"));
    assert!(
        folder
            .text("CMakeLists.txt")
            .contains("add_library(frame STATIC IMPORTED GLOBAL)")
    );
    assert_eq!(folder.text("frame.friction"), whole());
    compiles(&folder.0, "frame.h");
}

#[test]
fn odd_names_and_other_scenes() {
    for (scene, name) in ODD.iter().zip(["odd", "law"]) {
        let folder = Folder::new(name);
        folder.export(scene, &[]);
        compiles(&folder.0, &format!("{name}.h"));
    }
    let folder = Folder::new("odd-fields");
    folder.export(ODD[0], &["--name", "other"]);
    let header = folder.text("other.h");
    for field in [
        "float force;",
        "float force_double;",
        "float force_3;",
        "struct other_mass_now mass_int;",
    ] {
        assert!(header.contains(field), "{field}: {header}");
    }
}

/// Two contacts, of which C cannot write one name, and one contact with a dashpot.
const TWO: &str = "struct Two {
    masses: { a: 1, b: 2 }, springs: { base - a: 1, a - b: 1 },
    contacts: { push: a - wall, größe: a - base { stiffness: 1 } },
    excitation: base, force: { b }, scalar: f32, input: hold, provide: [stepper],
}";
const DASHPOT: &str = "struct Damped {
    masses: { a: 1 }, springs: { base - a: 1 }, contacts: { pads: a - wall }, dampers: { base - a: 0.1 },
    excitation: a, provide: [stepper],
}";

#[test]
fn several_contacts_and_dashpots() {
    let folder = Folder::new("two");
    folder.export(TWO, &[]);
    let header = folder.text("two.h");
    for field in [
        "float friction_push;",
        "float friction_2;",
        "struct two_contact contact_2;",
        "uint32_t contact, float mu);",
    ] {
        assert!(header.contains(field), "{field}: {header}");
    }
    compiles(&folder.0, "two.h");
    let folder = Folder::new("damped");
    folder.export(DASHPOT, &[]);
    let header = folder.text("damped.h");
    for field in ["double friction;", "double stiction;", "int32_t sliding;"] {
        assert!(header.contains(field), "{field}: {header}");
    }
    compiles(&folder.0, "damped.h");
}

#[test]
fn keeps_a_changed_example_and_its_own_description() {
    let folder = Folder::new("again");
    folder.export(&whole(), &[]);
    fs::write(folder.0.join("main.c"), "/* mine */\n").unwrap();
    let own = folder.0.join("frame.friction");
    folder.export("", &[own.to_str().unwrap()]);
    assert_eq!(folder.text("main.c"), "/* mine */\n");
    assert_eq!(folder.text("frame.friction"), whole());
}

#[test]
fn says_what_is_missing() {
    let folder = Folder::new("missing");
    let told = folder.export(BLOCK, &[]);
    let stepper = "frictiongen: the library has no stepper, because the description does not provide it; add `stepper` to `provide` for the motion under any force\n";
    assert_eq!(told, stepper);
    let told = folder.export(
        &BLOCK.replace("excitation", "provide: [limits, simulation], excitation"),
        &[],
    );
    assert_eq!(told, stepper);
    assert_eq!(
        functions(&folder.text("block.h"), "block_simulation_"),
        [
            "start",
            "start_from",
            "advance",
            "masses",
            "contact",
            "progress"
        ]
    );
}

#[test]
fn refuses_what_has_no_library() {
    let folder = Folder::new("refused");
    let path = folder.0.to_str().unwrap();
    let with = |scene: &str, more: &[&str]| {
        let lines = failure(
            scene,
            &[&["export", "--to", "c", "-o", path], more].concat(),
        );
        assert!(!folder.0.exists(), "{lines:?}");
        lines.join("\n")
    };
    let more = TWO.replace("provide: [stepper]", "provide: [stepper, orbit]");
    let told = "frictiongen: <stdin>: an export of several contacts, dashpots or a free mass has only a stepper; write `provide: [stepper]`";
    assert_eq!(with(&more, &[]), told);
    let renamed = BLOCK.replace("excitation", "crate: ::other, excitation");
    let facade = "frictiongen: the field `crate` names the library `::other`, but an exported crate names it `::frictiongen`; leave `crate` out";
    assert_eq!(with(&renamed, &[]), facade);
    let name = "frictiongen: --name is `a-b`, which cannot begin a name in C; write --name with letters, digits and underscores, for example --name frame";
    assert_eq!(with(BLOCK, &["--name", "a-b"]), name);
    let foreign = BLOCK.replace("Block", "Größe");
    let name = "frictiongen: the scene's name gives `größe`, which cannot begin a name in C; write --name with letters, digits and underscores, for example --name frame";
    assert_eq!(with(&foreign, &[]), name);
    let math = "frictiongen: math.h is a header of the C library; give the files another name, for example --name my_math";
    assert_eq!(with(&BLOCK.replace("Block", "Math"), &[]), math);
    let here = env!("CARGO_MANIFEST_DIR");
    let other = format!(
        "frictiongen: --library is {here}: the folder contains another crate; give the folder `frictiongen` of a clone, which contains its Cargo.toml"
    );
    assert_eq!(with(BLOCK, &["--library", here]), other);
    let none = "frictiongen: --library is no-such-folder: there is no such file or folder; give the folder `frictiongen` of a clone, which contains its Cargo.toml";
    assert_eq!(with(BLOCK, &["--library", "no-such-folder"]), none);
}

/// A scene of which the command makes an FMU.
fn stepped() -> String {
    BLOCK.replace("excitation", "provide: [stepper], step: 1e-3, excitation")
}

#[test]
fn refuses_what_has_no_fmu() {
    let folder = Folder::new("fmu-refused");
    let path = folder.0.join("block.fmu");
    let path = path.to_str().unwrap();
    let with = |scene: &str, more: &[&str]| {
        let lines = failure(scene, &[&["export", "--to", "fmu"], more].concat());
        assert!(!folder.0.exists(), "{lines:?}");
        lines.join("\n")
    };
    let stepper = "frictiongen: an FMU needs a stepper, which the description does not provide; add `stepper` to its `provide`, for example `provide: [stepper]`, and `step: 1e-3`";
    assert_eq!(with(BLOCK, &["-o", path]), stepper);
    let step = "frictiongen: an FMU has a constant step, which the description does not give; add its length in seconds, for example `step: 1e-3`";
    assert_eq!(
        with(&stepped().replace("step: 1e-3, ", ""), &["-o", path]),
        step
    );
    let name = "frictiongen: cannot write the FMU block.zip: its name must end in .fmu, for example -o frame.fmu";
    assert_eq!(with(&stepped(), &["-o", "block.zip"]), name);
    assert_eq!(with(TWO, &["-o", path]), step);
}

/// Runs the export with another program in place of cargo.
fn without_cargo(folder: &Folder, cargo: &str) -> String {
    fs::create_dir_all(&folder.0).unwrap();
    fs::write(folder.0.join("block.friction"), stepped()).unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_frictiongen"))
        .args(["export", "block.friction", "--to", "fmu", "-o", "block.fmu"])
        .env("CARGO", cargo)
        .current_dir(&folder.0)
        .output()
        .unwrap();
    assert_eq!(run.status.code(), Some(2));
    assert!(!folder.0.join("block.fmu").exists());
    String::from_utf8(run.stderr).unwrap()
}

#[test]
fn an_fmu_needs_cargo() {
    let folder = Folder::new("fmu-cargo");
    let missing = "frictiongen: cargo builds block_fmu\nfrictiongen: cannot start cargo, which builds the FMU: there is no such file or folder; install Rust, or set the variable CARGO to the path of cargo\n";
    assert_eq!(without_cargo(&folder, "./no-such-program"), missing);
    // The command itself fails when it gets the arguments of cargo.
    let told = without_cargo(&folder, env!("CARGO_BIN_EXE_frictiongen"));
    let failed = "frictiongen: cargo cannot build the crate in block_fmu, and its own message above says why; without a registry, give the folder of the library by --library\n";
    assert!(told.ends_with(failed), "{told}");
    for file in [
        "lib", "scene", "fmi3", "inputs", "instance", "missing", "saved",
    ] {
        let text = folder.text(&format!("block_fmu/src/{file}.rs"));
        assert!(!text.is_empty(), "{file}");
    }
    let described = folder.text("block_fmu/modelDescription.xml");
    assert!(
        described.contains("modelIdentifier=\"block\""),
        "{described}"
    );
    assert_eq!(folder.text("block_fmu/block.friction"), stepped());
}

/// Simulates three FMUs with FMPy, if it can be had, and compares 500 steps with Rust, bit for bit.
#[test]
#[ignore = "builds three crates with all their dependencies: minutes"]
fn simulates_as_rust_does() {
    run_script("fmu", "500", "outputs each with the bits of Rust");
}

/// Builds two exported libraries, and compares 10,000 random steps with Rust, bit for bit. The script without a number
/// takes a million steps.
#[test]
#[ignore = "builds two crates with all their dependencies: minutes"]
fn steps_as_rust_does() {
    run_script("export", "10000", "the same bits as Rust");
}

/// Runs a script of the project for a number of steps. It may skip everything.
fn run_script(name: &str, steps: &str, expected: &str) {
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scripts");
    let run = Command::new(scripts.join(name))
        .arg(steps)
        .env("FRICTIONGEN", env!("CARGO_BIN_EXE_frictiongen"))
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&run.stdout).into_owned();
    assert!(
        run.status.success(),
        "{told}{}",
        String::from_utf8_lossy(&run.stderr)
    );
    assert!(told.is_empty() || told.contains(expected), "{told}");
}

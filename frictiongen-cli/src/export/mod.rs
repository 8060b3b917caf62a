//! `frictiongen export`: writes a crate with a C header, which solves the scene of a description for a program in C.

mod face;
mod files;
mod header;
mod names;
mod room;
mod rust;
mod status;
mod steady;
mod stepping;

use crate::args::{ExportArguments, ExportTarget};
use crate::compile::command;
use crate::failure::{Failure, reason};
use crate::file::{check, write_file};
use crate::progress;
use face::Face;
use frictiongen::study::scene::{Precision, Provide, Scene};
use frictiongen_codegen::standalone::Origin;
use frictiongen_codegen::{Description, Limits};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Items of `provide` of which an export has functions.
const EXPORTED: &str = "limits, motion, stuck, orbit, stepper or self_check";

/// Runs `frictiongen export`.
pub fn run(arguments: &ExportArguments, _out: &mut dyn Write) -> Result<(), Failure> {
    let ExportTarget::C = arguments.to;
    // The command rejects every description that the macro rejects, because the exported crate calls the macro.
    let (description, text) = arguments.file.exported(&Limits::MACRO)?;
    let scene = &description.scene;
    check_facade(&description)?;
    let prefix = names::prefix(scene, arguments.name.as_deref())?;
    let face = face_of(&description)?;
    let library = arguments.library.as_deref().map(library).transpose()?;
    let folder = &arguments.output;
    let source = arguments.file.path();
    let all = files(&description, (&face, &prefix), (arguments, &text, library));
    fs::create_dir_all(folder.join("src")).map_err(|error| {
        Failure::new(format_args!(
            "cannot write the folder {}: {}",
            folder.display(),
            reason(&error)
        ))
    })?;
    // The description inside the folder may be the file that was read.
    let copy = folder.join(format!("{prefix}.friction"));
    let is_same = source.is_some_and(|source| same(source, &copy));
    for (path, text) in &all {
        if is_same && *path == copy {
            continue;
        }
        check(path, source)?;
        write_file(path, source, text)?;
    }
    let example = folder.join("main.c");
    if !example.exists() {
        write_file(
            &example,
            source,
            &files::example(scene, (&prefix, real(scene))),
        )?;
    }
    if scene.provides(&Provide::Simulation) {
        progress::say(
            "frictiongen: `export` leaves out `simulation` of `provide`; use `stepper` for a motion in time\n",
        );
    }
    if !scene.provides(&Provide::Stepper) {
        progress::say(
            "frictiongen: the library has no stepper, because the description does not provide it; add `stepper` to `provide` for the motion under any force\n",
        );
    }
    Ok(())
}

fn same(one: &Path, other: &Path) -> bool {
    matches!((fs::canonicalize(one), fs::canonicalize(other)), (Ok(one), Ok(other)) if one == other)
}

/// Returns the names and texts of all files that the command overwrites.
fn files(
    description: &Description,
    (face, prefix): (&Face, &str),
    (arguments, text, library): (&ExportArguments, &str, Option<PathBuf>),
) -> Vec<(PathBuf, String)> {
    let scene = &description.scene;
    let command = format!(
        "frictiongen export {} --to c",
        command::description(&arguments.file)
    );
    let origin = Origin {
        description: text,
        command: &command,
    };
    let real = real(scene);
    let scalar = match scene.precision {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    };
    let name = description.name.to_string();
    let head = origin.rust_head(scene);
    let header = header::header(face, scene, (prefix, &origin.c_comment(scene), real));
    let folder = &arguments.output;
    vec![
        (folder.join(format!("{prefix}.h")), header),
        (folder.join(format!("{prefix}.friction")), text.to_owned()),
        (
            folder.join("src").join("lib.rs"),
            rust::library(face, &head, (prefix, &name, scalar)),
        ),
        (
            folder.join("Cargo.toml"),
            files::manifest(prefix, library.as_deref()),
        ),
        (folder.join("Makefile"), files::makefile(prefix)),
        (folder.join("CMakeLists.txt"), files::cmake(prefix)),
    ]
}

/// Returns the name of the scalar in C.
fn real(scene: &Scene) -> &'static str {
    match scene.precision {
        Precision::F64 => "double",
        Precision::F32 => "float",
    }
}

/// Collects the functions of the scene.
fn face_of(description: &Description) -> Result<Face, Failure> {
    let scene = &description.scene;
    let mut face = Face::default();
    steady::add(&mut face, scene);
    if scene.provides(&Provide::Stepper) {
        stepping::add(&mut face, scene, &description.name.to_string());
    }
    if face.functions.is_empty() {
        return Err(Failure::new(format_args!(
            "the description provides nothing that `export` writes; add {EXPORTED} to its `provide`, for example `provide: [stepper]`"
        )));
    }
    Ok(face)
}

/// Fails for a description that renames the library.
fn check_facade(description: &Description) -> Result<(), Failure> {
    let path = description.facade.to_string().replace(' ', "");
    if path == "::frictiongen" {
        return Ok(());
    }
    Err(Failure::new(format_args!(
        "the field `crate` names the library `{path}`, but an exported crate names it `::frictiongen`; leave `crate` out"
    )))
}

/// Returns the absolute path of the library's folder, which must contain the crate `frictiongen`.
fn library(path: &Path) -> Result<PathBuf, Failure> {
    let refused = |why: &str| {
        Failure::new(format_args!(
            "--library is {}: {why}; give the folder `frictiongen` of a clone, which contains its Cargo.toml",
            path.display()
        ))
    };
    let whole = fs::canonicalize(path).map_err(|error| refused(&reason(&error)))?;
    let manifest = fs::read_to_string(whole.join("Cargo.toml"));
    let manifest = manifest.map_err(|_| refused("the folder has no Cargo.toml"))?;
    // A program of another crate may have this name too: only the name of the package counts.
    let mut package = manifest
        .lines()
        .map(str::trim)
        .skip_while(|line| *line != "[package]")
        .skip(1)
        .take_while(|line| !line.starts_with('['));
    if package.any(|line| line == "name = \"frictiongen\"") {
        Ok(whole)
    } else {
        Err(refused("the folder contains another crate"))
    }
}

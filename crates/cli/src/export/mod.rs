//! `frictiongen export`: writes a crate that solves the scene of a description, with a C header for programs in C. With
//! `--to fmu` it writes an FMU.

mod face;
mod files;
mod fmu;
mod header;
mod names;
mod orbit;
mod room;
mod rust;
mod simulating;
mod status;
mod steady;
mod stepping;

use crate::args::{ExportArguments, ExportTarget};
use crate::compile::command;
use crate::failure::{Failure, reason};
use crate::file::{check, write_file};
use crate::progress;
use face::ExportedItems;
use frictiongen::study::scene::{Precision, Provide, Scene};
use frictiongen_codegen::standalone::Origin;
use frictiongen_codegen::{Description, SizeLimits};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// A checked request for an export.
struct ExportRequest<'a> {
    arguments: &'a ExportArguments,
    description: &'a Description,
    /// Prefix of all names in the exported C interface.
    prefix: &'a str,
    /// Text of the scene description, and the command line of the export.
    origin: Origin<'a>,
    /// Folder of the crate `frictiongen`. `None` means the crate of the registry.
    library: Option<&'a Path>,
}

/// Runs `frictiongen export`.
pub fn run(arguments: &ExportArguments, _out: &mut dyn Write) -> Result<(), Failure> {
    // The command rejects every scene description that the macro rejects, because the exported crate calls the macro.
    let (description, text) = arguments.file.exported(&SizeLimits::MACRO)?;
    check_facade(&description)?;
    let prefix = names::prefix(&description.scene, arguments.name.as_deref())?;
    let library = arguments.library.as_deref().map(library).transpose()?;
    let (to, write): (_, fn(&ExportRequest<'_>) -> _) = match arguments.to {
        ExportTarget::C => ("c", write_c),
        ExportTarget::Fmu => ("fmu", fmu::run),
    };
    let command = format!(
        "frictiongen export {} --to {to}",
        command::description(&arguments.file)
    );
    write(&ExportRequest {
        arguments,
        description: &description,
        prefix: &prefix,
        origin: Origin {
            description: &text,
            command: &command,
        },
        library: library.as_deref(),
    })
}

/// Writes the crate with a C header.
fn write_c(asked: &ExportRequest<'_>) -> Result<(), Failure> {
    let (prefix, folder) = (asked.prefix, &asked.arguments.output);
    let scene = &asked.description.scene;
    names::check_header(prefix)?;
    let face = face_of(asked.description);
    let source = asked.arguments.file.path();
    let all = files(asked, &face);
    create(&folder.join("src"))?;
    // The folder may already contain a copy of the scene description, and the command may have read this copy.
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
            &files::example(scene, (prefix, real(scene))),
        )?;
    }
    if !scene.provides(&Provide::Stepper) {
        progress::say(
            "frictiongen: the library has no stepper, because the description does not provide it; add `stepper` to `provide` for the motion under any force\n",
        );
    }
    Ok(())
}

/// Creates a folder, and its parent folders if necessary.
fn create(folder: &Path) -> Result<(), Failure> {
    fs::create_dir_all(folder).map_err(|error| {
        Failure::new(format_args!(
            "cannot write the folder {}: {}",
            folder.display(),
            reason(&error)
        ))
    })
}

fn same(one: &Path, other: &Path) -> bool {
    matches!((fs::canonicalize(one), fs::canonicalize(other)), (Ok(one), Ok(other)) if one == other)
}

/// Returns the names and texts of all files that the command overwrites.
fn files(asked: &ExportRequest<'_>, face: &ExportedItems) -> Vec<(PathBuf, String)> {
    let scene = &asked.description.scene;
    let (prefix, origin) = (asked.prefix, &asked.origin);
    let real = real(scene);
    let scalar = match scene.precision {
        Precision::F64 => "f64",
        Precision::F32 => "f32",
    };
    let name = asked.description.name.to_string();
    let head = origin.rust_head(scene);
    let header = header::header(face, scene, (prefix, &origin.c_comment(scene), real));
    let folder = &asked.arguments.output;
    vec![
        (folder.join(format!("{prefix}.h")), header),
        (
            folder.join(format!("{prefix}.friction")),
            origin.description.to_owned(),
        ),
        (
            folder.join("src").join("lib.rs"),
            rust::library(face, &head, (prefix, &name, scalar), scene.is_joined()),
        ),
        (
            folder.join("Cargo.toml"),
            files::manifest(prefix, asked.library),
        ),
        (folder.join("Makefile"), files::makefile(prefix)),
        (folder.join("CMakeLists.txt"), files::cmake(prefix)),
    ]
}

/// Returns the C type of the scene's scalar.
fn real(scene: &Scene) -> &'static str {
    match scene.precision {
        Precision::F64 => "double",
        Precision::F32 => "float",
    }
}

/// Collects the functions and structs that the scene offers to C.
fn face_of(description: &Description) -> ExportedItems {
    let scene = &description.scene;
    let mut face = ExportedItems::default();
    steady::add(&mut face, scene);
    if scene.provides(&Provide::Simulation) {
        let name = description.name.to_string();
        simulating::add(&mut face, scene, (&name, steady::unit(scene)));
    }
    if scene.provides(&Provide::Stepper) {
        stepping::add(&mut face, scene, &description.name.to_string());
    }
    face
}

/// Fails if the field `crate` of the scene description gives another path for the crate `frictiongen`.
fn check_facade(description: &Description) -> Result<(), Failure> {
    let path = description.facade.to_string().replace(' ', "");
    if path == "::frictiongen" {
        return Ok(());
    }
    Err(Failure::new(format_args!(
        "the field `crate` names the library `{path}`, but an exported crate names it `::frictiongen`; leave `crate` out"
    )))
}

/// Returns the absolute path of a folder. Fails unless the folder contains the crate `frictiongen`.
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
    // A binary target of another crate may also have this name. The code therefore compares the name of the package.
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

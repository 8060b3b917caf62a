//! `frictiongen export --to fmu`: writes a crate with the functions of FMI 3.0, builds it with cargo, and packs the
//! binary with its description.

mod archive;
mod description;
mod sources;
#[cfg(test)]
mod tests;
mod variables;

use super::{ExportRequest, files, same};
use crate::failure::{Failure, reason};
use crate::file::{check, write_file, write_with};
use crate::progress;
use archive::Archive;
use frictiongen::study::scene::{Precision, Provide, Scene, StepInput};
use frictiongen_codegen::standalone::scene_hash;
use std::env::consts::{ARCH, DLL_EXTENSION, OS};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use variables::Variables;

/// Writes the FMU of a scene.
pub fn run(asked: &ExportRequest<'_>) -> Result<(), Failure> {
    let scene = &asked.description.scene;
    let output = &asked.arguments.output;
    let step = step(scene)?;
    let source = asked.arguments.file.path();
    let folder = folder(output)?;
    check(output, source)?;
    let token = format!(
        "frictiongen-{}-{}",
        env!("CARGO_PKG_VERSION"),
        scene_hash(scene)
    );
    let variables = Variables::of(scene);
    let prefix = asked.prefix;
    let described = description::write(scene, &variables, (prefix, &token, step));
    let copy = folder.join(format!("{prefix}.friction"));
    let own = source.is_some_and(|source| same(source, &copy));
    let name = asked.description.name.to_string();
    let manifest = files::fmu_manifest(prefix, asked.library);
    let all = [
        ("Cargo.toml", manifest.as_str()),
        ("modelDescription.xml", &described),
        (
            "src/lib.rs",
            &sources::library(&asked.origin.rust_head(scene), prefix),
        ),
        (
            "src/scene.rs",
            &sources::scene(scene, &variables, (&name, &token)),
        ),
    ];
    super::create(&folder.join("src"))?;
    for (name, text) in all.into_iter().chain(sources::FIXED) {
        write_file(&folder.join(name), source, text)?;
    }
    if !own {
        write_file(&copy, source, asked.origin.description)?;
    }
    let binary = build(&folder)?;
    let binary = fs::read(&binary).map_err(|error| {
        Failure::new(format_args!(
            "cannot read {}: {}",
            binary.display(),
            reason(&error)
        ))
    })?;
    let mut archive = Archive::default();
    archive.add("modelDescription.xml", described.as_bytes());
    archive.add(
        &format!("binaries/{}/{prefix}.{DLL_EXTENSION}", platform()),
        &binary,
    );
    archive.add(
        &format!("extra/frictiongen/{prefix}.friction"),
        asked.origin.description.as_bytes(),
    );
    let bytes = archive.finish();
    write_with(output, source, |out| Ok(out.write_all(&bytes)?))?;
    if scene.stepping.input == StepInput::Linear {
        progress::say(
            "frictiongen: the scene has linear input, so set the sample at the end of a step before fmi3DoStep; add `input: hold` for an importer that sets the sample at its start\n",
        );
    }
    Ok(())
}

/// Returns the length of the stepper's step in s, in the precision of the binary.
fn step(scene: &Scene) -> Result<f64, Failure> {
    if !scene.provides(&Provide::Stepper) {
        return Err(Failure::new(
            "an FMU needs a stepper, which the description does not provide; add `stepper` to its `provide`, for example `provide: [stepper]`, and `step: 1e-3`",
        ));
    }
    let Some(step) = scene.stepping.step else {
        return Err(Failure::new(
            "an FMU has a constant step, which the description does not give; add its length in seconds, for example `step: 1e-3`",
        ));
    };
    Ok(match scene.precision {
        Precision::F64 => step,
        Precision::F32 => f64::from(step as f32),
    })
}

/// Returns the folder in which the command writes the crate of the FMU. For `frame.fmu` this folder is `frame_fmu`,
/// next to the file.
fn folder(output: &Path) -> Result<PathBuf, Failure> {
    match (output.file_stem(), output.extension()) {
        (Some(stem), Some(ending)) if ending.eq_ignore_ascii_case("fmu") => {
            let mut name = stem.to_os_string();
            name.push("_fmu");
            Ok(output.with_file_name(name))
        }
        _ => Err(Failure::new(format_args!(
            "cannot write the FMU {}: its name must end in .fmu, for example -o frame.fmu",
            output.display()
        ))),
    }
}

/// Returns the name of this machine's platform in FMI 3.0.
fn platform() -> String {
    let architecture = if ARCH == "arm" { "aarch32" } else { ARCH };
    let system = if OS == "macos" { "darwin" } else { OS };
    format!("{architecture}-{system}")
}

/// Builds the crate of the FMU with cargo. Returns the path of the binary.
fn build(folder: &Path) -> Result<PathBuf, Failure> {
    progress::say(&format!("frictiongen: cargo builds {}\n", folder.display()));
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let run = Command::new(cargo)
        .args(["build", "--release", "--quiet"])
        .arg("--message-format=json-render-diagnostics")
        .current_dir(folder)
        .stderr(Stdio::inherit())
        .output()
        .map_err(|error| {
            Failure::new(format_args!(
                "cannot start cargo, which builds the FMU: {}; install Rust, or set the variable CARGO to the path of cargo",
                reason(&error)
            ))
        })?;
    let binary = String::from_utf8_lossy(&run.stdout)
        .lines()
        .find_map(binary);
    binary.filter(|_| run.status.success()).ok_or_else(|| {
        Failure::new(format_args!(
            "cargo cannot build the crate in {}, and its own message above says why; without a registry, give the folder of the library by --library",
            folder.display()
        ))
    })
}

/// Returns the path of the shared library, if this line of cargo's output contains the path.
fn binary(line: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(line).ok()?;
    let kinds = message.get("target")?.get("kind")?.as_array()?;
    if !kinds.iter().any(|kind| kind == "cdylib") {
        return None;
    }
    let names = message.get("filenames")?.as_array()?.iter();
    let mut paths = names.filter_map(|name| Some(PathBuf::from(name.as_str()?)));
    paths.find(|path| {
        path.extension()
            .is_some_and(|ending| ending == DLL_EXTENSION)
    })
}

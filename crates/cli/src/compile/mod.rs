//! `frictiongen compile`: builds tables of a declared accuracy. The command prints a summary of the tables, or writes
//! the tables as code or data.

pub mod command;
mod data;

use crate::args::{CompileArguments, TableFormat};
use crate::failure::Failure;
use crate::file::write_file;
use crate::progress;
use frictiongen::System;
use frictiongen::study::InvalidScene;
use frictiongen::study::columns::FrequencyUnit;
use frictiongen::study::scene::{Accuracy, Declared, Proving, Range, Scene, Side};
use frictiongen::study::table::{Evidence, FINEST_PROVEN, Proof, ProofWork, Tables};
use frictiongen_codegen::standalone::{
    Origin, Source, c_header, c_name, c_source, c_tables, c_tables_name, left_out, rust_source,
};
use frictiongen_codegen::{SceneTables, SizeLimits};
use std::io::Write;
use std::path::Path;

/// Size limits for a scene description: those of the macro, but without tables. The command builds the tables itself,
/// with the accuracy from its options.
const LIMITS: SizeLimits = SizeLimits {
    tables: false,
    ..SizeLimits::MACRO
};

/// Error message if the accuracy of the tables is missing.
const NO_ACCURACY: &str = "the accuracy of the tables is missing; give --accuracy 1e-4 or --budget 4096, or declare one of the two in the description";

/// Runs `frictiongen compile`.
pub fn run(arguments: &CompileArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let (description, text) = arguments.file.constant_level_with_text(&LIMITS)?;
    arguments.file.check_rigid(&description)?;
    let mut scene = description.scene;
    declare(&mut scene, arguments)?;
    let name = c_prefix(&scene, arguments)?;
    let mut tables = SceneTables::of(&scene).map_err(Failure::new)?;
    if let Some(tables) = tables.as_mut().filter(|_| arguments.prove) {
        tables.prove(&scene, ProofWork::WHOLE);
    }
    let command = command::written(arguments);
    let origin = Origin {
        description: &text,
        command: &command,
    };
    let scene = &scene;
    match &tables {
        Some(SceneTables::Double(tables)) => {
            let source = Source {
                scene,
                tables,
                origin,
            };
            write(&source, (arguments, &name), out)?;
        }
        Some(SceneTables::Single(tables)) => {
            let source = Source {
                scene,
                tables,
                origin,
            };
            write(&source, (arguments, &name), out)?;
        }
        None => return Err(Failure::new(NO_ACCURACY)),
    }
    if arguments.format.is_some() {
        say_what_is_left_out(scene);
    }
    Ok(())
}

/// Returns the prefix of all names in the emitted C code.
fn c_prefix(scene: &Scene, arguments: &CompileArguments) -> Result<String, Failure> {
    let Some(name) = &arguments.name else {
        return Ok(c_name(scene));
    };
    if arguments.format != Some(TableFormat::C) {
        return Err(Failure::new(
            "--name is the prefix of names in C; add --format c, or leave --name out",
        ));
    }
    let is_letter = |letter: char| letter.is_ascii_alphabetic() || letter == '_';
    let sound =
        name.starts_with(is_letter) && name.chars().all(|c| is_letter(c) || c.is_ascii_digit());
    if !sound {
        return Err(Failure::new(format_args!(
            "--name is `{name}`, which cannot begin a name in C; write letters, digits and underscores, for example frame_fine"
        )));
    }
    Ok(name.clone())
}

/// Prints a line on standard error that lists the items of the field `provide` that the emitted files do not contain.
fn say_what_is_left_out(scene: &Scene) {
    let left_out = left_out(scene);
    if !left_out.is_empty() {
        progress::say(&format!(
            "frictiongen: `compile` leaves out {} of `provide`, because it writes only limits, the motion of the contact and stuck responses; use the macro or the library for the rest\n",
            left_out.join(", ")
        ));
    }
}

/// Replaces the accuracy, range and side of the scene description by those from the options. On the safe side, β_lim is
/// never above its exact value, and β*_lim never below.
fn declare(scene: &mut Scene, arguments: &CompileArguments) -> Result<(), Failure> {
    let declared = &mut scene.declared;
    // Only the option --prove requests a proof of the accuracy here. The field `proof` of the scene description applies
    // only to the macro.
    declared.proof = Proving::Quick;
    if let Some(accuracy) = &arguments.accuracy {
        declared.accuracy = Accuracy::Relative(number(accuracy, "--accuracy")?);
        declared.budget = None;
    }
    if let Some(bytes) = &arguments.budget {
        declared.budget = Some(number(bytes, "--budget")?);
        declared.accuracy = Accuracy::Exact;
    }
    let beta = declared
        .range
        .map_or((0.0, f64::INFINITY), |range| range.beta);
    if let Some(r) = range(scene, arguments)? {
        scene.declared.range = Some(Range { r, beta });
    }
    if scene.declared.accuracy == Accuracy::Exact && scene.declared.budget.is_none() {
        // A scene description with a range but without an accuracy has an error of its own. The message of that error
        // would not mention the options.
        return Err(Failure::new(NO_ACCURACY));
    }
    if arguments.safe {
        scene.declared.side = Side::Safe;
    }
    let checked: Result<System, _> = System::try_from(scene.clone());
    let told = |error: InvalidScene| {
        let lines = error
            .errors
            .iter()
            .map(|error| format!("frictiongen: {error}"));
        Failure::Lines(lines.collect())
    };
    checked.map(drop).map_err(told)
}

/// Returns the range of the frequency ratio r from --r, --hz or --omega, or `None` without these options.
fn range(scene: &Scene, arguments: &CompileArguments) -> Result<Option<(f64, f64)>, Failure> {
    let options = [
        (&arguments.r, "--r", FrequencyUnit::Ratio, "0.2:2.5"),
        (&arguments.hz, "--hz", FrequencyUnit::Hertz, "1:7"),
        (
            &arguments.omega,
            "--omega",
            FrequencyUnit::AngularFrequency,
            "6:45",
        ),
    ];
    let given = options
        .into_iter()
        .find_map(|(text, option, unit, example)| Some((text.as_deref()?, option, unit, example)));
    let Some((text, option, unit, example)) = given else {
        return Ok(None);
    };
    let ends = text.split_once(':').filter(|(_, high)| !high.contains(':'));
    let Some((low, high)) = ends else {
        return Err(Failure::new(format_args!(
            "{option} is `{text}`, which is not a range a:b; write, for example, {example}"
        )));
    };
    let (low, high) = (number(low, option)?, number(high, option)?);
    if unit == FrequencyUnit::Ratio {
        return Ok(Some((low, high)));
    }
    // A scene description may declare an accuracy without a range, which is an error for the macro. The conversion to r
    // needs only the chain.
    let chain = Scene {
        declared: Declared::default(),
        ..scene.clone()
    };
    let system = System::try_from(chain).map_err(Failure::new)?;
    let ratio = |value: f64| unit.given(&system, value).r;
    Ok(Some((ratio(low), ratio(high))))
}

fn number(text: &str, option: &str) -> Result<f64, Failure> {
    text.trim().parse().map_err(|_| {
        Failure::new(format_args!(
            "{option} is `{text}`, which is not a number; write, for example, 1e-4"
        ))
    })
}

fn write<S: frictiongen::scalar::Float>(
    source: &Source<'_, S>,
    (arguments, name): (&CompileArguments, &str),
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let Source { scene, tables, .. } = *source;
    let path = arguments.output.as_deref();
    let no_form = || {
        Failure::new(
            "beta*_lim has no table here, because only the exact formulas keep the accuracy; use the macro or the library",
        )
    };
    let is_code = matches!(arguments.format, Some(TableFormat::Rust | TableFormat::C));
    if is_code && tables.sliding.is_some() && tables.request.stuck && tables.held.is_none() {
        return Err(Failure::new(
            "the stuck responses have no table here: their zeros are too close together, their rounding errors exceed half the accuracy, or they need more than a quarter of the bytes; leave `stuck` out of `provide`, or use the macro or the library",
        ));
    }
    let text = match arguments.format {
        None => figures(scene, tables, arguments.prove),
        Some(TableFormat::Rust) => rust_source(source).ok_or_else(no_form)?,
        Some(TableFormat::Json) => format!("{}\n", data::written(source)),
        Some(TableFormat::C) => {
            let header = path.map(|path| path.with_extension("h"));
            let file = header.as_deref().and_then(Path::file_name);
            let file = file.map(|file| file.to_string_lossy());
            let code = c_source(source, name, file.as_deref()).ok_or_else(no_form)?;
            if let (Some(header), Some(file)) = (&header, &file) {
                let numbers = c_tables(source, name).ok_or_else(no_form)?;
                let beside = header.with_file_name(c_tables_name(file));
                let description = arguments.file.path();
                write_file(header, description, &c_header(source, name))?;
                write_file(&beside, description, &numbers)?;
            }
            code
        }
    };
    match path {
        Some(path) => write_file(path, arguments.file.path(), &text),
        None => {
            out.write_all(text.as_bytes())?;
            Ok(out.flush()?)
        }
    }
}

/// Returns a sentence about the accuracy of the tables. Without a proof, errors between the checked points may be
/// larger.
fn told<S: frictiongen::scalar::Float>(tables: &Tables<S>, proof: &Proof, proves: bool) -> String {
    if proves || proof.evidence != Evidence::Checked {
        return proof.told_in::<S>();
    }
    let points = tables.report.points;
    let remedy = if FINEST_PROVEN <= tables.request.accuracy {
        "; --prove proves it".to_owned()
    } else {
        format!("; --prove proves accuracies down to {FINEST_PROVEN:e}")
    };
    format!("Checked at {points} points, not proven: between them an error may be larger{remedy}.")
}

/// Returns the summary of the tables as text, one number in each line. `proves` is true if the user has requested a
/// proof.
fn figures<S: frictiongen::scalar::Float>(
    scene: &Scene,
    tables: &Tables<S>,
    proves: bool,
) -> String {
    let report = &tables.report;
    let (low, high) = tables.request.r;
    let sliding = match &tables.sliding {
        Some(product) => {
            let (plain, divisions, roots) = product.operations();
            format!(
                "{}  {plain} additions and multiplications, {divisions} divisions, {roots} roots",
                tables.sliding_proof.told_in::<S>()
            )
        }
        None => "by the exact formulas".to_owned(),
    };
    let motion = if tables.moves() {
        format!(
            "motion          {}\n",
            told(tables, &tables.motion_proof, proves)
        )
    } else {
        String::new()
    };
    let stuck = match &tables.held {
        Some(held) => {
            let (plain, divisions) = held.most_operations();
            format!(
                "stuck           {}  At most {plain} additions and multiplications and {divisions} divisions a mass; {} bytes\n",
                held.told(),
                held.bytes(),
            )
        }
        None if tables.request.stuck => "stuck           by the exact formulas\n".to_owned(),
        None => String::new(),
    };
    let reach = tables.declared_reach(scene);
    let most = scene.declared.range.map_or(0.0, |range| range.beta.1);
    let regimes = match (reach.always_continuous, reach.never_stuck) {
        (true, true) => {
            format!("regimes         continuous at every r, for every beta up to {most}\n")
        }
        (true, false) => {
            format!(
                "regimes         continuous or bistable at every r, for every beta up to {most}\n"
            )
        }
        (false, true) => {
            format!(
                "regimes         continuous or stick-slip at every r, for every beta up to {most}\n"
            )
        }
        (false, false) => String::new(),
    };
    let functions = match tables.functions {
        5 => "beta_lim, a, g, arg V and |V|",
        4 => "beta_lim, a, g and arg V",
        2 => "beta_lim and a sgn V",
        _ => "beta_lim",
    };
    let side = match tables.request.side {
        Side::Near => "",
        Side::Safe => ", never above",
    };
    format!(
        "scene           {}\n\
         range           r from {low} to {high}\n\
         accuracy        {:e}{side}\n\
         table           {functions}: {} pieces of degree {}, {} buckets\n\
         bytes           {}\n\
         largest error   {:.2e} at r = {}, checked at {} points that the fit did not see\n\
         beta_lim        {}\n\
         {motion}\
         lookup          {} comparisons, then {} additions and multiplications a function\n\
         sliding limit   {sliding}\n\
         {stuck}\
         {regimes}\
         built from      {} exact values\n",
        scene.name,
        tables.request.accuracy,
        tables.pieces.len(),
        tables.terms - 1,
        tables.index.buckets.len(),
        report.bytes,
        report.worst.error,
        report.worst.at,
        report.points,
        told(tables, &tables.proof, proves),
        tables.index.halvings,
        tables.additions_and_multiplications(),
        report.evaluations,
    )
}

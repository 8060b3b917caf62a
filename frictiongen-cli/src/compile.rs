//! `frictiongen compile`: tables of a declared accuracy, their figures, or them as code or data.

use crate::args::{CompileArguments, TableFormat};
use crate::failure::Failure;
use crate::file::write_file;
use frictiongen::System;
use frictiongen::kernel::table::{Factor, Root};
use frictiongen::study::InvalidScene;
use frictiongen::study::scene::{Accuracy, Proving, Range, Scene, Side};
use frictiongen::study::table::{HeldForm, Product, Proof, Tables, Work};
use frictiongen_codegen::standalone::{c_header, c_source, rust_source};
use frictiongen_codegen::{Limits, SceneTables};
use serde_json::{Value, json};
use std::io::Write;
use std::path::Path;

/// What a macro takes, without the tables, which are built with the options.
const LIMITS: Limits = Limits {
    tables: false,
    ..Limits::MACRO
};

/// Runs the command.
pub fn run(arguments: &CompileArguments, out: &mut dyn Write) -> Result<(), Failure> {
    let mut scene = arguments.file.constant_level(&LIMITS)?.scene;
    declare(&mut scene, arguments)?;
    let tables = SceneTables::of(&scene).map_err(Failure::new)?;
    match tables.map(|tables| tables.proven(&scene, Work::WHOLE)) {
        Some(SceneTables::Double(tables)) => write(&scene, &tables, arguments, out),
        Some(SceneTables::Single(tables)) => write(&scene, &tables, arguments, out),
        None => Err(Failure::new(
            "how exact the tables are to be is not said: give --accuracy 1e-4 or --budget 4096, or write it in the description",
        )),
    }
}

/// What the options say in place of the description.
fn declare(scene: &mut Scene, arguments: &CompileArguments) -> Result<(), Failure> {
    let declared = &mut scene.declared;
    // This command looks for the whole proof in any case.
    declared.proof = Proving::Quick;
    if let Some(accuracy) = &arguments.accuracy {
        declared.accuracy = Accuracy::Relative(number(accuracy, "--accuracy")?);
        declared.budget = None;
    }
    if let Some(bytes) = &arguments.budget {
        declared.budget = Some(number(bytes, "--budget")?);
        declared.accuracy = Accuracy::Exact;
    }
    if let Some(r) = &arguments.r {
        let ends = r.split_once(':').filter(|(_, high)| !high.contains(':'));
        let Some((low, high)) = ends else {
            return Err(Failure::new(format_args!(
                "--r is `{r}`, which is no range a:b; write, for example, 0.2:2.5"
            )));
        };
        let beta = declared
            .range
            .map_or((0.0, f64::INFINITY), |range| range.beta);
        let r = (number(low, "--r")?, number(high, "--r")?);
        declared.range = Some(Range { r, beta });
    }
    if arguments.safe {
        declared.side = Side::Safe;
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

fn number(text: &str, option: &str) -> Result<f64, Failure> {
    text.trim().parse().map_err(|_| {
        Failure::new(format_args!(
            "{option} has `{text}`, which is no number; write, for example, 1e-4"
        ))
    })
}

fn write<S: frictiongen::kernel::Float>(
    scene: &Scene,
    tables: &Tables<S>,
    arguments: &CompileArguments,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    let path = arguments.output.as_deref();
    let no_form = || {
        Failure::new(
            "beta*_lim has no form of its own here: only the exact formulas keep the accuracy; use the macro or the library",
        )
    };
    let is_code = matches!(arguments.format, Some(TableFormat::Rust | TableFormat::C));
    if is_code && tables.sliding.is_some() && tables.request.stuck && tables.held.is_none() {
        return Err(Failure::new(
            "the stuck responses have no form of their own here: their zeros cannot be told apart, their roundings are more than half the accuracy, or they take more than a quarter of the bytes; leave `stuck` out of `provide`, or use the macro or the library",
        ));
    }
    let text = match arguments.format {
        None => figures(scene, tables),
        Some(TableFormat::Rust) => rust_source(scene, tables).ok_or_else(no_form)?,
        Some(TableFormat::Json) => format!("{}\n", data(scene, tables)),
        Some(TableFormat::C) => {
            let header = path.map(|path| path.with_extension("h"));
            let name = header
                .as_deref()
                .and_then(Path::file_name)
                .map(|name| name.to_string_lossy());
            let source = c_source(scene, tables, name.as_deref()).ok_or_else(no_form)?;
            if let Some(header) = &header {
                write_file(header, arguments.file.path(), &c_header(scene, tables))?;
            }
            source
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

/// The figures, one a line.
fn figures<S: frictiongen::kernel::Float>(scene: &Scene, tables: &Tables<S>) -> String {
    let report = &tables.report;
    let (low, high) = tables.request.r;
    let sliding = match &tables.sliding {
        Some(product) => {
            let (plain, divisions, roots) = product.operations();
            format!(
                "{}  {plain} additions and multiplications, {divisions} divisions, {roots} roots",
                tables.sliding_proof.told()
            )
        }
        None => "by the exact formulas".to_owned(),
    };
    let motion = if tables.moves() {
        format!("motion          {}\n", tables.motion_proof.told())
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
        (true, _) => {
            format!("regimes         continuous at every r, for every beta up to {most}\n")
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
        tables.proof.told(),
        tables.index.halvings,
        tables.additions_and_multiplications(),
        report.evaluations,
    )
}

/// The tables as data.
fn data<S: frictiongen::kernel::Float>(scene: &Scene, tables: &Tables<S>) -> Value {
    let value = |value: S| value.to_f64();
    let factor = |factor: &Factor<S>| match *factor {
        Factor::Zero { at, rest } => json!({ "zero": [value(at), value(rest)] }),
        Factor::Pair {
            at,
            rest,
            off,
            least,
        } => json!({ "pair": [value(at), value(rest), value(off), value(least)] }),
        Factor::Real { off } => json!({ "real": [value(off)] }),
    };
    let product = |product: &Option<Product<S>>| match product {
        None => Value::Null,
        Some(product) => json!({
            "gain": value(product.gain),
            "squared": product.squared,
            "numerator": product.numerator.iter().map(factor).collect::<Vec<_>>(),
            "denominator": product.denominator.iter().map(factor).collect::<Vec<_>>(),
        }),
    };
    let root = |root: &Root<S>| match *root {
        Root::Pair {
            at,
            rest,
            off,
            rate,
        } => json!({ "pair": [value(at), value(rest), value(off), value(rate)] }),
        Root::Real { rate } => json!({ "real": [value(rate)] }),
    };
    let form = |form: &HeldForm<S>| match form {
        HeldForm::Fixed(amplitude) => json!({ "fixed": value(*amplitude) }),
        HeldForm::Undamped(own) => json!({ "undamped": product(&Some(own.clone())) }),
        HeldForm::Damped {
            gain,
            numerator,
            denominator,
        } => json!({ "damped": {
            "gain": value(*gain),
            "numerator": numerator.iter().map(root).collect::<Vec<_>>(),
            "denominator": denominator.iter().map(root).collect::<Vec<_>>(),
        } }),
    };
    let stuck = tables.held.as_ref().map(|held| {
        let named = scene.masses.iter().zip(&held.masses);
        let masses = named.map(|(mass, own)| (mass.name.clone(), form(own)));
        json!({
            "masses": Value::Object(masses.collect()),
            "contact_force": form(&held.force),
            "resonances": held.resonances.iter().map(|own| value(*own)).collect::<Vec<_>>(),
            "largest_error": { "value": held.worst.error, "r": held.worst.at },
            "checked_points": held.points,
        })
    });
    let pieces = tables.pieces.iter().map(|piece| {
        let of = piece.coefficients.iter();
        let of = of.map(|of| of.iter().map(|c| value(*c)).collect::<Vec<f64>>());
        json!({
            "from": value(piece.from),
            "origin": value(piece.origin),
            "coefficients": of.collect::<Vec<_>>(),
        })
    });
    let functions = ["beta_lim", "a", "g", "arg_V", "abs_V"];
    let functions = functions.get(..tables.functions).unwrap_or_default();
    json!({
        "version": 1,
        "scene": scene.name,
        "range": { "r": [tables.request.r.0, tables.request.r.1] },
        "accuracy": tables.request.accuracy,
        "side": if tables.request.side == Side::Safe { "safe" } else { "near" },
        "functions": functions,
        "index": {
            "low": value(tables.index.low),
            "density": value(tables.index.density),
            "halvings": tables.index.halvings,
            "buckets": tables.index.buckets,
        },
        "pieces": pieces.collect::<Vec<_>>(),
        "sliding_limit": product(&tables.sliding),
        "excitation": product(&tables.excitation),
        "stuck": stuck,
        "bytes": tables.report.bytes,
        "largest_error": { "value": tables.report.worst.error, "r": tables.report.worst.at },
        "checked_points": tables.report.points,
        "proof": proof(&tables.proof),
        "sliding_proof": proof(&tables.sliding_proof),
        "excitation_proof": proof(&tables.excitation_proof),
        "motion_proof": proof(&tables.motion_proof),
    })
}

/// What is proven, as data.
fn proof(proof: &Proof) -> Value {
    json!({
        "evidence": proof.evidence.word(),
        "bound": { "value": proof.bound.error, "r": proof.bound.at },
        "open": proof.open,
        "work": proof.work.0,
    })
}

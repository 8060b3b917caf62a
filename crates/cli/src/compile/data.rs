//! Writes the tables of `frictiongen compile` as JSON.

use frictiongen::kernel::table::{Factor, Root};
use frictiongen::study::scene::{Scene, Side};
use frictiongen::study::table::{HeldForm, Product, Proof, Tables};
use frictiongen_codegen::known::{KnownAnswers, MotionAnswers, MotionKind};
use frictiongen_codegen::standalone::{NOTICE, Source, UnitConstants, known_answers, scene_hash};
use serde_json::{Value, json};

/// Returns the tables as JSON. The first fields name the scene description and the command.
pub(super) fn written<S: frictiongen::scalar::Float>(source: &Source<'_, S>) -> String {
    let Source {
        scene,
        tables,
        origin,
    } = source;
    let generated = json!({
        "by": format!("frictiongen {}", env!("CARGO_PKG_VERSION")),
        "command": origin.command,
        "description": origin.description,
        "notice": NOTICE,
        "scene_hash": scene_hash(scene),
    });
    let data = [of(scene, tables), units::<S>(scene), known(source)];
    let [tables, units, known] = data.map(|value| shortened::<S>(value).to_string());
    let tables = tables.strip_prefix('{').unwrap_or(&tables);
    format!("{{\"generated\":{generated},\"units\":{units},\"known_answers\":{known},{tables}")
}

/// Shortens the numbers of tables in `f32`. Each number keeps only as many digits as a reader needs to get the same
/// `f32`.
fn shortened<S: frictiongen::scalar::Float>(value: Value) -> Value {
    if S::EPSILON <= f64::EPSILON {
        return value;
    }
    match value {
        Value::Number(number) if number.is_f64() => {
            let short = number.as_f64().and_then(shortest);
            short.map_or(Value::Number(number), Value::from)
        }
        Value::Array(values) => values.into_iter().map(shortened::<S>).collect(),
        Value::Object(fields) => {
            let fields = fields.into_iter();
            let fields = fields.map(|(name, value)| (name, shortened::<S>(value)));
            Value::Object(fields.collect())
        }
        other => other,
    }
}

/// Returns the `f64` with the fewest digits that rounds to the same `f32`. Returns `None` for a number that is no `f32`.
fn shortest(value: f64) -> Option<f64> {
    #[allow(clippy::cast_possible_truncation, reason = "the next line compares")]
    let single = value as f32;
    if f64::from(single) != value {
        return None;
    }
    let short: f64 = format!("{single:?}").parse().ok()?;
    #[allow(clippy::cast_possible_truncation, reason = "a reader does the same")]
    let read = short as f32;
    (read == single).then_some(short)
}

/// Returns, as JSON, the constants that convert between non-dimensional ratios and physical units.
fn units<S: frictiongen::scalar::Float>(scene: &Scene) -> Value {
    let units = UnitConstants::of::<S>(scene);
    json!({
        "k1": { "value": units.k1, "unit": "N/m", "spring": units.spring },
        "m1": { "value": units.m1, "unit": "kg", "mass": units.mass },
        "reference_frequency": { "value": units.reference, "unit": "rad/s" },
        "natural_frequencies": { "value": units.hertz, "unit": "Hz" },
        "resonances": units.resonances,
    })
}

/// Returns, as JSON, the known answers with which a reader can check an evaluation of the tables.
fn known<S: frictiongen::scalar::Float>(source: &Source<'_, S>) -> Value {
    let (tolerance, all) = known_answers(source);
    let motion = |motion: &MotionAnswers| {
        let answers = (motion.outcome == MotionKind::Continuous).then_some(motion.contact);
        json!({
            "beta": motion.beta,
            "regime": match motion.outcome {
                MotionKind::Continuous => "continuous",
                MotionKind::StickSlip => "stick-slip",
                MotionKind::Stuck => "stuck",
            },
            "amplitude": answers.map(|[amplitude, _]| amplitude),
            "phase": answers.map(|[_, phase]| phase),
        })
    };
    let points = all.iter().map(|known: &KnownAnswers| {
        let (force, masses) = known.stuck.split_last().unzip();
        json!({
            "r": known.r,
            "beta_lim": known.continuous,
            "sliding_limit": known.sliding,
            "contact": known.motion.as_ref().map(motion),
            "stuck_masses": masses,
            "contact_force": force,
        })
    });
    json!({ "tolerance": tolerance, "points": points.collect::<Vec<_>>() })
}

/// Converts the tables of a scene to JSON.
fn of<S: frictiongen::scalar::Float>(scene: &Scene, tables: &Tables<S>) -> Value {
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

/// Converts the proofs of the tables to JSON.
fn proof(proof: &Proof) -> Value {
    json!({
        "evidence": proof.evidence.word(),
        "bound": { "value": proof.bound.error, "r": proof.bound.at },
        "open": proof.open,
        "work": proof.work.0,
    })
}

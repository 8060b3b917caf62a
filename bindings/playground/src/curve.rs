//! Answers questions about the amplitude over frequency of a scene with one contact.

use crate::question::{Question, picture};
use frictiongen::study::curve::{Curve, CurveRequest, CurveStart};
use frictiongen::{Of, System};
use frictiongen_plot::Colour;
use frictiongen_plot::desk::{Drawn, Reading, Scales, lines, panel};
use serde_json::{Value, json};

/// Height of the frame of a curve's picture, in pixels.
pub const HEIGHT: f64 = 230.0;
/// Largest deviation of the drawn lines from the curve, relative to the value of the curve.
const ACCURACY: f64 = 5e-3;

/// Returns the picture of the amplitude curves, one for each start in the question, and the points of the curves.
pub fn answer(question: &Question) -> Result<Value, String> {
    let system = question.system()?;
    let of = question.motion();
    let mut curves = Vec::new();
    for start in &question.starts {
        curves.push(asked(&system, question, question.beta, start)?);
    }
    // For comparison, the picture contains the curve without friction.
    let free = asked(&system, question, 0.0, "rest")?;
    let refined = curves.iter().all(|curve| curve.refined);
    let points: Vec<Value> = curves.iter().map(points).collect();
    if question.bare {
        return Ok(json!({ "curves": points, "refined": refined }));
    }
    let scales = Scales::groups(&system).showing(of);
    let drawn: Vec<Drawn<'_>> = curves
        .iter()
        .zip(&question.starts)
        .enumerate()
        .map(|(index, (curve, start))| Drawn {
            curve,
            name: match start.as_str() {
                "up" => "swept up".into(),
                "down" => "swept down".into(),
                _ => "with friction".into(),
            },
            colour: Colour::Series(index),
        })
        .collect();
    let mut panel = panel("", &drawn, 0, Reading::Amplitude, &scales);
    let without = Drawn {
        curve: &free,
        name: "without friction".into(),
        colour: Colour::Grey,
    };
    for layer in lines(&without, 0, Reading::Amplitude, &scales) {
        panel = panel.with(layer);
    }
    let mut drawing = picture(panel, HEIGHT);
    if let Some(fields) = drawing.as_object_mut() {
        fields.insert("curves".into(), json!(points));
        fields.insert("refined".into(), json!(refined));
    }
    Ok(drawing)
}

fn asked(system: &System, question: &Question, beta: f64, start: &str) -> Result<Curve, String> {
    let mut request = CurveRequest::new(question.from, question.to, &[question.motion()]);
    request.accuracy = ACCURACY;
    request.work = question.work;
    request.start = match start {
        "up" => CurveStart::Up,
        "down" => CurveStart::Down,
        _ => CurveStart::Rest,
    };
    if question.motion() == Of::Contact {
        request.turned = system.contact_is_reversed();
    }
    system
        .curve(&request, beta)
        .map_err(|error| error.to_string())
}

/// Returns frequency ratio, amplitude and regime of each point of a curve.
fn points(curve: &Curve) -> Value {
    let points = curve.pieces.iter().flat_map(|piece| &piece.points);
    let told = points.map(|point| {
        let movement = point.movements.first();
        let amplitude = movement.map(|movement| movement.swing.amplitude);
        json!([point.r, amplitude, crate::orbit::code(point.regime)])
    });
    Value::Array(told.collect())
}

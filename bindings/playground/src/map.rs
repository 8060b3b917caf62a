//! Answers questions about the regimes over frequency and friction of a scene with one contact.

use crate::question::{Question, picture};
use frictiongen::Regime;
use frictiongen_plot::Colour;
use frictiongen_plot::desk::{Scales, limit_lines, regimes};
use serde_json::{Value, json};

/// Height of the frame of a map's picture, in pixels.
pub const HEIGHT: f64 = 260.0;
/// Largest deviation of the drawn limits from the exact limits, measured in β/(1 + β) with the friction ratio β.
const ACCURACY: f64 = 2e-3;

/// Returns the picture of the limits β_lim and β*_lim over frequency, and of the regimes between them.
pub fn answer(question: &Question) -> Result<Value, String> {
    let system = question.system()?;
    let lines = system
        .limit_lines(question.from, question.to, ACCURACY)
        .map_err(|error| error.to_string())?;
    let mut limits: Vec<f64> = lines.points.iter().map(|point| point.1.sliding).collect();
    let top = question.top.unwrap_or_else(|| top(&mut limits));
    let scales = Scales::groups(&system);
    let mut panel = regimes("", &lines, top, &scales);
    for line in limit_lines(&lines, top, &scales, Colour::Black) {
        panel = panel.with(line);
    }
    let mut drawing = picture(panel, HEIGHT);
    if let Some(fields) = drawing.as_object_mut() {
        fields.insert("top".into(), json!(top));
    }
    Ok(drawing)
}

/// Returns a friction ratio above most of the limits, for the upper end of a map. Limits near resonances, which may
/// be infinite, do not affect it.
pub fn top(limits: &mut [f64]) -> f64 {
    limits.sort_by(f64::total_cmp);
    let most = limits.get(limits.len() * 17 / 20).copied().unwrap_or(1.0);
    let top = 1.1 * most;
    if 0.0 < top && top.is_finite() {
        top
    } else {
        1.0
    }
}

/// Names of the regimes. The page refers to a regime by its index in this list.
pub const REGIMES: [&str; 3] = ["continuous", "stick-slip", "stuck"];

/// Returns the index of a regime in [`REGIMES`].
pub fn class(regime: Regime) -> usize {
    match regime {
        Regime::Continuous => 0,
        Regime::Stuck => 2,
        _ => 1,
    }
}

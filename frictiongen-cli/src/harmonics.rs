//! Writes harmonics: amplitude and lag, and in JSON also real and imaginary part.

use crate::json::object;
use crate::measure::{Dimension, Measure};
use crate::number::{Cell, Exact as _};
use crate::table::Column;
use frictiongen::Complex;
use frictiongen::study::units::polar;
use serde_json::Value as Json;

/// Returns the columns of the table.
pub fn columns(orders: &[u32], measure: &Measure) -> Vec<Column> {
    let (unit, angle) = (
        measure.title(Dimension::Length),
        measure.title(Dimension::Angle),
    );
    let both = |order: &u32| {
        [
            Column::computed(&[&format!("|X_{order}|"), unit]),
            Column::computed(&[&format!("lag X_{order}"), angle]),
        ]
    };
    orders.iter().flat_map(both).collect()
}

/// Returns the names of the CSV columns.
pub fn names(part: &str, orders: &[u32], measure: &Measure) -> Vec<String> {
    let both = |order: &u32| {
        [
            measure.name(&format!("{part}.X{order}.amplitude"), Dimension::Length),
            measure.name(&format!("{part}.X{order}.phase"), Dimension::Angle),
        ]
    };
    orders.iter().flat_map(both).collect()
}

/// Returns the cells of a harmonic.
pub fn values(harmonic: Complex<f64>, measure: &Measure) -> [Cell<'static>; 2] {
    let (amplitude, phase) = polar(harmonic);
    [
        measure.length(amplitude).into(),
        measure.angle(phase).into(),
    ]
}

/// Returns a JSON list of harmonics.
pub fn json(orders: &[u32], harmonics: &[Complex<f64>], measure: &Measure) -> Json {
    let lengths = ["re", "im", "amplitude"].map(|name| measure.name(name, Dimension::Length));
    let angle = measure.name("phase", Dimension::Angle);
    let [re, im, amplitude] = &lengths;
    let harmonics = orders.iter().zip(harmonics).map(|(order, harmonic)| {
        let length = |value: f64| Cell::from(measure.length(value)).json();
        let [size, lag] = values(*harmonic, measure);
        Json::Object(object([
            ("n", Json::from(*order)),
            (re, length(harmonic.re)),
            (im, length(harmonic.im)),
            (amplitude, size.json()),
            (&angle, lag.json()),
        ]))
    });
    harmonics.collect()
}

//! `docs/trade.svg`: accuracy against cost, with the Pareto front.

use crate::measure::{By, Row};
use crate::methods::Method;
use crate::tables::{Pool, pools};
use plotters::prelude::*;
use std::path::Path;

const SIZE: (u32, u32) = (1500, 884);
const LEGEND: u32 = 84;
const MASSES: [usize; 4] = [1, 2, 5, 10];
/// Below, an error is drawn at the border.
const LEAST_ERROR: f64 = 1e-17;
const MOST_ERROR: f64 = 10.0;
const TIMES: (f64, f64) = (1.0, 1e11);

const WAYS: [By; 11] = [
    By::Double,
    By::Single,
    By::RunTime,
    By::Hand,
    By::Textbook,
    By::Balance(1),
    By::Balance(3),
    By::Balance(9),
    By::Balance(25),
    By::Stepper,
    By::Table(TABLES[0]),
];
/// The exponents of the tables from coarse to fine.
const TABLES: [u8; 6] = [2, 3, 4, 6, 9, 12];

fn colour(by: By) -> RGBColor {
    match by {
        By::Double => RGBColor(0, 90, 180),
        By::Single => RGBColor(0, 160, 220),
        By::RunTime => RGBColor(0, 140, 90),
        By::Hand => RGBColor(210, 40, 30),
        By::Textbook => RGBColor(120, 70, 30),
        By::Balance(1) => RGBColor(250, 190, 90),
        By::Balance(3) => RGBColor(240, 150, 40),
        By::Balance(9) => RGBColor(210, 110, 10),
        By::Balance(_) => RGBColor(150, 75, 0),
        By::Stepper => RGBColor(130, 60, 160),
        By::Table(_) => RGBColor(220, 0, 120),
        By::Before => RGBColor(128, 128, 128),
    }
}

/// In the legend.
fn named(by: By) -> String {
    match by {
        By::Table(_) => format!("tables, 1e-{} to 1e-{}", TABLES[0], TABLES[5]),
        other => other.name(),
    }
}

/// What stands beside a mark.
fn short(method: Method) -> &'static str {
    match method {
        Method::Limits => "exact S",
        Method::WithoutSearch => "no search",
        Method::PerMode => "per mode",
        Method::Amplitude => "exact",
        Method::Monoharmonic => "monoharm.",
        Method::Fundamental => "fundam.",
        Method::Contact => "contact",
        Method::Orbit => "stops",
    }
}

fn place(pool: &Pool) -> (f64, f64) {
    (
        pool.time,
        pool.usual.percentile().clamp(LEAST_ERROR, MOST_ERROR),
    )
}

/// Those that nothing beats in both, from the fastest on.
fn front(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    let mut best = f64::INFINITY;
    sorted.retain(|(_, error)| {
        let better = *error < best;
        best = best.min(*error);
        better
    });
    sorted
}

/// The front as steps.
fn steps(front: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut line = Vec::new();
    let mut before: Option<f64> = None;
    for (time, error) in front {
        line.push((*time, before.unwrap_or(MOST_ERROR)));
        line.push((*time, *error));
        before = Some(*error);
    }
    line.extend(before.map(|error| (TIMES.1, error)));
    line
}

/// Draws all pools.
pub fn draw(rows: &[Row], path: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let pools = pools(rows);
    let area = SVGBackend::new(path, SIZE).into_drawing_area();
    area.fill(&WHITE)?;
    let (head, body) = area.split_vertically(LEGEND);
    for (index, by) in WAYS.iter().enumerate() {
        let at = (20 + (index % 5) as i32 * 290, 16 + (index / 5) as i32 * 24);
        head.draw(&Circle::new(at, 6, colour(*by).filled()))?;
        let name = (at.0 + 12, at.1 - 8);
        head.draw(&Text::new(named(*by), name, ("sans-serif", 17)))?;
    }
    for (index, panel) in body.split_evenly((2, MASSES.len())).iter().enumerate() {
        let masses = MASSES[index % MASSES.len()];
        let response = index >= MASSES.len();
        let wanted = if response {
            Method::Amplitude
        } else {
            Method::Limits
        };
        let inside: Vec<&Pool> = pools
            .iter()
            .filter(|pool| pool.masses == masses && pool.method.exact() == wanted)
            .filter(|pool| pool.time.is_finite() && pool.usual.percentile().is_finite())
            .collect();
        let what = if response {
            "amplitude of a mass"
        } else {
            "both limits"
        };
        let mut chart = ChartBuilder::on(panel)
            .caption(format!("{what}, {masses} DOF"), ("sans-serif", 17))
            .margin(6)
            .x_label_area_size(36)
            .y_label_area_size(52)
            .build_cartesian_2d(
                (TIMES.0..TIMES.1).log_scale(),
                (LEAST_ERROR..MOST_ERROR).log_scale(),
            )?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .x_desc("ns a call")
            .y_desc("relative error, 99 of 100")
            .x_labels(6)
            .y_labels(8)
            .x_label_formatter(&|x| format!("{x:.0e}"))
            .y_label_formatter(&|y| format!("{y:.0e}"))
            .draw()?;
        let points: Vec<(f64, f64)> = inside.iter().map(|pool| place(pool)).collect();
        chart.draw_series(LineSeries::new(
            steps(&front(&points)),
            BLACK.mix(0.5).stroke_width(2),
        ))?;
        // Emitted code on top, where the run-time system is in the same place.
        for pool in inside.into_iter().rev() {
            let colour = colour(pool.by);
            chart.draw_series([Circle::new(place(pool), 5, colour.filled())])?;
            if pool.by == By::Double {
                let label = Text::new(short(pool.method), (7, -12), ("sans-serif", 13));
                chart.draw_series([EmptyElement::at(place(pool)) + label])?;
            }
        }
    }
    area.present()?;
    Ok(())
}

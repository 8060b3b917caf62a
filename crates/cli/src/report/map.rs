//! Computes and draws the regimes over frequency and friction, with β_lim and β*_lim.

use super::asked::ReportRequest;
use super::plot::{Axes, HorizontalAxis, Plot, PlotCurve};
use super::words::{digits, number, object, rounded};
use crate::failure::Failure;
use crate::interrupt;
use crate::layout::Layout;
use crate::progress::Progress;
use frictiongen::Limits;
use frictiongen::study::columns::{
    Frequency, FrequencyUnit, LimitsAsked, LimitsRow, LimitsTable, Setting,
};
use frictiongen::study::{
    map::{LimitLines, Map, MapRequest, Pattern},
    words,
};
use frictiongen_plot::desk::{Shade, limit_lines, map_panel, regimes};
use frictiongen_plot::{Across as Line, Colour, Figure, Guide, Layer, Panel};
use maud::{Markup, html};
use serde_json::{Value as Json, json};
use std::sync::Mutex;

/// Largest distance between a limit and its line in the picture, measured in β/(1 + β).
const LINES: f64 = 5e-4;
/// Number of rows of the table of limits.
const ROWS: usize = 31;

/// Contents of the section about regimes.
pub struct Regimes {
    lines: LimitLines,
    /// The map of the regimes. `None` for a long chain, because its steady states would take too long.
    map: Option<Map>,
    /// True if the map ends before its last frequency because the user pressed Ctrl-C.
    pub is_cut: bool,
    top: f64,
    rows: Vec<LimitsRow>,
    /// The smallest and the largest values of β_lim and β*_lim over the range.
    pub spread: Spread,
    levels: Vec<f64>,
}

/// Extreme values of β_lim and β*_lim over the range of frequencies, as friction ratios.
pub struct Spread {
    /// Largest β with which the contact slides all the time at every frequency of the range.
    pub continuous_to: f64,
    /// Smallest β with which a stuck state exists at every frequency of the range.
    pub stuck_from: f64,
}

/// Returns the numbers of frequencies and of frictions of a map. Returns `None` for a long chain, which gets no map.
fn cells(masses: usize) -> Option<(usize, usize)> {
    match masses {
        0..=4 => Some((120, 72)),
        5..=12 => Some((60, 36)),
        _ => None,
    }
}

impl Regimes {
    /// Computes the map over the range of frequencies, up to a friction above all `levels`. `known` contains the
    /// extreme values of β_lim and β*_lim if a search has already found them.
    pub fn of(
        asked: &ReportRequest,
        levels: &[f64],
        known: Option<(f64, f64)>,
    ) -> Result<Self, Failure> {
        let system = &asked.system;
        let (from, to) = (asked.band.from, asked.band.to);
        let lines = system.limit_lines(from, to, LINES).map_err(Failure::new)?;
        let ends = |read: fn(&Limits<f64>) -> f64| {
            let limits = lines.points.iter().map(|(_, limits)| read(limits));
            limits.fold((f64::INFINITY, 0.0_f64), |(low, high), limit| {
                (low.min(limit), high.max(limit))
            })
        };
        // If the search for the best friction has found the extreme values, they are more accurate than the few points
        // of a drawn line.
        let (continuous_to, stuck_from) = known.unwrap_or_else(|| {
            (
                ends(|limits| limits.continuous.min(limits.sliding)).0,
                ends(|limits| limits.sliding).1,
            )
        });
        let spread = Spread {
            continuous_to,
            stuck_from,
        };
        let limits = asked.sliding_limits();
        let most = limits.get(limits.len() * 17 / 20).copied().unwrap_or(1.0);
        let top = levels
            .iter()
            .fold(1.1 * most, |top, level| top.max(1.2 * level));
        let top = if 0.0 < top && top.is_finite() {
            top
        } else {
            1.0
        };
        let mut is_cut = false;
        let map = match cells(system.scene().masses.len()) {
            None => None,
            Some((columns, count)) => {
                let step = (to - from) / columns as f64;
                let rise = top / count as f64;
                // Each point of the map is the centre of a cell. The cells fill the whole range.
                let request = MapRequest {
                    r: (0..columns)
                        .map(|i| from + step * (i as f64 + 0.5))
                        .collect(),
                    beta: (0..count).map(|i| rise * (i as f64 + 0.5)).collect(),
                    of: Vec::new(),
                };
                let progress = Mutex::new(Progress::silent(columns, "frequencies of the map"));
                let map = system.map(&request, |done| {
                    if let Ok(mut progress) = progress.lock() {
                        progress.reach(done);
                    }
                    !interrupt::pressed()
                });
                let map = map.map_err(Failure::new)?;
                is_cut = map.columns.len() < columns;
                // A picture of the map needs at least two frequencies.
                (1 < map.columns.len()).then_some(map)
            }
        };
        let table = table(asked);
        let row = |r: f64| table.row(Frequency::at(system, r)).ok();
        Ok(Self {
            rows: asked.even(ROWS).filter_map(row).collect(),
            lines,
            map,
            is_cut,
            top,
            spread,
            levels: levels.to_vec(),
        })
    }

    /// Returns the picture of the map over frequency and friction.
    pub fn plot(&self, asked: &ReportRequest) -> Plot {
        let scales = &asked.words.scales;
        let mut panel = match &self.map {
            Some(map) => map_panel("", map, &self.lines, &[], Shade::Regime, scales),
            None => regimes("", &self.lines, self.top, scales),
        };
        for (index, level) in self
            .levels
            .iter()
            .enumerate()
            .filter(|(_, level)| **level > 0.0)
        {
            panel = panel.with(Guide {
                colour: Colour::Series(index),
                ..Guide::new(Line::Y(scales.friction(*level)))
            });
        }
        (panel.y.low, panel.y.high) = (0.0, scales.friction(self.top));
        (panel.x.low, panel.x.high) = (
            scales.frequency(asked.band.from),
            scales.frequency(asked.band.to),
        );
        let panel = Panel {
            height: Some(300.0),
            ..panel
        };
        let [continuous, sliding] = limit_lines(&self.lines, self.top, scales, Colour::Black);
        let series = |name: &str, line: frictiongen_plot::Line| {
            let layers = [Layer::from(line)];
            PlotCurve::of(&name.into(), Colour::Black, &layers, false)
        };
        let mut series = vec![
            series("limit of continuous motion", continuous),
            series("limit of sliding", sliding),
        ];
        if asked.is_elastic() {
            series.remove(0);
        }
        let axes = Axes {
            quantity: if asked.words.measure.scale().is_some() {
                "friction"
            } else {
                "friction ratio"
            },
            unit: if asked.words.measure.scale().is_some() {
                "N"
            } else {
                ""
            },
        };
        let across = HorizontalAxis {
            name: if asked.words.in_hertz {
                "frequency"
            } else {
                "frequency ratio"
            },
            unit: if asked.words.in_hertz { "Hz" } else { "" },
        };
        let figure = Figure::new("", "", 1, vec![panel]);
        Plot::new(
            "regimes",
            "What the contact does over frequency and friction",
            figure,
            &across,
            &[(axes, series)],
            self.cells(asked),
        )
    }

    /// Returns the regime of the contact in each cell of the map, row by row from the smallest friction upwards.
    fn cells(&self, asked: &ReportRequest) -> Json {
        let Some(map) = &self.map else {
            return Json::Null;
        };
        let scales = &asked.words.scales;
        let mut names: Vec<String> = Vec::new();
        let mut cells = Vec::new();
        for row in 0..map.beta.len() {
            for column in &map.columns {
                let name = match column.points.get(row) {
                    // An elastic contact that sticks does not stop, because it moves with its spring. The text
                    // therefore says "sticks".
                    Some(Ok(point)) if asked.is_elastic() => {
                        does(point.pattern).replace("stops", "sticks")
                    }
                    Some(Ok(point)) => does(point.pattern),
                    Some(Err(error)) => format!("no answer: {}", words::no_answer(*error)),
                    None => continue,
                };
                let known = names.iter().position(|known| *known == name);
                cells.push(known.unwrap_or_else(|| {
                    names.push(name);
                    names.len() - 1
                }));
            }
        }
        let x: Vec<f64> = map
            .columns
            .iter()
            .map(|column| rounded(scales.frequency(column.r)))
            .collect();
        let y: Vec<f64> = map
            .beta
            .iter()
            .map(|beta| rounded(scales.friction(*beta)))
            .collect();
        json!({ "x": x, "y": y, "names": names, "cells": cells })
    }

    /// Returns the section about regimes as HTML.
    pub fn html(&self, plot: &Plot, asked: &ReportRequest) -> Markup {
        let words = &asked.words;
        html! {
            section #regimes {
                h2 { "Where the contact slides and where it sticks" }
                p {
                    @if asked.is_elastic() {
                        "From the dashed limit on the contact never slides, and moves with its spring. Below this limit it slides, and sticks after each reversal."
                    } @else {
                    "Below the solid limit the contact can slide all the time. From the dashed limit on it can stay stuck. Between the two limits \
                     it slides and stops in turn. Where the dashed limit is below the solid one, both states are possible between them, \
                     and the start decides."
                    }
                    @if self.levels.iter().any(|level| *level > 0.0) { " The thin horizontal lines are the frictions of the curves." }
                    @if self.is_cut { " Ctrl-C ended the map before its last frequency." }
                    @else if self.map.is_none() { " The map does not show the motion between the limits, because that takes too long for this number of masses." }
                }
                div.plots.single { (plot.html()) }
                dl.facts {
                    @if !asked.is_elastic() {
                        div { dt { "never a stop in the range up to" } dd { (words.friction(self.spread.continuous_to)) } }
                    }
                    div {
                        dt { "stuck all over the range from" }
                        dd {
                            @if self.spread.stuck_from.is_finite() { (words.friction(self.spread.stuck_from)) }
                            @else { "no friction does" }
                        }
                    }
                }
                details {
                    summary { @if asked.is_elastic() { "Values: the limit" } @else { "Values: both limits" } }
                    div.scroll tabindex="0" role="region" aria-label="Both limits over frequency" {
                        table {
                            thead { tr {
                                th scope="col" { (words.frequency_title()) }
                                @if !asked.is_elastic() { th scope="col" { "limit of continuous motion" } }
                                th scope="col" { "limit of sliding" }
                            } }
                            tbody { @for row in &self.rows { tr {
                                th scope="row" { (digits(words.scales.frequency(row.frequency.r))) }
                                @if !asked.is_elastic() { td { (row.continuous.map(|beta| words.friction(beta)).unwrap_or_default()) } }
                                td { (words.friction(row.sliding)) }
                            } } }
                        }
                    }
                }
            }
        }
    }

    /// Returns the limits as JSON data. Their points have the form of `frictiongen limits --json`.
    pub fn data(&self, asked: &ReportRequest) -> Json {
        let words = &asked.words;
        let limit = |beta: f64| object(words.friction_json(beta));
        let columns = table(asked).columns();
        let points = self.rows.iter();
        let points = points.map(|row| Layout::Flat.json(&columns, row, false));
        json!({
            "nothing_sticks_up_to": limit(self.spread.continuous_to),
            "stuck_from": limit(self.spread.stuck_from),
            "highest_shown": number(words.scales.friction(self.top)),
            "points": points.collect::<Vec<_>>(),
        })
    }
}

/// Returns the table of β_lim and β*_lim in the units of the page.
fn table(asked: &ReportRequest) -> LimitsTable<'_> {
    LimitsTable {
        setting: Setting::new(
            &asked.system,
            asked.words.measure,
            FrequencyUnit::Ratio.under(&asked.words.measure),
        ),
        asked: LimitsAsked::Exact,
    }
}

/// Returns words for the motion of the contact in this pattern.
fn does(pattern: Pattern) -> String {
    use frictiongen::Regime;
    match (pattern.regime, pattern.period, pattern.stops) {
        (Regime::Continuous, ..) => "slides all the time".to_owned(),
        (Regime::Stuck, ..) => "stuck".to_owned(),
        (_, 0, _) => "stops, without a steady state".to_owned(),
        (_, 1, 0) => "reverses more than twice, without a stop".to_owned(),
        (_, 1, 1) => "stops once in a cycle".to_owned(),
        (_, 1, stops) => format!("stops {stops} times in a cycle"),
        (_, period, _) => format!("stops; repeats after {period} cycles"),
    }
}

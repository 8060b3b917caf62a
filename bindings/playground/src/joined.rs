//! Answers questions in small parts, so that the page can stop after each part. These are quick curves of every
//! scene, and all answers for scenes with several contacts or dashpots.

use crate::map::{REGIMES, class, top};
use crate::orbit::{code, loop_picture};
use crate::question::{Question, picture};
use frictiongen::study::joined::{JoinedAt, JoinedOrbit};
use frictiongen::{Regime, System};
use frictiongen_plot::{Axis, Cells, Colour, Fill, Label, Line, Panel, Point, Raster, Stroke};
use serde_json::{Value, json};

/// Largest number of samples in a cycle of the shown motion.
const SAMPLES: usize = 240;
/// Largest number of cycles of the motion that the page shows.
const MOST_CYCLES: usize = 16;

fn text(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// Returns the amplitude of the mass with the index `of`, or that of the first contact for `None`.
fn size(orbit: &JoinedOrbit<'_>, of: Option<usize>) -> Option<f64> {
    match of {
        Some(mass) => orbit.largest_displacements().get(mass).copied(),
        None => orbit
            .contacts()
            .next()
            .map(|contact| contact.displacement()),
    }
}

/// Returns amplitude and regime of the steady state at each frequency ratio of the question.
pub fn points(question: &Question) -> Result<Value, String> {
    let system = question.system()?;
    let joined = match system.scene().is_joined() {
        true => Some(system.joined().map_err(text)?),
        false => None,
    };
    let point = |r: f64| {
        let Some(joined) = &joined else {
            let response = system.at(r).ok()?.response(question.beta).ok()?;
            let size = response.swing(question.motion())?.amplitude;
            return Some((size, class(response.regime())));
        };
        let orbit = joined.at_any(r).ok()?.orbit(question.beta).ok()?;
        Some((size(&orbit, question.of)?, class(orbit.regime())))
    };
    let points = question.rs.iter().map(|r| {
        let found = point(*r);
        json!([r, found.map(|found| found.0), found.map(|found| found.1)])
    });
    Ok(json!({ "points": points.collect::<Vec<_>>() }))
}

/// Returns the picture of a curve. Its points are in the question, because they were computed before.
pub fn line(question: &Question) -> Result<Value, String> {
    let label = if matches!(
        question.system()?.scene().excitation,
        frictiongen::study::scene::Excitation::Base
    ) {
        "displacement over *Y*"
    } else {
        "displacement over *P*/*k*_1"
    };
    let sizes = question.points.iter().filter_map(|point| point.1);
    let most = sizes.fold(0.0, f64::max);
    let high = if 0.0 < most { 1.06 * most } else { 1.0 };
    let mut panel = Panel::new(
        "",
        Axis::new("frequency ratio *r*", question.from, question.to),
        Axis::new(label, 0.0, high),
    );
    let strokes = [Stroke::Solid, Stroke::DashDot, Stroke::Dotted];
    for (regime, (name, stroke)) in REGIMES.into_iter().zip(strokes).enumerate() {
        // A line continues to the first point of the next regime, so that the curve has no gaps.
        let mut pieces: Vec<Vec<Point>> = vec![Vec::new()];
        let mut before: Option<usize> = None;
        for (r, size, found) in &question.points {
            let joins = *found == Some(regime) || before == Some(regime);
            match (size, pieces.last_mut()) {
                (Some(size), Some(piece)) if joins => piece.push((*r, *size)),
                _ => pieces.push(Vec::new()),
            }
            before = *found;
        }
        pieces.retain(|piece| 1 < piece.len());
        if !pieces.is_empty() {
            panel = panel.with(Line::new(name, Colour::Series(0), stroke, pieces));
        }
    }
    Ok(picture(panel, crate::curve::HEIGHT))
}

/// Returns the regime at one frequency ratio for each friction ratio of the question, and the friction ratio above
/// which all contacts can stay stuck.
pub fn cells(question: &Question) -> Result<Value, String> {
    let system = question.system()?;
    let joined = system.joined().map_err(text)?;
    let at = joined.at_any(question.r).map_err(text)?;
    let limit = at.stuck().map(|stuck| stuck.limit()).ok();
    let cell = |beta: &f64| match limit {
        // Above the limit, motion from rest may reach a state other than the stuck state. A search for it takes long
        // and rarely finds one.
        Some(limit) if limit <= *beta => Some(class(Regime::Stuck)),
        _ => at.orbit(*beta).ok().map(|orbit| class(orbit.regime())),
    };
    let cells: Vec<Option<usize>> = question.betas.iter().map(cell).collect();
    Ok(json!({ "cells": cells, "limit": limit }))
}

/// Returns the picture of a map, with a line for the limit of the stuck state. The regimes of the cells are in the
/// question, because they were computed before.
pub fn raster(question: &Question) -> Result<Value, String> {
    let system = question.system()?;
    let joined = system.joined().map_err(text)?;
    let count = 120;
    let step = (question.to - question.from) / f64::from(count);
    let rs = (0..=count).map(|index| question.from + step * f64::from(index));
    let limit = |r: f64| Some((r, joined.at_any(r).ok()?.stuck().ok()?.limit()));
    let limits: Vec<Point> = rs.filter_map(limit).collect();
    let mut heights: Vec<f64> = limits.iter().map(|point| point.1).collect();
    let top = question.top.unwrap_or_else(|| top(&mut heights));
    let mut panel = Panel::new(
        "",
        Axis::new("frequency ratio *r*", question.from, question.to),
        Axis::new("friction ratio *β*", 0.0, top),
    );
    let columns = question.rs.len();
    if 0 < columns {
        let classes = REGIMES.into_iter().enumerate();
        let classes = classes.map(|(index, name)| (Label::from(name), Fill::Class(index)));
        panel = panel.with(Raster {
            x: (question.from, question.to),
            y: (0.0, top),
            columns,
            cells: Cells::Classes {
                classes: classes.collect(),
                cells: question.cells.clone(),
            },
        });
    }
    let shown = limits
        .into_iter()
        .map(|(r, beta)| (r, beta.min(4.0 * top)))
        .collect();
    panel = panel.with(Line::new(
        "*β*_lim^*, stuck state above",
        Colour::Black,
        Stroke::Dashed,
        vec![shown],
    ));
    let mut drawing = picture(panel, crate::map::HEIGHT);
    if let Some(fields) = drawing.as_object_mut() {
        fields.insert("top".into(), json!(top));
    }
    Ok(drawing)
}

/// Returns the numbers of the steady state that motion from rest reaches.
pub fn orbit(question: &Question, system: &System) -> Result<Value, String> {
    let joined = system.joined().map_err(text)?;
    let names = joined.contact_names();
    let at: JoinedAt<'_> = joined.at_any(question.r).map_err(text)?;
    let orbit = at.orbit(question.beta).map_err(text)?;
    let contacts = orbit.contacts().zip(&names);
    let contacts = contacts.map(|(contact, name)| {
        json!({
            "name": name, "regime": code(contact.regime()), "stops": contact.stops(),
            "stuck_fraction": contact.stuck_fraction(), "energy": contact.energy(),
        })
    });
    let amplitudes = orbit.largest_displacements().into_iter();
    let stuck = at.stuck().ok();
    let mut told = json!({
        "regime": code(orbit.regime()),
        "settled": true,
        "period": orbit.period(),
        "stops": orbit.contacts().map(|contact| contact.stops()).sum::<usize>(),
        "stable": orbit.is_stable(),
        "marginal": orbit.is_marginal(),
        "masses": amplitudes.map(|amplitude| json!({ "amplitude": amplitude, "phase": null })).collect::<Vec<_>>(),
        "contact": orbit.contacts().next().map(|contact| contact.displacement()),
        "force": orbit.contacts().map(|contact| contact.force()).fold(0.0, f64::max),
        "work": orbit.contacts().map(|contact| contact.energy()).sum::<f64>() / orbit.period() as f64,
        "contacts": contacts.collect::<Vec<_>>(),
        "limits": { "continuous": null, "sliding": stuck.map(|stuck| stuck.limit()) },
    });
    if let Some(fields) = told.as_object_mut().filter(|_| !question.bare) {
        let (motion, loops) = motion(system, &orbit, &names)?;
        fields.insert("motion".into(), motion);
        fields.insert("loop".into(), loops);
    }
    Ok(told)
}

/// Returns one period of the motion in a steady state, and the picture of the contacts' hysteresis loops.
fn motion(
    system: &System,
    orbit: &JoinedOrbit<'_>,
    names: &[String],
) -> Result<(Value, Value), String> {
    let cycles = orbit.period().min(MOST_CYCLES);
    let samples = (2 * SAMPLES / cycles.max(1)).clamp(16, SAMPLES);
    let (whole, fine) = (u32::try_from(cycles), u32::try_from(samples));
    let (Ok(whole), Ok(fine)) = (whole, fine) else {
        return Err("the period has too many cycles".to_owned());
    };
    let mut run = orbit.simulation().map_err(text)?;
    let history = run.history(0, whole, fine).map_err(text)?;
    let count = history.states.first().map_or(0, |state| state.0.len());
    let mass = |index: usize| -> Vec<Option<f64>> {
        let states = history.states.iter();
        states.map(|state| state.0.get(index).copied()).collect()
    };
    let contact = |index: usize| {
        history
            .contacts
            .iter()
            .filter_map(move |all| all.get(index))
    };
    let sticks = |index: usize| -> Vec<u8> {
        contact(index)
            .map(|contact| u8::from(contact.is_sticking))
            .collect()
    };
    let motion = json!({
        "cycles": cycles,
        "masses": (0..count).map(mass).collect::<Vec<_>>(),
        "sticks": (0..names.len()).map(sticks).collect::<Vec<_>>(),
    });
    let loops = names.iter().enumerate().map(|(index, name)| {
        let displacements = contact(index).map(|contact| contact.displacement).collect();
        let forces = contact(index).map(|contact| contact.force).collect();
        let name = if names.len() == 1 {
            String::new()
        } else {
            name.clone()
        };
        (name, displacements, forces)
    });
    Ok((motion, loop_picture(system, &loops.collect::<Vec<_>>())))
}

//! Answers questions about the steady state at one frequency and one friction: its numbers, one period of its motion,
//! and its hysteresis loop.

use crate::map::{REGIMES, class};
use crate::question::{Question, picture};
use frictiongen::study::history::History;
use frictiongen::study::response::{MotionQuantity, SystemResponse};
use frictiongen::study::scene::Excitation;
use frictiongen::{Of, Regime, System};
use frictiongen_plot::{Axis, Colour, Line, Panel, Point, Stroke};
use serde_json::{Value, json};

/// Height of the frame of a hysteresis loop's picture, in pixels.
const HEIGHT: f64 = 200.0;
/// Number of samples of one period of the shown motion.
const SAMPLES: u32 = 480;

/// Returns the numbers of the steady state that motion from rest reaches, one period of its motion and its hysteresis
/// loop.
pub fn answer(question: &Question) -> Result<Value, String> {
    let system = question.system()?;
    if system.scene().is_joined() {
        return crate::joined::orbit(question, &system);
    }
    let at = system.at(question.r).map_err(|error| error.to_string())?;
    let response = at
        .response(question.beta)
        .map_err(|error| error.to_string())?;
    let limits = at.limits();
    let mut told = numbers(&system, &response);
    let limits = json!({ "continuous": limits.continuous, "sliding": limits.sliding });
    if let Some(fields) = told.as_object_mut() {
        fields.insert("limits".into(), limits);
        match period(&system, &response) {
            Ok((motion, loop_)) if !question.bare => {
                fields.insert("motion".into(), motion);
                fields.insert("loop".into(), loop_);
            }
            Ok(_) => {}
            Err(error) => {
                fields.insert("still".into(), json!(error));
            }
        }
    }
    Ok(told)
}

/// Returns the name of a regime that the page uses, one of [`REGIMES`].
pub fn code(regime: Regime) -> &'static str {
    REGIMES.get(class(regime)).copied().unwrap_or_default()
}

fn numbers(system: &System, response: &SystemResponse<'_>) -> Value {
    let (stops, reversals, stuck_fraction, stable) = match response {
        SystemResponse::Continuous(_) => (0, 2, 0.0, true),
        SystemResponse::StickSlip(orbit) => (
            orbit.stops(),
            orbit.reversals(),
            orbit.stuck_fraction(),
            orbit.is_stable(),
        ),
        SystemResponse::Stuck(_) => (0, 0, 1.0, true),
    };
    let count = system.scene().masses.len();
    let masses = (0..count).map(|index| {
        let swing = response.swing(Of::Mass(index));
        json!({
            "amplitude": swing.map(|swing| swing.amplitude),
            "phase": swing.and_then(|swing| swing.phase),
        })
    });
    json!({
        "regime": code(response.regime()),
        "settled": response.is_settled(),
        "period": response.period(),
        "stops": stops,
        "reversals": reversals,
        "stuck_fraction": stuck_fraction,
        "stable": stable,
        "marginal": response.is_marginal(),
        "masses": masses.collect::<Vec<_>>(),
        "contact": response.swing(Of::Contact).map(|swing| swing.amplitude),
        "force": response.contact_force(),
        "work": response.largest(Of::Contact, MotionQuantity::Energy),
    })
}

/// Returns one period of the motion in a steady state, and the picture of the contact's hysteresis loop.
fn period(system: &System, response: &SystemResponse<'_>) -> Result<(Value, Value), String> {
    let count = system.scene().masses.len();
    let of: Vec<Of> = (0..count).map(Of::Mass).chain([Of::Contact]).collect();
    // Each cycle of a long period has fewer samples. Their number is even.
    let samples = (SAMPLES / response.period().max(1)).max(16) & !1;
    let history = response
        .history(&of, samples)
        .map_err(|error| error.to_string())?;
    let contact = history.track(Of::Contact);
    let contact: Vec<f64> = contact.map_or(Vec::new(), |track| track.displacement.clone());
    let masses = history.tracks.iter().take(count);
    let masses: Vec<&Vec<f64>> = masses.map(|track| &track.displacement).collect();
    let sticks: Vec<u8> = sticks(&history);
    let motion = json!({
        "cycles": history.cycles,
        "masses": masses,
        "sticks": [sticks],
    });
    let loops = [(String::new(), contact, history.friction.clone())];
    Ok((motion, loop_picture(system, &loops)))
}

fn sticks(history: &History) -> Vec<u8> {
    let stuck = frictiongen::answer::Contact::Stuck;
    let contact = history.contact.iter();
    contact.map(|contact| u8::from(*contact == stuck)).collect()
}

/// A hysteresis loop: the name of the contact, its displacements and its forces.
pub type Loop = (String, Vec<f64>, Vec<f64>);

/// Returns the picture of hysteresis loops: the force of each contact over its relative displacement.
pub fn loop_picture(system: &System, loops: &[Loop]) -> Value {
    let (over_x, over_y) = match system.scene().excitation {
        Excitation::Base => ("*Y*", "*k*_1*Y*"),
        Excitation::Force(_) => ("*P*/*k*_1", "*P*"),
    };
    let all = |read: fn(&Loop) -> &Vec<f64>| {
        let most = loops.iter().flat_map(read).map(|value| value.abs());
        let most = most.fold(0.0, f64::max);
        if 0.0 < most { 1.12 * most } else { 1.0 }
    };
    let (x, y) = (all(|contact| &contact.1), all(|contact| &contact.2));
    let mut panel = Panel::new(
        "",
        Axis::new(format!("relative displacement over {over_x}"), -x, x),
        Axis::new(format!("friction force over {over_y}"), -y, y),
    );
    for (index, (name, displacements, forces)) in loops.iter().enumerate() {
        let points: Vec<Point> = displacements
            .iter()
            .copied()
            .zip(forces.iter().copied())
            .collect();
        let line = if name.is_empty() {
            Line::unnamed(Colour::Series(index), Stroke::Solid, vec![points])
        } else {
            Line::new(
                frictiongen_plot::Label::verbatim(name),
                Colour::Series(index),
                Stroke::Solid,
                vec![points],
            )
        };
        panel = panel.with(line);
    }
    picture(panel, HEIGHT)
}

//! Compares events, states and steady states with `joints.json`.  A plain program made that file, with matrix exponentials
//! between events and bisection.  It shares nothing with this project.

use frictiongen::System;
use frictiongen::answer::Contact;
use serde_json::Value;
use std::f64::consts::TAU;

/// A scene of the reference, with the numbers that turn its units into groups.
pub struct Reference {
    pub system: System,
    pub value: Value,
    /// ω in rad/s, r and β.
    pub omega: f64,
    pub r: f64,
    pub beta: f64,
    /// Unit of displacement: P/k₁, or the base's amplitude.
    pub unit: f64,
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .expect("a list")
        .iter()
        .map(number)
        .collect()
}

/// Returns all scenes of the reference.
pub fn references() -> Vec<Reference> {
    let all: Value = serde_json::from_str(include_str!("joints.json")).expect("JSON");
    let all = all.as_array().expect("a list").iter();
    all.map(|value| {
        let contact = &value["contacts"][0];
        let masses = numbers(&value["masses"]).into_iter().enumerate();
        let masses: Vec<_> = masses.map(|(i, m)| format!("m{}: {m:?}", i + 1)).collect();
        let springs = value["springs"].as_array().expect("a list").iter();
        let text = |value: &Value| value.as_str().expect("a name").to_owned();
        let springs: Vec<_> = springs
            .map(|spring| {
                format!("{} - {}: {:?}", text(&spring[0]), text(&spring[1]), number(&spring[2]))
            })
            .collect();
        let excitation = text(&value["excitation"]);
        let description = format!(
            "struct Reference {{ masses: {{ {} }}, springs: {{ {} }}, contact: {} - {}, stiffness: {:?},
                excitation: {excitation}, damping: modal{:?}, stiction: {:?}, provide: [orbit, simulation] }}",
            masses.join(", "),
            springs.join(", "),
            text(&contact["between"][0]),
            text(&contact["between"][1]),
            number(&contact["stiffness"]),
            numbers(&value["zeta"]),
            number(&contact["stiction"]),
        );
        let system: System = description.parse().expect("a scene");
        let (omega, load) = (number(&value["omega"]), number(&value["load"]));
        let stiffness = system.scene().first_stiffness();
        let (unit, force) = if excitation == "base" {
            (load, stiffness * load)
        } else {
            (load / stiffness, load)
        };
        Reference {
            r: system.frequency_ratio(omega),
            beta: number(&contact["force"]) / force,
            system,
            value: value.clone(),
            omega,
            unit,
        }
    })
    .collect()
}

/// State of the contact as the reference writes it: 1 and −1 while it slides, 0 while it sticks.
fn code(contact: Contact) -> f64 {
    match contact {
        Contact::Stuck => 0.0,
        Contact::Forward => 1.0,
        Contact::Backward => -1.0,
    }
}

/// Every event of the first three cycles, to 1e-10 of the period, and the states after each cycle, to 1e-10 of the
/// largest displacement and velocity.  The reference has 1e-12 of the period.
#[test]
fn first_cycles_follow_the_reference() {
    let (mut events, mut states) = (0, 0);
    for reference in references() {
        let Reference {
            system,
            value,
            omega,
            r,
            beta,
            unit,
        } = &reference;
        let mut run = system.simulation(*r, *beta).expect("a run");
        let mut expected = value["events"].as_array().expect("events").iter();
        let masses: Vec<String> = system
            .scene()
            .masses
            .iter()
            .map(|mass| mass.name.clone())
            .collect();
        let mut passed = 0.0;
        for cycle in 0..3 {
            let end = f64::from(cycle + 1) * TAU;
            // The events follow from whole segments, so that no step cuts them.
            while passed < end {
                let before = run.contact();
                let segment = run.advance(end - passed).expect("a segment");
                passed += segment.length;
                if segment.event.is_none() {
                    continue;
                }
                let event = expected.next().expect("an event");
                let late = (passed - number(&event["t"]) * omega) / TAU;
                assert!(
                    late.abs() < 1e-10,
                    "event {events}: late by {late:e} periods"
                );
                assert_eq!(
                    code(before),
                    number(&event["before"][0]),
                    "before event {events}"
                );
                assert_eq!(
                    code(run.contact()),
                    number(&event["after"][0]),
                    "after event {events}"
                );
                events += 1;
            }
            let after = &value["after_cycles"][cycle as usize];
            let (x, v) = (numbers(&after["x"]), numbers(&after["v"]));
            for (mass, (x, v)) in masses.iter().zip(x.iter().zip(&v)) {
                let moment = run.mass(mass).expect("a mass");
                let own = (
                    moment.displacement() * unit,
                    moment.velocity() * unit * omega,
                );
                let size = unit.max(x.abs());
                assert!((own.0 - x).abs() < 1e-10 * size, "{} for {x}", own.0);
                assert!(
                    (own.1 - v).abs() < 1e-10 * size * omega,
                    "{} for {v}",
                    own.1
                );
                states += 1;
            }
        }
        assert!(expected.next().is_none(), "an event is missing");
    }
    assert_eq!((events, states), (52, 15));
}

/// Steady amplitudes and stuck fractions to 1e-9, which is what the reference has, and the number of stops.
#[test]
fn steady_states_follow_the_reference() {
    let mut compared = 0;
    for Reference {
        system,
        value,
        r,
        beta,
        unit,
        ..
    } in references()
    {
        let orbit = system.steady_state(r, beta).expect("a steady state");
        let steady = &value["steady"];
        let masses = &system.scene().masses;
        for (mass, amplitude) in masses.iter().zip(numbers(&steady["amplitude"])) {
            let own = orbit.mass(&mass.name).expect("a mass").amplitude() * unit;
            assert!(
                (own - amplitude).abs() < 1e-9 * amplitude,
                "{own} for {amplitude}"
            );
            compared += 1;
        }
        let fraction = number(&steady["stuck_fraction"][0]);
        assert!(
            (orbit.stuck_fraction() - fraction).abs() < 1e-8,
            "{fraction}"
        );
        assert_eq!(orbit.stops() as f64, number(&steady["stops"][0]));
        assert_eq!((orbit.period(), orbit.reversals()), (1, 0));
        assert!(orbit.is_stable() && !orbit.is_marginal());
    }
    assert_eq!(compared, 5);
}

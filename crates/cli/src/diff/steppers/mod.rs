//! Compares the steppers of two scenes: the declared time step, the bounds on the cost of a step, the step tables, and
//! the results of a run.

mod run;
mod words;

use frictiongen::System;
use frictiongen::study::scene::{Excitation, FrictionLaw, Provide};
use frictiongen_codegen::{SizeLimits, StepFacts, parse_text, step_facts};
use run::{Answer, SineSum, StepperRun};
use std::f64::consts::TAU;

/// Number of time steps in the shortest natural period of both scenes, if no scene description declares a step.
const STEPS_IN_PERIOD: f64 = 20.0;
/// Length of the compared run, divided by the longest natural period of both scenes.
const PERIODS: f64 = 10.0;
/// Smallest and largest number of steps in the compared run.
const STEPS: (f64, f64) = (200.0, 10_000.0);
/// Friction force of each contact in the compared run, divided by the largest force that this contact carries in the
/// old scene while it alone is stuck. If all contacts were stuck, one contact could keep the load from another.
const FRICTION: f64 = 0.3;
/// Friction force that keeps every contact stuck in a run, as a multiple of the load. For base motion the load is the
/// amplitude of the base times the largest spring stiffness.
const HOLDS: f64 = 1e6;
/// Largest velocity of a contact without friction in the compared run, divided by the largest speed in the field
/// `friction: stribeck` of the old scene.
const SPEED: f64 = 2.0;

/// Largest difference, over the compared steps, between the two steppers in one result.
#[derive(Clone, Debug, PartialEq)]
pub struct StepDifference {
    /// Name of the result, such as the displacement of a mass.
    pub name: String,
    /// Number of the step at which the difference is largest.
    pub step: u32,
    /// Value of the result from the old stepper and from the new stepper, after the step of the largest difference.
    pub values: (f64, f64),
    /// Largest absolute value of the result over the steps of both scenes.
    pub largest: f64,
}

impl StepDifference {
    /// Returns the largest difference divided by the largest absolute value of the result.
    pub fn relative(&self) -> f64 {
        if self.largest == 0.0 {
            return 0.0;
        }
        (self.values.1 - self.values.0).abs() / self.largest
    }
}

/// Results of the steppers of two scenes in the compared run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RunDifferences {
    /// Time step of both steppers, in s.
    pub step: f64,
    /// Number of steps in the compared run.
    pub steps: u32,
    /// Amplitude of each sine wave in the load.
    pub amplitude: f64,
    /// Friction force of each contact, with the name of the contact.
    pub frictions: Vec<(String, f64)>,
    /// Number of events that the old stepper and the new stepper find in the compared run.
    pub events: (u64, u64),
    /// Largest difference of each result, such as the displacement of a mass.
    pub differences: Vec<StepDifference>,
}

/// Comparison of the steppers of two scenes.
#[derive(Clone, Debug, Default)]
pub struct Steppers {
    /// Time step that each scene description declares, old and new. `None` if a description declares no step.
    pub declared: (Option<f64>, Option<f64>),
    /// Facts about the emitted steppers, old and new, such as step tables and bounds on the cost. `None` if one of the
    /// scenes has several contacts or dashpots, or no emitted code.
    pub facts: Option<(StepFacts, StepFacts)>,
    /// Results of both steppers in a run of steps. `None` if the runs were not compared.
    pub answers: Option<RunDifferences>,
    /// Reasons why the command has not compared some properties of the steppers.
    pub left_out: Vec<String>,
}

/// Compares the steppers of two scenes. Returns `None` if no scene provides a stepper, unless `alone` is true: the
/// command then compares no other answers, and each scene has a stepper at run time.
pub fn compare([old, new]: [&System; 2], texts: &[String; 2], alone: bool) -> Option<Steppers> {
    let provides = [old, new].map(|system| system.scene().provides(&Provide::Stepper));
    let mut found = Steppers {
        declared: (old.scene().stepping.step, new.scene().stepping.step),
        ..Steppers::default()
    };
    let only = match provides {
        [false, false] if !alone => return None,
        [true, true] | [false, false] => "",
        [true, false] => "old",
        [false, true] => "new",
    };
    if !only.is_empty() {
        let other = if only == "old" { "new" } else { "old" };
        found.left_out.push(format!(
            "the stepper: only the {only} description provides one; write `stepper` in `provide` of the {other} description too"
        ));
        return Some(found);
    }
    found.facts = facts(texts);
    match answers(old, new) {
        Ok(answers) => found.answers = Some(answers),
        Err(reason) => found.left_out.push(format!("answers of a step: {reason}")),
    }
    Some(found)
}

/// Returns the facts about the emitted steppers of both scene descriptions, such as step tables. Returns `None` if the
/// macro rejects a description, or if a scene has several contacts or dashpots.
fn facts(texts: &[String; 2]) -> Option<(StepFacts, StepFacts)> {
    // If the macro rejects a scene description, the comparison of emitted code reports the errors.
    let limits = SizeLimits {
        tables: false,
        ..SizeLimits::MACRO
    };
    let of = |text: &String| step_facts(&parse_text(text, &limits).ok()?);
    let [old, new] = texts;
    Some((of(old)?, of(new)?))
}

/// Compares the results of the steppers of both scenes under the same input.
fn answers(old: &System, new: &System) -> Result<RunDifferences, String> {
    let scenes = [old.scene(), new.scene()];
    let [on_base, on_base_new] = scenes.map(|scene| scene.excitation == Excitation::Base);
    if on_base != on_base_new {
        return Err("a force drives one scene, and the base the other".to_owned());
    }
    let [names, names_new] = scenes.map(|scene| {
        let contacts = scene.named_contacts().into_iter();
        contacts.map(|contact| contact.name).collect::<Vec<_>>()
    });
    if names != names_new {
        return Err(format!(
            "the old scene has the contacts {}, and the new scene has {}",
            names.join(", "),
            names_new.join(", ")
        ));
    }
    let rates = [old.natural_frequencies(), new.natural_frequencies()].concat();
    let moving = || rates.iter().copied().filter(|rate| *rate > 0.0);
    let shortest = TAU / moving().reduce(f64::max).unwrap_or(1.0);
    let longest = TAU / moving().reduce(f64::min).unwrap_or(1.0);
    let step = match scenes.map(|scene| scene.stepping.step) {
        [Some(one), Some(other)] if one != other => {
            return Err(format!(
                "the old stepper takes steps of {one:?} s, and the new stepper steps of {other:?} s; declare the same `step` to compare them"
            ));
        }
        [Some(step), _] | [None, Some(step)] => step,
        [None, None] => shortest / STEPS_IN_PERIOD,
    };
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "between the bounds of `STEPS`"
    )]
    let steps = (PERIODS * longest / step).ceil().clamp(STEPS.0, STEPS.1) as u32;
    let mut load = SineSum::over(&rates);
    let (amplitude, frictions) = levels(old, &load, (step, steps), &names)?;
    load.amplitude = amplitude;
    let mut answers = RunDifferences {
        step,
        steps,
        amplitude,
        frictions,
        ..RunDifferences::default()
    };
    follow([old, new], &load, &mut answers)?;
    Ok(answers)
}

/// Runs both steppers under the same load, and stores the largest difference of each result in `answers`.
fn follow(
    [old, new]: [&System; 2],
    load: &SineSum,
    answers: &mut RunDifferences,
) -> Result<(), String> {
    let which = |which: &str, reason: String| format!("the {which} stepper stops: {reason}");
    let start = |system| StepperRun::start(system, load, answers.step, &answers.frictions);
    let mut one = start(old).map_err(|reason| which("old", reason))?;
    let mut other = start(new).map_err(|reason| which("new", reason))?;
    let mut differences = named(old, new, &answers.frictions);
    for step in 1..=answers.steps {
        let before = one.step().map_err(|reason| which("old", reason))?;
        let after = other.step().map_err(|reason| which("new", reason))?;
        answers.events.0 += before.events;
        answers.events.1 += after.events;
        for (difference, [place, place_new]) in &mut differences {
            let values = (place.of(&before), place_new.of(&after));
            let size = values.0.abs().max(values.1.abs());
            difference.largest = difference.largest.max(size);
            let apart = |values: (f64, f64)| (values.1 - values.0).abs();
            if apart(values) > apart(difference.values) || step == 1 {
                (difference.values, difference.step) = (values, step);
            }
        }
    }
    let differences = differences.into_iter();
    answers.differences = differences.map(|(difference, _)| difference).collect();
    Ok(())
}

/// A number in the results of a step: the displacement of a mass, by the index of the mass, or a number of a contact,
/// by the indices of the contact and of the number.
#[derive(Clone, Copy)]
enum Place {
    Mass(usize),
    Contact(usize, usize),
}

impl Place {
    /// Returns the number at this position in the results of a step.
    fn of(self, answer: &Answer) -> f64 {
        let number = match self {
            Self::Mass(mass) => answer.masses.get(mass),
            Self::Contact(contact, number) => {
                let contact = answer.contacts.get(contact);
                contact.and_then(|contact| contact.get(number))
            }
        };
        number.copied().unwrap_or(0.0)
    }
}

/// Returns the results that the command compares: first the displacement of each mass that both scenes have, then the
/// displacement and force of each contact. With each result comes its position in the old scene and in the new scene.
fn named(
    old: &System,
    new: &System,
    contacts: &[(String, f64)],
) -> Vec<(StepDifference, [Place; 2])> {
    let empty = |name: String| StepDifference {
        name,
        step: 1,
        values: (0.0, 0.0),
        largest: 0.0,
    };
    let masses = old.scene().masses.iter().enumerate();
    let masses = masses.filter_map(|(index, mass)| {
        let mut others = new.scene().masses.iter();
        let other = others.position(|other| other.name == mass.name)?;
        let name = format!("displacement of {}", mass.name);
        Some((empty(name), [Place::Mass(index), Place::Mass(other)]))
    });
    let contacts = contacts.iter().enumerate();
    let contacts = contacts.flat_map(|(index, (contact, _))| {
        let numbers = [("displacement", 0), ("friction force", 2)];
        numbers.map(|(number, place)| {
            let name = format!("{number} in {contact}");
            (empty(name), [Place::Contact(index, place); 2])
        })
    });
    masses.chain(contacts).collect()
}

/// Returns the amplitude of each wave in the load, and the friction force of each contact. The friction force of a
/// contact follows from a run of the old scene in which this contact alone sticks. With the friction law `stribeck`, the amplitude follows
/// from a run without friction.
fn levels(
    old: &System,
    load: &SineSum,
    (step, steps): (f64, u32),
    contacts: &[String],
) -> Result<(f64, Vec<(String, f64)>), String> {
    // The friction force is 0 in all contacts except the contact `held`.
    let run = |load: &SineSum, held: Option<(usize, f64)>| -> Result<Vec<[f64; 2]>, String> {
        let force = |index| {
            held.filter(|(held, _)| *held == index)
                .map_or(0.0, |(_, force)| force)
        };
        let named = |(index, contact): (usize, &String)| (contact.clone(), force(index));
        let frictions: Vec<(String, f64)> = contacts.iter().enumerate().map(named).collect();
        let mut run = StepperRun::start(old, load, step, &frictions)?;
        let mut largest = vec![[0.0_f64; 2]; contacts.len()];
        for _ in 0..steps {
            let answer = run.step()?;
            for (largest, [_, velocity, force]) in largest.iter_mut().zip(answer.contacts) {
                let [most_velocity, most_force] = *largest;
                *largest = [
                    most_velocity.max(velocity.abs()),
                    most_force.max(force.abs()),
                ];
            }
        }
        Ok(largest)
    };
    let mut load = load.clone();
    if let FrictionLaw::Stribeck(points) = &old.scene().friction
        && let Some([speed, _]) = points.last()
    {
        let free = run(&load, None)?;
        let fastest = free
            .iter()
            .fold(0.0, |fastest: f64, [v, _]| fastest.max(*v));
        if fastest > 0.0 {
            load.amplitude *= SPEED * speed / fastest;
        }
    }
    let stiffest = old.scene().springs.iter().map(|spring| spring.stiffness);
    let stiffest = match old.scene().excitation {
        Excitation::Base => stiffest.fold(0.0, f64::max),
        Excitation::Force(_) => 1.0,
    };
    let holding = HOLDS * stiffest * load.amplitude;
    let frictions = contacts.iter().enumerate().map(|(index, contact)| {
        let largest = run(&load, Some((index, holding)))?;
        let force = largest.get(index).map_or(0.0, |[_, force]| *force);
        Ok((contact.clone(), FRICTION * force))
    });
    Ok((load.amplitude, frictions.collect::<Result<_, String>>()?))
}

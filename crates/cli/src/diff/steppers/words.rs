//! Writes the comparison of two steppers, as text and as JSON.

use super::super::{ROUNDINGS, per_cent, relative};
use super::run::{BAND, WAVES};
use super::{FRICTION, RunDifferences, Steppers};
use crate::failure::Failure;
use crate::number::{Cell, Lossless as _, computed};
use frictiongen_codegen::StepFacts;
use serde_json::{Value as Json, json};
use std::io::Write;

/// Comparison of the numbers in the step tables of two steppers.
struct TableDifferences<'f> {
    /// Number of compared numbers in the tables.
    count: usize,
    /// Number of compared numbers that differ.
    differing: usize,
    /// Number with the largest relative difference: its position in the tables, its old value and its new value.
    largest: Option<(&'f str, f64, f64)>,
}

/// Compares the numbers in the step tables of two steppers. Returns the reason if the tables cannot be compared.
fn tables<'f>(
    old: &'f StepFacts,
    new: &'f StepFacts,
) -> Result<Option<TableDifferences<'f>>, String> {
    let (before, after) = (&old.numbers, &new.numbers);
    if before.is_empty() && after.is_empty() {
        return Ok(None);
    }
    let places = |numbers: &'f [(String, f64)]| numbers.iter().map(|(place, _)| place);
    if before.is_empty() || after.is_empty() {
        let only = if after.is_empty() { "old" } else { "new" };
        return Err(format!(
            "step tables: only the {only} description declares a `step` and has constant tables"
        ));
    }
    if !places(before).eq(places(after)) {
        return Err(format!(
            "step tables: the modes or the inputs differ ({} numbers -> {} numbers)",
            before.len(),
            after.len()
        ));
    }
    let pairs = || before.iter().zip(after);
    let pairs = || pairs().map(|((place, old), (_, new))| (place.as_str(), *old, *new));
    Ok(Some(TableDifferences {
        count: before.len(),
        differing: pairs().filter(|(_, old, new)| old != new).count(),
        largest: pairs().max_by(|a, b| relative(a.1, a.2).total_cmp(&relative(b.1, b.2))),
    }))
}

/// Returns the text `old -> new`. If both numbers are equal, returns the number and the word "unchanged".
fn counts(old: u64, new: u64) -> String {
    if old == new {
        format!("{old}, unchanged")
    } else {
        format!("{old} -> {new}")
    }
}

/// Formats an entry of a step table: a whole number, such as a count of terms, without decimals.
fn entry(value: f64) -> String {
    if value.fract() == 0.0 {
        format!("{value}")
    } else {
        computed(value)
    }
}

impl Steppers {
    /// Writes the comparison of two steppers as text.
    pub fn write(&self, out: &mut dyn Write) -> Result<(), Failure> {
        writeln!(out, "\nstepper")?;
        match self.declared {
            (Some(old), Some(new)) if old == new => {
                writeln!(out, "  declared step  {old:?} s, unchanged")?;
            }
            (Some(old), Some(new)) => writeln!(out, "  declared step  {old:?} s -> {new:?} s")?,
            (Some(old), None) => writeln!(out, "  declared step  removed, was {old:?} s")?,
            (None, Some(new)) => writeln!(out, "  declared step  added, {new:?} s")?,
            (None, None) => {}
        }
        if let Some((old, new)) = &self.facts {
            self.write_facts(old, new, out)?;
        }
        if let Some(answers) = &self.answers {
            answers.write(out)?;
        }
        for reason in &self.left_out {
            writeln!(out, "  not compared: {reason}")?;
        }
        Ok(())
    }

    fn write_facts(
        &self,
        old: &StepFacts,
        new: &StepFacts,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
        let of = match self.declared {
            (Some(_), Some(_)) => "step",
            (None, None) => "part of a step",
            _ => "step, and of a part of a step in the scene that declares no `step`",
        };
        writeln!(out, "  operations of a {of}")?;
        let (one, other) = (&old.cost, &new.cost);
        for (name, old, new) in [
            ("without events, at most", one.tables, other.tables),
            ("with one event, about  ", one.one_event, other.one_event),
            ("worst case             ", one.most, other.most),
        ] {
            writeln!(out, "    {name}  {}", counts(old, new))?;
        }
        if old.parts != new.parts {
            let parts = counts(old.parts.into(), new.parts.into());
            writeln!(out, "    parts of the step        {parts}")?;
        }
        match tables(old, new) {
            Err(reason) => writeln!(out, "  not compared: {reason}")?,
            Ok(None) => {}
            Ok(Some(found)) => {
                let TableDifferences {
                    count, differing, ..
                } = found;
                write!(
                    out,
                    "  step tables    {differing} of {count} numbers differ"
                )?;
                match found.largest {
                    Some((place, old, new)) if differing != 0 => writeln!(
                        out,
                        ", by {} at most\n    `{place}`: {} -> {}",
                        per_cent(relative(old, new)).trim_start_matches('+'),
                        entry(old),
                        entry(new)
                    )?,
                    _ => writeln!(out)?,
                }
            }
        }
        Ok(())
    }

    /// Returns the comparison of two steppers as JSON.
    pub fn json(&self) -> Json {
        let number = |value: f64| Cell::from(value).json();
        let facts = |facts: &StepFacts| {
            json!({
                "parts": facts.parts,
                "without_events": facts.cost.tables,
                "with_one_event": facts.cost.one_event,
                "worst_case": facts.cost.most,
            })
        };
        let compared = self
            .facts
            .as_ref()
            .map(|(old, new)| (facts(old), facts(new), tables(old, new)));
        let (operations, tables) = match compared {
            None => (Json::Null, Json::Null),
            Some((old, new, tables)) => (
                json!({ "old": old, "new": new }),
                tables.ok().flatten().map_or(Json::Null, |found| {
                    let largest = found.largest.filter(|_| found.differing != 0);
                    json!({
                        "numbers": found.count,
                        "differing": found.differing,
                        "largest": largest.map(|(place, old, new)| json!({
                            "place": place,
                            "old": number(old),
                            "new": number(new),
                            "relative": number(relative(old, new)),
                        })),
                    })
                }),
            ),
        };
        json!({
            "step_s": { "old": self.declared.0.map(number), "new": self.declared.1.map(number) },
            "operations": operations,
            "tables": tables,
            "answers": self.answers.as_ref().map(RunDifferences::json),
            "not_compared": self.reasons(),
        })
    }

    /// Returns all reasons why the command has not compared some properties of the steppers.
    fn reasons(&self) -> Vec<String> {
        let mut reasons = self.left_out.clone();
        if let Some((old, new)) = &self.facts {
            reasons.extend(tables(old, new).err());
        }
        reasons
    }
}

impl RunDifferences {
    fn write(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let frictions = self.frictions.iter();
        let frictions =
            frictions.map(|(contact, force)| format!("{} in {contact}", computed(*force)));
        let frictions: Vec<String> = frictions.collect();
        writeln!(
            out,
            "  answers after each of {} steps of {} s from rest",
            self.steps,
            computed(self.step)
        )?;
        writeln!(
            out,
            "    Load, in the units of the scenes: {WAVES} sine waves with amplitude {}, \
             fixed random phases and logarithmic spacing in Hz.",
            computed(self.amplitude)
        )?;
        let (low, high) = BAND;
        writeln!(
            out,
            "    Waves from {low} times the lowest to \
             {high} times the highest natural frequency of both scenes."
        )?;
        writeln!(
            out,
            "    Friction force, \
             {FRICTION} times the largest force of the contact in the old scene while it alone sticks:"
        )?;
        writeln!(out, "      {}", frictions.join(", "))?;
        for line in [
            "Both steppers compute in f64.",
            "A difference is relative to the largest absolute value of its answer over the steps.",
        ] {
            writeln!(out, "    {line}")?;
        }
        for difference in &self.differences {
            let (name, relative) = (&difference.name, difference.relative());
            if relative <= ROUNDINGS {
                writeln!(out, "    {name}: unchanged, to rounding")?;
                continue;
            }
            writeln!(
                out,
                "    {name}: differs by {} at most, in step {}: {} -> {}",
                per_cent(relative).trim_start_matches('+'),
                difference.step,
                computed(difference.values.0),
                computed(difference.values.1)
            )?;
        }
        writeln!(out, "    events: {}", counts(self.events.0, self.events.1))?;
        Ok(())
    }

    fn json(&self) -> Json {
        let number = |value: f64| Cell::from(value).json();
        let frictions = self.frictions.iter();
        json!({
            "step_s": number(self.step),
            "steps": self.steps,
            "amplitude_of_a_wave": number(self.amplitude),
            "friction": frictions
                .map(|(contact, force)| (contact.clone(), number(*force)))
                .collect::<serde_json::Map<_, _>>(),
            "events": { "old": self.events.0, "new": self.events.1 },
            "differences": self.differences.iter().map(|found| json!({
                "name": found.name,
                "step": found.step,
                "old": number(found.values.0),
                "new": number(found.values.1),
                "relative": number(found.relative()),
            })).collect::<Json>(),
        })
    }
}

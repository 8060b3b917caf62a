//! The differences of two scenes as text.

use super::answers::{BAND, Difference, FREQUENCIES, FRICTION};
use super::parameters::FieldChange;
use super::{Differences, ROUNDINGS, per_cent};
use crate::failure::Failure;
use crate::number::computed;
use std::io::Write;

/// Largest number of ranges of frequencies that a line of the comparison lists.
const SHOWN_RANGES: usize = 6;

/// Formats the first ranges of a list.
fn ranges(all: &[(f64, f64)]) -> String {
    let shown = all.iter().take(SHOWN_RANGES).map(|(from, to)| {
        if from == to {
            return computed(*from);
        }
        format!("{} to {}", computed(*from), computed(*to))
    });
    let mut text = shown.collect::<Vec<_>>().join(", ");
    if all.len() > SHOWN_RANGES {
        text += &format!(", and {} more", all.len() - SHOWN_RANGES);
    }
    text
}

impl FieldChange {
    /// Writes the old and the new value of a field. The name of the field occupies `width` columns.
    fn write(&self, width: usize, out: &mut dyn Write) -> Result<(), Failure> {
        let name = &self.name;
        let relative = self
            .relative()
            .map(|relative| format!(" ({})", per_cent(relative)));
        match (&self.old, &self.new) {
            (Some(old), Some(new)) => writeln!(
                out,
                "  {name:<width$}  {} -> {}{}",
                old.text,
                new.text,
                relative.unwrap_or_default()
            )?,
            (Some(old), None) => writeln!(out, "  {name:<width$}  removed, was {}", old.text)?,
            (None, Some(new)) => writeln!(out, "  {name:<width$}  added, {}", new.text)?,
            (None, None) => {}
        }
        Ok(())
    }
}

/// Writes the natural frequency of a mode in the old and in the new scene, in Hz. Modes count from 1.
fn write_mode(
    mode: usize,
    pair: (Option<f64>, Option<f64>),
    out: &mut dyn Write,
) -> Result<(), Failure> {
    match pair {
        (Some(old), Some(new)) if (new - old).abs() <= ROUNDINGS * old => {
            writeln!(out, "  mode {mode}  {}, unchanged", computed(old))?;
        }
        (Some(old), Some(new)) => {
            let change = per_cent((new - old) / old);
            writeln!(
                out,
                "  mode {mode}  {} -> {} ({change})",
                computed(old),
                computed(new)
            )?;
        }
        (Some(old), None) => writeln!(out, "  mode {mode}  removed, was {}", computed(old))?,
        (None, Some(new)) => writeln!(out, "  mode {mode}  added, {}", computed(new))?,
        (None, None) => {}
    }
    Ok(())
}

impl Difference {
    /// Writes the largest difference of an answer, and the frequencies at which it was not compared.
    fn write(&self, out: &mut dyn Write) -> Result<(), Failure> {
        if self.left_out_by.is_empty() {
            writeln!(out, "  {}", self.name)?;
        } else {
            writeln!(out, "  {} ({})", self.name, self.left_out_by)?;
        }
        if u32::try_from(self.compared) != Ok(FREQUENCIES) {
            writeln!(
                out,
                "    compared at {} of {FREQUENCIES} frequencies, {}: not at {} Hz",
                self.compared,
                self.where_both,
                ranges(&self.gaps)
            )?;
        }
        let size = |relative: f64| per_cent(relative).trim_start_matches('+').to_owned();
        if self.relative <= ROUNDINGS {
            writeln!(out, "    unchanged, to rounding")?;
        } else if self.relative - self.smallest <= ROUNDINGS {
            writeln!(
                out,
                "    differs by {} at every compared frequency",
                size(self.relative)
            )?;
        } else {
            let unit = if self.unit.is_empty() {
                String::new()
            } else {
                format!(" {}", self.unit)
            };
            writeln!(
                out,
                "    largest difference {}, at {} Hz: {} -> {}{unit}; median {}",
                size(self.relative),
                computed(self.hertz),
                computed(self.values.0),
                computed(self.values.1),
                size(self.median)
            )?;
        }
        Ok(())
    }
}

impl Differences {
    /// Writes all differences as text.
    pub(super) fn write(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let [old, new] = &self.names;
        writeln!(out, "{old} -> {new}")?;
        if self.changes.is_empty() {
            writeln!(out, "\nThe descriptions describe the same scene.")?;
            return Ok(());
        }
        writeln!(out, "\nparameters")?;
        let width = self
            .changes
            .iter()
            .map(|change| change.name.chars().count());
        let width = width.max().unwrap_or(0);
        for change in &self.changes {
            change.write(width, out)?;
        }
        self.write_answers(out)?;
        if let Some(steppers) = &self.steppers {
            steppers.write(out)?;
        }
        let idle = self.without_effect();
        if !idle.is_empty() {
            writeln!(
                out,
                "\nno compared answer depends on the change of: {}",
                idle.join(", ")
            )?;
        }
        self.write_code(out)
    }

    fn write_answers(&self, out: &mut dyn Write) -> Result<(), Failure> {
        writeln!(out, "\nnatural frequencies (Hz)")?;
        for (mode, pair) in (1..).zip(&self.answers.modes) {
            write_mode(mode, *pair, out)?;
        }
        if let Some((from, to)) = self.answers.band {
            writeln!(
                out,
                "\nanswers at {FREQUENCIES} frequencies, logarithmically spaced from {} to {} Hz",
                computed(from),
                computed(to)
            )?;
            self.write_conditions(out)?;
        }
        for difference in &self.answers.differences {
            difference.write(out)?;
        }
        for reason in &self.answers.left_out {
            writeln!(out, "  not compared: {reason}")?;
        }
        Ok(())
    }

    /// Writes the compared range of frequencies, the formulas and the friction force of the compared answers.
    fn write_conditions(&self, out: &mut dyn Write) -> Result<(), Failure> {
        let range = |(from, to): (f64, f64)| format!("{} to {}", computed(from), computed(to));
        let [old, new] = self.answers.ratios.map(range);
        if old == new {
            writeln!(out, "  Frequency ratio r: {old} in both scenes.")?;
        } else {
            writeln!(
                out,
                "  Frequency ratio r: {old} (old scene), {new} (new scene)."
            )?;
        }
        let (low, high) = BAND;
        writeln!(
            out,
            "  Default range: {low} times the lowest to \
             {high} times the highest natural frequency of both scenes."
        )?;
        if self.answers.within_range {
            writeln!(
                out,
                "  The declared `range` narrows it. \
                 Code with tables returns an error outside its `range`."
            )?;
        }
        writeln!(
            out,
            "  The answers of both scenes come from the exact formulas in f64, not from tables."
        )?;
        for note in &self.notes {
            writeln!(out, "  {note}.")?;
        }
        writeln!(
            out,
            "  A difference is relative to the larger of both values, a change in brackets to the old value."
        )?;
        writeln!(
            out,
            "  Friction force for amplitudes, in both scenes: \
             {FRICTION} min(F_lim, F*_lim) of the old scene at each frequency."
        )?;
        writeln!(
            out,
            "  Phases, stuck responses and stick-slip motions are not compared."
        )?;
        Ok(())
    }

    fn write_code(&self, out: &mut dyn Write) -> Result<(), Failure> {
        writeln!(out, "\nemitted code in Rust")?;
        let code = match &self.code {
            Err(reason) => {
                writeln!(out, "  not compared: {reason}")?;
                return Ok(());
            }
            Ok(code) => code,
        };
        writeln!(
            out,
            "  Lines and bytes include documentation comments, \
             but not the header comment of `expand`."
        )?;
        // `compile` refuses several contacts, dashpots and `stribeck`, for which there is no band.
        if self.answers.band.is_some() {
            writeln!(
                out,
                "  C is not compared. \
                 `compile --format c -o NAME.c` writes its numbers to NAME_tables.h."
            )?;
        }
        let (removed, added) = code.differing;
        writeln!(
            out,
            "  lines            {} -> {}; {removed} removed, {added} added",
            code.lines.0, code.lines.1
        )?;
        writeln!(
            out,
            "  bytes of source  {} -> {}",
            code.bytes.0, code.bytes.1
        )?;
        if code.tables != (0, 0) {
            writeln!(
                out,
                "  bytes of tables  {} -> {}, without those of a step",
                code.tables.0, code.tables.1
            )?;
        }
        if code.functions.is_empty() {
            writeln!(out, "  operations       unchanged in every function")?;
        }
        for (name, old, new) in &code.functions {
            writeln!(out, "  operations of `{name}`")?;
            match (old, new) {
                (Some(old), Some(new)) => writeln!(out, "    {old}\n    -> {new}")?,
                (Some(old), None) => writeln!(out, "    function removed, had {old}")?,
                (None, Some(new)) => writeln!(out, "    function added, has {new}")?,
                (None, None) => {}
            }
        }
        Ok(())
    }
}

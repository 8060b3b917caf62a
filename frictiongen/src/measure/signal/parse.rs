//! Parses the text of a signal.

use super::{CHIRP_ERROR, MOST_PIECES, Shape, Signal, Target};
use crate::measure::error::MeasureError;
use crate::measure::recording::{Dimension, Unit};
use crate::study::System;
use crate::study::scene::Excitation;
use std::f64::consts::{PI, TAU};

/// All shapes, each with an example.
const SHAPES: [(&str, &str); 7] = [
    ("const", "`const 5 N`"),
    ("step", "`step 5 N from 1 s`"),
    ("ramp", "`ramp 5 N for 2 s`"),
    ("sine", "`sine 5 N at 2 Hz`"),
    ("half-sine", "`half-sine 5 N for 20 ms`"),
    ("rectangle", "`rectangle 5 N for 20 ms`"),
    ("chirp", "`chirp 5 N at 1 Hz to 9 Hz for 20 s`"),
];

/// Numbers behind the words of a signal.
#[derive(Debug, Default)]
struct Words {
    on: Option<String>,
    at: Option<f64>,
    to: Option<f64>,
    from: Option<f64>,
    lasts: Option<f64>,
}

impl Signal {
    /// Parses a signal for a scene.
    ///
    /// # Errors
    /// [`MeasureError::Signal`] for a text that is not a signal, and for a signal that the scene cannot have.
    pub fn parse(text: &str, system: &System) -> Result<Self, MeasureError> {
        read(text, system).map_err(|what| MeasureError::Signal {
            text: text.trim().to_owned(),
            what,
        })
    }
}

fn read(text: &str, system: &System) -> Result<Signal, String> {
    let text = text.replace(',', " ");
    let mut words = text.split_whitespace();
    let shape = words.next().unwrap_or_default();
    if shape == "pulse" {
        return Err("a pulse is `half-sine` or `rectangle`; write one of them".to_owned());
    }
    let known = SHAPES.iter().find(|(name, _)| *name == shape);
    let Some((_, example)) = known else {
        let examples = SHAPES.map(|(_, example)| example).join(", ");
        return Err(format!(
            "`{shape}` is no shape; write, for example, {examples}"
        ));
    };
    let (amplitude, unit) = quantity(&mut words, "an amplitude such as `5 N` or `0.2 g`")?;
    let said = clauses(&mut words)?;
    said.check(shape, example)?;
    let (target, scale) = target(unit, said.on.as_deref(), system)?;
    let length = said.lasts.unwrap_or(f64::INFINITY);
    let omega = TAU * said.at.unwrap_or(0.0);
    let shape = match shape {
        "ramp" => Shape::Ramp,
        "sine" => Shape::Sine(omega),
        "half-sine" => Shape::Sine(PI / length),
        "chirp" if target == Target::Displacement => {
            return Err(
                "a chirp of the base is a velocity or an acceleration; give its amplitude in such a unit"
                    .to_owned(),
            );
        }
        "chirp" => chirp([omega, TAU * said.to.unwrap_or(0.0)], length)?,
        _ => Shape::Step,
    };
    let amplitude = amplitude * scale;
    if !amplitude.is_finite() {
        return Err("the amplitude must be a finite number".to_owned());
    }
    Ok(Signal {
        target,
        shape,
        amplitude,
        start: said.from.unwrap_or(0.0),
        length,
    })
}

/// Returns a chirp in pieces of constant frequency. Inside a piece, the phase differs by at most κh²/8, where κ is the rate
/// of the angular frequency and h is the length of the piece.
fn chirp(ends: [f64; 2], length: f64) -> Result<Shape, String> {
    let rate = (ends[1] - ends[0]).abs() / length;
    let pieces = (length * (rate / (8.0 * CHIRP_ERROR)).sqrt())
        .ceil()
        .max(1.0);
    if pieces <= MOST_PIECES {
        return Ok(Shape::Chirp { ends, pieces });
    }
    Err(format!(
        "to an error of {CHIRP_ERROR:e} of its amplitude, the chirp needs {pieces:e} pieces of constant frequency, more than \
         {MOST_PIECES:e}; give a shorter chirp or closer frequencies"
    ))
}

/// Returns the target of a signal, and the size of its unit in SI units.
fn target(unit: Unit, on: Option<&str>, system: &System) -> Result<(Target, f64), String> {
    let scene = system.scene();
    let on_base = scene.excitation == Excitation::Base && system.loaded().is_ok();
    let target = match unit.dimension() {
        Dimension::Force => Target::Force(loaded_mass(on, system)?),
        Dimension::Time => return Err(format!("`{}` is no unit of an amplitude", unit.name())),
        _ if on.is_some() => {
            return Err(format!(
                "`on` belongs to a force, but `{}` moves the base; leave `on` out or give a force",
                unit.name()
            ));
        }
        _ if !on_base => {
            return Err(format!(
                "`{}` moves the base, but the base of this scene is at rest; write `excitation: base` in the description, or \
                 give a force",
                unit.name()
            ));
        }
        Dimension::Displacement => Target::Displacement,
        Dimension::Velocity => Target::Velocity,
        Dimension::Acceleration => Target::Acceleration,
    };
    Ok((target, unit.scale()))
}

/// Returns the index of the mass on which a force acts.
fn loaded_mass(on: Option<&str>, system: &System) -> Result<usize, String> {
    let scene = system.scene();
    let names: Vec<&str> = scene.masses.iter().map(|mass| mass.name.as_str()).collect();
    if let Some(on) = on {
        let index = names.iter().position(|name| *name == on);
        return index
            .ok_or_else(|| format!("`{on}` is no mass; the masses are {}", names.join(", ")));
    }
    match scene.excitation {
        Excitation::Force(mass) if system.loaded().is_ok() => Ok(mass),
        _ => Err(format!(
            "`excitation` names no mass; name a mass as in `on {}`",
            names.first().copied().unwrap_or_default()
        )),
    }
}

/// Reads the words behind the amplitude, with their numbers.
fn clauses<'t>(words: &mut impl Iterator<Item = &'t str>) -> Result<Words, String> {
    let mut said = Words::default();
    while let Some(word) = words.next() {
        let (slot, given) = match word {
            "on" => {
                let name = words.next().ok_or("`on` needs the name of a mass")?;
                if said.on.replace(name.to_owned()).is_some() {
                    return Err("`on` stands twice".to_owned());
                }
                continue;
            }
            "at" => (&mut said.at, frequency(words, word)?),
            "to" => (&mut said.to, frequency(words, word)?),
            "from" => (&mut said.from, time(words, word)?),
            "for" => (&mut said.lasts, time(words, word)?),
            _ => {
                return Err(format!(
                    "`{word}` is not understood; behind the amplitude stand `on NAME`, `at … Hz`, `to … Hz`, `from … s` and \
                     `for … s`"
                ));
            }
        };
        if slot.replace(given).is_some() {
            return Err(format!("`{word}` stands twice"));
        }
    }
    Ok(said)
}

impl Words {
    /// Fails for a missing or superfluous word. `example` is a signal of this shape.
    fn check(&self, shape: &str, example: &str) -> Result<(), String> {
        let (needs_at, needs_to) = (matches!(shape, "sine" | "chirp"), shape == "chirp");
        let needs_length = matches!(shape, "ramp" | "half-sine" | "rectangle" | "chirp");
        let missing = |word: &str| Err(format!("`{shape}` needs `{word}`, as in {example}"));
        let surplus = |word: &str| Err(format!("`{shape}` has no `{word}`; leave it out"));
        match () {
            () if needs_at && self.at.is_none() => missing("at … Hz"),
            () if needs_to && self.to.is_none() => missing("to … Hz"),
            () if needs_length && self.lasts.is_none() => missing("for … s"),
            () if !needs_at && self.at.is_some() => surplus("at"),
            () if !needs_to && self.to.is_some() => surplus("to"),
            () if shape == "const" && (self.from.is_some() || self.lasts.is_some()) => {
                Err("`const` acts at all times; with `from` or `for`, write `step`".to_owned())
            }
            () => Ok(()),
        }
    }
}

/// Reads a frequency in Hz above 0.
fn frequency<'t>(words: &mut impl Iterator<Item = &'t str>, word: &str) -> Result<f64, String> {
    let (number, unit) = number(words, &format!("`{word}` needs a frequency such as `2 Hz`"))?;
    if unit != "Hz" {
        let hint = if seconds(unit).is_some() {
            "; the start is `from … s`"
        } else {
            ""
        };
        return Err(format!(
            "`{word}` gives a frequency in Hz, not in `{unit}`{hint}"
        ));
    }
    if 0.0 < number && number.is_finite() {
        return Ok(number);
    }
    Err(format!(
        "the frequency behind `{word}` must be above 0 Hz and finite"
    ))
}

/// Reads a time: a start from 0 s on, or a length above 0 s.
fn time<'t>(words: &mut impl Iterator<Item = &'t str>, word: &str) -> Result<f64, String> {
    let (number, unit) = number(words, &format!("`{word}` needs a time such as `0.5 s`"))?;
    let scale = seconds(unit)
        .ok_or_else(|| format!("`{word}` gives a time in s, ms or us, not in `{unit}`"))?;
    let (least, fits) = match word {
        "for" => ("above", 0.0 < number),
        _ => ("at least", 0.0 <= number),
    };
    if fits && number.is_finite() {
        return Ok(number * scale);
    }
    Err(format!(
        "the time behind `{word}` must be {least} 0 s and finite"
    ))
}

/// Reads a number and its unit.
fn quantity<'t>(
    words: &mut impl Iterator<Item = &'t str>,
    needed: &str,
) -> Result<(f64, Unit), String> {
    let (number, unit) = number(words, needed)?;
    let unit = unit.parse::<Unit>().map_err(|error| error.to_string())?;
    Ok((number, unit))
}

/// Reads a number and the word of its unit, which may follow the number without a blank.
fn number<'t>(
    words: &mut impl Iterator<Item = &'t str>,
    needed: &str,
) -> Result<(f64, &'t str), String> {
    let word = words.next().ok_or_else(|| format!("it lacks {needed}"))?;
    if let Ok(number) = word.parse::<f64>() {
        let unit = words.next();
        return Ok((
            number,
            unit.ok_or_else(|| format!("`{word}` has no unit; write {needed}"))?,
        ));
    }
    let splits = word.char_indices().map(|(place, _)| word.split_at(place));
    let mut splits = splits.filter_map(|(number, unit)| Some((number.parse().ok()?, unit)));
    let longest = splits.by_ref().last();
    longest.ok_or_else(|| format!("`{word}` is no number; write {needed}"))
}

/// Returns the size of a unit of time in s, or `None` for another unit.
fn seconds(unit: &str) -> Option<f64> {
    let unit: Unit = unit.parse().ok()?;
    (unit.dimension() == Dimension::Time).then(|| unit.scale())
}

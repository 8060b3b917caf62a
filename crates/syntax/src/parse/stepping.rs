//! Parses the fields of a description for the friction law and for the stepper.

use frictiongen_model::scene::StepInput;

use super::chain::braces;
use super::declared::choice;
use super::forms::{arguments, mass_names};
use super::number::{Number, number};
use super::reader::{Name, Read, TokenReader};
use super::suggest;
use super::syntax::{Choice, FrictionEntry, LawEntry, Placed};
use super::token::Delimiter;
use crate::diagnostics::{Problems, Reported, TokenPosition};

/// Advice for a user who gives a friction force in a description, which must not contain one.
pub(crate) const HOW_MUCH: &str = "delete it here: each request takes the friction as an argument, the force F or the friction ratio β = F/P; the field `stiction` is μ, static over kinetic friction";

/// Smooth laws of friction in the literature, which are not linear between two events.
const SMOOTH: [&str; 3] = ["dahl", "lugre", "bouc_wen"];

/// Parses the friction law: `coulomb` or `stribeck(v₁: f₁, …)`.
pub(crate) fn friction(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<FrictionEntry> {
    const LAWS: &str =
        "write `coulomb` or, for the stepper and the simulation, `stribeck(0.1: 0.8)`";
    let place = reader.place();
    let Some(word) = reader.take_word() else {
        let message = format!(
            "the friction must be a law, not {}; {LAWS}; if the number is the amount of friction, {HOW_MUCH}",
            reader.found()
        );
        problems.report(place, message);
        return Read::lost();
    };
    let law = match word.text.as_str() {
        "coulomb" => Ok(LawEntry::Coulomb),
        "stribeck" => points(reader, problems, place).map(LawEntry::Stribeck),
        text if SMOOTH.contains(&text.to_lowercase().as_str()) => {
            let message = format!(
                "`{text}` is not linear between two events, so that no exact solution exists; elastic contacts answer most of it: give the contact a `stiffness`, or write several elastic contacts side by side for a smooth loop; for a friction that falls with the speed, write `stribeck: exp(1.3, 0.05)`"
            );
            let reported = problems.report(place, message);
            let _ = reader.take_group(Delimiter::Parenthesis);
            Err(reported)
        }
        text => {
            let hint = suggest::hint(text, ["coulomb", "stribeck"], || LAWS.to_owned());
            let reported = problems.report(place, format!("there is no friction `{text}`{hint}"));
            // After an unknown friction law, the parser also skips the points in parentheses.
            let _ = reader.take_group(Delimiter::Parenthesis);
            Err(reported)
        }
    };
    // The parser consumes the bracket even if the points in it have errors, so that the reader is at the end of the
    // entry.
    Read {
        value: law.ok().map(|law| FrictionEntry { place, law }),
        clean: true,
    }
}

/// Parses a friction that decays with the speed: `exp(fs, vs)`, or `exp(fs, vs, accuracy)`.
pub(crate) fn stribeck(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<FrictionEntry> {
    const FORM: &str = "write `stribeck: exp(fs, vs)` for a friction that falls from fs·F at rest to F as exp(−|v|/vs), for example `exp(1.3, 0.05)`; for straight lines, write `friction: stribeck(0.1: 0.8)`";
    let place = reader.place();
    let word = reader.take_word();
    let inside = reader.take_group(Delimiter::Parenthesis);
    let (Some("exp"), Some(inside)) = (word.as_ref().map(|word| word.text.as_str()), inside) else {
        problems.report(place, FORM);
        return Read::lost();
    };
    let numbers = arguments(inside, problems);
    let numbers = numbers.and_then(|numbers| match numbers.len() {
        2 | 3 => Ok(numbers),
        count => {
            let message = format!("`exp` takes two or three numbers, not {count}; {FORM}");
            Err(problems.report(place, message))
        }
    });
    let law = numbers.map(LawEntry::Decaying);
    Read {
        value: law.ok().map(|law| FrictionEntry { place, law }),
        clean: true,
    }
}

/// Parses the points of a friction law, in parentheses. Fails if the parser could not read all points, because the
/// positions of the other points in the list are then uncertain.
fn points(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    place: TokenPosition,
) -> Result<Vec<[Number; 2]>, Reported> {
    let Some(mut inside) = reader.take_group(Delimiter::Parenthesis) else {
        let message = "`stribeck` needs points in parentheses, each a speed and a kinetic level over F; write, for example, `stribeck(0.1: 0.8)`";
        let reported = problems.report(place, message);
        let _ = reader.take_group(Delimiter::Bracket);
        let _ = reader.take_group(Delimiter::Brace);
        return Err(reported);
    };
    if inside.reader.is_word(0) {
        let message = "`stribeck(…)` takes points, each a speed and a kinetic level over F, as in `stribeck(0.1: 0.8)`; for an exponential decay, write the field `stribeck: exp(1.3, 0.05)` in place of `friction`";
        return Err(problems.report(place, message));
    }
    let list = inside.reader.list(
        problems,
        |_| false,
        |_| false,
        |reader, problems| point(reader, problems).unwrap_or_else(|Reported| Read::lost()),
    );
    if list.complete {
        Ok(list.entries)
    } else {
        Err(Reported)
    }
}

/// Parses a point of a friction law: `speed: level`.
fn point(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Result<Read<[Number; 2]>, Reported> {
    let speed = number(reader, problems);
    if !speed.clean {
        return Err(Reported);
    }
    reader.take_colon(problems, "a speed and its kinetic level")?;
    let level = number(reader, problems);
    Ok(Read {
        value: speed
            .value
            .zip(level.value)
            .map(|(speed, level)| [speed, level]),
        clean: level.clean,
    })
}

/// Parses the interpolation of the stepper's input within a step: `hold` (constant) or `linear`.
pub(crate) fn input(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Choice<StepInput>> {
    let choices = [("hold", StepInput::Hold), ("linear", StepInput::Linear)];
    choice(reader, problems, "input", choices)
}

/// Parses the names of the masses on which the stepper may apply a force: `{ name, … }`.
pub(crate) fn force(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<Placed<Name>> {
    braces(
        reader,
        problems,
        "the masses that the stepper may load must be in braces",
        "{ m1, m2 }",
        |inner, problems| mass_names(inner, problems, "force: { m1 }"),
    )
}

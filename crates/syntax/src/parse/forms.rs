//! Parses the fields of a description for damping and for the items to provide.

use super::declared::choice;
use super::number::{Number, hundredth, number};
use super::reader::{Inside, List, Name, Read, TokenReader};
use super::suggest;
use super::syntax::{Choice, DampingEntry, DampingKind, Placed, ProvideEntry, ProvideKind};
use super::token::{Delimiter, Token, TokenKind};
use crate::diagnostics::{Problems, Reported, TokenPosition};
use frictiongen_model::scene::DampingFrom;

const DAMPING: [&str; 3] = ["none", "modal", "rayleigh"];
/// Words of the field `provide`. Each word names a group of methods that the macro emits.
const PROVIDE: [&str; 7] = [
    "limits",
    "motion",
    "stuck",
    "orbit",
    "simulation",
    "stepper",
    "self_check",
];

/// Parses the velocities on which damping acts: `rest` for absolute velocities, or `base` for velocities relative to
/// the moving base.
pub(crate) fn damping_from(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Choice<DampingFrom>> {
    let choices = [("rest", DampingFrom::Rest), ("base", DampingFrom::Base)];
    choice(reader, problems, "damping_from", choices)
}

/// Parses the damping: `none`, `modal(ζ)`, `modal[ζ₁, …]` or `rayleigh(a, b)`.
pub(crate) fn damping(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<DampingEntry> {
    let place = reader.place();
    let Some(word) = reader.take_word() else {
        let message = format!(
            "the damping is `none`, `modal(ζ)`, `modal[ζ1, ζ2]` or `rayleigh(a, b)`, not {}; write, for example, `modal({})`",
            reader.found(),
            ratio_for(reader).unwrap_or(0.01)
        );
        problems.report(place, message);
        return Read::lost();
    };
    let kind = match word.text.as_str() {
        "none" => Ok(DampingKind::None),
        "modal" => modal(reader, problems, place),
        "rayleigh" => rayleigh(reader, problems, place),
        text => {
            let hint = suggest::hint(text, DAMPING, || {
                "write `none`, `modal(0.01)`, `modal[0.01, 0.02]` or `rayleigh(0.1, 0.001)`"
                    .to_owned()
            });
            problems.report(place, format!("there is no damping `{text}`{hint}"));
            // After an unknown kind of damping, the parser also skips the numbers in parentheses.
            let _ = reader.take_group(Delimiter::Parenthesis);
            let _ = reader.take_group(Delimiter::Bracket);
            return Read {
                value: None,
                clean: true,
            };
        }
    };
    // The parser consumes the bracket even if the numbers in it have errors, so that the reader is at the end of the
    // entry.
    Read {
        value: kind.ok().map(|kind| DampingEntry { place, kind }),
        clean: true,
    }
}

/// Returns the damping ratio that the author of `damping: number` probably means. A number below 1 is the ratio
/// itself. A number of 1 or more, or a number before `%`, is a percentage.
fn ratio_for(reader: &TokenReader<'_>) -> Option<f64> {
    let Some(Token {
        kind: TokenKind::Number(text),
        ..
    }) = reader.peek(0)
    else {
        return None;
    };
    let value: f64 = text.parse().ok()?;
    Some(if reader.is_punct(1, '%') || value >= 1.0 {
        hundredth(value)
    } else {
        value
    })
}

fn modal(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    place: TokenPosition,
) -> Result<DampingKind, Reported> {
    if let Some(mut inside) = reader.take_group(Delimiter::Bracket) {
        return Ok(DampingKind::Modal(
            numbers(&mut inside.reader, problems).entries,
        ));
    }
    let Some(inside) = reader.take_group(Delimiter::Parenthesis) else {
        let message = "`modal` needs damping ratios; write `modal(0.01)` for the same ratio in all modes, or `modal[0.01, 0.02]` for one ratio per mode";
        let reported = problems.report(place, message);
        let _ = reader.take_group(Delimiter::Brace);
        return Err(reported);
    };
    match arguments(inside, problems)?.as_slice() {
        [ratio] => Ok(DampingKind::Uniform(*ratio)),
        found => Err(problems.report(
            place,
            format!(
                "`modal(…)` takes one damping ratio for all modes, not {}; for one ratio per mode, write square brackets, `modal[0.01, 0.02]`; a decimal fraction has a point, not a comma",
                found.len()
            ),
        )),
    }
}

fn rayleigh(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    place: TokenPosition,
) -> Result<DampingKind, Reported> {
    const FORM: &str =
        "write `rayleigh(a, b)` with C = aM + bK, for example `rayleigh(0.1, 0.001)`";
    let Some(inside) = reader.take_group(Delimiter::Parenthesis) else {
        let reported = problems.report(
            place,
            format!("`rayleigh` needs two factors in parentheses; {FORM}"),
        );
        let _ = reader.take_group(Delimiter::Bracket);
        let _ = reader.take_group(Delimiter::Brace);
        return Err(reported);
    };
    match arguments(inside, problems)?.as_slice() {
        [mass, stiffness] => Ok(DampingKind::Rayleigh(*mass, *stiffness)),
        found => Err(problems.report(
            place,
            format!("`rayleigh` takes two factors, not {}; {FORM}", found.len()),
        )),
    }
}

/// Parses the numbers in parentheses. Fails if the parser could not read all numbers, because the positions of the
/// other numbers in the list are then uncertain.
pub(super) fn arguments(
    mut inside: Inside<'_>,
    problems: &mut Problems,
) -> Result<Vec<Number>, Reported> {
    let list = numbers(&mut inside.reader, problems);
    if list.complete {
        Ok(list.entries)
    } else {
        Err(Reported)
    }
}

fn numbers(reader: &mut TokenReader<'_>, problems: &mut Problems) -> List<Number> {
    reader.list(problems, |_| false, |_| false, number)
}

/// Parses the list of items that the scene provides.
pub(crate) fn provide(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<ProvideEntry>> {
    let place = reader.place();
    let Some(mut inside) = reader.take_group(Delimiter::Bracket) else {
        let message = format!(
            "`provide` must be a list in square brackets, but here is {}; write, for example, `[limits, motion]`",
            reader.found()
        );
        problems.report(place, message);
        return Read::lost();
    };
    let begins = |reader: &TokenReader<'_>| reader.is_word(0);
    let list = inside.reader.list(
        problems,
        begins,
        |_| false,
        |reader, problems| provide_item(reader, problems).into(),
    );
    Read::clean(Placed {
        list,
        place: inside.place,
    })
}

fn provide_item(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Result<ProvideEntry, Reported> {
    let place = reader.place();
    let all = || format!("write one or more of {}", PROVIDE.join(", "));
    let Some(word) = reader.take_word() else {
        let message = format!("{} cannot be provided; {}", reader.found(), all());
        return Err(problems.report(place, message));
    };
    let kind = match word.text.as_str() {
        "limits" => ProvideKind::Limits,
        "stuck" => ProvideKind::Stuck,
        "orbit" => ProvideKind::Orbit,
        "simulation" => ProvideKind::Simulation,
        "stepper" => ProvideKind::Stepper,
        "self_check" => ProvideKind::SelfCheck,
        "motion" => ProvideKind::Motion(
            reader
                .take_group(Delimiter::Parenthesis)
                .map(|mut inside| mass_names(&mut inside.reader, problems, "motion(m1)")),
        ),
        text => {
            let hint = suggest::hint(text, PROVIDE, all);
            return Err(problems.report(place, format!("`{text}` cannot be provided{hint}")));
        }
    };
    Ok(ProvideEntry { place, kind })
}

/// Parses a list of mass names. Error messages show `example`, a valid list.
pub(crate) fn mass_names(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    example: &str,
) -> List<Name> {
    let begins = |reader: &TokenReader<'_>| reader.is_word(0);
    reader.list(
        problems,
        begins,
        |_| false,
        |reader, problems| {
            let place = reader.place();
            reader
                .take_word()
                .ok_or_else(|| {
                    let message = format!(
                        "the name of a mass belongs here, not {}; write, for example, `{example}`",
                        reader.found()
                    );
                    problems.report(place, message)
                })
                .into()
        },
    )
}

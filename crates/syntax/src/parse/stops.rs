//! Parses the fields `stops` and `constant` (constant forces) of a description.

use super::chain::{braces, ends};
use super::joints::{Properties, Property, filled};
use super::number::number;
use super::reader::{Name, Read, TokenReader};
use super::syntax::{MassEntry, Placed, StopEntry};
use crate::diagnostics::{Problems, Reported};

/// The properties that a stop may have.
const PROPERTIES: Properties<4> = Properties {
    owner: "stop",
    names: ["gap", "stiffness", "damping", "restitution"],
    example: "gap: 0.002",
};

/// Parses the field `stops`: `{ name: node - node { gap: number, stiffness: number, damping: number }, … }`, with
/// `restitution: number` in place of the stiffness and the damping.
pub(crate) fn stops(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<StopEntry>> {
    let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
    let read = braces(
        reader,
        problems,
        "the stops must be in braces",
        "{ bumper: m1 - wall { gap: 0.002, stiffness: 1e6 } }",
        |inner, problems| {
            inner.list(problems, begins, begins, |reader, problems| {
                stop(reader, problems).unwrap_or_else(|Reported| Read::lost())
            })
        },
    );
    filled(
        read,
        problems,
        "`stops` lists no stop; write, for example, `bumper: m1 - wall { gap: 0.002, stiffness: 1e6 }`, or leave the field out",
    )
}

fn stop(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Result<Read<StopEntry>, Reported> {
    let place = reader.place();
    let Some(name) = reader.take_word() else {
        let message = format!(
            "the name of a stop belongs here, not {}; write, for example, `bumper: m1 - wall {{ gap: 0.002, stiffness: 1e6 }}`",
            reader.found()
        );
        return Err(problems.report(place, message));
    };
    if reader.is_punct(0, '-') {
        let message = format!(
            "a stop needs a name before its sides; write, for example, `bumper: {} - wall {{ gap: 0.002, stiffness: 1e6 }}`",
            name.text
        );
        return Err(problems.report(place, message));
    }
    reader.take_colon(problems, "the name of a stop and its sides")?;
    let (from, to) = ends(reader, problems, "the stop", "m1 - wall")?;
    let (values, complete) = PROPERTIES.read(reader, problems);
    // A property that the parser could not read may be one that seems to be missing.
    if complete {
        check_forms(&name, values, problems);
    }
    let [gap, stiffness, damping, restitution] =
        values.map(|value| value.map(|Property { number, .. }| number));
    Ok(Read::clean(StopEntry {
        name,
        from,
        to,
        gap,
        stiffness,
        damping,
        restitution,
        complete,
    }))
}

/// Reports properties of a stop that are missing, and properties that exclude each other.
fn check_forms(name: &Name, values: [Option<Property>; 4], problems: &mut Problems) {
    let [gap, stiffness, damping, restitution] = values;
    let text = &name.text;
    let impact = stiffness.is_some() || restitution.is_some();
    match (gap, impact) {
        (Some(_), true) => {}
        (None, true) => {
            let message = format!(
                "the stop `{text}` has no gap; write, for example, `gap: 0.002`, or `gap: 0` for sides that touch at rest"
            );
            problems.report(name.place, message);
        }
        (Some(_), false) => {
            let message = format!(
                "the stop `{text}` has neither `stiffness` nor `restitution`; write, for example, `stiffness: 1e6`, or `restitution: 0.8` for a rigid stop"
            );
            problems.report(name.place, message);
        }
        (None, false) => {
            let message = format!(
                "the stop `{text}` needs a gap, and a `stiffness` or a `restitution`; write them in braces after its sides, for example `{{ gap: 0.002, stiffness: 1e6 }}`"
            );
            problems.report(name.place, message);
        }
    }
    let Some(restitution) = restitution else {
        return;
    };
    if stiffness.is_some() {
        problems.report(
            restitution.place,
            "`stiffness` and `restitution` exclude each other: a stop with `restitution` is rigid; keep one of the two",
        );
    }
    if let Some(damping) = damping {
        problems.report(
            damping.place,
            "`damping` belongs to a stop with `stiffness`: `restitution` is the loss of a rigid stop; leave one of the two out",
        );
    }
}

/// Parses the field `constant`: `{ mass: number, … }`.
pub(crate) fn constant(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Placed<MassEntry>> {
    let begins = |reader: &TokenReader<'_>| reader.is_word(0) && reader.is_punct(1, ':');
    let read = braces(
        reader,
        problems,
        "the constant forces must be in braces",
        "{ m1: 9.81 }",
        |inner, problems| {
            inner.list(problems, begins, begins, |reader, problems| {
                force(reader, problems).unwrap_or_else(|Reported| Read::lost())
            })
        },
    );
    filled(
        read,
        problems,
        "`constant` lists no force; write, for example, `m1: 9.81`, or leave the field out",
    )
}

/// Parses one constant force: `mass: number`.
fn force(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Result<Read<MassEntry>, Reported> {
    let place = reader.place();
    let Some(name) = reader.take_word() else {
        let message = format!(
            "the name of a mass belongs here, not {}; write, for example, `m1: 9.81`",
            reader.found()
        );
        return Err(problems.report(place, message));
    };
    reader.take_colon(problems, "the name of a mass and the force on it")?;
    let value = number(reader, problems);
    Ok(Read {
        value: value.value.map(|value| MassEntry { name, value }),
        clean: value.clean,
    })
}

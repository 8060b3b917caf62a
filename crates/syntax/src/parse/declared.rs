//! Parses the fields of a description about tables, which replace the exact formulas: their accuracy, the range of r
//! and β in which they are valid, and more.

use frictiongen_model::scene::{Beyond, Proving, Side};

use super::number::number;
use super::reader::{Read, TokenReader};
use super::suggest;
use super::syntax::{AccuracyEntry, Choice, RangeEntry, RangeSyntax};
use super::token::Delimiter;
use crate::diagnostics::{Problems, Reported};

/// Parses the declared accuracy: `exact` or a number.
pub(crate) fn accuracy(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<AccuracyEntry> {
    let place = reader.place();
    if !reader.is_word(0) {
        let Read { value, clean } = number(reader, problems);
        return Read {
            value: value.map(AccuracyEntry::Relative),
            clean,
        };
    }
    if reader.take_word().is_some_and(|word| word.text == "exact") {
        return Read::clean(AccuracyEntry::Exact);
    }
    problems.report(
        place,
        "an accuracy must be `exact` or a relative error; write, for example, `accuracy: 1e-4`",
    );
    Read {
        value: None,
        clean: true,
    }
}

/// Parses the declared range of the emitted tables: `{ r: a..b, beta: a..b }`.
pub(crate) fn range(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<RangeEntry> {
    let place = reader.place();
    let Some(mut inside) = reader.take_group(Delimiter::Brace) else {
        let message = format!(
            "a range must be in braces, but here is {}; write, for example, `{{ r: 0.2..2.5 }}`",
            reader.found()
        );
        problems.report(place, message);
        return Read::lost();
    };
    let mut entry = RangeEntry {
        place,
        ratio: None,
        friction: None,
    };
    let mut sound = true;
    let list = inside.reader.list(
        problems,
        |reader| reader.is_word(0) && reader.is_punct(1, ':'),
        |_| false,
        |reader, problems| part(reader, problems, &mut entry).into(),
    );
    sound &= list.complete;
    if sound && entry.ratio.is_none() {
        problems.report(
            place,
            "a range must include the frequency ratio `r`; write, for example, `{ r: 0.2..2.5 }`",
        );
        sound = false;
    }
    Read {
        value: sound.then_some(entry),
        clean: true,
    }
}

/// Parses one range of the declaration: `r: a..b` or `beta: a..b`.
fn part(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    entry: &mut RangeEntry,
) -> Result<(), Reported> {
    let place = reader.place();
    let Some(word) = reader.take_word() else {
        let message = format!(
            "a range begins with `r` or `beta`, not {}; write, for example, `r: 0.2..2.5`",
            reader.found()
        );
        return Err(problems.report(place, message));
    };
    let slot = match word.text.as_str() {
        "r" => &mut entry.ratio,
        "beta" => &mut entry.friction,
        text => {
            let hint = suggest::hint(text, ["r", "beta"], || "write `r` or `beta`".to_owned());
            return Err(problems.report(place, format!("there is no range of `{text}`{hint}")));
        }
    };
    if slot.is_some() {
        let message = format!("`{}` is given twice; keep one of the two", word.text);
        return Err(problems.report(place, message));
    }
    reader.take_colon(problems, "the name of a range and its bounds")?;
    let low = number(reader, problems);
    let dots = reader.place();
    if !(low.clean && reader.take_punct('.') && reader.take_punct('.')) {
        if !low.clean {
            return Err(Reported);
        }
        let message = format!(
            "two points (`..`) must separate the bounds of a range, not {}; write, for example, `0.2..2.5`",
            reader.found()
        );
        return Err(problems.report(dots, message));
    }
    // The range includes both bounds, so `..=` means the same as `..` here.
    let _ = reader.take_punct('=');
    let high = number(reader, problems);
    if !high.clean {
        return Err(Reported);
    }
    if let (Some(low), Some(high)) = (low.value, high.value) {
        *slot = Some(RangeSyntax { low, high });
    }
    Ok(())
}

/// Parses the side of the exact limits on which the limits from tables may lie: `near` (either side) or `safe` (only
/// the safe side).
pub(crate) fn side(reader: &mut TokenReader<'_>, problems: &mut Problems) -> Read<Choice<Side>> {
    choice(
        reader,
        problems,
        "side",
        [("near", Side::Near), ("safe", Side::Safe)],
    )
}

/// Parses the behaviour of the emitted code outside the declared range: `error`, or `exact` for the exact formulas.
pub(crate) fn beyond(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Choice<Beyond>> {
    let choices = [("error", Beyond::Error), ("exact", Beyond::Exact)];
    choice(reader, problems, "beyond", choices)
}

/// Parses the time that the macro may spend on a proof of the tables' accuracy: `quick` or `whole`.
pub(crate) fn proof(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
) -> Read<Choice<Proving>> {
    let choices = [("quick", Proving::Quick), ("whole", Proving::Whole)];
    choice(reader, problems, "proof", choices)
}

pub(crate) fn choice<T: Copy>(
    reader: &mut TokenReader<'_>,
    problems: &mut Problems,
    field: &str,
    choices: [(&'static str, T); 2],
) -> Read<Choice<T>> {
    let place = reader.place();
    let [(first, _), (second, _)] = choices;
    let all = || format!("write `{first}` or `{second}`");
    let Some(word) = reader.take_word() else {
        let message = format!("`{field}` is a word, not {}; {}", reader.found(), all());
        problems.report(place, message);
        return Read::lost();
    };
    let known = choices.iter().find(|(name, _)| *name == word.text);
    if let Some((_, value)) = known {
        return Read::clean(Choice {
            value: *value,
            place,
        });
    }
    let hint = suggest::hint(&word.text, [first, second], all);
    problems.report(place, format!("`{field}` cannot be `{}`{hint}", word.text));
    Read {
        value: None,
        clean: true,
    }
}

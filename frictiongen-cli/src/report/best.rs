//! The best friction for each mass that is shown.

use super::asked::Asked;
use super::words::{Words, number, object};
use crate::asked::Part;
use frictiongen::Of;
use frictiongen::study::{
    FrequencyBand, Optimum, OptimumError, OptimumKind, OptimumRequest, words,
};
use maud::{Markup, html};
use serde_json::{Value as Json, json};

/// The most masses of a chain whose best friction is looked for; of longer ones it takes minutes.
const MOST_MASSES: usize = 12;
/// The most masses of a chain for which it is looked for over the whole range.
const WHOLE_RANGE: usize = 4;
/// The most motions whose best friction is looked for.
const MOST_MOTIONS: usize = 4;

/// The best friction for one motion, or why there is none.
pub struct Best {
    /// Of which motion.
    pub part: Part,
    /// What was found.
    pub found: Result<Optimum, OptimumError>,
}

/// Over which frequencies it is looked for: the range, or of a longer chain as much of it as has the lowest resonance
/// alone, since over all of them it takes more amplitudes than are computed.
pub fn band(asked: &Asked) -> (f64, f64) {
    let (from, to) = (asked.band.from, asked.band.to);
    match asked.system.resonances() {
        [first, second, ..] if WHOLE_RANGE < asked.system.scene().masses.len() => {
            let between = (first * second).sqrt();
            (from, if from < between { to.min(between) } else { to })
        }
        _ => (from, to),
    }
}

/// The best frictions, or why none was looked for.
pub fn search(asked: &Asked) -> Result<Vec<Best>, String> {
    let masses = asked.system.scene().masses.len();
    if MOST_MASSES < masses {
        return Err(format!(
            "The best friction of a chain of more than {MOST_MASSES} masses is not looked for here: it takes minutes. \
             “frictiongen optimum” finds it for one motion."
        ));
    }
    let (from, to) = band(asked);
    let only_contact = asked.parts.iter().all(|part| part.of == Of::Contact);
    let parts = asked.parts.iter();
    let parts = parts.filter(|part| only_contact || part.of != Of::Contact);
    let best = |part: &Part| Best {
        part: part.clone(),
        found: asked.system.optimum(&OptimumRequest {
            of: part.of,
            band: FrequencyBand::Ratio(from, to),
            load: asked.words.measure.load(),
        }),
    };
    Ok(parts.take(MOST_MOTIONS).map(best).collect())
}

/// The one for what moves farthest.
pub fn worst(best: &Result<Vec<Best>, String>) -> Option<(&Best, &Optimum)> {
    let all = best.as_ref().ok()?.iter();
    let found = all.filter_map(|best| Some((best, best.found.as_ref().ok()?)));
    // A mass that a contact can hold at rest asks for no choice.
    let found = found.filter(|(_, optimum)| 0.0 < optimum.amplitude);
    found.max_by(|a, b| a.1.amplitude.total_cmp(&b.1.amplitude))
}

/// What limits the amplitude there, in words.
pub fn kind(kind: OptimumKind) -> &'static str {
    match kind {
        OptimumKind::EqualPeaks => {
            "two peaks are equally high: with more friction one grows, with less the other"
        }
        OptimumKind::SinglePeak => "one peak is at its least",
        OptimumKind::NoFriction => "any friction makes it worse",
        OptimumKind::Stuck => "the contact is best stuck; more friction changes nothing",
    }
}

/// The section.
pub fn html(best: &Result<Vec<Best>, String>, asked: &Asked) -> Markup {
    let words = &asked.words;
    html! {
        section #best {
            h2 { "The best friction" }
            @match best {
                Err(reason) => p { (reason) },
                Ok(all) => {
                    p {
                        "The friction that keeps the largest amplitude between "
                        (words.frequency(band(asked).0)) " and " (words.frequency(band(asked).1))
                        " smallest, over all regimes. Where friction may be from … to …, that amplitude is at most a tenth above its least."
                        @if band(asked).1 < asked.band.to { " Of so long a chain it is looked for about the lowest resonance only." }
                    }
                    div.scroll tabindex="0" role="region" aria-label="Best frictions" {
                        table {
                            thead { tr {
                                th scope="col" { "of" }
                                th scope="col" { "best friction" }
                                th scope="col" { "largest amplitude" }
                                th scope="col" { "at" }
                                th scope="col" { "without friction" }
                                th scope="col" { "contact stuck" }
                                th scope="col" { "within a tenth: friction from … to" }
                                th scope="col" { "what limits it" }
                            } }
                            tbody { @for best in all { (row(best, asked)) } }
                        }
                    }
                }
            }
        }
    }
}

/// An amplitude, or that it has none or no bound.
pub fn bound(words: &Words, ratio: f64) -> String {
    match ratio {
        0.0 => "at rest".to_owned(),
        ratio if ratio.is_finite() => words.length(ratio),
        _ => "without bound".to_owned(),
    }
}

fn row(best: &Best, asked: &Asked) -> Markup {
    let words = &asked.words;
    html! {
        tr {
            th scope="row" { (best.part.name) }
            @match &best.found {
                Err(error) => td colspan="7" { "none: " (error) },
                Ok(optimum) => {
                    td { (words.friction(optimum.beta)) }
                    td { (bound(words, optimum.amplitude)) }
                    td {
                        @for (index, peak) in optimum.peaks.iter().enumerate().filter(|(_, peak)| peak.amplitude > 0.0) {
                            @if index > 0 { ", " }
                            (words.frequency(peak.r)) " (" (words::regime(peak.regime))
                            @if peak.at_end { ", end of the range" } ")"
                        }
                    }
                    td { (bound(words, optimum.without_friction)) }
                    td { (bound(words, optimum.with_contact_locked)) }
                    td {
                        @if let Some(widest) = optimum.tolerances.last() {
                            (words.friction(widest.from))
                            @if widest.to.is_finite() { " … " (words.friction(widest.to)) } @else { " on" }
                        }
                    }
                    td { (kind(optimum.kind)) }
                }
            }
        }
    }
}

/// The same as data.
pub fn data(best: &Result<Vec<Best>, String>, asked: &Asked) -> Json {
    let words = &asked.words;
    let one = |best: &Best| match &best.found {
        Err(error) => json!({ "of": best.part.name, "none": error.to_string() }),
        Ok(optimum) => {
            let length = |ratio: f64| number(words.measure.length(ratio));
            let name = |name: &str| words.measure.length_name(name);
            let mut fields: Vec<(String, Json)> = vec![
                ("of".to_owned(), best.part.name.as_str().into()),
                ("limited_by".to_owned(), kind(optimum.kind).into()),
                (name("amplitude"), length(optimum.amplitude)),
                (name("without_friction"), length(optimum.without_friction)),
                (
                    name("with_contact_stuck"),
                    length(optimum.with_contact_locked),
                ),
            ];
            let owned = |(name, value): (&str, Json)| (name.to_owned(), value);
            fields.extend(words.friction_json(optimum.beta).into_iter().map(owned));
            let limit = |beta: f64| object(words.friction_json(beta));
            fields.push((
                "nothing_sticks_up_to".to_owned(),
                limit(optimum.free_of_sticking),
            ));
            fields.push(("stuck_from".to_owned(), limit(optimum.locked)));
            let peaks = optimum.peaks.iter().map(|peak| {
                let mut fields: Vec<(String, Json)> = words
                    .frequency_json(&asked.system, peak.r)
                    .into_iter()
                    .map(owned)
                    .collect();
                fields.push(words.length_json(peak.amplitude));
                fields.push(("regime".to_owned(), words::regime(peak.regime).into()));
                object(fields)
            });
            fields.push(("peaks".to_owned(), peaks.collect()));
            let within = optimum.tolerances.iter().map(|tolerance| {
                json!({
                    "excess": tolerance.excess,
                    "from": limit(tolerance.from),
                    "to": limit(tolerance.to),
                })
            });
            fields.push(("within".to_owned(), within.collect()));
            object(fields)
        }
    };
    match best {
        Err(reason) => json!({ "none": reason }),
        Ok(all) => all.iter().map(one).collect(),
    }
}

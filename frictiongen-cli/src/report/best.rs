//! The best friction for each mass that is shown.

use super::answer::{Answer, Peak};
use super::asked::Asked;
use super::found::at_once;
use super::response::Responses;
use super::tried::Trial;
use super::words::{Words, number, object};
use crate::asked::Part;
use frictiongen::study::{FrequencyBand, OptimumKind, OptimumRequest, words};
use frictiongen::{Error, Of};
use maud::{Markup, html};
use serde_json::{Value as Json, json};

/// The most masses of a chain whose exact optimum is looked for: of longer ones it takes minutes.
const EXACT: usize = 4;
/// The most masses of a chain whose best friction is looked for among some.
const MOST_MASSES: usize = 16;
/// The most motions whose best friction is looked for.
const MOST_MOTIONS: usize = 4;

/// The best friction for one motion, or why there is none.
pub struct Best {
    /// Of which motion.
    pub part: Part,
    /// What was found.
    pub found: Result<Answer, String>,
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
    let only_contact = asked.parts.iter().all(|part| part.of == Of::Contact);
    let parts = asked.parts.iter();
    let parts = parts.filter(|part| only_contact || part.of != Of::Contact);
    let parts: Vec<Part> = parts.take(MOST_MOTIONS).cloned().collect();
    if EXACT < masses {
        return tried(asked, parts).map_err(|error| error.to_string());
    }
    let best = |part: Part| {
        let found = asked.system.optimum(&OptimumRequest {
            of: part.of,
            band: FrequencyBand::Ratio(asked.band.from, asked.band.to),
            load: asked.words.measure.load(),
        });
        let found = found.map(Answer::exact).map_err(|error| error.to_string());
        Best { part, found }
    };
    Ok(at_once(parts, best))
}

/// The same of some frictions tried.
fn tried(asked: &Asked, parts: Vec<Part>) -> Result<Vec<Best>, Error> {
    let mut trial = Trial::of(asked, parts.iter().map(|part| part.of).collect())?;
    let best = |(place, part): (usize, Part)| {
        let found = trial.best(asked, place)?;
        let found = found.ok_or_else(|| {
            "with every friction tried a resonance is without bound: nothing damps it".to_owned()
        });
        Ok(Best { part, found })
    };
    parts.into_iter().enumerate().map(best).collect()
}

/// Takes a larger amplitude that a curve with the best friction has: where steady states jump, a narrow peak may lie between
/// the frequencies tried.
pub fn met(best: &mut Result<Vec<Best>, String>, asked: &Asked, responses: &Responses) {
    let all = best.iter_mut().flatten();
    for Best { part, found } in all {
        let Ok(answer) = found else { continue };
        let place = asked.parts.iter().position(|known| known.of == part.of);
        let peak = place.and_then(|place| responses.largest(answer.beta, place));
        if let Some((amplitude, r, regime)) = peak
            && answer.tried.is_some()
            && answer.amplitude < amplitude
        {
            answer.amplitude = amplitude;
            answer.peaks = vec![Peak {
                r,
                amplitude,
                regime,
                at_end: r == asked.band.from || r == asked.band.to,
            }];
        }
    }
}

/// The one for what moves farthest.
pub fn worst(best: &Result<Vec<Best>, String>) -> Option<(&Best, &Answer)> {
    let all = best.as_ref().ok()?.iter();
    let found = all.filter_map(|best| Some((best, best.found.as_ref().ok()?)));
    // A mass that a contact can hold at rest asks for no choice.
    let found = found.filter(|(_, answer)| 0.0 < answer.amplitude);
    found.max_by(|a, b| a.1.amplitude.total_cmp(&b.1.amplitude))
}

/// What limits the amplitude there, in words.
pub fn kind(kind: Option<OptimumKind>) -> &'static str {
    match kind {
        None => "less friction or more makes it larger",
        Some(OptimumKind::EqualPeaks) => {
            "two peaks are equally high: with more friction one grows, with less the other"
        }
        Some(OptimumKind::SinglePeak) => "one peak is at its least",
        Some(OptimumKind::NoFriction) => "any friction makes it worse",
        Some(OptimumKind::Stuck) => "the contact is best stuck; more friction changes nothing",
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
                        (words.frequency(asked.band.from)) " and " (words.frequency(asked.band.to))
                        " smallest, over all regimes. Where friction may be from … to …, that amplitude is at most a tenth above its least."
                        @if let Some((frictions, frequencies)) = all.iter().find_map(|best| best.found.as_ref().ok()?.tried) {
                            " Of so long a chain these are the best of some " (frictions) " frictions tried at " (frequencies)
                            " frequencies, closely about all resonances, free and with the contact stuck: right to about a twentieth of the friction. \
                             Where steady states jump, an amplitude may have a narrow peak between them. "
                            "“frictiongen optimum” finds all digits for one motion over a narrower range."
                        }
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
                    td { (words.friction(optimum.beta)) @if optimum.kind == Some(OptimumKind::Stuck) { " or more" } }
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
                        @if let Some((from, to)) = optimum.within {
                            (words.friction(from))
                            @if to.is_finite() { " … " (words.friction(to)) } @else { " on" }
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
        Err(error) => json!({ "of": best.part.name, "none": error }),
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
            if let Some(exact) = &optimum.exact {
                let free = limit(exact.free_of_sticking);
                fields.push(("nothing_sticks_up_to".to_owned(), free));
                fields.push(("stuck_from".to_owned(), limit(exact.locked)));
            }
            if let Some((frictions, frequencies)) = optimum.tried {
                let tried = json!({ "frictions": frictions, "frequencies": frequencies });
                fields.push(("tried".to_owned(), tried));
            }
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
            let within: Vec<(f64, f64, f64)> = match &optimum.exact {
                Some(exact) => {
                    let all = exact.tolerances.iter();
                    all.map(|one| (one.excess, one.from, one.to)).collect()
                }
                None => {
                    let within = optimum.within.into_iter();
                    within.map(|(from, to)| (0.1, from, to)).collect()
                }
            };
            let within = within.into_iter().map(
                |(excess, from, to)| json!({ "excess": excess, "from": limit(from), "to": limit(to) }),
            );
            fields.push(("within".to_owned(), within.collect()));
            object(fields)
        }
    };
    match best {
        Err(reason) => json!({ "none": reason }),
        Ok(all) => all.iter().map(one).collect(),
    }
}

//! Finds the best friction for each mass that the page shows.

use super::asked::ReportRequest;
use super::found::at_once;
use super::words::{PageUnits, digits, number, object};
use crate::asked::MovingPart;
use crate::measure::PhysicalQuantity;
use frictiongen::Of;
use frictiongen::study::{
    optimum::{FrequencyBand, Optimum, OptimumEnd, OptimumKind, OptimumOptions, OptimumRequest},
    response::MotionQuantity,
    words,
};
use maud::{Markup, html};
use serde_json::{Value as Json, json};

/// Largest number of masses for which the page shows best frictions.
const MOST_MASSES: usize = 16;
/// Bound on the work of one search for a best friction, in units of about 10 µs. The bound is lower than in
/// `frictiongen optimum`, because the page should be ready within seconds.
const WORK: usize = 150_000;
/// Largest number of motions (displacements of a mass or of the contact) for which the command searches the best
/// friction. In a chain of more than [`ALL_MOTIONS`] masses, [`MOST_OF_LONG`] applies instead.
const MOST_MOTIONS: usize = 4;
/// Largest number of masses for which the command searches the best friction for up to `MOST_MOTIONS` motions. For a
/// longer chain, it searches for at most [`MOST_OF_LONG`] motions.
const ALL_MOTIONS: usize = 4;
/// Largest number of motions for which the command searches the best friction, in a chain of more than `ALL_MOTIONS`
/// masses.
const MOST_OF_LONG: usize = 2;

/// Best friction for one motion, or the reason why the search found none.
pub struct Best {
    /// The contact or mass whose largest amplitude is minimised.
    pub part: MovingPart,
    /// Result of the search for the best friction, or the reason for its failure.
    pub found: Result<Optimum, String>,
}

/// Searches for the best friction of each motion. Returns an error with the reason if the page contains no search.
pub fn search(asked: &ReportRequest) -> Result<Vec<Best>, String> {
    let masses = asked.system.scene().masses.len();
    if MOST_MASSES < masses {
        return Err(format!(
            "The page does not search the best friction of a chain of more than {MOST_MASSES} masses, because that takes minutes. \
             “frictiongen optimum” finds it for one motion."
        ));
    }
    let only_contact = asked.parts.iter().all(|part| part.of == Of::Contact);
    let parts = asked.parts.iter();
    let parts = parts.filter(|part| only_contact || part.of != Of::Contact);
    let mut parts: Vec<MovingPart> = parts.cloned().collect();
    // The command searches only for the masses with the largest amplitudes while the contact is stuck.
    let farthest = asked.farthest_if_stuck();
    let rank = |part: &MovingPart| match part.of {
        Of::Mass(mass) => farthest.iter().position(|other| *other == mass),
        _ => None,
    };
    let most = if masses <= ALL_MOTIONS {
        MOST_MOTIONS
    } else {
        MOST_OF_LONG
    };
    let mut ranks: Vec<usize> = parts.iter().filter_map(rank).collect();
    ranks.sort_unstable();
    if let Some(last) = ranks.get(most.saturating_sub(1)) {
        parts.retain(|part| rank(part).is_some_and(|rank| rank <= *last));
    }
    let best = |part: MovingPart| {
        let request = OptimumRequest {
            of: part.of,
            size: part.size,
            band: FrequencyBand::Ratio(asked.band.from, asked.band.to),
            load: asked.words.measure.load(),
        };
        let options = OptimumOptions {
            work: Some(WORK),
            ..OptimumOptions::default()
        };
        let found = asked.system.optimum_with(&request, &options);
        let found = found.map_err(|error| error.to_string());
        Best { part, found }
    };
    Ok(at_once(parts, best))
}

/// Returns two friction ratios. Up to the first friction ratio, the contact slides all the time at every frequency of
/// the range. From the second friction ratio upwards, a stuck state exists at every frequency of the range.
pub fn limits(best: &Result<Vec<Best>, String>) -> Option<(f64, f64)> {
    let mut all = best.iter().flatten();
    let found = all.find_map(|best| best.found.as_ref().ok())?;
    Some((found.free_of_sticking, found.locked))
}

/// Returns the range of friction ratios β in which the largest amplitude is at most 10 % above the best amplitude.
pub fn within(optimum: &Optimum) -> Option<(f64, f64)> {
    let widest = optimum.tolerances.last();
    widest.map(|widest| (widest.from, widest.to))
}

/// Returns the motion whose largest amplitude at its own best friction exceeds that of all other motions.
pub fn worst(best: &Result<Vec<Best>, String>) -> Option<(&Best, &Optimum)> {
    let all = best.as_ref().ok()?.iter();
    let found = all.filter_map(|best| Some((best, best.found.as_ref().ok()?)));
    // A mass that rests while the contact sticks does not count, because a large friction can stop it completely.
    let found = found.filter(|(_, answer)| 0.0 < answer.amplitude);
    found.max_by(|a, b| a.1.amplitude.total_cmp(&b.1.amplitude))
}

/// Returns the equivalent damping ratio ζ_eq of the contact at the highest peak, with the best friction.
fn damping(optimum: &Optimum, asked: &ReportRequest) -> Option<f64> {
    let peak = optimum.peaks.first()?;
    let response = asked.system.at(peak.r).ok()?.response(optimum.beta).ok()?;
    response.largest(Of::Contact, MotionQuantity::Damping)
}

/// Returns words that explain why every other friction gives a larger amplitude.
pub fn kind(optimum: &Optimum) -> &'static str {
    match (optimum.kind, optimum.end) {
        (_, OptimumEnd::WorkSpent) => {
            "the best result within the time limit of a page; “frictiongen optimum” searches longer"
        }
        (_, OptimumEnd::Stopped) => words::end(optimum.end),
        (OptimumKind::Flat, _) => words::kind(optimum.kind),
        (OptimumKind::EqualPeaks, _) => {
            "two peaks are equally high: more friction raises one, less friction raises the other"
        }
        (OptimumKind::SinglePeak, OptimumEnd::Jump) => words::end(optimum.end),
        (OptimumKind::SinglePeak, _) => "one peak is at its minimum",
        (OptimumKind::NoFriction, _) => "any friction makes the amplitude larger",
        (OptimumKind::Bounded | OptimumKind::Balanced, _) => words::kind(optimum.kind),
        (OptimumKind::Trivial, _) => "trivial: with the contact stuck, this motion rests",
        (OptimumKind::Stuck, _) => "a stuck contact is best; more friction changes nothing",
    }
}

/// Returns the section about the best friction as HTML.
pub fn html(best: &Result<Vec<Best>, String>, asked: &ReportRequest) -> Markup {
    let words = &asked.words;
    html! {
        section #best {
            h2 { "The best friction" }
            @match best {
                Err(reason) => p { (reason) },
                Ok(all) => {
                    p {
                        "With the best friction the largest amplitude over all regimes between "
                        (words.frequency(asked.band.from)) " and " (words.frequency(asked.band.to))
                        " is as small as possible. The range of friction in the second last column keeps that amplitude within a tenth of its minimum."
                        @if all.len() < asked.parts.iter().filter(|part| part.of != Of::Contact).count() {
                            " The table lists the motions that are largest with the contact stuck. “frictiongen optimum” finds the others."
                        }
                    }
                    div.scroll tabindex="0" role="region" aria-label="Best frictions" {
                        table {
                            thead { tr {
                                th scope="col" { "of" }
                                th scope="col" { "best friction" }
                                th scope="col" { "largest amplitude" }
                                th scope="col" { "at" }
                                th scope="col" { "equivalent damping ratio ζ" sub { "eq" } " there" }
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

/// Formats an amplitude, which may be zero or unbounded.
pub fn bound(words: &PageUnits, ratio: f64) -> String {
    match ratio {
        0.0 => "at rest".to_owned(),
        ratio if ratio.is_finite() => words.length(ratio),
        _ => "unbounded".to_owned(),
    }
}

fn row(best: &Best, asked: &ReportRequest) -> Markup {
    let words = &asked.words;
    html! {
        tr {
            th scope="row" { (best.part.name) }
            @match &best.found {
                Err(error) => td colspan="8" { "none: " (error) },
                Ok(optimum) => {
                    td { (words.friction(optimum.beta)) @if matches!(optimum.kind, OptimumKind::Stuck | OptimumKind::Trivial) || optimum.bracket[1].is_infinite() { " or more" } }
                    td { (bound(words, optimum.amplitude)) }
                    td {
                        @for (index, peak) in optimum.peaks.iter().enumerate().filter(|(_, peak)| peak.amplitude > 0.0) {
                            @if index > 0 { ", " }
                            (words.frequency(peak.r)) " (" (words::regime(peak.regime))
                            @if peak.at_end { ", end of the range" } ")"
                        }
                    }
                    td { @if let Some(ratio) = damping(optimum, asked) { (digits(ratio)) } }
                    td { (bound(words, optimum.without_friction)) }
                    td { (bound(words, optimum.with_contact_locked)) }
                    td {
                        @if let Some((from, to)) = within(optimum) {
                            (words.friction(from))
                            @if to.is_finite() { " … " (words.friction(to)) } @else { " on" }
                        }
                    }
                    td {
                        (kind(optimum))
                        @if let Some(beyond) = optimum.beyond_jump { "; beyond the jump " (words.length(beyond)) }
                    }
                }
            }
        }
    }
}

/// Returns the section about the best friction as JSON data.
pub fn data(best: &Result<Vec<Best>, String>, asked: &ReportRequest) -> Json {
    let words = &asked.words;
    let one = |best: &Best| match &best.found {
        Err(error) => json!({ "of": best.part.name, "none": error }),
        Ok(optimum) => {
            let length = |ratio: f64| number(words.measure.length(ratio));
            let name = |name: &str| words.measure.name(name, PhysicalQuantity::Length);
            let mut fields: Vec<(String, Json)> = vec![
                ("of".to_owned(), best.part.name.as_str().into()),
                ("limited_by".to_owned(), kind(optimum).into()),
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
            fields.push(("end".to_owned(), words::end(optimum.end).into()));
            if let Some(ratio) = damping(optimum, asked) {
                fields.push(("zeta_eq".to_owned(), number(ratio)));
            }
            if let Some(beyond) = optimum.beyond_jump {
                fields.push((name("beyond_jump"), length(beyond)));
            }
            let [from, to] = optimum.bracket.map(limit);
            fields.push(("bracket".to_owned(), json!({ "from": from, "to": to })));
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
            let within = optimum.tolerances.iter().map(|within| {
                json!({ "excess": within.excess, "from": limit(within.from), "to": limit(within.to) })
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

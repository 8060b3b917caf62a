//! Summary at the top of the report page, with the main results.

use super::asked::ReportRequest;
use super::best::{self, Best};
use super::map::Spread;
use super::modes::ModeSection;
use super::response::Responses;
use super::words::digits;
use frictiongen::study::scene::Excitation;
use frictiongen::study::{
    optimum::{OptimumEnd, OptimumKind},
    units::Load,
};
use maud::{Markup, html};

/// Largest number of resonances that the summary names.
const MOST_NAMED: usize = 4;

/// Returns the summary of the report page as HTML.
pub fn html(
    asked: &ReportRequest,
    modes: &ModeSection,
    spread: &Spread,
    best: &Result<Vec<Best>, String>,
    responses: &Responses,
) -> Markup {
    let (words, scene) = (&asked.words, asked.system.scene());
    let resonances = modes.resonances(words);
    let named = resonances
        .iter()
        .take(MOST_NAMED)
        .map(String::as_str)
        .collect::<Vec<_>>()
        .join(", ");
    let (from, to) = (
        words.frequency(asked.band.from),
        words.frequency(asked.band.to),
    );
    html! {
        section #short aria-label="In short" {
            ul.short {
                li {
                    @if scene.masses.len() == 1 { "One mass" } @else { (scene.masses.len()) " masses" }
                    ", driven by " @if scene.excitation == Excitation::Base { "the motion of the base" } @else { "a force" }
                    "; without friction " @if resonances.len() == 1 { "it resonates" } @else { "they resonate" } " at " (named)
                    @if resonances.len() > MOST_NAMED { " and " (resonances.len() - MOST_NAMED) " more" } "."
                }
                @if let Some((best, optimum)) = best::worst(best) {
                    li {
                        @match optimum.kind {
                            OptimumKind::NoFriction => {
                                strong { "No friction is best" } " for " strong { (best.part.name) } ", which moves farthest. It moves by at most " (words.length(optimum.amplitude)) " between " (from) " and " (to) "."
                            }
                            OptimumKind::Stuck | OptimumKind::Trivial => {
                                "For " strong { (best.part.name) } ", which moves farthest, a stuck contact is best: with a friction of "
                                (words.friction(optimum.beta)) " or more it moves by at most " (words.length(optimum.amplitude)) " between " (from) " and " (to) "."
                            }
                            OptimumKind::EqualPeaks | OptimumKind::SinglePeak | OptimumKind::Flat | OptimumKind::Bounded | OptimumKind::Balanced => {
                                strong { "Best friction: " (words.friction(optimum.beta)) }
                                @if optimum.end == OptimumEnd::WorkSpent { ", the best result within the time limit" } ", chosen for " strong { (best.part.name) }
                                ", which moves farthest. With this friction it moves by at most "
                                strong { (words.length(optimum.amplitude)) } " between " (from) " and " (to) ". Largest amplitude without friction: "
                                (best::bound(words, optimum.without_friction)) ", with the contact stuck: "
                                (best::bound(words, optimum.with_contact_locked)) "."
                            }
                        }
                    }
                    @if let (Some((from, to)), OptimumKind::EqualPeaks | OptimumKind::SinglePeak) = (best::within(optimum), optimum.kind) {
                        li {
                            "The friction need not be exact: from " (words.friction(from)) " to " (words.friction(to))
                            " the largest amplitude stays within a tenth of its minimum."
                        }
                    }
                    @if let Some(stretches) = responses.stretches(optimum.beta, asked.is_elastic()) {
                        li { "With the best friction the contact " @for (index, (does, from, to)) in stretches.iter().enumerate() {
                            @if index > 0 { ", " } (does) " from " (words.frequency(*from)) " to " (words.frequency(*to))
                        } "." }
                    }
                    @if optimum.unbounded_to > 0.0 {
                        li { "Up to " (words.friction(optimum.unbounded_to)) " a resonance is unbounded, because only friction damps it." }
                    }
                } @else if let Ok(all) = best {
                    @for best in all.iter().take(1) { @if let Err(error) = &best.found {
                        li { "No best friction for " (best.part.name) ": " (error) "." }
                    } }
                }
                li {
                    @if asked.is_elastic() {
                        "The contact is elastic: with any friction it sticks after each reversal, until its spring has the friction force; "
                    } @else if spread.continuous_to > 0.0 {
                        "Up to " (words.friction(spread.continuous_to)) " the contact never stops anywhere in this range; "
                    } @else {
                        "With any friction the contact stops somewhere in this range; "
                    }
                    @if spread.stuck_from.is_finite() {
                        "from " (words.friction(spread.stuck_from)) " on it never moves."
                    } @else {
                        "no friction keeps it stuck everywhere."
                    }
                }
                @if let Some(load) = words.measure.load() {
                    li {
                        "These results are for " (match load {
                            Load::Base(motion) => format!("a base motion of {} mm", digits(1e3 * motion)),
                            load => format!("a force of {} N", digits(load.amplitude())),
                        }) ". With twice the load and twice the friction, all motions are twice as large."
                    }
                }
            }
        }
    }
}

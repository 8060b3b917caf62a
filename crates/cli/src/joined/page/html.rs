//! Writes the report page of a scene with several contacts as HTML.

use super::contents::{Contents, Loops, contents};
use crate::args::ReportArguments;
use crate::failure::Failure;
use crate::file::write_page;
use crate::measure;
use crate::modes;
use crate::report::page::document;
use crate::report::scene::{drawing, masses_and_springs};
use crate::report::words::{PageUnits, digits};
use frictiongen::study::scene::{Node, Scene};
use maud::{Markup, PreEscaped, html};
use std::io::Write;

/// Security policy of the page, which has no script.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'";

/// Computes the report page of a scene with several contacts, and writes the page. `file` is the name of the scene
/// description, and `documentation` contains its doc comments.
pub fn write(
    arguments: &ReportArguments,
    scene: Scene,
    (file, documentation): (&str, &str),
    out: &mut dyn Write,
) -> Result<(), Failure> {
    contents(arguments, scene, |contents| {
        let html = page(contents, (file, documentation));
        let paths = (arguments.output.as_deref(), arguments.file.path());
        write_page(paths, &html, out)
    })
}

/// Returns the HTML of the report page.
fn page(contents: &Contents<'_>, (file, documentation): (&str, &str)) -> String {
    let scene = contents.question.system.scene();
    let main = html! {
        (summary(contents))
        @if !contents.chosen.is_empty() {
            aside aria-label="What was chosen" { @for line in &contents.chosen { p { (line) } } }
        }
        (chain(contents))
        (damped_modes(contents))
        (figures(contents))
        (stuck(contents))
        @if let Some(loops) = &contents.loops { (contacts(contents, loops)) }
        section #beyond {
            h2 { "Limits of this page" }
            p {
                "The page shows steady states under one harmonic load, reached from rest. For motions from a start, see "
                code { "frictiongen time" } ". For the best common friction and the best shares, see " code { "frictiongen optimum" }
                ". For the effect of every number of the description, see " code { "frictiongen sensitivity" } "."
            }
        }
    };
    let data = (&contents.data(file), None);
    document(POLICY, &scene.name, (file, documentation), &main, data)
}

/// Returns the units and number formats of the page.
fn words(contents: &Contents<'_>) -> PageUnits {
    let question = contents.question;
    let in_hertz = question.frequencies.are_physical();
    PageUnits {
        scales: crate::picture::scales(question.system, in_hertz, &question.measure),
        in_hertz,
        measure: question.measure,
    }
}

/// Returns the section of the page with the main results as HTML.
fn summary(contents: &Contents<'_>) -> Markup {
    let (words, question) = (words(contents), contents.question);
    let ends = [contents.band.from, contents.band.to].map(|r| words.frequency(r));
    let largest = contents.stuck.iter();
    let largest = largest.max_by(|a, b| a.limit.total_cmp(&b.limit));
    html! {
        section #short aria-label="In short" {
            ul.short {
                li {
                    (count(question.joined.contact_names().len(), "contact")) " and "
                    (count(question.system.scene().masses.len(), "mass")) ", from " (ends[0]) " to " (ends[1]) "."
                }
                @if let Some(largest) = largest {
                    li {
                        "From a common friction of " strong { (words.friction(largest.limit)) } " on, no contact slides anywhere in this range. "
                        "With less, " strong { (largest.first) } " slides first, at " (words.frequency(largest.r)) "."
                    }
                }
                @if let Some(load) = measure::description(&question.measure, digits) {
                    li { "These results are for the load " (load) ". With twice the load and twice the friction, all motions are twice as large." }
                } @else {
                    li {
                        "No load is given. Therefore friction is the ratio β, and amplitudes are multiples of " (words.length_unit())
                        ". Give the load by " code { (measure::option(&question.measure)) } " to see N and mm."
                    }
                }
            }
        }
    }
}

/// Returns a number with its noun, in the singular or the plural.
fn count(number: usize, noun: &str) -> String {
    let ending = match (number, noun.ends_with('s')) {
        (1, _) => "",
        (_, true) => "es",
        (_, false) => "s",
    };
    format!("{number} {noun}{ending}")
}

/// Returns the section of the page with the sketch of the chain and its values as HTML.
fn chain(contents: &Contents<'_>) -> Markup {
    let scene = contents.question.system.scene();
    let between =
        |from: Node, to: Node| format!("{} – {}", scene.node_name(from), scene.node_name(to));
    let has_belts = scene
        .named_contacts()
        .iter()
        .any(|own| own.law.speed != 0.0);
    html! {
        section #scene {
            h2 { "The chain" }
            @match drawing(scene, &contents.question.measure) {
                // The crate frictiongen-plot has made this SVG text, and has escaped every word of the user in it.
                Some(svg) => div.scroll.paper.sketch tabindex="0" role="region" aria-label="Drawing of the chain" { (PreEscaped(svg)) },
                None => p { "A chain of " (scene.masses.len()) " masses is not drawn; its values are in the tables." },
            }
            table {
                caption { "Contacts" }
                thead { tr {
                    th scope="col" { "name" } th scope="col" { "between" } th scope="col" { "stiffness (N/m)" }
                    th scope="col" { "share of F" } th scope="col" { "stiction μ" }
                    @if has_belts { th scope="col" { "surface speed (m/s)" } }
                } }
                tbody { @for contact in scene.named_contacts() { tr {
                    th scope="row" { (contact.name) }
                    td { (between(contact.sides.from, contact.sides.to)) }
                    td { @match contact.law.stiffness { Some(stiffness) => (digits(stiffness)), None => "rigid" } }
                    td { (digits(contact.law.share)) }
                    td { (digits(contact.law.stiction)) }
                    @if has_belts { td { (digits(contact.law.speed)) } }
                } } }
            }
            @if !scene.joints.stops.is_empty() { (stops(scene)) }
            @if !scene.joints.constant.is_empty() { table {
                caption { "Constant forces" }
                thead { tr { th scope="col" { "on" } th scope="col" { "N" } } }
                tbody { @for own in &scene.joints.constant { tr {
                    th scope="row" { (scene.node_name(Node::Mass(own.mass))) }
                    td { (digits(own.force)) }
                } } }
            } }
            details {
                summary { "Values: masses, springs and dashpots" }
                div.pair {
                    (masses_and_springs(scene))
                    @if !scene.joints.dampers.is_empty() { table {
                        caption { "Dashpots" }
                        thead { tr { th scope="col" { "between" } th scope="col" { "N·s/m" } } }
                        tbody { @for damper in &scene.joints.dampers { tr {
                            th scope="row" { (between(damper.from, damper.to)) }
                            td { (digits(damper.coefficient)) }
                        } } }
                    } }
                }
            }
        }
    }
}

/// Returns the table of the stops as HTML.
fn stops(scene: &Scene) -> Markup {
    html! {
        table {
            caption { "Stops" }
            thead { tr {
                th scope="col" { "name" } th scope="col" { "between" } th scope="col" { "gap (m)" }
                th scope="col" { "stiffness (N/m)" } th scope="col" { "damping (N·s/m)" } th scope="col" { "restitution" }
            } }
            tbody { @for stop in &scene.joints.stops {
                @let (stiffness, damping, restitution) = stop.law.impact.numbers();
                tr {
                    th scope="row" { (stop.name) }
                    td { (scene.node_name(stop.sides.from)) " – " (scene.node_name(stop.sides.to)) }
                    td { (digits(stop.law.gap)) }
                    @if let Some(stiffness) = stiffness {
                        td { (digits(stiffness)) } td { (digits(damping)) } td { "–" }
                    } @else {
                        td { "–" } td { "–" } td { (digits(restitution)) }
                    }
                }
            } }
        }
    }
}

/// Returns the section of the page with the damped modes as HTML.
fn damped_modes(contents: &Contents<'_>) -> Markup {
    html! {
        @if let Some(sets) = &contents.modes {
            section #modes {
                h2 { "Damped modes" }
                p {
                    "The modes of the chain with its dashpots and its damping. Stuck contacts are springs if they are elastic, and otherwise join their two "
                    "sides. Contacts that do not stick have no friction."
                }
                div.scroll tabindex="0" role="region" aria-label="Damped modes" { table {
                    thead { tr { th scope="col" { "contacts" } th scope="col" { "f (Hz)" } th scope="col" { "damping ratio" } } }
                    tbody { @for [name, frequency, zeta] in modes::rows(sets, digits) { tr {
                        th scope="row" { (name) } td { (frequency) } td { (zeta) }
                    } } }
                } }
            }
        }
    }
}

/// Returns the sections of the page with the figures as HTML.
fn figures(contents: &Contents<'_>) -> Markup {
    html! {
        @for (id, figure) in &contents.figures {
            section id=(id) {
                @match *id {
                    "closed" => {
                        h2 { "Without friction, and with all contacts stuck" }
                        p { "Both amplitudes are closed forms." }
                    }
                    "curves" => {
                        h2 { "Amplitudes and sticking" }
                        p { "Each line belongs to one common friction. The style of a line shows how many contacts slide." }
                    }
                    "map" => {
                        h2 { "Regimes" }
                        p { "No contact slides above the dashed line." }
                    }
                    _ => {
                        h2 { "Hysteresis loops" }
                        p {
                            "One period of the steady state with the largest amplitude at the middle friction. "
                            "The area of a loop is the energy that the contact dissipates in a period."
                        }
                    }
                }
                figure.plot {
                    // The crate frictiongen-plot has made this SVG text, and has escaped every word of the user in it.
                    div.paper { (PreEscaped(figure.clone().narrow().svg())) }
                }
            }
        }
    }
}

/// Returns the section of the page about the state in which no contact slides, as HTML.
fn stuck(contents: &Contents<'_>) -> Markup {
    let words = words(contents);
    let limits = |ends: (f64, f64)| {
        let within = contents.stuck.iter();
        let within = within.filter(move |stuck| ends.0 <= stuck.r && stuck.r <= ends.1);
        within.map(|stuck| stuck.limit).fold(0.0, f64::max)
    };
    html! {
        section #stuck {
            h2 { "The first contact that slides" }
            p {
                "No contact slides from the friction that the dashed line of the map shows. If the friction falls below, one contact slides first."
            }
            table {
                thead { tr {
                    th scope="col" { "contact" } th scope="col" { "from" } th scope="col" { "to" }
                    th scope="col" { "no contact slides from, at most" }
                } }
                tbody { @for first in contents.firsts() { tr {
                    th scope="row" { (first.name) }
                    td { (words.frequency(first.ends.0)) }
                    td { (words.frequency(first.ends.1)) }
                    td { (words.friction(limits(first.ends))) }
                } } }
            }
        }
    }
}

/// Returns the table of the contacts in the steady state whose hysteresis loops the page shows.
fn contacts(contents: &Contents<'_>, loops: &Loops<'_>) -> Markup {
    let words = words(contents);
    let names = contents.question.joined.contact_names();
    let rows = names.iter().zip(loops.orbit.contacts());
    let measure = &contents.question.measure;
    html! {
        section #contacts {
            h2 { "Contacts in this steady state" }
            p { (words.frequency(loops.frequency.r)) ", common friction " (words.friction(loops.beta)) "." }
            table {
                thead { tr {
                    th scope="col" { "contact" } th scope="col" { "stops" } th scope="col" { "reversals" } th scope="col" { "stuck fraction" }
                    th scope="col" { "slip (" (words.length_unit()) ")" } th scope="col" { "largest force" }
                } }
                tbody { @for (name, contact) in rows { tr {
                    th scope="row" { (name) }
                    td { (contact.stops()) }
                    td { (contact.reversals()) }
                    td { (digits(contact.stuck_fraction())) }
                    td { (digits(words.scales.length(contact.slip()))) }
                    td { (digits(measure.force(contact.force()))) @if measure.scale().is_some() { " N" } }
                } } }
            }
        }
    }
}

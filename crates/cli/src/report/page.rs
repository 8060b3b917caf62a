//! Assembles the report page from its head, its sections and its data.

use super::asked::ReportRequest;
use super::best::{self, Best};
use super::cost::CostSection;
use super::features::FeatureSection;
use super::map::Regimes;
use super::modes::ModeSection;
use super::response::Responses;
use super::{live, scene, summary};
use crate::measure;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use serde_json::{Value as Json, json};

/// Version of the format of the page's data. It increases when a field gets another name or another meaning.
const VERSION: u32 = 1;

/// Style sheet of the report page.
const STYLE: &str = include_str!("style.css");
/// Script of the report page.
const SCRIPT: &str = include_str!("read.js");
/// Hash of the page's script. A browser runs no other script in the page. A test compares this hash with the script.
const SCRIPT_HASH: &str = include_str!("read.js.sha256");

/// Contents of the report page.
pub struct ReportPage<'a> {
    /// Name of the scene description, which the report page shows.
    pub file: &'a str,
    /// Doc comments of the scene description, which the report page shows.
    pub documentation: &'a str,
    /// Scene, range, units and motions of the page, from the user's options and the defaults.
    pub asked: ReportRequest,
    /// Contents of the section about modes.
    pub modes: ModeSection,
    /// Contents of the section about amplitudes and phases.
    pub responses: Responses,
    /// Contents of the section about limits and regimes.
    pub regimes: Regimes,
    /// Contents of the section about features of the response.
    pub features: FeatureSection,
    /// Best friction of each motion, or the reason why the command made no search.
    pub best: Result<Vec<Best>, String>,
    /// Contents of the section about cost and accuracy of the emitted code.
    pub cost: CostSection,
    /// The page of the playground with the scene description, if the user requests the playground.
    pub live: Option<String>,
}

impl ReportPage<'_> {
    /// Returns the HTML of the report page.
    pub fn html(&self) -> String {
        let asked = &self.asked;
        let (modes, regimes) = (self.modes.plot(asked), self.regimes.plot(asked));
        let responses = self.responses.plots(asked, self.features.lines());
        let plots = [&modes, &regimes].into_iter().chain(&responses);
        let plots: Vec<&Json> = plots.map(super::plot::Plot::data).collect();
        let data = json!({
            "version": VERSION,
            "file": self.file,
            "name": asked.system.scene().name,
            "scene": scene::data(asked),
            "range": asked.words.frequency_json(&asked.system, asked.band.from).into_iter()
                .zip(asked.words.frequency_json(&asked.system, asked.band.to))
                .map(|((name, from), (_, to))| (name.to_owned(), json!([from, to])))
                .collect::<serde_json::Map<_, _>>(),
            "chosen": asked.chosen,
            "modes": self.modes.data(),
            "responses": self.responses.data(asked),
            "limits": self.regimes.data(asked),
            "features": self.features.data(asked),
            "best": best::data(&self.best, asked),
            "emitted": self.cost.data(),
            "plots": plots,
        });
        let name = &asked.system.scene().name;
        let policy = match self.live {
            Some(_) => live::POLICY.to_owned(),
            None => format!(
                "default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-{}'",
                SCRIPT_HASH.trim()
            ),
        };
        let main = html! {
            (summary::html(asked, &self.modes, &self.regimes.spread, &self.best, &self.responses))
            (self.chosen())
            (scene::html(asked))
            (self.modes.html(&modes, asked))
            (self.responses.html(&responses, asked))
            (self.regimes.html(&regimes, asked))
            (self.features.html(asked))
            (best::html(&self.best, asked))
            (self.cost.html())
            @if let Some(page) = &self.live { (live::html(page)) }
            (limits_of_the_page())
        };
        let about = (self.file, self.documentation);
        document(&policy, name, about, &main, (&data, Some(SCRIPT)))
    }

    /// Returns the section about the choices of the command and about the units.
    fn chosen(&self) -> Markup {
        let words = &self.asked.words;
        let option = measure::option(&words.measure);
        html! {
            @if words.measure.load().is_none() || !self.asked.chosen.is_empty() {
                aside aria-label="What was chosen" {
                    @if words.measure.load().is_none() {
                        p {
                            "No load is given. Therefore friction is the ratio β, and amplitudes are multiples of "
                            (words.length_unit())
                            @if !words.in_hertz { "; frequencies are the ratio r" }
                            ". Give the load by " code { (option) } " to see N and mm" @if !words.in_hertz { ", and Hz" } "."
                        }
                    }
                    @for line in &self.asked.chosen { p { (line) } }
                }
            }
        }
    }
}

/// Returns a whole page: the head with the security policy, the `main` element, the data, and the script if there is
/// one. `name` is the name of the scene. `file` is the name of the scene description, and `documentation` contains its
/// doc comments.
pub fn document(
    policy: &str,
    name: &str,
    (file, documentation): (&str, &str),
    main: &Markup,
    (data, script): (&Json, Option<&str>),
) -> String {
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(policy);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (name) ": friction report" }
                // The style sheet and the script belong to this crate and contain no text of the user.
                style { (PreEscaped(STYLE)) }
            }
            body {
                header {
                    h1 { (name) }
                    @if !documentation.is_empty() { p.about { (documentation) } }
                    p.note { "Made from " code { (file) } " by frictiongen " (env!("CARGO_PKG_VERSION")) "." }
                }
                main { (main) }
                script #data type="application/json" { (PreEscaped(within_script(data))) }
                @if let Some(script) = script { script { (PreEscaped(script)) } }
            }
        }
    };
    page.into_string()
}

/// Returns the section about questions that the page does not answer.
fn limits_of_the_page() -> Markup {
    html! {
        section #beyond {
            h2 { "Limits of this page" }
            p {
                "The page shows steady states under one harmonic load, reached from rest, with one contact of constant friction. "
                "For motions from a start, see " code { "frictiongen time" }
                ". For the effect of every mass and spring, see " code { "frictiongen sensitivity" }
                ". Wear, normal forces that vary, and several frequencies at once are not in the model. "
                code { "docs/limits.md" } " lists what else is not, with the nearest way to treat each."
            }
        }
    }
}

/// Returns JSON data for a script element. The result contains no text that would end the element or begin a comment.
fn within_script(data: &Json) -> String {
    data.to_string()
        .replace('&', "\\u0026")
        .replace('<', "\\u003c")
        .replace('>', "\\u003e")
}

#[cfg(test)]
mod tests {
    use super::within_script;
    use serde_json::{Value, json};

    #[test]
    fn no_string_ends_the_block() {
        let data = json!({ "</script><script>": "<!-- <script> & ]]>" });
        let text = within_script(&data);
        assert!(!text.contains(['<', '>', '&']), "{text}");
        assert_eq!(serde_json::from_str::<Value>(&text).unwrap(), data);
    }
}

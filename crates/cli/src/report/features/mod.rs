//! Section of the report about the features of the response, such as resonances, thresholds and peaks. The section
//! describes in words the features that `frictiongen features` lists.

mod tables;

use super::asked::ReportRequest;
use crate::features::report::{FeaturesReport, table};
use crate::number::Lossless as _;
use crate::output::ResultTable as _;
use frictiongen::study::columns::{FeatureLine, FeaturesAsked};
use maud::{Markup, html};
use serde_json::{Value as Json, json};

/// Largest number of masses for which the page lists features. For longer chains, the derivatives of a feature with
/// respect to all masses and springs take too long.
const MOST_MASSES: usize = 16;
/// Largest number of masses for which the page shows exact peaks, and features at every given friction.
const ALL_FRICTIONS: usize = 4;
/// Largest number of rows in a table of the page. The JSON data contain all rows.
const MOST_ROWS: usize = 24;

/// Contents of the section about features of the response.
pub struct FeatureSection {
    /// Friction ratios β of the features that depend on friction.
    frictions: Vec<f64>,
    lines: Result<Vec<FeatureLine>, String>,
}

/// A table of the section about features.
struct SectionTable {
    title: String,
    says: String,
    heads: Vec<&'static str>,
    rows: Vec<Vec<String>>,
}

impl FeatureSection {
    /// Finds the features at the user's frictions. Without these frictions, finds the features at the best friction, or
    /// else at the first positive friction of `levels`. For a chain of more than [`MOST_MASSES`] masses, the page
    /// refers to the command `frictiongen features` instead.
    pub fn of(asked: &ReportRequest, levels: &[f64], best: Option<f64>) -> Self {
        let masses = asked.system.scene().masses.len();
        if MOST_MASSES < masses {
            return Self {
                frictions: Vec::new(),
                lines: Err(format!(
                    "The page does not list the features of more than {MOST_MASSES} masses; “frictiongen features” lists them."
                )),
            };
        }
        let sliding = |beta: &&f64| 0.0 < **beta;
        let mut frictions: Vec<f64> = match (&asked.frictions, best) {
            (None, Some(best)) if 0.0 < best && best.is_finite() => vec![best],
            (Some(given), _) => given.iter().filter(sliding).copied().collect(),
            (None, _) => levels.iter().filter(sliding).take(1).copied().collect(),
        };
        if ALL_FRICTIONS < masses {
            frictions.truncate(1);
        }
        let lines = asked
            .system
            .features(asked.words.measure.load())
            .map_err(|error| error.to_string())
            .and_then(|features| {
                let table = table(
                    &asked.system,
                    &asked.band,
                    asked.words.measure,
                    &asked.parts,
                );
                let found = table.rows(
                    &features,
                    FeaturesAsked {
                        range: [asked.band.from, asked.band.to],
                        frictions: &frictions,
                        peaks: masses <= ALL_FRICTIONS,
                    },
                );
                found.map_err(|error| error.to_string())
            });
        Self { frictions, lines }
    }

    /// Returns all features that the search found, one for each line.
    pub fn lines(&self) -> &[FeatureLine] {
        self.lines.as_deref().unwrap_or_default()
    }

    fn named<'s>(&'s self, feature: &'static str) -> impl Iterator<Item = &'s FeatureLine> {
        let lines = self.lines().iter();
        lines.filter(move |line| line.feature == feature)
    }

    /// Returns the features in the form in which `frictiongen features` prints them. With each feature comes the
    /// parameter to which its first number is most sensitive.
    fn report<'a>(&self, asked: &'a ReportRequest) -> FeaturesReport<'a> {
        FeaturesReport {
            system: &asked.system,
            band: asked.band.clone(),
            measure: asked.words.measure,
            lines: self.lines().to_vec(),
        }
    }

    /// Returns the section about features as HTML.
    pub fn html(&self, asked: &ReportRequest) -> Markup {
        let damped = asked.system.modal().is_damped();
        html! {
            section #features {
                h2 { "Features of the response" }
                @match &self.lines {
                    Err(reason) => p { (reason) },
                    Ok(_) => {
                        p {
                            "These features explain the shape of the curves. Formulas and interval arithmetic find them. Only the true peaks, and with damping \
                             the regimes of the contact, come from close samples."
                            @if damped {
                                " This chain is damped, so that it has no invariant points and no inversions."
                            }
                        }
                        @if ALL_FRICTIONS < asked.system.scene().masses.len() {
                            p.note { "The page lists true peaks only for up to " (ALL_FRICTIONS) " masses. “frictiongen features” lists them for longer chains." }
                        }
                        @for table in self.tables(asked) { (table.html()) }
                    }
                }
            }
        }
    }

    /// Returns the section about features as JSON data. It contains the lines of `frictiongen features --json`, but
    /// only one derivative in each line.
    pub fn data(&self, asked: &ReportRequest) -> Json {
        if let Err(reason) = &self.lines {
            return json!({ "none": reason });
        }
        let report = self.report(asked);
        let columns = report.columns();
        let one = |line: &FeatureLine| -> Json {
            let shown = columns.iter().filter(|column| column.is_in_csv());
            let fields = shown.map(|column| (column.key(), column.read(line).json()));
            fields.collect::<serde_json::Map<_, _>>().into()
        };
        let frictions = self.frictions.iter();
        json!({
            "beta": frictions.copied().collect::<Vec<f64>>(),
            "lines": report.lines.iter().map(one).collect::<Vec<_>>(),
        })
    }
}

impl SectionTable {
    /// Removes the column with this heading from the table.
    fn leave_out(&mut self, head: &str) {
        let Some(place) = self.heads.iter().position(|other| *other == head) else {
            return;
        };
        self.heads.remove(place);
        for row in self.rows.iter_mut().filter(|row| place < row.len()) {
            row.remove(place);
        }
    }

    fn html(&self) -> Markup {
        html! {
            h3 { (self.title) }
            p { (self.says) }
            div.scroll tabindex="0" role="region" aria-label=(self.title) {
                table {
                    thead { tr { @for head in &self.heads { th scope="col" { (head) } } } }
                    tbody { @for row in self.rows.iter().take(MOST_ROWS) { tr {
                        @for (index, cell) in row.iter().enumerate() {
                            @if index == 0 { th scope="row" { (cell) } } @else { td { (cell) } }
                        }
                    } } }
                }
            }
            @if MOST_ROWS < self.rows.len() {
                p.note { "The first " (MOST_ROWS) " of " (self.rows.len()) " are shown. The data block at the end of this page has all of them." }
            }
        }
    }
}

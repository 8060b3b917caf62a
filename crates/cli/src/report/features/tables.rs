//! Builds the tables of the section about features of the response.

use super::super::asked::ReportRequest;
use super::super::words::{PageUnits, digits};
use super::{FeatureSection, SectionTable};
use frictiongen::study::columns::FeatureLine;

impl FeatureSection {
    /// Returns the tables of features that have at least one row.
    pub(super) fn tables(&self, asked: &ReportRequest) -> Vec<SectionTable> {
        let mut tables = self.about_the_chain(asked);
        if !asked.system.modal().is_damped() {
            tables.extend(self.without_damping(&asked.words));
        }
        tables.extend(self.at_frictions(asked));
        tables.retain(|table| !table.rows.is_empty());
        tables
    }

    fn about_the_chain(&self, asked: &ReportRequest) -> Vec<SectionTable> {
        let words = &asked.words;
        let report = self.report(asked);
        let moved = |line: &FeatureLine| match line.strongest() {
            Some((_, parameter, percent)) => {
                format!(
                    "{} % for 1 % of {}",
                    digits(percent),
                    report.table().symbol(parameter)
                )
            }
            None => String::new(),
        };
        let damped = asked.system.modal().is_damped();
        let elastic = asked.is_elastic();
        let force = |line: &FeatureLine| {
            line.friction
                .map_or_else(|| line.detail.clone(), |force| limit(words, force))
        };
        let resonances = self.named("resonance").map(|line| {
            let mut row = vec![line.of.clone(), place(words, line), force(line)];
            if damped {
                let mut thresholds = self.named("threshold without damping");
                let own = thresholds.find(|other| other.of == line.of);
                row.push(own.map_or_else(|| "none".to_owned(), force));
            }
            row.push(moved(line));
            row
        });
        let (says, heads) = if elastic && damped {
            (
                "An elastic contact sticks after each reversal, so that it never slides all the time. The threshold is that without damping: up to \
                 it, the amplitude of the undamped chain would be unbounded.",
                vec![
                    "mode",
                    "at",
                    "the contact",
                    "threshold without damping",
                    "frequency moves most",
                ],
            )
        } else if damped {
            (
                "Up to the first friction the contact slides all the time at that resonance. The second is the threshold without damping: up to it, \
                 the amplitude of the undamped chain would be unbounded.",
                vec![
                    "mode",
                    "at",
                    "slides all the time up to",
                    "threshold without damping",
                    "frequency moves most",
                ],
            )
        } else {
            (
                "Below its threshold a resonance is unbounded, because only friction damps it.",
                vec!["mode", "at", "bounded from", "frequency moves most"],
            )
        };
        let stuck = self.named("resonance if stuck").map(|line| {
            let holds = match line.friction {
                Some(force) if force.is_infinite() => "slides whatever the friction".to_owned(),
                Some(force) => format!("slides up to {}", words.force(force)),
                None => line.detail.clone(),
            };
            vec![place(words, line), holds, moved(line)]
        });
        let ends = ["limit for r -> 0", "limit for r -> inf"]
            .into_iter()
            .zip(["towards rest", "far above all resonances"]);
        let ends = ends.flat_map(|(feature, at)| {
            self.named(feature).map(move |line| {
                let does = match line.friction {
                    Some(0.0) if line.detail == "slides up to" => {
                        "is stuck with any friction".to_owned()
                    }
                    Some(0.0) => "stops with any friction".to_owned(),
                    Some(force) if force.is_infinite() => {
                        format!("{} any friction", line.detail)
                    }
                    Some(force) => format!("{} {}", line.detail, words.force(force)),
                    None => line.detail.clone(),
                };
                vec![at.to_owned(), does]
            })
        });
        vec![
            SectionTable {
                title: "Resonances and their thresholds".to_owned(),
                says: says.to_owned(),
                heads,
                rows: resonances.collect(),
            },
            SectionTable {
                title: "Resonances of the chain with its contact stuck".to_owned(),
                says: "With too much friction the peak of the response is at these frequencies. If the contact slides there at any friction, no friction can lock it."
                    .to_owned(),
                heads: vec!["at", "the contact there", "frequency moves most"],
                rows: stuck.collect(),
            },
            SectionTable {
                title: "At the ends of the frequency axis".to_owned(),
                says: "Behaviour of the contact under a very slow and a very fast load.".to_owned(),
                heads: vec!["where", "the contact"],
                rows: ends.collect(),
            },
        ]
    }

    fn without_damping(&self, words: &PageUnits) -> Vec<SectionTable> {
        let points = self.named("invariant point").map(|line| {
            vec![
                line.of.clone(),
                place(words, line),
                amplitude(words, line),
                line.friction
                    .map_or_else(String::new, |force| limit(words, force)),
                measured(&line.detail).to_owned(),
            ]
        });
        let inversions = self.named("grows with friction").map(|line| {
            let (_, ends) = line.detail.split_once(": ").unwrap_or_default();
            vec![
                line.of.clone(),
                range(words, line),
                ends.to_owned(),
                measured(&line.detail).to_owned(),
            ]
        });
        let still = self
            .named("antiresonance")
            .map(|line| vec![line.of.clone(), place(words, line)]);
        vec![
            SectionTable {
                title: "Invariant points".to_owned(),
                says: "At these frequencies friction does not change the amplitude, as long as the contact slides all the time. \
                       There, more friction does not lower the curve, and a measurement does not determine the friction."
                    .to_owned(),
                heads: vec!["of", "at", "amplitude there", "for friction up to", "what is invariant"],
                rows: points.collect(),
            },
            SectionTable {
                title: "Where friction makes it worse".to_owned(),
                says: "Between these frequencies more friction makes the motion larger.".to_owned(),
                heads: vec!["of", "from … to", "from and to what", "what grows"],
                rows: inversions.collect(),
            },
            SectionTable {
                title: "Antiresonances".to_owned(),
                says: "Without friction the amplitude of these motions is zero at these frequencies.".to_owned(),
                heads: vec!["of", "at"],
                rows: still.collect(),
            },
        ]
    }

    fn at_frictions(&self, asked: &ReportRequest) -> Vec<SectionTable> {
        let words = &asked.words;
        let forces: Vec<String> = self
            .frictions
            .iter()
            .map(|beta| words.friction(*beta))
            .collect();
        let at = match forces.as_slice() {
            [only] => format!(" with {only}"),
            _ => String::new(),
        };
        let force = |line: &FeatureLine| {
            line.friction
                .map_or_else(String::new, |force| words.force(force))
        };
        let slides = self
            .named("slides")
            .map(|line| vec![force(line), range(words, line)]);
        let regimes = self
            .named("regime")
            .map(|line| vec![force(line), range(words, line), does(&line.detail)]);
        // A mass that is at rest while the contact sticks has no peak.
        let moving = |line: &&FeatureLine| line.amplitude != Some(0.0);
        let peaks = self.named("peak").filter(moving).map(|line| {
            let (mode, regime) = line.detail.split_once(": ").unwrap_or((&line.detail, ""));
            let estimate = self.named("peak by estimate").find(|other| {
                (other.detail.as_str(), &other.of, other.friction)
                    == (mode, &line.of, line.friction)
            });
            vec![
                force(line),
                line.of.clone(),
                mode.trim_start_matches("mode ").to_owned(),
                place(words, line),
                amplitude(words, line),
                estimate.map_or_else(|| "none".to_owned(), |line| amplitude(words, line)),
                does(regime),
            ]
        });
        let starts = self.named("quasi-static start").map(|line| {
            let height = match line.amplitude {
                Some(_) => amplitude(words, line),
                None => "the contact is stuck there".to_owned(),
            };
            vec![force(line), line.of.clone(), height]
        });
        let crossings = self.named("same amplitude").map(|line| {
            vec![
                line.of.clone(),
                place(words, line),
                amplitude(words, line),
                line.detail.clone(),
            ]
        });
        let mut tables = vec![
            SectionTable {
                title: format!("Peaks{at}"),
                says: "The table compares the largest amplitude about each resonance, over all regimes, with the estimate for small damping. \
                       A resonance that is not listed has no peak."
                    .to_owned(),
                heads: vec!["friction", "of", "mode", "peak at", "amplitude", "estimate", "the contact there"],
                rows: peaks.collect(),
            },
            SectionTable {
                title: format!("Where the contact slides{at}"),
                says: "In these ranges the contact slides, all the time or between stops, with this friction and with every smaller one. \
                       Outside them the contact is stuck."
                    .to_owned(),
                heads: vec!["friction", "from … to"],
                rows: slides.collect(),
            },
            SectionTable {
                title: format!("What the contact does{at}"),
                says: "From low to high frequencies.".to_owned(),
                heads: vec!["friction", "from … to", "the contact"],
                rows: regimes.collect(),
            },
            SectionTable {
                title: format!("The quasi-static start{at}"),
                says: "Amplitude of each mass under a very slow load. The curves begin there.".to_owned(),
                heads: vec!["friction", "of", "amplitude"],
                rows: starts.collect(),
            },
            SectionTable {
                title: "The same amplitude with two frictions".to_owned(),
                says: "At these frequencies the exact curves of two frictions cross.".to_owned(),
                heads: vec!["of", "at", "amplitude", "which"],
                rows: crossings.collect(),
            },
        ];
        if let [_] = self.frictions.as_slice() {
            // If all rows of a table have the same friction, the title of the table contains the friction. The code
            // then removes the column of frictions.
            for table in &mut tables {
                table.leave_out("friction");
            }
        }
        tables
    }
}

fn place(words: &PageUnits, line: &FeatureLine) -> String {
    line.r.map_or_else(String::new, |r| words.frequency(r))
}

fn range(words: &PageUnits, line: &FeatureLine) -> String {
    match (line.r, line.to) {
        (Some(from), Some(to)) => {
            format!("{} … {}", words.frequency(from), words.frequency(to))
        }
        _ => place(words, line),
    }
}

/// Formats a friction with its unit. For an infinite friction it returns "any friction".
fn limit(words: &PageUnits, force: f64) -> String {
    if force.is_infinite() {
        "any friction".to_owned()
    } else {
        words.force(force)
    }
}

/// Formats the amplitude of a feature, which is in m under a load and otherwise non-dimensional.
fn amplitude(words: &PageUnits, line: &FeatureLine) -> String {
    match line.amplitude {
        None => String::new(),
        Some(size) if size.is_infinite() => "unbounded".to_owned(),
        Some(size) => words.length(words.measure.length_ratio(size)),
    }
}

/// Returns words for the quantity (amplitude, or also phase) that a feature describes. `detail` is the text of the
/// feature's field `detail`.
fn measured(detail: &str) -> &'static str {
    if detail.starts_with("fundamental") {
        "fundamental component"
    } else if detail.contains("estimate") {
        "amplitude, as estimated"
    } else if detail.contains("phase too") {
        "amplitude and phase"
    } else {
        "amplitude"
    }
}

/// Returns words for the motion of the contact in a regime.
fn does(regime: &str) -> String {
    match regime {
        "continuous" => "slides all the time".to_owned(),
        "stick-slip" => "slides and stops in turn".to_owned(),
        "stuck" => "is stuck".to_owned(),
        // For an elastic contact, a percentage in brackets follows the name of the regime.
        other => other.replacen("stick-slip (", "slides and sticks in turn (", 1),
    }
}

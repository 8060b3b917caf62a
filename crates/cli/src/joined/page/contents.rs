//! Contents of the report page for a scene with several contacts: choices of the command, and computed results.

use super::figures::{closed, loops_figure};
use crate::args::{FrictionArguments, ReportArguments, ShadeArgument};
use crate::asked;
use crate::failure::Failure;
use crate::frequency::{Band, Frequencies};
use crate::friction::Frictions;
use crate::interrupt;
use crate::joined::Question;
use crate::joined::draw::{self, CurveRows, Picture};
use crate::measure::{self, Measure};
use crate::modes;
use crate::report::asked::{FRACTIONS, PLACES, RANGE, given_band, given_frictions};
use crate::report::words::number;
use frictiongen::System;
use frictiongen::study::columns::{Frequency, JoinedRow};
use frictiongen::study::joined::{DampedModes, JoinedOrbit};
use frictiongen::study::scene::Scene;
use frictiongen_plot::Figure;
use serde_json::{Value as Json, json};

/// Number of frequencies on each curve of steady states.
const CURVE: usize = 40;
/// Number of frequencies and number of frictions of the map.
const MAP: (usize, usize) = (24, 10);

/// The steady state in which no contact slides, at one frequency.
pub struct StuckAnswers {
    /// Frequency ratio r of the steady state.
    pub r: f64,
    /// Smallest common friction ratio β of the contacts at which no contact slides.
    pub limit: f64,
    /// Name of the contact that slides first if the friction falls below `limit`.
    pub first: String,
}

/// A range of frequencies in which the same contact slides first if the friction decreases.
pub struct First<'a> {
    /// Name of the contact that slides first.
    pub name: &'a str,
    /// Lowest and highest frequency ratio r of the range.
    pub ends: (f64, f64),
}

/// The steady state whose hysteresis loops the page shows.
pub struct Loops<'a> {
    /// Frequency of the steady state.
    pub frequency: Frequency,
    /// Common friction of the contacts, as friction ratio β.
    pub beta: f64,
    /// The steady state with the motion of every contact.
    pub orbit: JoinedOrbit<'a>,
}

/// Contents of the report page for a scene with several contacts.
pub(super) struct Contents<'a> {
    /// The system, its contacts, the units of the results, and the motions that the page shows.
    pub question: &'a Question<'a>,
    /// Range of frequencies that the page shows.
    pub band: &'a Band,
    /// Damped modes with each set of stuck contacts. `None` for a long chain.
    pub modes: Option<Vec<DampedModes>>,
    /// States in which no contact slides, at frequencies over the range.
    pub stuck: Vec<StuckAnswers>,
    /// Steady states on the response curves, with one curve for each friction.
    pub curves: Vec<CurveRows>,
    /// Figures of the page, each with its name: closed forms, curves, map and hysteresis loops.
    pub figures: Vec<(&'static str, Figure)>,
    /// The steady state whose hysteresis loops the page shows, if one was found.
    pub loops: Option<Loops<'a>>,
    /// Sentences that tell the reader which values the command has chosen.
    pub chosen: Vec<String>,
}

impl Contents<'_> {
    /// Returns the ranges in which the same contact slides first if the friction decreases, in ascending order of
    /// frequency.
    pub fn firsts(&self) -> Vec<First<'_>> {
        let mut ranges: Vec<First<'_>> = Vec::new();
        for stuck in &self.stuck {
            match ranges.last_mut() {
                Some(last) if last.name == stuck.first => last.ends.1 = stuck.r,
                _ => ranges.push(First {
                    name: &stuck.first,
                    ends: (stuck.r, stuck.r),
                }),
            }
        }
        ranges
    }

    /// Returns the numbers of the page as JSON.
    pub fn data(&self, file: &str) -> Json {
        let stuck = self.stuck.iter().map(|stuck| {
            json!({ "r": number(stuck.r), "stuck_from_beta": number(stuck.limit), "slides_first": stuck.first })
        });
        let contacts = self.question.joined.contact_names();
        let masses = self.question.names();
        let points = self.curves.iter().flat_map(|(friction, line)| {
            let (contacts, masses) = (&contacts, &masses);
            line.iter().map(move |row| {
                let fractions = contacts.iter().enumerate();
                let fractions = fractions.map(|(index, name)| {
                    let fraction = row.stuck_fraction(index).map_or(Json::Null, number);
                    (name.clone(), fraction)
                });
                let sizes = masses.iter().enumerate().map(|(index, name)| {
                    let size = row.amplitude(contacts.len() + index);
                    (name.clone(), size.map_or(Json::Null, number))
                });
                json!({
                    "r": number(row.frequency.r),
                    "beta": number(friction.beta),
                    "regime": row.regime,
                    "amplitude": sizes.collect::<serde_json::Map<_, _>>(),
                    "stuck_fraction": fractions.collect::<serde_json::Map<_, _>>(),
                })
            })
        });
        json!({
            "version": 1,
            "file": file,
            "name": self.question.system.scene().name,
            "chosen": self.chosen,
            "damped_modes": self.modes.as_deref().map(modes::json),
            "stuck": stuck.collect::<Vec<_>>(),
            "points": points.collect::<Vec<_>>(),
        })
    }
}

/// Computes the contents of the report page, and calls `write` with these contents.
pub(super) fn contents(
    arguments: &ReportArguments,
    scene: Scene,
    write: impl FnOnce(&Contents<'_>) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let system = System::try_from(scene).map_err(Failure::new)?;
    let joined = system.joined().map_err(Failure::new)?;
    let measure = measure::constant(&arguments.load, &system)?;
    let mut chosen = Vec::new();
    let band = band(arguments, &system, &measure, &mut chosen)?;
    let parts = asked::motions(&system, &arguments.of)?;
    let over = |count| Frequencies::evenly(&system, &band, count).under(&measure);
    let base = Question {
        system: &system,
        joined: &joined,
        frequencies: over(PLACES),
        frictions: levels(&[1.0], &measure)?,
        measure,
        parts,
        orders: None,
    };
    let stuck = stuck(&base)?;
    let (middle, high) = middle(&stuck);
    let frictions = match given_frictions(arguments, &measure)? {
        Some(given) => given,
        None => {
            chosen.push(format!(
                "The frictions of the curves are {}, {} and {} times the median of the friction from which no contact slides.",
                FRACTIONS[0], FRACTIONS[1], FRACTIONS[2]
            ));
            levels(&FRACTIONS.map(|part| part * middle), &measure)?
        }
    };
    interrupt::watch();
    let asked = |frequencies, frictions| Question {
        frequencies,
        frictions,
        parts: base.parts.clone(),
        orders: None,
        ..base
    };
    let curve = asked(over(CURVE), frictions);
    let curves = draw::rows(&curve)?;
    let steps = (1..=MAP.1).map(|step| 1.1 * high * step as f64 / MAP.1 as f64);
    let map = asked(over(MAP.0), levels(&steps.collect::<Vec<_>>(), &measure)?);
    let map_rows = draw::rows(&map)?;
    let mut figures = vec![("closed", closed(&base)?)];
    let shown = Picture::Curve(false, false);
    figures.push(("curves", draw::steady_figure(&curve, shown, &curves)?));
    let shown = Picture::Map(ShadeArgument::Regime);
    figures.push(("map", draw::steady_figure(&map, shown, &map_rows)?));
    let loops = loops(&base, &curves)?;
    if let Some(loops) = &loops {
        figures.push((
            "loops",
            loops_figure(&base, (loops.frequency, &loops.orbit))?,
        ));
    }
    write(&Contents {
        question: &base,
        band: &band,
        modes: modes::of(&system),
        stuck,
        curves,
        figures,
        loops,
        chosen,
    })
}

/// Returns the user's range of frequencies. Without this range, returns a range around the resonances.
fn band(
    arguments: &ReportArguments,
    system: &System,
    measure: &Measure,
    chosen: &mut Vec<String>,
) -> Result<Band, Failure> {
    if let Some(band) = given_band(arguments, system)? {
        return Ok(band);
    }
    let positive = |r: &&f64| 1e-6 < **r && r.is_finite();
    let mut resonances = system.resonances().iter().filter(positive);
    let lowest = resonances.next().copied();
    let Some(lowest) = lowest else {
        return Err(Failure::new(
            "without friction this scene has no resonance, from which a range of frequencies could follow; give a range by --hz, --omega or --r",
        ));
    };
    let highest = resonances.next_back().copied().unwrap_or(lowest);
    chosen.push(format!(
        "The range of frequencies goes from {} of the lowest to {} of the highest resonance without friction.",
        RANGE[0], RANGE[1]
    ));
    let in_hertz = measure.load().is_some();
    Ok(Band::between(
        RANGE[0] * lowest,
        RANGE[1] * highest,
        in_hertz,
    ))
}

/// Converts friction ratios β to frictions, which are in N under a load, and rounds the frictions to two digits.
fn levels(betas: &[f64], measure: &Measure) -> Result<Frictions, Failure> {
    let scale = measure.scale();
    let values = betas.iter().map(|beta| {
        let value = scale.map_or(*beta, |scale| scale.friction(*beta));
        format!("{value:.1e}")
    });
    let text = Some(values.collect::<Vec<_>>().join(","));
    let arguments = match scale {
        None => FrictionArguments {
            beta: text,
            friction: None,
        },
        Some(_) => FrictionArguments {
            beta: None,
            friction: text,
        },
    };
    Frictions::parse(&arguments, None)?.under(measure)
}

/// Computes the state in which no contact slides, at each frequency of the range.
fn stuck(question: &Question<'_>) -> Result<Vec<StuckAnswers>, Failure> {
    let mut all = Vec::new();
    for frequency in question.frequencies.all(question.system) {
        let at = question.table().at(frequency).map_err(Failure::new)?;
        // At a resonance of an undamped chain, no state exists in which no contact slides.
        if let Ok(stuck) = at.stuck() {
            all.push(StuckAnswers {
                r: frequency.r,
                limit: stuck.limit(),
                first: stuck.first().to_owned(),
            });
        }
    }
    Ok(all)
}

/// Returns the median and the 0.9 quantile of the friction ratios from which no contact slides.
fn middle(stuck: &[StuckAnswers]) -> (f64, f64) {
    let limits = stuck.iter().map(|stuck| stuck.limit);
    let mut limits: Vec<f64> = limits
        .filter(|limit| 0.0 < *limit && limit.is_finite())
        .collect();
    limits.sort_by(f64::total_cmp);
    let at = |share: usize| limits.get(limits.len() * share / 10).copied();
    (at(5).unwrap_or(1.0), at(9).unwrap_or(1.0))
}

/// Finds the steady state with the largest amplitude of any mass, on the curve with the middle friction.
fn loops<'q>(
    question: &'q Question<'_>,
    curves: &[CurveRows],
) -> Result<Option<Loops<'q>>, Failure> {
    let contacts = question.joined.contact_names().len();
    let Some((friction, line)) = curves.get(curves.len() / 2) else {
        return Ok(None);
    };
    let size = |row: &JoinedRow| {
        let sizes = (0..question.parts.len()).filter_map(|index| row.amplitude(contacts + index));
        sizes.fold(0.0, f64::max)
    };
    let known = line.iter().filter(|row| row.is_known());
    let Some(row) = known.max_by(|a, b| size(a).total_cmp(&size(b))) else {
        return Ok(None);
    };
    let friction = friction.at(&question.measure, row.frequency);
    let at = question.table().at(row.frequency).map_err(Failure::new)?;
    let Ok(orbit) = at.orbit(friction.beta) else {
        return Ok(None);
    };
    Ok(Some(Loops {
        frequency: row.frequency,
        beta: friction.beta,
        orbit,
    }))
}

//! Contents of the report page. The contents follow from the user's options, or from defaults if the user gives no
//! option.

use super::words::PageUnits;
use crate::args::ReportArguments;
use crate::asked::{self, MovingPart};
use crate::failure::Failure;
use crate::frequency::Band;
use crate::friction::Frictions;
use crate::measure::{self, Measure};
use crate::picture;
use frictiongen::study::scene::{Excitation, Node};
use frictiongen::study::units;
use frictiongen::{Of, System};

/// Largest number of frictions on a page. Colours for more frictions would be hard to distinguish.
const MOST_FRICTIONS: usize = 6;
/// Largest number of masses for which the page shows every motion.
const ALL_SHOWN: usize = 4;
/// Default range of frequencies. The range begins at 0.3 times the lowest resonance, and ends at 1.5 times the highest
/// resonance.
pub const RANGE: [f64; 2] = [0.3, 1.5];
/// Default frictions, divided by the median of β*_lim over the range of frequencies.
pub const FRACTIONS: [f64; 3] = [0.1, 0.3, 0.7];
/// Number of frequencies over the range at which the command computes β*_lim and the motion with the contact stuck.
/// The page uses the median of β*_lim, and the largest amplitude of each mass with the contact stuck.
pub const PLACES: usize = 401;

/// Scene, range, units and motions that the report page shows.
pub struct ReportRequest {
    /// The system that the page describes.
    pub system: System,
    /// Range of frequencies of the results.
    pub band: Band,
    /// The units of the numbers on the page.
    pub words: PageUnits,
    /// The contact and masses whose motions the page shows.
    pub parts: Vec<MovingPart>,
    /// Friction ratios β that the user gave. `None` for the default frictions.
    pub frictions: Option<Vec<f64>>,
    /// Sentences for the reader about the values that the command has chosen, and about the rule for each choice.
    pub chosen: Vec<String>,
}

impl ReportRequest {
    /// Reads the options, and chooses everything that the options do not set.
    pub fn of(arguments: &ReportArguments, system: System) -> Result<Self, Failure> {
        let measure = measure::constant(&arguments.load, &system)?;
        let mut chosen = Vec::new();
        let band = match given_band(arguments, &system)? {
            Some(band) => band,
            None => {
                chosen.push(format!(
                    "The range of frequencies goes from {} of the lowest to {} of the highest resonance.",
                    RANGE[0], RANGE[1]
                ));
                automatic(&system, measure.load().is_some())
            }
        };
        let words = PageUnits {
            scales: picture::scales(&system, band.is_physical(), &measure),
            in_hertz: band.is_physical(),
            measure,
        };
        let parts = if arguments.of.is_empty() {
            shown(&system, &band, &mut chosen)?
        } else {
            let parts = asked::parts(&system, &arguments.of)?;
            let plain = |part: &&MovingPart| {
                matches!(part.of, Of::Contact | Of::Mass(_)) && !part.has_rate()
            };
            if let Some(part) = parts.iter().find(|part| !plain(part)) {
                return Err(Failure::new(format_args!(
                    "--of `{}`: the report shows the contact and masses; `curve` shows relative motions and forces",
                    part.name
                )));
            }
            parts
        };
        let frictions = given_frictions(arguments, &words.measure)?;
        let frictions = frictions.map(|given| given.all().map(|friction| friction.beta).collect());
        Ok(Self {
            system,
            band,
            words,
            parts,
            frictions,
            chosen,
        })
    }

    /// Returns `count` evenly spaced frequency ratios r over the range of the page, including both bounds.
    pub fn even(&self, count: usize) -> impl Iterator<Item = f64> + use<> {
        evenly(&self.band, count)
    }

    /// Returns the indices of the masses, in descending order of the largest amplitude with the contact stuck.
    pub fn farthest_if_stuck(&self) -> Vec<usize> {
        farthest_if_stuck(&self.system, &self.band)
    }

    /// Returns true if the contact is elastic.
    pub fn is_elastic(&self) -> bool {
        self.system.scene().stiffness.is_some()
    }

    /// Returns the finite values of β*_lim at frequencies over the range, in ascending order.
    pub fn sliding_limits(&self) -> Vec<f64> {
        let at = |r: f64| Some(self.system.at(r).ok()?.sliding_limit());
        let mut limits: Vec<f64> = self.even(PLACES).filter_map(at).collect();
        limits.retain(|limit| limit.is_finite());
        limits.sort_by(f64::total_cmp);
        limits
    }

    /// Returns the frictions of the curves, in ascending order. The function returns the user's frictions. Without
    /// these, it returns the default frictions and the best friction.
    pub fn levels(&mut self, best: Option<f64>) -> Vec<f64> {
        if let Some(given) = &self.frictions {
            return given.clone();
        }
        let limits = self.sliding_limits();
        let middle = limits.get(limits.len() / 2).copied().unwrap_or(1.0);
        let middle = if 0.0 < middle { middle } else { 1.0 };
        let scale = self.words.measure.scale();
        let nice = |beta: f64| match scale {
            Some(scale) => scale.friction_ratio(two_digits(scale.friction(beta))),
            None => two_digits(beta),
        };
        let mut levels: Vec<f64> = FRACTIONS.iter().map(|part| nice(part * middle)).collect();
        let [first, second, third] = FRACTIONS;
        self.chosen.push(format!(
            "The frictions of the curves are {first}, {second} and {third} times the median of the sliding limit over the range ({}), \
             rounded to two digits{}.",
            self.words.friction(middle),
            if best.is_some() { ", and the best friction" } else { "" },
        ));
        if let Some(best) = best.filter(|best| 0.0 < *best && best.is_finite()) {
            // A reader could not distinguish a curve that is close to the curve of the best friction. The code
            // therefore drops the friction of such a curve.
            levels.retain(|level| 0.05 * best < (level - best).abs());
            levels.push(best);
        }
        levels.retain(|level| 0.0 < *level && level.is_finite());
        levels.sort_by(f64::total_cmp);
        levels.dedup();
        levels
    }
}

/// Reads the range of frequencies of a page, if the user gave one.
pub fn given_band(arguments: &ReportArguments, system: &System) -> Result<Option<Band>, Failure> {
    let band = arguments.range().map(|range| Band::parse(&range, system));
    match band.transpose()? {
        Some(band) if band.widest.is_some() => Err(Failure::new(
            "a page needs a range a:b, without a step, because the page chooses its own points",
        )),
        band => Ok(band),
    }
}

/// Reads the frictions of a page, if the user gave any.
pub fn given_frictions(
    arguments: &ReportArguments,
    measure: &Measure,
) -> Result<Option<Frictions>, Failure> {
    let Some(given) = arguments.frictions() else {
        return Ok(None);
    };
    let given = Frictions::parse(&given, None)?.under(measure)?;
    if MOST_FRICTIONS < given.len() {
        return Err(Failure::new(format_args!(
            "a page shows up to {MOST_FRICTIONS} frictions, but {} are given",
            given.len()
        )));
    }
    Ok(Some(given))
}

/// Returns `count` evenly spaced frequency ratios r over a range, including both bounds.
fn evenly(band: &Band, count: usize) -> impl Iterator<Item = f64> + use<> {
    let (from, to) = (band.from, band.to);
    let steps = count.max(2) - 1;
    (0..=steps).map(move |i| {
        if i == steps {
            to
        } else {
            from + (to - from) * i as f64 / steps as f64
        }
    })
}

/// Returns the indices of the masses, in descending order of the largest amplitude over the range with the contact
/// stuck.
fn farthest_if_stuck(system: &System, band: &Band) -> Vec<usize> {
    let stuck = evenly(band, PLACES).filter_map(|r| system.at(r).ok()?.stuck().ok());
    let mut most = vec![(0.0_f64, 0); system.scene().masses.len()];
    for (mass, place) in most.iter_mut().enumerate() {
        place.1 = mass;
    }
    for stuck in stuck {
        for (size, mass) in &mut most {
            let motion = stuck.mass_at(*mass);
            *size = motion.map_or(*size, |motion| size.max(units::polar(motion).0));
        }
    }
    most.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    most.into_iter().map(|(_, mass)| mass).collect()
}

fn two_digits(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

fn automatic(system: &System, in_hertz: bool) -> Band {
    let positive = |r: &&f64| 0.0 < **r && r.is_finite();
    let resonances = || system.resonances().iter().filter(positive);
    let (lowest, highest) = (resonances().next(), resonances().next_back());
    let [low, high] = RANGE;
    Band::between(
        low * lowest.copied().unwrap_or(1.0),
        high * highest.copied().unwrap_or(1.0),
        in_hertz,
    )
}

/// Returns the contact and masses that the page shows. For a long chain, the function chooses only some masses: those
/// at the contact and at the load, the last mass, and the mass that moves farthest with the contact stuck. If a mass
/// slides on a wall, the contact moves as this mass does, so the list does not contain the contact.
fn shown(
    system: &System,
    band: &Band,
    chosen: &mut Vec<String>,
) -> Result<Vec<MovingPart>, Failure> {
    let mut all = asked::parts(system, &[])?;
    let scene = system.scene();
    if [scene.contact.from, scene.contact.to].contains(&Node::Wall) {
        all.retain(|part| part.of != Of::Contact);
    }
    let count = scene.masses.len();
    if count <= ALL_SHOWN {
        return Ok(all);
    }
    let mut kept = vec![count - 1];
    for node in [scene.contact.from, scene.contact.to] {
        if let Node::Mass(index) = node {
            kept.push(index);
        }
    }
    match scene.excitation {
        Excitation::Force(index) => kept.push(index),
        Excitation::Base => {
            kept.extend(
                scene
                    .springs
                    .iter()
                    .filter_map(|spring| match (spring.from, spring.to) {
                        (Node::Base, Node::Mass(index)) | (Node::Mass(index), Node::Base) => {
                            Some(index)
                        }
                        _ => None,
                    }),
            )
        }
    }
    kept.extend(farthest_if_stuck(system, band).first());
    chosen.push(format!(
        "Of {count} masses the page shows the masses at the contact and at the load, the last mass, and the mass that would move \
         farthest with the contact stuck. The option --of shows others."
    ));
    let counts = |part: &MovingPart| match part.of {
        Of::Contact => true,
        Of::Mass(index) => kept.contains(&index),
        _ => false,
    };
    Ok(all.into_iter().filter(counts).collect())
}

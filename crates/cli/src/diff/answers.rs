//! Largest differences between the results of two scenes at the same frequencies and friction forces.

use super::relative;
use crate::number::computed;
use frictiongen::System;
use frictiongen::study::scene::{Accuracy, Beyond, Excitation, FrictionLaw, Provide, Scene};
use frictiongen::study::units::{Load, hertz};

/// Number of frequencies at which the command compares two scenes.
pub const FREQUENCIES: u32 = 400;
/// Range of the compared frequencies. The range begins at 0.2 times the lowest natural frequency of both scenes, and
/// ends at 1.5 times the highest.
pub const BAND: (f64, f64) = (0.2, 1.5);
/// Largest value that the comparison treats as 0, divided by the largest value of the same result over the frequencies.
/// Rounding errors of a result whose exact value is 0 have this size.
const NOISE: f64 = 1e-12;
/// Friction for the comparison of motions, divided by the smaller of the limits β_lim and β*_lim of the old scene.
pub const FRICTION: f64 = 0.5;

/// Text for a comparison that covers only the frequencies at which both scenes have a finite limit.
const FINITE: &str = "where both limits are finite";
/// Text for a comparison that covers only the frequencies at which both scenes have a continuous motion.
const CONTINUOUS: &str = "where both motions are continuous";

/// Largest difference, over the compared frequencies, between the old scene and the new scene in one result.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// Name of the result that the command compares.
    pub name: String,
    /// Unit of the result's old and new value.
    pub unit: &'static str,
    /// Frequency of the largest difference, in Hz.
    pub hertz: f64,
    /// Value of the result in the old scene and in the new scene, at the frequency of the largest difference.
    pub values: (f64, f64),
    /// Difference of the two values at the frequency of the largest difference, divided by the larger value.
    pub relative: f64,
    /// Median of the relative differences over the compared frequencies.
    pub median: f64,
    /// Smallest of the relative differences.
    pub smallest: f64,
    /// Ranges of frequencies in Hz at which a scene has no result. The ends are compared frequencies.
    pub gaps: Vec<(f64, f64)>,
    /// Number of frequencies at which both scenes have a result.
    pub compared: usize,
    /// Text that names the scene or scenes (old, new) whose emitted code does not provide this result. The text is
    /// empty if the code of both scenes provides the result.
    pub left_out_by: &'static str,
    /// Text that names the compared frequencies, if the comparison covers only some frequencies of the band.
    pub where_both: &'static str,
}

/// Natural frequencies of both scenes in Hz, mode by mode.
pub type NaturalFrequencies = Vec<(Option<f64>, Option<f64>)>;

/// Comparison of the results of two scenes.
#[derive(Clone, Debug, Default)]
pub struct Answers {
    /// Natural frequencies of both scenes.
    pub modes: NaturalFrequencies,
    /// Lowest and highest compared frequency, in Hz.
    pub band: Option<(f64, f64)>,
    /// Lowest and highest compared frequency ratio r, in the old scene and in the new scene.
    pub ratios: [(f64, f64); 2],
    /// True if a declared `range` narrows the range that [`BAND`] gives.
    pub within_range: bool,
    /// Largest difference for each result that the command compares.
    pub differences: Vec<Difference>,
    /// Reasons why some results were not compared.
    pub left_out: Vec<String>,
}

/// Compares the results of two scenes.
pub fn compare(old: &System, new: &System) -> Answers {
    let frequencies = |system: &System| -> Vec<f64> {
        system
            .natural_frequencies()
            .into_iter()
            .map(hertz)
            .collect()
    };
    let (before, after) = (frequencies(old), frequencies(new));
    let mut answers = Answers {
        modes: (0..before.len().max(after.len()))
            .map(|mode| (before.get(mode).copied(), after.get(mode).copied()))
            .collect(),
        ..Answers::default()
    };
    let scenes = [old.scene(), new.scene()];
    if scenes
        .iter()
        .any(|scene| scene.friction != FrictionLaw::Coulomb)
    {
        let reason = "limits and amplitudes: they need a constant kinetic level, not `stribeck`";
        answers.left_out.push(reason.to_owned());
        return answers;
    }
    if scenes.iter().any(|scene| scene.stiffness.is_some()) {
        let reason = "limits and amplitudes: they need a rigid contact, not `stiffness`";
        answers.left_out.push(reason.to_owned());
        return answers;
    }
    if scenes.iter().any(|scene| scene.is_joined()) {
        let reason = "limits and amplitudes: they need scenes without `contacts` and `dampers`";
        answers.left_out.push(reason.to_owned());
        return answers;
    }
    let on_base = |index: usize| {
        scenes
            .get(index)
            .map(|scene| scene.excitation == Excitation::Base)
    };
    if on_base(0) != on_base(1) {
        let reason = "limits and amplitudes: a force drives one scene, and the base the other";
        answers.left_out.push(reason.to_owned());
        return answers;
    }
    let (Some(lowest), Some(highest)) = (
        before.iter().chain(&after).copied().reduce(f64::min),
        before.iter().chain(&after).copied().reduce(f64::max),
    ) else {
        return answers;
    };
    let wide = (BAND.0 * lowest, BAND.1 * highest);
    let (from, to) = [old, new]
        .into_iter()
        .filter_map(answered)
        .fold(wide, |band, range| {
            (band.0.max(range.0), band.1.min(range.1))
        });
    if from >= to {
        answers.left_out.push(format!(
            "limits and amplitudes: no frequency in {}..{} Hz is in each `range`",
            computed(wide.0),
            computed(wide.1)
        ));
        return answers;
    }
    answers.within_range = (from, to) != wide;
    answers.band = Some((from, to));
    answers.ratios = [old, new].map(|system| {
        let ratio = |hertz| system.frequency_ratio_at_hertz(hertz);
        (ratio(from), ratio(to))
    });
    let ratio = (to / from).powf(1.0 / f64::from(FREQUENCIES - 1));
    let band: Vec<f64> = (0..FREQUENCIES)
        .map(|index| from * ratio.powf(f64::from(index)))
        .collect();
    answers.differences = differences(old, new, &band);
    answers.left_out.extend(unshared(old, new));
    answers
}

/// Returns the range of frequencies in Hz in which the emitted code of a scene gives results. Returns `None` if the
/// code gives results at every frequency.
fn answered(system: &System) -> Option<(f64, f64)> {
    let declared = &system.scene().declared;
    let exact = declared.accuracy == Accuracy::Exact && declared.budget.is_none();
    if exact || declared.beyond == Beyond::Exact {
        return None;
    }
    let (low, high) = declared.range?.r;
    let ratio_at_one_hertz = system.frequency_ratio_at_hertz(1.0);
    Some((low / ratio_at_one_hertz, high / ratio_at_one_hertz))
}

/// Returns true if the emitted code of a scene provides the continuous motion of a mass. `mass` is `None` for the
/// contact.
fn provides(scene: &Scene, mass: Option<&str>) -> bool {
    let named = |index: &usize| {
        let own = scene.masses.get(*index).map(|own| own.name.as_str());
        own == mass
    };
    scene.provide.iter().any(|item| match item {
        Provide::Motion(None) => true,
        Provide::Motion(Some(masses)) => mass.is_none() || masses.iter().any(named),
        _ => false,
    })
}

/// Returns a text that names the scene or scenes whose emitted code does not provide the continuous motion of a mass.
/// `mass` is `None` for the contact.
fn left_out_by(old: &Scene, new: &Scene, mass: Option<&str>) -> &'static str {
    match (provides(old, mass), provides(new, mass)) {
        (true, true) => "",
        (false, true) => "the old emitted code does not provide it",
        (true, false) => "the new emitted code does not provide it",
        (false, false) => "the emitted code does not provide it",
    }
}

/// Returns a sentence about masses that only one scene has. Returns `None` if both scenes have the same masses.
fn unshared(old: &System, new: &System) -> Option<String> {
    let has =
        |system: &System, name: &str| system.scene().masses.iter().any(|mass| mass.name == name);
    let only = |one: &System, other: &System| -> Vec<String> {
        let masses = one.scene().masses.iter();
        let missing = masses.filter(|mass| !has(other, &mass.name));
        missing.map(|mass| mass.name.clone()).collect()
    };
    let mut names = only(old, new);
    names.extend(only(new, old));
    let these = match names.len() {
        0 => return None,
        1 => "this mass",
        _ => "each of these masses",
    };
    let names = names.join(", ");
    Some(format!("amplitude of {names}: only one scene has {these}"))
}

/// One result (such as β_lim or an amplitude) of the old scene and of the new scene, over the compared frequencies.
struct ResultSeries {
    name: String,
    unit: &'static str,
    left_out_by: &'static str,
    where_both: &'static str,
    values: Vec<(f64, f64, f64)>,
}

impl ResultSeries {
    fn new(name: impl Into<String>, unit: &'static str, where_both: &'static str) -> Self {
        Self {
            name: name.into(),
            unit,
            left_out_by: "",
            where_both,
            values: Vec::new(),
        }
    }

    fn push(&mut self, hertz: f64, old: f64, new: f64) {
        if old.is_finite() && new.is_finite() {
            self.values.push((hertz, old, new));
        }
    }

    /// Returns the ranges of frequencies of the band at which the series has no values.
    fn gaps(&self, band: &[f64]) -> Vec<(f64, f64)> {
        let is_missing = |hertz: &f64| self.values.iter().all(|(own, ..)| own != hertz);
        let runs = band.chunk_by(|one, next| is_missing(one) == is_missing(next));
        let gaps = runs.filter_map(|run| {
            let (first, last) = (run.first()?, run.last()?);
            is_missing(first).then_some((*first, *last))
        });
        gaps.collect()
    }

    fn difference(mut self, band: &[f64]) -> Option<Difference> {
        let sizes = self.values.iter().flat_map(|(_, old, new)| [old, new]);
        let least = NOISE * sizes.fold(0.0, |size: f64, value| size.max(value.abs()));
        for (_, old, new) in &mut self.values {
            for value in [old, new] {
                if value.abs() <= least {
                    *value = 0.0;
                }
            }
        }
        let values = self.values.iter();
        let largest = values.max_by(|a, b| relative(a.1, a.2).total_cmp(&relative(b.1, b.2)))?;
        let mut all: Vec<f64> = self
            .values
            .iter()
            .map(|(_, old, new)| relative(*old, *new))
            .collect();
        all.sort_by(f64::total_cmp);
        let gaps = self.gaps(band);
        Some(Difference {
            name: self.name,
            unit: self.unit,
            hertz: largest.0,
            values: (largest.1, largest.2),
            relative: relative(largest.1, largest.2),
            median: median(&all),
            smallest: all.first().copied().unwrap_or(0.0),
            gaps,
            compared: all.len(),
            left_out_by: self.left_out_by,
            where_both: self.where_both,
        })
    }
}

/// Returns the median of sorted numbers, or 0 without numbers.
fn median(sorted: &[f64]) -> f64 {
    let at = |place: usize| sorted.get(place).copied().unwrap_or(0.0);
    let half = sorted.len() / 2;
    if sorted.len() % 2 == 1 {
        at(half)
    } else {
        0.5 * (at(half.saturating_sub(1)) + at(half))
    }
}

fn differences(old: &System, new: &System, band: &[f64]) -> Vec<Difference> {
    let on_base = old.scene().excitation == Excitation::Base;
    // The load has the amplitude 1. The results are therefore limits and displacements per unit of the load.
    let load = if on_base {
        Load::Base(1.0)
    } else {
        Load::Force(1.0)
    };
    let (Ok(scale), Ok(scale_new)) = (old.load_scale(load), new.load_scale(load)) else {
        return Vec::new();
    };
    let (force, force_new) = (scale.force(), scale_new.force());
    let (length, length_new) = (scale.length(), scale_new.length());
    let (of_force, of_length) = if on_base { ("N/m", "") } else { ("", "m/N") };
    let load = if on_base { "Y" } else { "P" };
    let limit = |name: &str| ResultSeries::new(format!("{name}/{load}"), of_force, FINITE);
    let mut continuous = limit("limit of continuous motion F_lim");
    let mut sliding = limit("limit of sliding F*_lim");
    let names = new.scene().masses.iter().map(|mass| &mass.name);
    let names: Vec<&String> = names.collect();
    let shared = old.scene().masses.iter().map(|mass| &mass.name);
    let shared: Vec<&String> = shared.filter(|name| names.contains(name)).collect();
    let names = shared.iter().map(|name| Some(name.as_str()));
    let mut motions: Vec<ResultSeries> = std::iter::once(None)
        .chain(names)
        .map(|mass| {
            let name = format!(
                "amplitude of {} over {load}",
                mass.unwrap_or(&new.scene().contact_name)
            );
            ResultSeries {
                left_out_by: left_out_by(old.scene(), new.scene(), mass),
                ..ResultSeries::new(name, of_length, CONTINUOUS)
            }
        })
        .collect();
    for hertz in band {
        let ratio = |system: &System| system.frequency_ratio_at_hertz(*hertz);
        let (Ok(at), Ok(at_new)) = (old.at(ratio(old)), new.at(ratio(new))) else {
            continue;
        };
        let (limits, limits_new) = (at.limits(), at_new.limits());
        continuous.push(
            *hertz,
            force * limits.continuous,
            force_new * limits_new.continuous,
        );
        sliding.push(
            *hertz,
            force * limits.sliding,
            force_new * limits_new.sliding,
        );
        let beta = FRICTION * limits.continuous.min(limits.sliding);
        let (Ok(motion), Ok(motion_new)) =
            (at.motion(beta), at_new.motion(beta * force / force_new))
        else {
            continue;
        };
        let masses = shared
            .iter()
            .filter_map(|name| Some((motion.mass(name).ok()?, motion_new.mass(name).ok()?)));
        let pairs = std::iter::once((motion.contact(), motion_new.contact())).chain(masses);
        for (series, (one, other)) in motions.iter_mut().zip(pairs) {
            series.push(
                *hertz,
                length * one.amplitude(),
                length_new * other.amplitude(),
            );
        }
    }
    let all = [continuous, sliding].into_iter().chain(motions);
    all.filter_map(|series| series.difference(band)).collect()
}

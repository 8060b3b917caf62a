//! Finds the best common friction of several contacts, with which the largest amplitude of a mass is smallest.

use super::refused;
use crate::args::OptimumArguments;
use crate::asked;
use crate::failure::Failure;
use crate::frequency::Band;
use crate::interrupt;
use crate::layout::Layout;
use crate::measure;
use crate::number::computed;
use crate::output::{self, ResultTable, Visitor};
use crate::progress::Progress;
use crate::summary::Summary;
use crate::vary::Vary;
use frictiongen::System;
use frictiongen::study::columns::{
    Column, Frequency, FrictionSetting, JoinedRow, JoinedTable, Measure, PhysicalQuantity, Setting,
    TableRow,
};
use frictiongen::study::joined::{
    Joined, JoinedDistribution, JoinedError, JoinedOptimum, ShareRange,
};
use frictiongen::study::scene::Scene;
use std::io::Write;
use std::sync::Mutex;

/// Finds the common friction with which the largest amplitude of a mass over a band of frequencies is smallest. Also
/// writes the steady state at the frequency of this largest amplitude.
pub fn optimum(
    arguments: &OptimumArguments,
    scene: Scene,
    out: &mut dyn Write,
) -> Result<(), Failure> {
    refused(&[
        (!arguments.keep.is_empty(), "--keep"),
        (arguments.start.from.is_some(), "--from"),
        (1 < arguments.of.len(), "a second --of"),
    ])?;
    let system = System::try_from(scene).map_err(Failure::new)?;
    let joined = system.joined().map_err(Failure::new)?;
    let band = Band::parse(&arguments.frequency, &system)?;
    if band.widest.is_some() {
        return Err(Failure::new(
            "a band is a:b, without a step, because the search covers all its frequencies",
        ));
    }
    let measure = measure::constant(&arguments.load, &system)?;
    let joined = match measure.scale() {
        Some(scale) => joined.with_length(scale.length()),
        None => joined,
    };
    let band = band.under(&measure);
    let masses = asked::masses(&system, "--of", &arguments.of)?;
    let all: Vec<usize> = (0..system.scene().masses.len()).collect();
    let table = JoinedTable {
        setting: Setting {
            system: &system,
            measure,
            frequency: band.unit(),
            frequencies: &[],
            frictions: &[],
            forces: false,
            parts: &[],
        },
        joined: &joined,
        masses: &all,
    };
    // Without a spring in the scene, this call fails unless the units are physical. The user then gets the error before
    // the search.
    table
        .at(Frequency::at(&system, band.from))
        .map_err(Failure::new)?;
    let name = masses.first().map_or("", |mass| mass.name.as_str());
    let ranges = arguments.vary.as_deref().map(|text| ranges(&joined, text));
    let ranges = ranges.transpose()?;
    interrupt::watch();
    let progress = Mutex::new(Progress::search());
    let watch = || {
        if let Ok(mut progress) = progress.lock() {
            progress.step();
        }
        !interrupt::pressed()
    };
    let band_of = (band.from, band.to);
    let (found, shares) = match &ranges {
        None => (joined.optimum_watched(name, band_of, &watch), None),
        Some(ranges) => match joined.best_shares(name, band_of, ranges, &watch) {
            Ok(best) => (Ok(best.optimum), Some(best)),
            Err(error) => (Err(error), None),
        },
    };
    drop(progress);
    let found = found.map_err(Failure::new)?;
    let tuned = match &shares {
        Some(best) => joined.with_shares(&best.shares),
        None => joined.clone(),
    };
    let table = JoinedTable {
        joined: &tuned,
        ..table
    };
    let friction = FrictionSetting::of_ratio(found.friction, measure.scale());
    let row = table.row(Frequency::at(&system, found.r), friction);
    let report = OptimumReport {
        table,
        row: row.map_err(Failure::new)?,
        found,
        measure,
        name,
        shares: shares.map(|best| (joined.contact_names(), best)),
    };
    let summary = Summary::of(&system, band.is_physical(), measure);
    output::write(&report, &summary, arguments.format.checked()?, out)?;
    if !found.is_complete {
        return Err(interrupt::search_stopped());
    }
    Ok(())
}

/// Reads the shares that `--vary` names. A share is the friction of a contact, relative to the common friction. `share
/// pads=a:b` varies the share of one contact. `share=a:b` varies the shares of all contacts but the first, because a
/// common factor on all shares has the effect of the common friction.
fn ranges(joined: &Joined<'_>, text: &str) -> Result<Vec<ShareRange>, Failure> {
    let vary = Vary::parsed(text)?;
    let contacts = joined.contact_names();
    let mut words = vary.name.split_whitespace();
    let (first, contact, rest) = (words.next(), words.next(), words.next());
    if first != Some("share") || rest.is_some() {
        let only = "with several contacts only shares can vary; write `share=0.2:2` or";
        let example = contacts.last().map_or("pads", String::as_str);
        return Err(vary.wrong(&format_args!("{only} `share {example}=0.2:2`")));
    }
    let indices: Vec<usize> = match contact {
        None => (1..contacts.len()).collect(),
        Some(name) => {
            let found = contacts.iter().position(|contact| contact == name);
            let known = contacts.join(", ");
            let missing = || {
                vary.wrong(&format_args!(
                    "there is no contact `{name}`; the contacts are {known}"
                ))
            };
            vec![found.ok_or_else(missing)?]
        }
    };
    let (from, to) = vary.ends()?;
    if !(0.0 < from && from < to && to.is_finite()) {
        return Err(vary.wrong(&JoinedError::Shares));
    }
    let ranges = indices.into_iter();
    Ok(ranges
        .map(|contact| ShareRange { contact, from, to })
        .collect())
}

struct OptimumReport<'a> {
    table: JoinedTable<'a>,
    row: JoinedRow,
    found: JoinedOptimum,
    measure: Measure,
    name: &'a str,
    /// The names of the contacts and the best shares, if `--vary` is given.
    shares: Option<(Vec<String>, JoinedDistribution)>,
}

impl OptimumReport<'_> {
    /// Returns the best share of each contact, with the name of the contact. The list is empty without `--vary`.
    fn shares(&self) -> Vec<(&str, f64)> {
        let Some((names, best)) = &self.shares else {
            return Vec::new();
        };
        let names = names.iter().map(String::as_str);
        names.zip(best.shares.iter().copied()).collect()
    }

    /// Returns in words how the search ended, what it has compared, and what it can miss.
    fn end(&self) -> String {
        let JoinedOptimum {
            frequencies,
            frictions,
            evaluations,
            is_complete,
            ..
        } = self.found;
        let end = match is_complete {
            true => "all comparisons done",
            false => "the best so far: the search was stopped",
        };
        format!(
            "{end}; {frequencies} frequencies of the band, {frictions} frictions, {evaluations} steady states; a narrower \
             peak or minimum between them is not excluded"
        )
    }
}

impl ResultTable for OptimumReport<'_> {
    type Row = JoinedRow;

    fn len(&self) -> usize {
        1
    }

    fn each(&self, visit: Visitor<'_, JoinedRow>) -> Result<(), Failure> {
        visit(&self.row)
    }

    fn columns(&self) -> Vec<Column<'_, JoinedRow>> {
        self.table.columns()
    }

    fn layout(&self) -> Layout {
        Layout::Lines
    }

    fn head(&self) -> Vec<(String, serde_json::Value)> {
        let mut head = vec![
            ("of".to_owned(), self.name.into()),
            (
                "best_friction".to_owned(),
                self.measure.force(self.found.friction).into(),
            ),
            (
                "largest_amplitude".to_owned(),
                self.measure.length(self.found.amplitude).into(),
            ),
            ("steady_states".to_owned(), self.found.evaluations.into()),
            ("end".to_owned(), self.end().into()),
        ];
        if let Some((_, best)) = &self.shares {
            let shares = self.shares().into_iter();
            let shares = shares.map(|(name, share)| (name.to_owned(), share.into()));
            head.push((
                "shares".to_owned(),
                serde_json::Value::Object(shares.collect()),
            ));
            let before = self.measure.length(best.before.amplitude);
            head.push(("largest_amplitude_before".to_owned(), before.into()));
        }
        head
    }

    fn preamble(&self) -> Vec<(&'static str, String)> {
        let value = |dimension: PhysicalQuantity, ratio: f64| {
            let value = computed(self.measure.convert(dimension, ratio, self.row.omega()));
            let unit = self.measure.unit_or_reference(dimension);
            format!("{value} {unit}").trim_end().to_owned()
        };
        let amplitude = |amplitude: f64| value(PhysicalQuantity::Length, amplitude);
        let found = &self.found;
        let mut lines = vec![
            (
                "best common friction",
                value(PhysicalQuantity::Force, found.friction),
            ),
            (
                "largest amplitude",
                format!(
                    "{} of {} over the band",
                    amplitude(found.amplitude),
                    self.name
                ),
            ),
            ("how the search ended", self.end()),
        ];
        if let Some((_, best)) = &self.shares {
            let shares = self.shares().into_iter();
            let shares = shares.map(|(name, share)| format!("{name} {}", computed(share)));
            let before = amplitude(best.before.amplitude);
            let text = format!(
                "{}; with the shares of the description, the largest amplitude is {before}",
                shares.collect::<Vec<_>>().join(", ")
            );
            lines.push(("best shares", text));
        }
        lines
    }
}

//! Columns of the lists of features. Each kind of feature has one list.

use super::found::{EndRow, FeatureAt, FeatureLists, Named, NumberedResonance};
use super::sheet::Sheet;
use crate::study::columns::column::{Column, TableRow};
use crate::study::columns::setting::Setting;
use crate::study::{
    features::{
        Certainty, Crossing, HeldResonance, InvariantPoint, InvariantQuantity, Inversion,
        RegimeEnd, RegimeRange, ResonantPeak, Sensed, SlidingRange,
    },
    words,
};

/// Receives the lists of features one after another. The receiver is a trait, because the rows of different lists have
/// different types.
pub trait FeatureVisitor {
    /// Type of the error with which the receiver ends the visit of the lists.
    type Error;

    /// Receives one list, with its name, its columns and its rows.
    ///
    /// # Errors
    /// Any error of the receiver ends the visit.
    fn list<R: TableRow>(
        &mut self,
        name: &'static str,
        columns: &[Column<'_, R>],
        rows: &[R],
    ) -> Result<(), Self::Error>;
}

impl FeatureLists {
    /// Passes every list of features to a receiver.
    ///
    /// # Errors
    /// The first error that the receiver returns.
    pub fn visit<V: FeatureVisitor>(
        &self,
        setting: &Setting<'_>,
        to: &mut V,
    ) -> Result<(), V::Error> {
        to.list("resonances", &resonances(setting), &self.resonances)?;
        to.list("held_resonances", &held(setting), &self.held)?;
        to.list("ends", &ends(setting), &self.ends)?;
        let zeros = &self.antiresonances;
        to.list("antiresonances", &antiresonances(setting), zeros)?;
        to.list("invariant_points", &invariant(setting), &self.invariant)?;
        to.list("inversions", &inversions(setting), &self.inversions)?;
        to.list("starts", &starts(setting), &self.starts)?;
        to.list("sliding_ranges", &sliding(setting), &self.sliding)?;
        to.list("regimes", &regimes(setting), &self.regimes)?;
        to.list("peaks", &peaks(setting), &self.peaks)?;
        to.list("crossings", &crossings(setting), &self.crossings)
    }
}

fn resonances<'a>(setting: &Setting<'a>) -> Vec<Column<'a, NumberedResonance>> {
    let mut sheet = Sheet::new(setting);
    sheet
        .columns
        .count("mode", |mode: &NumberedResonance| Some(mode.number));
    sheet.places("", |mode| Some(mode.it.r));
    sheet.places_move(|mode| Some(&mode.it.frequency));
    sheet
        .columns
        .number("damping_ratio", |mode| Some(mode.it.damping_ratio));
    sheet.force("threshold", |mode| Some(mode.it.threshold.as_ref()?.value));
    sheet.columns.moves(|mode| mode.it.threshold.as_ref());
    sheet.force("continuous_limit", |mode| Some(mode.it.continuous_limit));
    sheet.columns.done()
}

fn held<'a>(setting: &Setting<'a>) -> Vec<Column<'a, HeldResonance>> {
    let mut sheet = Sheet::new(setting);
    sheet.places("", |it: &HeldResonance| Some(it.r));
    sheet.places_move(|it| Some(&it.frequency));
    sheet
        .columns
        .number("damping_ratio", |it| Some(it.damping_ratio));
    sheet.columns.flag("new", |it| Some(it.new));
    sheet.force("sliding_limit", |it| Some(it.sliding_limit));
    sheet.columns.done()
}

fn ends<'a>(setting: &Setting<'a>) -> Vec<Column<'a, EndRow>> {
    let mut sheet = Sheet::new(setting);
    sheet.columns.number("r", |end: &EndRow| Some(end.r));
    sheet.force("continuous_limit", |end| Some(end.limits.continuous.value));
    sheet.columns.moves(|end| Some(&end.limits.continuous));
    sheet.force("sliding_limit", |end| Some(end.limits.sliding.value));
    sheet.columns.moves(|end| Some(&end.limits.sliding));
    sheet.columns.done()
}

fn antiresonances<'a>(
    setting: &Setting<'a>,
) -> Vec<Column<'a, Named<crate::study::features::Antiresonance>>> {
    let mut sheet = Sheet::new(setting);
    sheet.of(|zero: &Named<crate::study::features::Antiresonance>| &zero.of);
    sheet.places("", |zero| Some(zero.it.r));
    sheet.places_move(|zero| Some(&zero.it.frequency));
    sheet.columns.done()
}

fn invariant<'a>(
    setting: &Setting<'a>,
) -> Vec<Column<'a, Named<(InvariantQuantity, InvariantPoint)>>> {
    let mut sheet = Sheet::new(setting);
    sheet.of(|point: &Named<(InvariantQuantity, InvariantPoint)>| &point.of);
    let columns = &mut sheet.columns;
    columns.word("measured", "", |point| Some(words::measured(point.it.0)));
    columns.word("condition", "", |point| Some(words::condition(&point.it.1)));
    sheet.places("", |point| Some(point.it.1.r));
    sheet.places_move(|point| Some(&point.it.1.frequency));
    sheet.length("amplitude", |point| Some(point.it.1.amplitude));
    sheet.force("continuous_limit", |point| {
        Some(point.it.1.continuous_limit)
    });
    sheet
        .columns
        .flag("simple", |point| Some(point.it.1.simple));
    sheet.columns.done()
}

fn inversions<'a>(setting: &Setting<'a>) -> Vec<Column<'a, Named<(InvariantQuantity, Inversion)>>> {
    let mut sheet = Sheet::new(setting);
    sheet.of(|range: &Named<(InvariantQuantity, Inversion)>| &range.of);
    let columns = &mut sheet.columns;
    columns.word("measured", "", |range| Some(words::measured(range.it.0)));
    sheet.places("", |range| Some(range.it.1.from));
    let columns = &mut sheet.columns;
    columns.word("edge", "", |range| Some(words::edge(range.it.1.from_edge)));
    sheet.places("to_", |range| Some(range.it.1.to));
    let columns = &mut sheet.columns;
    columns.word("to_edge", "", |range| Some(words::edge(range.it.1.to_edge)));
    sheet.columns.done()
}

fn starts<'a>(setting: &Setting<'a>) -> Vec<Column<'a, FeatureAt<Named<Option<Sensed>>>>> {
    let mut sheet = Sheet::new(setting);
    sheet.friction(|start: &FeatureAt<Named<Option<Sensed>>>| start.beta);
    sheet.of(|start| &start.it.of);
    sheet
        .columns
        .flag("stuck", |start| Some(start.it.it.is_none()));
    sheet.length("amplitude", |start| Some(start.it.it.as_ref()?.value));
    sheet.columns.moves(|start| start.it.it.as_ref());
    sheet.columns.done()
}

fn sliding<'a>(setting: &Setting<'a>) -> Vec<Column<'a, FeatureAt<SlidingRange>>> {
    let mut sheet = Sheet::new(setting);
    sheet.friction(|range: &FeatureAt<SlidingRange>| range.beta);
    sheet.places("", |range| Some(range.it.from));
    sheet.places_move(|range| range.it.from_frequency.as_ref());
    sheet.places("to_", |range| Some(range.it.to));
    sheet.places_move(|range| range.it.to_frequency.as_ref());
    sheet.columns.done()
}

fn regimes<'a>(setting: &Setting<'a>) -> Vec<Column<'a, FeatureAt<(Certainty, RegimeRange)>>> {
    let mut sheet = Sheet::new(setting);
    sheet.friction(|range: &FeatureAt<(Certainty, RegimeRange)>| range.beta);
    let columns = &mut sheet.columns;
    columns.word("regime", "", |range| Some(words::regime(range.it.1.regime)));
    sheet.places("", |range| Some(range.it.1.from));
    sheet.places("to_", |range| Some(range.it.1.to));
    sheet.places_move(|range| match &range.it.1.end {
        RegimeEnd::Continuous(sensed) | RegimeEnd::Sliding(sensed) => Some(sensed),
        _ => None,
    });
    let columns = &mut sheet.columns;
    columns.word("found", "", |range| Some(words::certainty(range.it.0)));
    sheet.columns.done()
}

fn peaks<'a>(setting: &Setting<'a>) -> Vec<Column<'a, FeatureAt<Named<ResonantPeak>>>> {
    let mut sheet = Sheet::new(setting);
    sheet.friction(|peak: &FeatureAt<Named<ResonantPeak>>| peak.beta);
    sheet.of(|peak| &peak.it.of);
    sheet
        .columns
        .count("mode", |peak| Some(peak.it.it.mode + 1));
    sheet.places("resonance_", |peak| Some(peak.it.it.resonance));
    sheet.length("estimate", |peak| Some(peak.it.it.estimate.as_ref()?.value));
    sheet.columns.moves(|peak| peak.it.it.estimate.as_ref());
    sheet.places("", |peak| Some(peak.it.it.peak.as_ref()?.r));
    sheet.length("amplitude", |peak| {
        Some(peak.it.it.peak.as_ref()?.amplitude.value)
    });
    sheet
        .columns
        .moves(|peak| Some(&peak.it.it.peak.as_ref()?.amplitude));
    sheet.columns.word("regime", "", |peak| {
        let found = peak.it.it.peak.as_ref()?;
        Some(found.regime.map_or("unbounded", words::regime))
    });
    sheet.columns.done()
}

/// Row of the list of crossings. In a crossing, a motion has the same amplitude for two friction ratios at one
/// frequency. The number in the row is the second friction ratio.
type CrossingRow = FeatureAt<Named<(f64, Crossing)>>;

fn crossings<'a>(setting: &Setting<'a>) -> Vec<Column<'a, CrossingRow>> {
    let mut sheet = Sheet::new(setting);
    sheet.friction(|crossing: &CrossingRow| crossing.beta);
    sheet.other_friction(|crossing| crossing.it.it.0);
    sheet.of(|crossing| &crossing.it.of);
    sheet.places("", |crossing| Some(crossing.it.it.1.r));
    sheet.places_move(|crossing| Some(&crossing.it.it.1.frequency));
    sheet.length("amplitude", |crossing| Some(crossing.it.it.1.amplitude));
    sheet.columns.done()
}

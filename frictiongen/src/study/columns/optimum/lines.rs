//! The result about the best friction as lines. Each line has a label for people, a key for programs, and the value.

use super::OptimumTable;
use crate::study::columns::builder::Columns;
use crate::study::columns::cell::Cell;
use crate::study::columns::column::{Column, ColumnKind, Head, Shown, TableRow};
use crate::study::columns::measure::PhysicalQuantity;
use crate::study::columns::setting::Frequency;
use crate::study::optimum::{Optimum, TunedNumber};

/// Largest number of frequencies without a steady state that the result names.
const MOST_UNSETTLED: usize = 5;

/// A row of the result about the best friction: one value with its label and its key.
#[derive(Clone, Debug)]
pub struct OptimumLine {
    /// Name of the list that contains the value. `None` for a value outside the lists.
    pub list: Option<&'static str>,
    /// Number of the entry in its list, counted from 1. `None` for a value outside the lists.
    pub row: Option<usize>,
    /// Key of the line's value for programs. Within one entry of a list, all keys are different.
    pub key: String,
    /// Name of the line's value, in words for people.
    pub label: String,
    /// Value of the line, as a cell of a table.
    pub value: Cell<'static>,
    /// Unit of the line's value. It is empty for a ratio.
    pub unit: &'static str,
    /// For a sensitivity: the unit of the parameter. The value of the line is the relative change of the amplitude per
    /// this unit.
    pub per: Option<&'static str>,
    /// For a tolerance of the friction: the amplitude at the bounds of the tolerance minus the best amplitude, divided
    /// by the best amplitude.
    pub excess: Option<f64>,
}

impl TableRow for OptimumLine {}

/// Collects the lines of a result.
#[derive(Default)]
struct Lines(Vec<OptimumLine>);

impl Lines {
    /// Begins an entry of a list, or a value outside the lists.
    fn entry(&mut self, list: Option<&'static str>, row: Option<usize>) -> LineEntry<'_> {
        LineEntry {
            lines: &mut self.0,
            list,
            row,
            excess: None,
            name: String::new(),
        }
    }
}

/// Collects the result lines of one entry of a list.
struct LineEntry<'l> {
    lines: &'l mut Vec<OptimumLine>,
    list: Option<&'static str>,
    row: Option<usize>,
    excess: Option<f64>,
    /// Text that replaces `{}` in the labels of the lines.
    name: String,
}

impl LineEntry<'_> {
    fn line(
        &mut self,
        key: impl Into<String>,
        label: impl Into<String>,
        (value, unit): (impl Into<Cell<'static>>, &'static str),
    ) {
        self.lines.push(OptimumLine {
            list: self.list,
            row: self.row,
            key: key.into(),
            label: label.into(),
            value: value.into(),
            unit,
            per: None,
            excess: self.excess,
        });
    }

    /// Adds one result line for each column of a row. Columns whose condition is false in this row give no line.
    fn lines<R>(&mut self, columns: &[Column<'_, R>], row: &R) {
        for column in columns.iter().filter(|column| column.says(row)) {
            let title = column.title.first().map_or("", String::as_str);
            let label = title.replace("{}", &self.name);
            let value = column.read(row).into_owned();
            self.line(column.key(), label, (value, column.of_what()));
        }
    }
}

impl<'a> OptimumTable<'a> {
    /// Returns the result as lines: the best numbers and the best friction, further quantities, peaks, tolerances and
    /// sensitivities.
    #[must_use]
    pub fn lines(&self, optimum: &Optimum) -> Vec<OptimumLine> {
        let mut lines = Lines::default();
        self.tuned_lines(optimum, &mut lines);
        lines.entry(None, None).lines(&self.best(), optimum);
        self.further_lines(optimum, &mut lines);
        self.peak_lines(optimum, &mut lines);
        self.tolerance_lines(optimum, &mut lines);
        lines.entry(None, None).lines(&self.bounds(), optimum);
        self.sensitivity_lines(optimum, &mut lines);
        self.scan_lines(optimum, &mut lines);
        lines.entry(None, None).lines(&self.effort(), optimum);
        self.unsettled_lines(optimum, &mut lines);
        lines.0
    }

    /// Adds one line for each of the first frequencies at which the motion does not settle.
    fn unsettled_lines(&self, optimum: &Optimum, lines: &mut Lines) {
        for (row, r) in (1..=MOST_UNSETTLED).zip(&optimum.unsettled) {
            let frequency = Frequency::at(self.setting.system, *r);
            let (key, value, unit) = match self.setting.frequency.has_hertz() {
                true => ("frequency_Hz", frequency.hertz, "Hz"),
                false => ("r", frequency.r, ""),
            };
            let mut entry = lines.entry(Some("unsettled"), Some(row));
            entry.line(key, "  the last 64 cycles count at", (value, unit));
        }
    }

    /// Adds the lines of the varied numbers. With shares, the best amplitude with the shares of the scene description
    /// follows.
    fn tuned_lines(&self, optimum: &Optimum, lines: &mut Lines) {
        let scene = self.setting.system.scene();
        let contacts = scene.named_contacts();
        for (row, number) in (1..).zip(&optimum.tuned) {
            let (of, value) = (number.of, (number.value, number.of.unit()));
            let contact = of.share().and_then(|contact| contacts.get(contact));
            let mut entry = match contact {
                Some(_) => lines.entry(Some("shares"), Some(row)),
                None => lines.entry(Some("tuned"), None),
            };
            match contact {
                Some(contact) => {
                    let label = format!("share of {}", contact.name);
                    entry.line(contact.name.as_str(), label, value);
                }
                None => entry.line("value", of.symbol(scene), value),
            }
            if number.at_end {
                let end = "a bound of the interval; a value beyond it may be better";
                entry.line("at_end", "which is", (end, ""));
            }
        }
        if let Some(before) = optimum.before {
            let measure = &self.setting.measure;
            let before = measure.convert(self.size(), before, optimum.reference);
            lines.entry(None, None).line(
                measure.name("amplitude_before", self.size()),
                "largest amplitude with the shares of the description",
                (before, measure.unit_or_reference(self.size())),
            );
        }
    }

    /// Adds two lines for each further quantity: its largest value, and its bound or divisor.
    fn further_lines(&self, optimum: &Optimum, lines: &mut Lines) {
        let measure = &self.setting.measure;
        let kept = self.kept.iter().map(|one| ("kept", one));
        let weighted = self.weighted.iter().map(|one| ("weighted", one));
        let all = kept.chain(weighted).zip(&optimum.largest);
        for (row, ((list, (part, value)), largest)) in (1..).zip(all) {
            let dimension = part.dimension();
            let unit = measure.unit_or_reference(dimension);
            let [found, other] = [*largest, *value]
                .map(|value| measure.convert(dimension, value, optimum.reference));
            let mut entry = lines.entry(Some(list), Some(row));
            let label = format!("largest value of {}", part.name);
            entry.line("largest", label, (found, unit));
            if list == "kept" {
                entry.line("bound", "  which is at most", (other, unit));
            } else {
                entry.line("over", "  divided by", (other, unit));
                entry.line("ratio", "  is", (largest / value, ""));
            }
        }
    }

    fn peak_lines(&self, optimum: &Optimum, lines: &mut Lines) {
        let mut columns = Columns::new(&self.setting.measure);
        if self.setting.frequency.has_hertz() {
            let head = Head::of("frequency", PhysicalQuantity::Hertz).titled(&["{}"]);
            columns.number(head, |row: &super::PeakRow| Some(row.frequency.hertz));
        }
        columns.number(Head::new("r").titled(&["{} r"]), |row: &super::PeakRow| {
            Some(row.frequency.r)
        });
        let mut columns = columns.done();
        let all = self.peak_columns().into_iter();
        columns.extend(all.filter_map(|mut column| {
            let is_frequency = column.axis != super::super::ColumnAxis::Row;
            let is_flag = column.kind == ColumnKind::Flag;
            column.title = vec![format!("  {}", column.title.first()?)];
            (!is_frequency && !is_flag).then_some(column)
        }));
        for (row, peak) in (1..).zip(self.peaks(optimum)) {
            let mut entry = lines.entry(Some("peaks"), Some(row));
            let name = match peak.peak.at_end {
                true => "peak at the end of the band at",
                false => "peak at",
            };
            name.clone_into(&mut entry.name);
            entry.lines(&columns, &peak);
        }
    }

    fn tolerance_lines(&self, optimum: &Optimum, lines: &mut Lines) {
        let mut columns = self.tolerance_columns();
        // The name of the entry, such as `5 % above the best`, replaces `{}`.
        let titles = ["{}: friction from", "{}: friction to"];
        for (column, title) in columns.iter_mut().skip(1).zip(titles) {
            column.title = vec![title.to_owned()];
        }
        for (row, tolerance) in (1..).zip(&optimum.tolerances) {
            let mut entry = lines.entry(Some("tolerances"), Some(row));
            entry.excess = Some(tolerance.excess);
            entry.name = format!("{:.0} % above the best", tolerance.excess * 100.0);
            entry.lines(columns.get(1..).unwrap_or_default(), tolerance);
        }
    }

    fn sensitivity_lines(&self, optimum: &Optimum, lines: &mut Lines) {
        let Some(point) = self.point() else { return };
        let scene = self.setting.system.scene();
        for row in self.sensitivities(optimum) {
            let name = row.parameter.label(scene, &point);
            lines.0.push(OptimumLine {
                list: Some("sensitivities"),
                row: None,
                key: row.parameter.key(scene, &point),
                label: format!("change in per cent for 1 % more {name}"),
                value: row.relative.into(),
                unit: "%",
                per: Some("%"),
                excess: None,
            });
        }
    }

    fn scan_lines(&self, optimum: &Optimum, lines: &mut Lines) {
        let Some(TunedNumber { of, .. }) = optimum.tuned.first() else {
            return;
        };
        let measure = &self.setting.measure;
        let name = of.symbol(self.setting.system.scene());
        let key = match measure.scale() {
            Some(_) => "friction",
            None => "beta",
        };
        for (row, point) in (1..).zip(&optimum.scan) {
            let mut entry = lines.entry(Some("scan"), Some(row));
            entry.line("value", format!("at {name}"), (point.value, of.unit()));
            let (force, size) = (PhysicalQuantity::Force, self.size());
            for (key, label, dimension, value) in [
                (key, "  best friction", force, point.beta),
                ("amplitude", "  largest amplitude", size, point.amplitude),
            ] {
                let value = measure.convert(dimension, value, optimum.reference);
                entry.line(key, label, (value, measure.unit_or_reference(dimension)));
            }
        }
    }

    /// Returns the columns of a table with these lines.
    #[must_use]
    pub fn line_columns(&self, lines: &[OptimumLine]) -> Vec<Column<'a, OptimumLine>> {
        let widest = lines.iter().map(|line| line.label.as_str());
        let widest = widest.max_by_key(|label| label.chars().count());
        let mut columns = Columns::new(&self.setting.measure);
        columns.show(Shown::Json);
        columns.word("list", "", |line: &OptimumLine| line.list);
        columns.count("row", |line| line.row);
        columns.word("key", "", |line| Some(&line.key));
        columns.show(Shown::Everywhere);
        columns.word("quantity", widest.unwrap_or_default(), |line| {
            Some(&line.label)
        });
        columns.cell("value", ColumnKind::Number, |line| line.value.borrowed());
        columns.word("unit", "P/k1", |line| Some(line.unit));
        columns.show(Shown::Json);
        columns.word("per", "", |line| line.per);
        columns.number("excess", |line| line.excess);
        columns.done()
    }
}

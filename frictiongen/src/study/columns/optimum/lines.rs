//! The result about the best friction as lines. Each line has a label for people, a key for programs, and the value.

use super::OptimumTable;
use crate::study::columns::builder::Columns;
use crate::study::columns::cell::Cell;
use crate::study::columns::column::{Column, ColumnKind, Head, Shown, TableRow};
use crate::study::columns::measure::PhysicalQuantity;
use crate::study::columns::setting::{Frequency, MovingPart};
use crate::study::optimum::{Optimum, SharesOptimum, Tunable, TunedOptimum};

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

/// A number of the scene description that the search has optimised together with the friction, and the result of this
/// search.
#[derive(Clone, Debug)]
pub struct Tuned<'a> {
    /// The number of the scene description, such as a mass or a stiffness.
    pub of: Tunable,
    /// The result of the search for the number and the friction.
    pub found: &'a TunedOptimum,
}

impl Tuned<'_> {
    /// Returns the best friction, with the number of amplitudes that the whole search has computed.
    #[must_use]
    pub fn optimum(&self) -> Optimum {
        Optimum {
            evaluations: self.found.evaluations,
            ..self.found.optimum.clone()
        }
    }
}

/// Quantities of a result about the best friction, in addition to the minimised quantity. Each entry has three items:
/// the quantity, its bound or divisor, and its largest value over the band of frequencies.
#[derive(Clone, Copy, Debug)]
pub enum Further<'a> {
    /// The search has considered no further quantities.
    None,
    /// Quantities with their upper bounds, which the result of the search satisfies.
    Kept(&'a [(MovingPart, f64, f64)]),
    /// Quantities with their divisors. The search has minimised the largest quotient.
    Weighted(&'a [(MovingPart, f64, f64)]),
}

/// Collects the result lines of one entry of a list.
struct LineEntry<'l> {
    lines: &'l mut Vec<OptimumLine>,
    list: Option<&'static str>,
    row: Option<usize>,
    excess: Option<f64>,
    /// Text that replaces `{}` in the labels of the lines.
    name: &'l str,
}

impl LineEntry<'_> {
    fn line(&mut self, key: impl Into<String>, label: String, value: Cell<'_>, unit: &'static str) {
        self.lines.push(OptimumLine {
            list: self.list,
            row: self.row,
            key: key.into(),
            label,
            value: value.into_owned(),
            unit,
            per: None,
            excess: self.excess,
        });
    }

    /// Adds one result line for each column of a row. Columns whose condition is false in this row give no line.
    fn lines<R>(&mut self, columns: &[Column<'_, R>], row: &R) {
        for column in columns.iter().filter(|column| column.says(row)) {
            let title = column.title.first().map_or("", String::as_str);
            let label = title.replace("{}", self.name);
            self.line(column.key(), label, column.read(row), column.of_what());
        }
    }
}

impl<'a> OptimumTable<'a> {
    /// Returns the result as lines: the best friction, its peaks, tolerances and sensitivities.
    #[must_use]
    pub fn lines(&self, optimum: &Optimum, tuned: Option<&Tuned<'_>>) -> Vec<OptimumLine> {
        self.lines_with(optimum, tuned, Further::None)
    }

    /// Returns the result as lines, with further lines for the quantities in `further`. Each of these quantities has
    /// its bound or divisor, and its largest value with the best friction.
    #[must_use]
    pub fn lines_with(
        &self,
        optimum: &Optimum,
        tuned: Option<&Tuned<'_>>,
        further: Further<'_>,
    ) -> Vec<OptimumLine> {
        let mut lines = Vec::new();
        if let Some(tuned) = tuned {
            self.tuned(tuned, &mut lines);
        }
        let once = |lines: &mut Vec<OptimumLine>, columns: Vec<Column<'a, Optimum>>| {
            let (list, row) = (None, None);
            let name = "";
            LineEntry {
                lines,
                list,
                row,
                excess: None,
                name,
            }
            .lines(&columns, optimum);
        };
        once(&mut lines, self.best());
        self.further_lines(further, optimum.reference, &mut lines);
        self.peak_lines(optimum, &mut lines);
        self.tolerance_lines(optimum, &mut lines);
        once(&mut lines, self.bounds());
        self.sensitivity_lines(optimum, &mut lines);
        if let Some(tuned) = tuned {
            self.scan_lines(tuned, &mut lines);
        }
        once(&mut lines, self.effort());
        self.unsettled_lines(optimum, &mut lines);
        lines
    }

    /// Adds one line for each of the first frequencies at which the motion does not settle.
    fn unsettled_lines(&self, optimum: &Optimum, lines: &mut Vec<OptimumLine>) {
        for (row, r) in (1..=MOST_UNSETTLED).zip(&optimum.unsettled) {
            let mut entry = LineEntry {
                lines: &mut *lines,
                list: Some("unsettled"),
                row: Some(row),
                excess: None,
                name: "",
            };
            let frequency = Frequency::at(self.setting.system, *r);
            let (key, value, unit) = match self.setting.frequency.has_hertz() {
                true => ("frequency_Hz", frequency.hertz, "Hz"),
                false => ("r", frequency.r, ""),
            };
            entry.line(
                key,
                "  the last 64 cycles count at".to_owned(),
                value.into(),
                unit,
            );
        }
    }

    /// Returns the lines of the best shares of several contacts, and the best amplitude with the shares of the scene
    /// description.
    #[must_use]
    pub fn share_lines(&self, found: &SharesOptimum) -> Vec<OptimumLine> {
        let mut lines = Vec::new();
        let contacts = self.setting.system.scene().named_contacts();
        for (row, (contact, share)) in (1..).zip(contacts.iter().zip(&found.shares)) {
            let mut entry = LineEntry {
                lines: &mut lines,
                list: Some("shares"),
                row: Some(row),
                excess: None,
                name: "",
            };
            let label = format!("share of {}", contact.name);
            entry.line(contact.name.as_str(), label, (*share).into(), "");
        }
        let measure = &self.setting.measure;
        let before = measure.convert(self.size(), found.before, found.optimum.reference);
        let mut entry = LineEntry {
            lines: &mut lines,
            list: None,
            row: None,
            excess: None,
            name: "",
        };
        let label = "largest amplitude with the shares of the description".to_owned();
        let key = measure.name("amplitude_before", self.size());
        entry.line(
            key,
            label,
            before.into(),
            measure.unit_or_reference(self.size()),
        );
        lines
    }

    /// Adds two lines for each further quantity: its largest value, and its bound or divisor.
    fn further_lines(&self, further: Further<'_>, reference: f64, lines: &mut Vec<OptimumLine>) {
        let measure = &self.setting.measure;
        let (list, all) = match further {
            Further::None => return,
            Further::Kept(all) => ("kept", all),
            Further::Weighted(all) => ("weighted", all),
        };
        for (row, (part, value, largest)) in (1..).zip(all) {
            let dimension = part.dimension();
            let mut entry = LineEntry {
                lines: &mut *lines,
                list: Some(list),
                row: Some(row),
                excess: None,
                name: "",
            };
            let unit = measure.unit_or_reference(dimension);
            let name = format!("largest value of {}", part.name);
            let [found, other] =
                [*largest, *value].map(|value| measure.convert(dimension, value, reference));
            entry.line("largest", name, found.into(), unit);
            if let Further::Kept(_) = further {
                entry.line("bound", "  which is at most".to_owned(), other.into(), unit);
            } else {
                entry.line("over", "  divided by".to_owned(), other.into(), unit);
                let quotient = largest / value;
                entry.line("ratio", "  is".to_owned(), quotient.into(), "");
            }
        }
    }

    /// Adds the line of the number that the search has optimised together with the friction.
    fn tuned(&self, tuned: &Tuned<'_>, lines: &mut Vec<OptimumLine>) {
        let mut entry = LineEntry {
            lines,
            list: Some("tuned"),
            row: None,
            excess: None,
            name: "",
        };
        let name = tuned.of.symbol(self.setting.system.scene());
        entry.line("value", name, tuned.found.value.into(), tuned.of.unit());
        if tuned.found.at_end {
            let end = "a bound of the interval; a value beyond it may be better";
            entry.line("at_end", "which is".to_owned(), end.into(), "");
        }
    }

    fn peak_lines(&self, optimum: &Optimum, lines: &mut Vec<OptimumLine>) {
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
            let mut entry = LineEntry {
                lines: &mut *lines,
                list: Some("peaks"),
                row: Some(row),
                excess: None,
                name: match peak.peak.at_end {
                    true => "peak at the end of the band at",
                    false => "peak at",
                },
            };
            entry.lines(&columns, &peak);
        }
    }

    fn tolerance_lines(&self, optimum: &Optimum, lines: &mut Vec<OptimumLine>) {
        let mut columns = self.tolerance_columns();
        // The name of the entry, such as `5 % above the best`, replaces `{}`.
        let titles = ["{}: friction from", "{}: friction to"];
        for (column, title) in columns.iter_mut().skip(1).zip(titles) {
            column.title = vec![title.to_owned()];
        }
        for (row, tolerance) in (1..).zip(&optimum.tolerances) {
            let mut entry = LineEntry {
                lines: &mut *lines,
                list: Some("tolerances"),
                row: Some(row),
                excess: Some(tolerance.excess),
                name: &format!("{:.0} % above the best", tolerance.excess * 100.0),
            };
            entry.lines(columns.get(1..).unwrap_or_default(), tolerance);
        }
    }

    fn sensitivity_lines(&self, optimum: &Optimum, lines: &mut Vec<OptimumLine>) {
        let Some(point) = self.point() else { return };
        let scene = self.setting.system.scene();
        for row in self.sensitivities(optimum) {
            let name = row.parameter.label(scene, &point);
            lines.push(OptimumLine {
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

    fn scan_lines(&self, tuned: &Tuned<'_>, lines: &mut Vec<OptimumLine>) {
        let measure = &self.setting.measure;
        let name = tuned.of.symbol(self.setting.system.scene());
        let reference = tuned.found.optimum.reference;
        let key = match measure.scale() {
            Some(_) => "friction",
            None => "beta",
        };
        for (row, point) in (1..).zip(&tuned.found.scan) {
            let mut entry = LineEntry {
                lines: &mut *lines,
                list: Some("scan"),
                row: Some(row),
                excess: None,
                name: "",
            };
            let value = point.value.into();
            entry.line("value", format!("at {name}"), value, tuned.of.unit());
            let numbers = [
                (key, "  best friction", PhysicalQuantity::Force, point.beta),
                (
                    "amplitude",
                    "  largest amplitude",
                    self.size(),
                    point.amplitude,
                ),
            ];
            for (key, label, dimension, value) in numbers {
                let unit = measure.unit_or_reference(dimension);
                let value = measure.convert(dimension, value, reference);
                entry.line(key, label.to_owned(), value.into(), unit);
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

//! Adds columns that several lists of features have in common.

use crate::study::columns::builder::Columns;
use crate::study::columns::column::{Head, TableRow};
use crate::study::columns::measure::PhysicalQuantity;
use crate::study::columns::setting::Setting;
use crate::study::features::Sensed;

/// The columns of one list of features. Under a load the features are already in Hz, N and m.
pub(super) struct Sheet<'a, R> {
    setting: Setting<'a>,
    pub(super) columns: Columns<'a, R>,
}

impl<'a, R: TableRow + 'a> Sheet<'a, R> {
    /// Returns a list without columns.
    pub(super) fn new(setting: &Setting<'a>) -> Self {
        Self {
            setting: *setting,
            columns: Columns::new(&setting.measure),
        }
    }

    /// Adds a column with the name of the contact or mass whose motion has the feature.
    pub(super) fn of(&mut self, of: impl Fn(&R) -> &String + 'a) {
        self.columns.word("of", "", move |row| Some(of(row)));
    }

    /// Adds a column of forces, in N under a load and otherwise as friction ratios.
    pub(super) fn force(&mut self, name: &'static str, of: impl Fn(&R) -> Option<f64> + 'a) {
        self.columns
            .converted(Head::of(name, PhysicalQuantity::Force), of);
    }

    /// Adds a column of lengths. The lengths are in m under a load. Otherwise they are divided by P/k₁, or by Y for
    /// base motion.
    pub(super) fn length(&mut self, name: &'static str, of: impl Fn(&R) -> Option<f64> + 'a) {
        self.columns
            .converted(Head::of(name, PhysicalQuantity::Length), of);
    }

    /// Adds a column of the requested friction ratio β. Under a load, also adds a column of the friction force in N.
    pub(super) fn friction(&mut self, beta: impl Fn(&R) -> f64 + Copy + 'a) {
        if self.setting.measure.scale().is_some() {
            let head = Head::of("friction", PhysicalQuantity::Force);
            self.columns.number(head, move |row| Some(beta(row)));
        }
        self.columns.number("beta", move |row| Some(beta(row)));
    }

    /// Adds a column of the second friction of a crossing, as a friction ratio or, under a load, as a force in N. At a
    /// crossing, a motion has equal amplitudes for two frictions.
    pub(super) fn other_friction(&mut self, beta: impl Fn(&R) -> f64 + 'a) {
        let head = Head::of("other_beta", PhysicalQuantity::Force).under_load("other_friction");
        self.columns.number(head, move |row| Some(beta(row)));
    }

    /// Adds the columns of one frequency. The names of the columns begin with the text `before`.
    pub(super) fn places(
        &mut self,
        before: &'static str,
        of: impl Fn(&R) -> Option<f64> + Copy + 'a,
    ) {
        if self.setting.frequency.has_hertz() {
            let system = self.setting.system;
            let head = Head::of(format!("{before}frequency"), PhysicalQuantity::Hertz);
            self.columns
                .converted(head, move |row| of(row).map(|r| system.hertz(r)));
        }
        self.columns.number(Head::new(format!("{before}r")), of);
    }

    /// Sets the derivatives of the frequency that was added last. Under a load, the derivatives are those of the
    /// frequency in Hz. Without a load, the derivatives are those of r.
    pub(super) fn places_move(&mut self, of: impl Fn(&R) -> Option<&Sensed> + 'a) {
        let before = usize::from(self.setting.measure.load().is_some());
        self.columns.moves_before(before, of);
    }
}

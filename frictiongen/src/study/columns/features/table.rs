//! Columns of the table of features, which has one line for each feature.

use super::joined;
use super::lines::{FeatureLine, FeaturesAsked, lines};
use crate::study::columns::builder::Columns;
use crate::study::columns::column::{Column, ColumnKind, Head, Shown};
use crate::study::columns::measure::PhysicalQuantity;
use crate::study::columns::setting::Setting;
use crate::study::{
    features::{FeatureError, Features},
    sensitivity::{OperatingPoint, Parameter},
};

/// The table of a scene's features, such as resonances and peaks. It has one line for each feature.
#[derive(Clone, Copy)]
pub struct FeatureTable<'a> {
    /// System, units, and the contact or masses whose motions the table contains.
    pub setting: Setting<'a>,
}

impl<'a> FeatureTable<'a> {
    /// Returns all features of a scene. Features that do not depend on friction come first.
    ///
    /// # Errors
    /// Same errors as the calls of [`Features`].
    pub fn rows(
        &self,
        features: &Features<'_>,
        asked: FeaturesAsked<'_>,
    ) -> Result<Vec<FeatureLine>, FeatureError> {
        lines(features, &self.setting, asked)
    }

    /// Returns all features of a scene with several contacts, with dashpots, or with masses that no path of springs
    /// connects to a support.
    ///
    /// # Errors
    /// [`FeatureError::Combination`] for the motion of another part than a mass. [`FeatureError::Joined`] if the solver
    /// for several contacts returns no result. [`FeatureError::Range`], [`FeatureError::Crowded`].
    pub fn joined_rows(&self, range: [f64; 2]) -> Result<Vec<FeatureLine>, FeatureError> {
        joined::lines(&self.setting, range)
    }

    /// Returns the symbol of a parameter, as the table prints it.
    #[must_use]
    pub fn symbol(&self, parameter: Parameter) -> String {
        // The symbol of a parameter does not depend on the numbers of the operating point. The code therefore uses
        // arbitrary numbers.
        let point = match self.setting.measure.load() {
            Some(load) => OperatingPoint::Physical {
                hertz: 1.0,
                friction: 1.0,
                load,
            },
            None => OperatingPoint::Groups { r: 1.0, beta: 1.0 },
        };
        parameter.symbol(self.setting.system.scene(), &point)
    }

    /// Returns the columns of the table. Columns of words are as wide as the longest word in `rows`.
    #[must_use]
    pub fn columns(&self, rows: &[FeatureLine]) -> Vec<Column<'a, FeatureLine>> {
        let (table, measure) = (*self, &self.setting.measure);
        let widest = |of: &dyn Fn(&FeatureLine) -> String| {
            let words = rows.iter().map(of);
            let widest = words.max_by_key(|word| word.chars().count());
            widest.unwrap_or_default()
        };
        let mut columns = Columns::new(measure);
        let width = widest(&|row| row.feature.to_owned());
        columns.word("feature", &width, |row: &FeatureLine| Some(row.feature));
        columns.word("of", &widest(&|row| row.of.clone()), |row| Some(&row.of));
        let head = Head::new("detail").titled(&["what"]);
        columns.word(head, &widest(&|row| row.detail.clone()), |row| {
            Some(&row.detail)
        });
        self.place(&mut columns, ("frequency", "at"), ("r", "r"), |row| row.r);
        self.place(
            &mut columns,
            ("to_frequency", "to"),
            ("to_r", "to r"),
            |row| row.to,
        );
        let unit = if measure.scale().is_some() {
            "(N)"
        } else {
            "beta"
        };
        let head = Head::of("beta", PhysicalQuantity::Force).under_load("friction");
        columns.converted(head.titled(&["friction", unit]), |row| row.friction);
        columns.converted(Head::of("amplitude", PhysicalQuantity::Length), |row| {
            row.amplitude
        });
        let width = widest(&|row| row.ground.name().to_owned());
        columns.word("found", &width, |row| Some(row.ground.name()));
        columns.show(Shown::Lines);
        let head = Head::new("per_cent_for_one").titled(&["% for", "1 % of"]);
        columns.number(head, |row| Some(row.strongest()?.2));
        let symbol = move |row: &FeatureLine| Some(table.symbol(row.strongest()?.1));
        let kind = ColumnKind::Word(
            widest(&|row| symbol(row).unwrap_or_default())
                .chars()
                .count(),
        );
        columns.cell(Head::new("parameter").titled(&[""]), kind, move |row| {
            symbol(row).into()
        });
        columns.done()
    }

    /// Adds two columns for a frequency: the frequency in Hz, and the frequency ratio r. Each column has a name and a
    /// heading.
    fn place(
        &self,
        columns: &mut Columns<'a, FeatureLine>,
        (hertz, at): (&'static str, &str),
        (ratio, title): (&'static str, &str),
        of: impl Fn(&FeatureLine) -> Option<f64> + Copy + 'a,
    ) {
        let system = self.setting.system;
        if self.setting.frequency.has_hertz() {
            let head = Head::of(hertz, PhysicalQuantity::Hertz).titled(&[at, "(Hz)"]);
            columns.converted(head, move |row| of(row).map(|r| system.hertz(r)));
        }
        columns.number(Head::new(ratio).titled(&[title, ""]), of);
    }
}

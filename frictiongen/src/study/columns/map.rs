//! Rows and columns of maps over frequency and friction.

use super::builder::Columns;
use super::column::{Column, ColumnAxis, Head};
use super::measure::{Measure, PhysicalQuantity};
use super::setting::{AtFriction, Frequency, FrictionSetting, Setting, at};
use crate::study::{
    map::{Boundary, Map, MapColumn, MapPoint},
    words,
};
use crate::{Error, Limits};
use std::borrow::Cow;

/// A row of the table of points of a map: one frequency and one friction.
#[derive(Clone, Debug)]
pub struct MapRow<'m> {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// Friction in the contact, as ratio β and, under a load, as force in N.
    pub friction: FrictionSetting,
    /// Name of the region of the map: regime, stops and period of the motion.
    pub region: Cow<'static, str>,
    /// The response at this point of the map, or the reason why no response exists.
    pub found: &'m Result<MapPoint, Error>,
}

/// A row of the table of limits: β_lim and β*_lim at one frequency of a map.
#[derive(Clone, Copy, Debug)]
pub struct MapLimitsRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// The limits as friction ratios.
    pub limits: Limits<f64>,
}

/// A row of the table of boundaries: one friction at which the region of the map changes, at one frequency.
#[derive(Clone, Debug)]
pub struct BoundaryRow {
    /// Frequency of the excitation, as ratio r, in Hz and in rad/s.
    pub frequency: Frequency,
    /// The friction on the boundary between two regions.
    pub friction: FrictionSetting,
    /// Width of the interval of β that contains the boundary.
    pub width: f64,
    /// Name of the region at less friction.
    pub below: Cow<'static, str>,
    /// Name of the region at more friction.
    pub above: Cow<'static, str>,
}

/// The table of a map over frequency and friction.
#[derive(Clone, Copy)]
pub struct MapTable<'a> {
    /// System, units, and the contact or masses whose motions the table contains.
    pub setting: Setting<'a>,
}

at!(MapRow<'_>, MapLimitsRow, BoundaryRow);

impl AtFriction for MapRow<'_> {
    fn friction(&self) -> FrictionSetting {
        self.friction
    }
}

impl AtFriction for BoundaryRow {
    fn friction(&self) -> FrictionSetting {
        self.friction
    }
}

impl MapRow<'_> {
    fn point(&self) -> Option<&MapPoint> {
        self.found.as_ref().ok()
    }

    /// Returns the point of the map if its motion is periodic. Other motions have no number of stops or reversals in a
    /// period.
    fn counted(&self) -> Option<&MapPoint> {
        self.point().filter(|point| 0 < point.pattern.period)
    }
}

/// Pairs the entries of a map with their frequencies, in order. If the user has cancelled the computation, a map has no
/// entries for the last frequencies.
fn placed<T>(
    frequencies: impl Iterator<Item = Frequency>,
    found: &[T],
    r: impl Fn(&T) -> f64,
) -> impl Iterator<Item = (Frequency, &T)> {
    let mut frequencies = frequencies.peekable();
    found.iter().filter_map(move |found| {
        while frequencies.next_if(|at| at.r != r(found)).is_some() {}
        Some((*frequencies.peek()?, found))
    })
}

impl<'a> MapTable<'a> {
    /// Returns the table rows of a map at the given frequencies and frictions. The rows of one frequency follow each
    /// other. If the amplitude of the load depends on frequency, each row has the friction ratio at its frequency.
    pub fn rows<'m>(
        measure: Measure,
        map: &'m Map,
        frequencies: impl Iterator<Item = Frequency>,
        frictions: impl Iterator<Item = FrictionSetting> + Clone,
    ) -> impl Iterator<Item = MapRow<'m>> {
        let columns = placed(frequencies, &map.columns, |column: &MapColumn| column.r);
        columns.flat_map(move |(frequency, column)| {
            let points = frictions.clone().zip(&column.points);
            points.map(move |(friction, found)| {
                let pattern = found.as_ref().map(|found| found.pattern);
                MapRow {
                    frequency,
                    friction: friction.at(&measure, frequency),
                    region: words::region(pattern.map_err(|error| *error)),
                    found,
                }
            })
        })
    }

    /// Returns the rows of the table of the limits β_lim and β*_lim of a map.
    pub fn limits(
        map: &Map,
        frequencies: impl Iterator<Item = Frequency>,
    ) -> impl Iterator<Item = MapLimitsRow> {
        let columns = placed(frequencies, &map.columns, |column| column.r);
        columns.map(|(frequency, column)| MapLimitsRow {
            frequency,
            limits: column.limits,
        })
    }

    /// Returns the rows of the table of the boundaries of a map.
    pub fn boundaries(
        self,
        boundaries: &[Boundary],
        frequencies: impl Iterator<Item = Frequency>,
    ) -> impl Iterator<Item = BoundaryRow> {
        let measure = self.setting.measure;
        let found = placed(frequencies, boundaries, |boundary| boundary.r);
        found.map(move |(frequency, boundary)| BoundaryRow {
            frequency,
            friction: FrictionSetting::of_ratio(boundary.beta, measure.scale_at(frequency.omega)),
            width: boundary.width,
            below: words::region(boundary.below),
            above: words::region(boundary.above),
        })
    }

    /// Returns the columns of the table of points.
    #[must_use]
    pub fn columns<'m: 'a>(&self) -> Vec<Column<'a, MapRow<'m>>> {
        use PhysicalQuantity::Length;
        let sign = self.setting.measure.sign();
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        self.setting.friction(&mut columns);
        columns.word("regime", "continuous", |row: &MapRow<'_>| {
            Some(words::regime(row.point()?.pattern.regime))
        });
        columns.word("region", "sliding reversals", |row| Some(&row.region));
        columns.count("period", |row| Some(row.counted()?.pattern.period as usize));
        columns.count("stops", |row| Some(row.counted()?.pattern.stops));
        columns.count("reversals", |row| Some(row.counted()?.pattern.reversals));
        columns.number(Head::new("stuck_fraction").titled(&["stuck"]), |row| {
            Some(row.point()?.stuck_fraction)
        });
        columns.number(Head::of("offset", Length), move |row| {
            Some(sign * row.point()?.offset)
        });
        columns.flag("marginal", |row| Some(row.point()?.marginal));
        columns.flag(Head::new("from_rest").titled(&["from", "rest"]), |row| {
            Some(row.point()?.from_rest)
        });
        for (part, named) in self.setting.parts.iter().enumerate() {
            columns.begin_motion(named);
            columns.number(Head::of("amplitude", named.dimension()), move |row| {
                row.point()?.amplitudes.get(part).copied()
            });
        }
        columns.done()
    }

    /// Returns the columns of the table of limits.
    #[must_use]
    pub fn limits_columns(&self) -> Vec<Column<'a, MapLimitsRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        columns.along(ColumnAxis::Frequency);
        columns.number(
            Head::of("continuous_limit", PhysicalQuantity::Force),
            |row: &MapLimitsRow| Some(row.limits.continuous),
        );
        columns.number(Head::of("sliding_limit", PhysicalQuantity::Force), |row| {
            Some(row.limits.sliding)
        });
        columns.done()
    }

    /// Returns the columns of the table of boundaries.
    #[must_use]
    pub fn boundary_columns(&self) -> Vec<Column<'a, BoundaryRow>> {
        let mut columns = Columns::new(&self.setting.measure);
        self.setting.frequency(&mut columns);
        // The frictions of the boundaries were computed, not given by the user.
        let setting = Setting {
            frictions: &[],
            ..self.setting
        };
        setting.friction(&mut columns);
        columns.number("width", |row: &BoundaryRow| Some(row.width));
        columns.word("below", "sliding reversals", |row| Some(&row.below));
        columns.word("above", "sliding reversals", |row| Some(&row.above));
        columns.done()
    }
}

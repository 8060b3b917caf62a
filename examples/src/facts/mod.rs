//! Numbers that the thesis prints, compared with computed numbers.
//!
//! The library computes everything from descriptions of scenes. A computed number agrees with a printed one if the
//! difference is at most half a unit of the last printed digit.

pub mod ask;
pub mod chapter2;
pub mod chapter3;
pub mod chapter4;
pub mod chapter7;
pub mod moving;
pub mod row;
pub mod stops;
pub mod table;
pub mod walls;

use row::Row;

/// Returns all rows of the table, from F01 to the last row.
#[must_use]
pub fn rows() -> Vec<Row> {
    let mut rows = chapter2::rows();
    rows.extend(chapter3::rows());
    rows.extend(chapter4::rows());
    rows.extend(walls::rows());
    rows.extend(moving::rows());
    rows.extend(chapter7::rows());
    rows.extend(stops::rows());
    rows.sort_by_key(|row| row.id);
    rows
}

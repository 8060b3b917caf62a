//! The numbers that the thesis prints, beside what they come out as.
//!
//! Everything is computed from descriptions of scenes by the library; a printed number is held to
//! half a unit of its last digit.

pub mod ask;
pub mod chapter2;
pub mod chapter3;
pub mod chapter4;
pub mod chapter7;
pub mod moving;
pub mod page;
pub mod row;
pub mod stops;
pub mod walls;

use row::Row;

/// F01 to the last, in order.
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

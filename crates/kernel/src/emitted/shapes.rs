//! Reorders the mode shapes of emitted code at compile time, from one row per mode to one row per mass.

/// Transposes a matrix, given as an array of rows, at compile time.
#[doc(hidden)]
#[must_use]
#[allow(clippy::indexing_slicing, reason = "at compile time")]
pub const fn transposed<S: Copy, const ROWS: usize, const COLUMNS: usize>(
    rows: &[[S; COLUMNS]; ROWS],
) -> [[S; ROWS]; COLUMNS] {
    const { assert!(0 < ROWS && 0 < COLUMNS, "a table of something") };
    let mut columns = [[rows[0][0]; ROWS]; COLUMNS];
    let mut row = 0;
    while row < ROWS {
        let mut column = 0;
        while column < COLUMNS {
            columns[column][row] = rows[row][column];
            column += 1;
        }
        row += 1;
    }
    columns
}

//! Expected numbers of each row, to the stated digits, and the printed numbers that are wrong.
//!
//! Most numbers are from the governing equations in extended precision. The following ones were first computed by this
//! library: the widths of F05, F06, F08 and F09, the regions of F28, the peaks of F29, and the fractions of F33 and
//! F34.
//!
//! * `beside` computes the widths, and the numbers of F06 and F09, in another way.
//! * `typed` computes F08, F28 and F29 by brute force from the closed forms.
//! * F34 is compared with the simulation in its own row.
//! * The fractions of F33 are only recorded. They are counts over ten thousand steady states, some of which other tests
//!   compare with other programs.

/// Expected numbers of a row of the table.
pub struct Expected {
    /// Identifier of the row: F01, ….
    pub id: &'static str,
    /// Indices of those entries of the row whose printed numbers are wrong.
    pub wrong: &'static [usize],
    /// Computed numbers of the row in order. Each is correct to half a unit of its last digit.
    pub values: &'static [&'static str],
}

const fn row(
    id: &'static str,
    wrong: &'static [usize],
    values: &'static [&'static str],
) -> Expected {
    Expected { id, wrong, values }
}

/// Expected numbers of all rows, in order.
pub const ROWS: &[Expected] = &[
    row("F01", &[], &["0.785398", "0.785398"]),
    row("F02", &[1], &["0.537029", "0.460414"]),
    row("F03", &[], &["1.000000000000", "1.261879"]),
    row("F04", &[], &["0.675000000000"]),
    row("F05", &[0], &["0.56", "0.173", "0.79", "0.117"]),
    row("F06", &[], &["1.2312"]),
    row("F07", &[0], &["1.506310"]),
    row("F08", &[], &["1.4316", "1.5423", "0.9529"]),
    row("F09", &[], &["1.0570"]),
    row("F10", &[], &["1.20206704", "1.224745", "1.024"]),
    row("F11", &[], &["0.333333333333"]),
    row("F12", &[], &["0.083333333333"]),
    row("F13", &[0, 1], &["0.333333333333", "0.605258"]),
    row("F14", &[], &["0.435863", "1.76477", "0.62984"]),
    row(
        "F15",
        &[],
        &["0.700000000000", "0.400000000000", "0.400000000000"],
    ),
    row("F16", &[], &["0.840336134", "0.866025404", "1.802775638"]),
    row("F17", &[1], &["0.559017", "1.118034"]),
    row(
        "F18",
        &[0],
        &["0.527585", "0.575595", "1.000000", "1.20079"],
    ),
    row("F19", &[0], &["0.3784", "0.524", "0.3737"]),
    row("F20", &[], &["0.55875"]),
    row("F21", &[], &["0.485403", "1.2708"]),
    row("F22", &[], &["1.44981", "1.44981"]),
    row("F23", &[], &["0.828219", "1.54936"]),
    row("F24", &[], &["1.41421356", "1.000000000000", "1.453238"]),
    row("F25", &[], &["0.543478261"]),
    row(
        "F26",
        &[1, 2, 4, 5],
        &[
            "0.8655", "0.8480", "0.8264", "0.8230", "0.8220", "0.8325", "0.8452",
        ],
    ),
    row("F27", &[], &["0.785398", "0.392699", "0.17901", "0.333333"]),
    row(
        "F28",
        &[1],
        &[
            "0.777873", "1.21352", "0.769548", "0.7768", "1.2168", "1.2272",
        ],
    ),
    row(
        "F29",
        &[0, 2, 3, 5],
        &["30.9043", "30.9012", "0.7732", "3.1196", "3.0879", "0.6720"],
    ),
    row("F30", &[0], &["0.341900", "0.977200", "1.111900"]),
    row("F31", &[], &["3.086000", "0.333333333333"]),
    row("F32", &[0], &["1.0667", "1.066697", "1.000000000000"]),
    row("F33", &[], &["0.9996", "0.9925"]),
    row(
        "F34",
        &[],
        &[
            "1.067359", "6.0", "0.726412", "50.2", "1.621253", "20.6", "0.896257", "62.4",
        ],
    ),
    row("F35", &[0], &["0", "6", "0.983595621"]),
    row("F36", &[0], &["0", "6", "0.993884883"]),
    row("F37", &[], &["0.8567297780578"]),
];

//! One colour for each β in all chapters, and darker colours for masses and for variants of a system.

use frictiongen_plot::Colour;

/// Colours of friction ratios, as in the figures of the thesis. Two ratios with the same colour are never in the same
/// figure.
const TABLE: [(f64, Colour); 15] = [
    (0.0, Colour::Rgb(0x60, 0x60, 0x60)),
    (0.1, Colour::Series(7)),
    (0.2, Colour::Series(0)),
    (0.3, Colour::Series(4)),
    (0.4, Colour::Series(2)),
    (0.5, Colour::Series(1)),
    (0.6, Colour::Series(3)),
    (0.7, Colour::Series(7)),
    (0.75, Colour::Series(6)),
    (0.8, Colour::Series(6)),
    (1.0, Colour::Series(4)),
    (1.25, Colour::Series(2)),
    (1.5, Colour::Series(5)),
    (2.0, Colour::Series(7)),
    (5.0, Colour::Series(3)),
];

const DEEP: [Colour; 5] = [
    Colour::Rgb(0x1b, 0x3a, 0x6b),
    Colour::Rgb(0xa6, 0x1b, 0x29),
    Colour::Rgb(0x4a, 0x7a, 0x1e),
    Colour::Rgb(0xa8, 0x6a, 0x00),
    Colour::Rgb(0x6a, 0x3d, 0x8f),
];

/// Returns the colour of a friction ratio. If the table of colours does not contain the ratio, its tenths determine
/// the colour.
#[must_use]
pub fn beta_colour(beta: f64) -> Colour {
    let known = TABLE.iter().find(|(known, _)| (known - beta).abs() < 1e-9);
    known.map_or(Colour::Series((10.0 * beta).round() as usize), |known| {
        known.1
    })
}

/// Returns the colour of a mass, by its index. No friction ratio has this colour.
#[must_use]
pub fn part_colour(index: usize) -> Colour {
    DEEP[index % DEEP.len()]
}

/// Returns the colour of one of several systems with the same friction ratio, for example with different μ.
#[must_use]
pub fn variant_colour(index: usize) -> Colour {
    part_colour(index)
}

#[cfg(test)]
mod tests {
    use super::beta_colour;

    #[test]
    fn no_two_of_a_figure_share_a_colour() {
        let figures: [&[f64]; 8] = [
            &[0.0, 0.2, 0.5, 0.8, 1.0, 1.25, 1.5, 2.0],
            &[0.0, 0.1, 0.2, 0.3, 0.4, 0.5],
            &[0.5, 0.75, 1.0, 1.5, 2.0],
            &[0.0, 0.2, 0.4, 0.5, 1.0, 1.5, 2.0, 5.0],
            &[0.0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8],
            &[0.0, 0.2, 0.4, 0.6, 1.0, 1.5, 2.0],
            &[0.0, 0.2, 0.4, 0.6, 0.7],
            &[0.2, 0.5, 1.0, 1.5, 2.0],
        ];
        for betas in figures {
            for (index, beta) in betas.iter().enumerate() {
                for other in &betas[..index] {
                    assert_ne!(beta_colour(*beta), beta_colour(*other), "{beta} {other}");
                }
            }
        }
    }
}

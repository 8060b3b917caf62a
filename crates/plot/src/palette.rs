//! Colours: strong colours for curves, pale colours for classes, and a colour map for values.

use std::fmt;

/// The colour of a line, marker or text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Colour {
    /// Black, for limits and everything that is not a series.
    Black,
    /// Grey, for curves that serve for comparison.
    Grey,
    /// Colour of the series with this index. The colours repeat after [`Colour::SERIES`] series.
    Series(usize),
    /// Any other colour, as red, green and blue.
    Rgb(u8, u8, u8),
}

/// The colour of an area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fill {
    /// Pale colour of the class with this index. The colours repeat after [`Fill::CLASSES`] classes. The first three
    /// colours are blue, orange and grey.
    Class(usize),
    /// A pale tint of a line's colour.
    Tint(Colour),
    /// Colour of a value from 0 to 1 on the colour map, from dark blue to yellow.
    Map(f64),
}

/// A colour as red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Rgb(pub u8, pub u8, pub u8);

impl fmt::Display for Rgb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{:02x}{:02x}{:02x}", self.0, self.1, self.2)
    }
}

/// Colour of text and strong lines.
pub(crate) const INK: Rgb = Rgb(0x22, 0x22, 0x22);
/// Colour of secondary text and hatching.
pub(crate) const SOFT: Rgb = Rgb(0x55, 0x55, 0x55);
/// Colour of grid lines.
pub(crate) const GRID: Rgb = Rgb(0xe4, 0xe4, 0xe4);
/// Colour of the frames of panels.
pub(crate) const FRAME: Rgb = Rgb(0x66, 0x66, 0x66);
/// Colour of the page, and of grid lines over areas.
pub(crate) const PAPER: Rgb = Rgb(0xff, 0xff, 0xff);

/// Colours of curves, in the order of [`Colour::Series`].
const SERIES: [Rgb; 8] = [
    Rgb(0x00, 0x64, 0xbd),
    Rgb(0xef, 0x58, 0x0e),
    Rgb(0x0e, 0xa1, 0x6a),
    Rgb(0xb6, 0x40, 0x79),
    Rgb(0x7a, 0x55, 0x25),
    Rgb(0x1e, 0x9b, 0xcf),
    Rgb(0x63, 0x40, 0x89),
    Rgb(0x8c, 0x93, 0x19),
];

/// Pale colours of areas, in the order of [`Fill::Class`].
const CLASSES: [Rgb; 8] = [
    Rgb(0xc1, 0xea, 0xff),
    Rgb(0xfb, 0xdc, 0xa2),
    Rgb(0xcc, 0xcc, 0xcc),
    Rgb(0xb6, 0x99, 0x7f),
    Rgb(0xed, 0x67, 0xbc),
    Rgb(0xd0, 0xff, 0x67),
    Rgb(0xfe, 0xf0, 0xdf),
    Rgb(0x83, 0xbb, 0xed),
];

/// Colour map from dark blue over green to yellow, similar to viridis. Its lightness increases evenly, also in
/// greyscale.
const MAP: [Rgb; 9] = [
    Rgb(0x44, 0x01, 0x54),
    Rgb(0x47, 0x2d, 0x7b),
    Rgb(0x3b, 0x52, 0x8b),
    Rgb(0x2c, 0x72, 0x8e),
    Rgb(0x21, 0x91, 0x8c),
    Rgb(0x28, 0xae, 0x80),
    Rgb(0x5e, 0xc9, 0x62),
    Rgb(0xad, 0xdc, 0x30),
    Rgb(0xfd, 0xe7, 0x25),
];

/// Writes a colour in the notation of web pages, such as `#0064bd`.
impl fmt::Display for Colour {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.rgb().fmt(f)
    }
}

impl Colour {
    /// Number of series whose colours differ. After these series, the colours repeat.
    pub const SERIES: usize = SERIES.len();

    pub(crate) fn rgb(self) -> Rgb {
        match self {
            Self::Black => INK,
            Self::Grey => Rgb(0x90, 0x90, 0x90),
            Self::Series(index) => cyclic(&SERIES, index),
            Self::Rgb(red, green, blue) => Rgb(red, green, blue),
        }
    }
}

impl Fill {
    /// Number of classes whose colours differ. After these classes, the colours repeat.
    pub const CLASSES: usize = CLASSES.len();

    pub(crate) fn rgb(self) -> Rgb {
        match self {
            Self::Class(index) => cyclic(&CLASSES, index),
            Self::Tint(colour) => between(PAPER, colour.rgb(), 0.22),
            Self::Map(share) => mapped(share),
        }
    }
}

fn cyclic(colours: &[Rgb], index: usize) -> Rgb {
    colours
        .iter()
        .cycle()
        .nth(index % colours.len())
        .copied()
        .unwrap_or(INK)
}

fn mapped(share: f64) -> Rgb {
    let last = (MAP.len() - 1) as f64;
    let share = if share.is_nan() { 0.0 } else { share };
    let place = share.clamp(0.0, 1.0) * last;
    let index = place.min(last - 1.0).floor();
    let pair = MAP.get(index as usize..).unwrap_or_default();
    match pair {
        [from, to, ..] => between(*from, *to, place - index),
        _ => INK,
    }
}

fn between(from: Rgb, to: Rgb, share: f64) -> Rgb {
    let mix = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * share).round() as u8;
    Rgb(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}

#[cfg(test)]
mod tests {
    use super::{CLASSES, Colour, Fill, MAP, Rgb, SERIES};

    /// Converts an sRGB colour to linear light. The result is red, green and blue, from 0 to 1.
    fn light(colour: Rgb) -> [f64; 3] {
        [colour.0, colour.1, colour.2].map(|part| {
            let part = f64::from(part) / 255.0;
            if part <= 0.04045 {
                part / 12.92
            } else {
                ((part + 0.055) / 1.055).powf(2.4)
            }
        })
    }

    /// Converts linear light to the colour space CIE L*a*b* with the white D65. Distances in this space measure how
    /// different two colours look.
    fn lab(rgb: [f64; 3]) -> [f64; 3] {
        let row = |m: [f64; 3]| rgb.iter().zip(m).map(|(a, b)| a * b).sum::<f64>();
        let f = |t: f64| {
            if 0.008_856 < t {
                t.cbrt()
            } else {
                7.787 * t + 16.0 / 116.0
            }
        };
        let x = f(row([0.4124, 0.3576, 0.1805]) / 0.9505);
        let y = f(row([0.2126, 0.7152, 0.0722]));
        let z = f(row([0.0193, 0.1192, 0.9505]) / 1.089);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// Returns a colour as three kinds of viewers see it: with normal sight, without the long-wavelength cones, and
    /// without the middle-wavelength cones (Machado 2009).
    fn seen(colour: Rgb) -> [[f64; 3]; 3] {
        let all = light(colour);
        let by = |m: [[f64; 3]; 3]| {
            m.map(|row| {
                row.iter()
                    .zip(all)
                    .map(|(a, b)| a * b)
                    .sum::<f64>()
                    .clamp(0.0, 1.0)
            })
        };
        let protan = [
            [0.152_286, 1.052_583, -0.204_868],
            [0.114_503, 0.786_281, 0.099_216],
            [-0.003_882, -0.048_116, 1.051_998],
        ];
        let deutan = [
            [0.367_322, 0.860_646, -0.227_968],
            [0.280_085, 0.672_501, 0.047_413],
            [-0.011_820, 0.042_940, 0.968_881],
        ];
        [lab(all), lab(by(protan)), lab(by(deutan))]
    }

    fn least(colours: &[Rgb]) -> f64 {
        let mut least = f64::INFINITY;
        for (index, a) in colours.iter().enumerate() {
            for b in colours.iter().skip(index + 1) {
                for (a, b) in seen(*a).iter().zip(seen(*b)) {
                    let square: f64 = a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum();
                    least = least.min(square.sqrt());
                }
            }
        }
        least
    }

    #[test]
    fn series_are_told_apart_by_the_colour_blind_and_on_white() {
        // A difference of 2.3 in L*a*b* is just noticeable.
        assert!(18.0 < least(&SERIES[..5]), "{}", least(&SERIES[..5]));
        assert!(11.0 < least(&SERIES), "{}", least(&SERIES));
        for colour in SERIES {
            let [r, g, b] = light(colour);
            let contrast = 1.05 / (0.2126 * r + 0.7152 * g + 0.0722 * b + 0.05);
            assert!(3.0 < contrast, "{colour} {contrast}");
        }
    }

    #[test]
    fn the_classes_of_regimes_are_told_apart() {
        assert!(12.0 < least(&CLASSES[..3]), "{}", least(&CLASSES[..3]));
        assert!(15.0 < least(&CLASSES), "{}", least(&CLASSES));
    }

    #[test]
    fn the_map_grows_lighter_and_ends_where_it_should() {
        let shades: Vec<f64> = (0..=64)
            .map(|i| lab(light(Fill::Map(f64::from(i) / 64.0).rgb()))[0])
            .collect();
        assert!(shades.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(Fill::Map(0.0).rgb(), MAP[0]);
        assert_eq!(Fill::Map(1.0).rgb(), MAP[8]);
        assert_eq!(Fill::Map(f64::NAN).rgb(), MAP[0]);
        assert_eq!(Fill::Map(f64::INFINITY).rgb(), MAP[8]);
    }

    #[test]
    fn colours_repeat() {
        assert_eq!(Colour::Series(Colour::SERIES + 1).rgb(), SERIES[1]);
        assert_eq!(Fill::Class(usize::MAX).rgb(), CLASSES[usize::MAX % 8]);
    }
}

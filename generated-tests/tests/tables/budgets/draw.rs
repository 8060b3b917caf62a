//! Draws random arguments, uniform in their bits, and dense near zeros, poles and branch points of the functions.

mod modes;

use crate::budgets::measure::{Arguments, Real};
use frictiongen_kernel::number::dd::Dd;
use fuzzing::Random;
pub use modes::*;

/// A generator of reproducible numbers.
pub struct Source(pub Random);

impl Source {
    pub fn next(&mut self) -> u64 {
        self.0.bits()
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.between(low, high)
    }

    /// Returns a positive number between 2^`low` and 2^`high`. Its exponent is uniform, and its bits are random.
    fn size(&mut self, low: f64, high: f64) -> f64 {
        self.between(low, high).exp2() * self.between(1.0, 1.0 + 1e-9)
    }

    /// Returns a number as [`size`](Self::size) does, with a random sign.
    fn spread(&mut self, low: f64, high: f64) -> f64 {
        let size = self.size(low, high);
        if self.next() & 1 == 0 { size } else { -size }
    }

    /// Returns a number on either side of `place`, at a distance between 2^−`close` and 1/4.
    fn beside(&mut self, place: f64, close: f64) -> f64 {
        place + self.spread(-close, -2.0)
    }
}

/// Range of the exponents of a scalar type, and the number of bits of its significand.
#[derive(Clone, Copy)]
pub struct Span {
    low: f64,
    high: f64,
    bits: f64,
}

/// Domain of a function: its text in the table, and the function that draws arguments from it.
#[derive(Clone, Copy)]
pub struct Domain {
    pub text: &'static str,
    pub draw: fn(&mut Source, Span) -> [f64; 3],
    /// Returns true if the domain contains the arguments. The function is called for arguments that were rounded or
    /// counted.
    pub holds: fn([f64; 3]) -> bool,
    /// `true` if a double-double may have a low part.
    pub tails: bool,
    /// Range of `f32` arguments that are all evaluated: from, to, and `true` if the range includes the negative
    /// numbers. Outside this range the results change only by powers of two, or not at all. Comments state the
    /// exceptions.
    pub counted: (f32, f32, bool),
}

/// Returns 2^power.
const fn power(power: i32) -> f32 {
    f32::from_bits(((127 + power) as u32) << 23)
}

fn any(a: [f64; 3]) -> bool {
    a.iter().all(|x| x.is_finite())
}

/// Draws arguments from a domain, as numbers of the scalar type `T`.
pub fn arguments<T: Real>(domain: &Domain, source: &mut Source) -> Arguments {
    let span = match T::FORMAT.0 {
        24 => Span {
            low: -126.0,
            high: 127.0,
            bits: 24.0,
        },
        53 => Span {
            low: -1020.0,
            high: 1023.0,
            bits: 53.0,
        },
        // The low words of double-doubles, and products of them, must not be subnormal.
        _ => Span {
            low: -400.0,
            high: 400.0,
            bits: 53.0,
        },
    };
    loop {
        let drawn = (domain.draw)(source, span);
        let drawn = drawn.map(|x| match T::FORMAT.0 {
            24 => f64::from(x as f32),
            _ => x,
        });
        if !(domain.holds)(drawn) {
            continue;
        }
        // Half of the double-doubles have a low word. Integers have none, because they are special arguments.
        let tail = T::FORMAT.0 == 105 && domain.tails && source.next() & 1 == 0;
        return drawn.map(|x| {
            let lost = if tail && x.fract() != 0.0 {
                x * source.between(-0.5, 0.5) / 2.0_f64.powi(54)
            } else {
                0.0
            };
            Dd::sum(x, lost)
        });
    }
}

pub const ANY: Domain = Domain {
    text: "all",
    draw: |s, span| [s.spread(span.low - 20.0, span.high), 0.0, 0.0],
    holds: any,
    tails: true,
    counted: (power(-24), power(24), true),
};

pub const NOT_NEGATIVE: Domain = Domain {
    text: "x ≥ 0",
    draw: |s, span| [s.size(span.low - 20.0, span.high), 0.0, 0.0],
    holds: |a| any(a) && a[0] >= 0.0,
    tails: true,
    counted: (1.0, 4.0, false),
};

pub const NOTHING: Domain = Domain {
    text: "constant",
    draw: |_, _| [0.0; 3],
    holds: any,
    tails: true,
    counted: (0.0, 0.0, false),
};

pub const HALF_TURNS: Domain = Domain {
    text: "all half-turns, crowded beside the quarters",
    draw: |s, span| {
        let quarter = (s.next() % 41) as f64 / 4.0;
        let h = match s.next() % 4 {
            0 => s.spread(span.low, span.high),
            1 => s.beside(quarter, span.bits),
            2 => s.spread(-6.0, 12.0),
            _ => s.between(-2.0, 2.0),
        };
        [h, 0.0, 0.0]
    },
    holds: any,
    tails: true,
    counted: (power(-14), power(24), false),
};

pub const HALF_TURN_PAIRS: Domain = Domain {
    text: "all pairs, crowded where h − d is beside a multiple of 1/2",
    draw: |s, span| {
        let half = (s.next() % 41) as f64 / 2.0;
        let (h, d) = match s.next() % 5 {
            0 => (s.spread(span.low, span.high), s.spread(span.low, span.high)),
            1 => (half + s.between(0.0, 4.0), half),
            2 => (s.beside(half, span.bits), s.spread(-60.0, 0.0)),
            3 => {
                let h = s.between(0.0, 40.0);
                (h, h - half + s.spread(-span.bits, -10.0))
            }
            _ => (s.between(-2.0, 2.0), s.between(-2.0, 2.0)),
        };
        [h, d, 0.0]
    },
    holds: any,
    tails: true,
    counted: (0.0, 0.0, false),
};

/// Numbers x for which e^x is a normal number of the scalar type.
pub const EXPONENTS: Domain = Domain {
    text: "all x with a normal e^x",
    draw: |s, span| {
        let x = match s.next() % 3 {
            0 => s.spread(span.low / 2.0, (span.high * 0.69).log2()),
            1 => s.between(-4.0, 4.0),
            _ => s.between(span.low * 0.69, span.high * 0.69),
        };
        [x, 0.0, 0.0]
    },
    holds: any,
    tails: true,
    counted: (power(-25), power(7), true),
};

/// Numbers x for which e^x − 1 does not overflow.
pub const GROWTHS: Domain = Domain {
    text: "all x up to the overflow, crowded beside 0 and ±1",
    draw: |s, span| {
        let one = if s.next() & 1 == 0 { 1.0 } else { -1.0 };
        let x = match s.next() % 4 {
            0 => s.spread(span.low / 2.2, (span.high * 0.69).log2()),
            1 => s.between(-4.0, 4.0),
            2 => s.beside(one, span.bits),
            _ => s.between(span.low * 0.69, span.high * 0.69),
        };
        [x, 0.0, 0.0]
    },
    holds: any,
    tails: true,
    counted: (power(-14), power(7), true),
};

pub const DECAYS: Domain = Domain {
    text: "a ≥ 0, crowded beside 0 and 2",
    draw: |s, span| {
        let a = match s.next() % 3 {
            0 => s.size(span.low / 3.2, 11.0),
            1 => s.between(0.0, 6.0),
            _ => s.beside(2.0, span.bits),
        };
        [a, 0.0, 0.0]
    },
    holds: |a| any(a) && a[0] >= 0.0,
    tails: true,
    counted: (power(-14), power(10), false),
};

/// Numbers z whose squares z² are normal numbers.
pub const SINC: Domain = Domain {
    text: "all z with a normal z², crowded beside 0, ±3/4 and the integers",
    draw: |s, span| {
        let whole = (s.next() % 12) as f64;
        let z = match s.next() % 5 {
            0 => s.spread(span.low / 2.2, 20.0),
            1 => s.beside(0.75, span.bits),
            2 => s.beside(whole, span.bits),
            _ => s.between(-4.0, 4.0),
        };
        [z, 0.0, 0.0]
    },
    holds: any,
    tails: true,
    counted: (power(-14), power(24), false),
};

pub const PAIRS: Domain = Domain {
    text: "pairs of all sizes, results in the normal range",
    draw: |s, span| match s.next() % 3 {
        0 => [
            s.spread(span.low / 2.1, span.high / 2.1),
            s.spread(span.low / 2.1, span.high / 2.1),
            0.0,
        ],
        1 => {
            let x = s.spread(-30.0, 30.0);
            let near = s.beside(1.0, span.bits);
            [x, -x * near, 0.0]
        }
        _ => [s.spread(-3.0, 3.0), s.spread(-3.0, 3.0), 0.0],
    },
    holds: any,
    tails: true,
    counted: (0.0, 0.0, false),
};

pub const DOUBLES: Domain = Domain {
    text: "pairs of f64 of all sizes",
    tails: false,
    ..PAIRS
};

/// Numbers for one or two complex arguments. The squares of the numbers are normal numbers.
pub const COMPLEX: Domain = Domain {
    text: "moduli with squares in the normal range",
    draw: |s, span| {
        let reach = span.high / 4.0;
        match s.next() % 2 {
            0 => [
                s.spread(-reach, reach),
                s.spread(-reach, reach),
                s.spread(-reach, reach),
            ],
            _ => [
                s.spread(-4.0, 4.0),
                s.spread(-4.0, 4.0),
                s.spread(-4.0, 4.0),
            ],
        }
    },
    holds: any,
    tails: true,
    counted: (0.0, 0.0, false),
};

/// Complex numbers of any size whose reciprocals are normal numbers.
pub const LARGE_COMPLEX: Domain = Domain {
    text: "moduli of any size with a normal reciprocal",
    draw: |s, span| {
        let reach = span.high - 3.0;
        let re = s.spread(-reach, reach);
        match s.next() % 2 {
            0 => [re, s.spread(-reach, reach), 0.0],
            _ => [re, re * s.spread(-4.0, 0.0), 0.0],
        }
    },
    holds: any,
    tails: true,
    counted: (0.0, 0.0, false),
};

pub const UNIT_COMPLEX: Domain = Domain {
    text: "|Re| + |Im| = 1 to rounding",
    draw: |s, span| {
        let re = match s.next() % 2 {
            0 => s.between(0.0, 1.0),
            _ => s.size(-span.bits, 0.0),
        };
        [re, -(1.0 - re), 0.0]
    },
    holds: any,
    tails: true,
    counted: (0.0, 0.0, false),
};

pub const POSITIVE: Domain = Domain {
    text: "positive, squares in the normal range",
    draw: |s, span| {
        let reach = span.high / 4.0;
        [
            s.size(-reach, reach),
            s.size(-reach, reach),
            s.size(-reach, reach),
        ]
    },
    holds: any,
    tails: true,
    counted: (0.0, 0.0, false),
};

pub const MARGINS: Domain = Domain {
    text: "β and limits from 2⁻³⁰ to 2³⁰, crowded beside a limit",
    draw: |s, span| {
        let limit = s.size(-30.0, 30.0);
        let beta = match s.next() % 2 {
            0 => s.size(-30.0, 30.0),
            _ => limit * s.beside(1.0, span.bits),
        };
        [beta, limit, s.size(-30.0, 30.0)]
    },
    holds: any,
    tails: true,
    counted: (0.0, 0.0, false),
};

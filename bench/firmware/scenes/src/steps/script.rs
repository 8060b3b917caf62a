//! Loads for measurements of steppers. The loads are computed with sums and products only, so that they have the same
//! bits on every processor.

use super::Machine;

/// Number of steps of a run under a load.
pub const STEPS: usize = 4000;

/// Friction force of the contact, in N.
pub const FRICTION: f64 = 3.0;

/// Rotation of a vector in one step of a load: cosine and sine of the angle.
type Turn = [f64; 2];

/// Rotations of the load `Song` at 2.3 Hz and 7.1 Hz, for a step of one millisecond.
const SLOW: Turn = [0.999_895_581_402_694_3, 0.014_450_823_207_274_255];
const FAST: Turn = [0.999_005_111_495_252_4, 0.044_595_820_503_260_594];
/// Angular frequencies of [`SLOW`] and [`FAST`], in rad/s.
const RATES: [f64; 2] = [14.451_326_206_513_047, 44.610_615_680_975_06];

/// The kinds of load under which a stepper is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Weather {
    /// A sum of two sinusoids.
    Song,
    /// A random load of up to 10⁴ times the friction force.
    Storm,
    /// A random load of up to 2.6 times the friction force, with more events than the other loads.
    Breeze,
}

/// A source of loads, step by step. It gives each kind of [`Weather`].
#[derive(Clone, Copy, Debug)]
pub struct Song<S> {
    slow: [S; 2],
    fast: [S; 2],
    seed: u32,
}

/// Operations that a scalar needs to compute a load.
pub trait Tone:
    Copy
    + core::ops::Add<Output = Self>
    + core::ops::Sub<Output = Self>
    + core::ops::Mul<Output = Self>
    + From<i8>
{
    /// Returns the scalar nearest to a constant.
    fn of(value: f64) -> Self;
}

impl Tone for f32 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value as f32
    }
}

impl Tone for f64 {
    #[inline(always)]
    fn of(value: f64) -> Self {
        value
    }
}

impl<S: Tone> Song<S> {
    /// Creates a source of loads whose sinusoids begin at zero.
    pub fn new() -> Self {
        let start = [S::of(1.0), S::of(0.0)];
        Self {
            slow: start,
            fast: start,
            seed: 1,
        }
    }

    /// Returns the load of the next step. If `on_base` is true, it is displacement in m and velocity in m/s of the
    /// base, and otherwise a force in N and zero.
    pub fn next(&mut self, on_base: bool, weather: Weather) -> [S; 2] {
        match weather {
            Weather::Song => {}
            Weather::Storm => return self.storm(on_base),
            Weather::Breeze => {
                let small = S::of(2.5e-4);
                return self.storm(on_base).map(|value| value * small);
            }
        }
        let turned = |[c, s]: [S; 2], [by_c, by_s]: Turn| {
            let (by_c, by_s) = (S::of(by_c), S::of(by_s));
            [c * by_c - s * by_s, s * by_c + c * by_s]
        };
        self.slow = turned(self.slow, SLOW);
        self.fast = turned(self.fast, FAST);
        let ([c, s], [fast_c, fast_s]) = (self.slow, self.fast);
        let share = S::of(0.6);
        if on_base {
            let size = S::of(0.0075);
            let place = size * (s + share * fast_s);
            let velocity = S::of(RATES[0]) * c + share * S::of(RATES[1]) * fast_c;
            [place, size * velocity]
        } else {
            [S::of(10.0) * (s + share * fast_s), S::of(0.0)]
        }
    }

    /// Returns a random load of up to 10⁴ times the friction force. Its sign and size change from step to step.
    fn storm(&mut self, on_base: bool) -> [S; 2] {
        let (first, second) = (self.draw(), self.draw());
        if on_base {
            [S::of(0.2) * first, S::of(20.0) * second]
        } else {
            [S::of(240.0) * first, S::of(0.0)]
        }
    }

    /// Draws a whole number from −128 to 127.
    fn draw(&mut self) -> S {
        self.seed = self
            .seed
            .wrapping_mul(1_664_525)
            .wrapping_add(1_013_904_223);
        S::from((self.seed >> 24) as u8 as i8)
    }
}

impl<S: Tone> Default for Song<S> {
    fn default() -> Self {
        Self::new()
    }
}

/// Runs a stepper under a load of the given kind. Returns the bits of its final state, or `None` after an error.
pub fn played<M: Machine>(weather: Weather) -> Option<[u64; 3]>
where
    M::Scalar: Tone,
{
    let mut song = Song::new();
    let mut machine = M::start()?;
    for _ in 0..STEPS {
        machine.advance(song.next(M::ON_BASE, weather), M::Scalar::of(FRICTION))?;
    }
    Some(machine.bits())
}

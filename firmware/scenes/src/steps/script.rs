//! What is played to a stepper: the same bits on every processor, by sums and products alone.

use super::Machine;

/// So many steps are played.
pub const STEPS: usize = 4000;

/// Friction force, N.
pub const FRICTION: f64 = 3.0;

/// A rotation by so much a step: its cosine, its sine.
type Turn = [f64; 2];

/// By 2.3 Hz and 7.1 Hz at a step of a millisecond.
const SLOW: Turn = [0.999_895_581_402_694_3, 0.014_450_823_207_274_255];
const FAST: Turn = [0.999_005_111_495_252_4, 0.044_595_820_503_260_594];
/// Angular frequencies, rad/s.
const RATES: [f64; 2] = [14.451_326_206_513_047, 44.610_615_680_975_06];

/// A load with two frequencies.
#[derive(Clone, Copy, Debug)]
pub struct Song<S> {
    slow: [S; 2],
    fast: [S; 2],
    seed: u32,
}

/// What a song needs of a scalar.
pub trait Tone:
    Copy
    + core::ops::Add<Output = Self>
    + core::ops::Sub<Output = Self>
    + core::ops::Mul<Output = Self>
    + From<i8>
{
    /// The nearest to a constant.
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
    /// From zero.
    pub fn new() -> Self {
        let start = [S::of(1.0), S::of(0.0)];
        Self {
            slow: start,
            fast: start,
            seed: 1,
        }
    }

    /// The next sample: of the base in metres and metres a second, or of a force, N, and nothing.
    pub fn next(&mut self, on_base: bool, storm: bool) -> [S; 2] {
        if storm {
            return self.storm(on_base);
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

    /// 10⁴ times the friction force, this way or that from step to step.
    fn storm(&mut self, on_base: bool) -> [S; 2] {
        let (first, second) = (self.draw(), self.draw());
        if on_base {
            [S::of(0.2) * first, S::of(20.0) * second]
        } else {
            [S::of(240.0) * first, S::of(0.0)]
        }
    }

    /// A whole number from −128 to 127.
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

/// The bits of where a machine is after all steps of a song or of a storm; none if it came to an error.
pub fn played<M: Machine>(storm: bool) -> Option<[u64; 3]>
where
    M::Scalar: Tone,
{
    let mut song = Song::new();
    let mut machine = M::start()?;
    for _ in 0..STEPS {
        machine.advance(song.next(M::ON_BASE, storm), M::Scalar::of(FRICTION))?;
    }
    Some(machine.bits())
}

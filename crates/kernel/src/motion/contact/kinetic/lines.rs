//! The friction law of a simulation: one kinetic force, or straight lines that give the force as a function of the
//! speed.

use super::line::{self, KineticLine};
use crate::errors::{Given, OutOfDomain};
use crate::number::scalar::Float;

/// Trait of a kinetic friction law: Coulomb's law, or straight lines that give the force as a function of the speed.
pub trait KineticLaw<'a, S>: Copy {
    /// Returns the straight lines of the friction law, or `None` if the kinetic friction is constant.
    fn lines(&self) -> Option<&Lines<'a, S>>;
    /// Returns the lines of the law as a mutable reference, or `None` if the kinetic friction is constant.
    fn lines_mut(&mut self) -> Option<&mut Lines<'a, S>>;
}

/// Friction law with one kinetic friction force at every speed: Coulomb's law.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Constant;

impl<'a, S> KineticLaw<'a, S> for Constant {
    #[inline]
    fn lines(&self) -> Option<&Lines<'a, S>> {
        None
    }

    #[inline]
    fn lines_mut(&mut self) -> Option<&mut Lines<'a, S>> {
        None
    }
}

/// Kinetic friction as straight lines between points of speed and force: Stribeck's law. Without points the kinetic
/// friction is constant.
#[derive(Clone, Copy, Debug)]
pub struct Lines<'a, S> {
    /// Points (v, f) with v ascending. v is the speed in the scene's units. f is the kinetic friction force divided by
    /// its value at zero speed.
    points: &'a [[S; 2]],
    /// Velocity, in the scene's units, that corresponds to dz̄/dτ = 1 of the relative displacement z̄.
    unit: S,
    /// Index of the straight line of the friction law that contains the present speed.
    place: usize,
    /// The way in which the last piece ends: on the same line, or at the crossing to the next or previous line.
    next: LineCrossing,
    /// Number of successive pieces of length zero. After [`STILL`] such pieces, the code extends the last of them.
    /// `cut` counts these extensions.
    still: u32,
    cut: u32,
}

/// The way in which a piece of motion on one line of the friction law ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LineCrossing {
    /// The speed stays on the same line of the friction law.
    None,
    /// The speed rises to the next line of the friction law.
    Faster,
    /// The speed falls to the previous line of the friction law.
    Slower,
}

/// Number of successive pieces of length zero after which the code extends the last piece. The extension continues on
/// the same line of the friction law, even across a point of the law.
const STILL: u32 = 4;

/// Largest number of doublings of the extension of a piece of length zero. Each further extension is twice as long as
/// the previous one. The first extension is the square root of a rounding unit, as a fraction of the power series'
/// length, and the longest is 2²⁰ times the first. In double precision the longest extension is a sixty-fourth of the
/// power series' length.
const CUTS: u32 = 20;

impl<'a, S: Float> Lines<'a, S> {
    /// Creates the lines of a law whose points have speeds in the scene's units. `amplitude` is the amplitude of the
    /// load at the frequency ratio r. `speed` is a velocity in the scene's units. At this velocity the derivative
    /// dz̄/dτ of the relative displacement z̄ is 1, if r = 1 and the amplitude is 1.
    #[must_use]
    pub fn under(points: &'a [[S; 2]], r: S, amplitude: S, speed: S) -> Self {
        Self {
            unit: r * amplitude * speed,
            ..Self::at_unit_speed(points)
        }
    }

    /// Changes the unit of velocity, if all displacements are multiplied by `factor`.
    pub(crate) fn scale(&mut self, factor: S) {
        self.unit = self.unit / factor;
    }

    /// Creates a law without lines. Such a law has one constant kinetic friction force.
    #[must_use]
    pub fn none() -> Self {
        Self::at_unit_speed(&[])
    }

    fn at_unit_speed(points: &'a [[S; 2]]) -> Self {
        Self {
            points,
            unit: S::constant(1.0),
            place: 0,
            next: LineCrossing::None,
            still: 0,
            cut: 0,
        }
    }

    /// Fails if the unit of velocity is not positive and finite, or if two speeds of the law coincide in that unit.
    pub(crate) fn check(&self) -> Result<(), OutOfDomain> {
        let sound = |place| {
            let line = Self { place, ..*self }.line();
            let ends = line
                .high
                .is_none_or(|high| line.low < high && high.is_finite());
            ends && line.slope.is_finite() && line.level.is_finite()
        };
        let unit = S::constant(0.0) < self.unit && self.unit.is_finite();
        if self.points.is_empty() || unit && (0..=self.points.len()).all(sound) {
            Ok(())
        } else {
            Err(OutOfDomain::LoadAmplitude(Given::of(self.unit)))
        }
    }

    /// Returns the line of the friction law that contains the present speed. The line's speeds are |dz̄/dτ|, where z̄
    /// is the relative displacement.
    pub(crate) fn line(&self) -> KineticLine<S> {
        let mut line = line::line(self.points, self.place);
        line.slope = line.slope * self.unit;
        line.low = line.low / self.unit;
        line.high = line.high.map(|high| high / self.unit);
        line
    }

    /// Returns the largest absolute slope of the friction law over the speed |dz̄/dτ|, with the relative displacement
    /// z̄.
    pub(crate) fn steepest(&self) -> S {
        line::steepest(self.points) * self.unit
    }

    /// Selects the straight line of the law that contains the given speed |dz̄/dτ|, before the first piece of motion.
    /// z̄ is the relative displacement.
    pub(crate) fn start(&mut self, speed: S) {
        self.place = line::place(self.points, speed * self.unit);
    }

    /// Records the line of the friction law on which the motion continues after a piece. `moves` is false if the piece
    /// has the length zero. If the code must extend the piece, returns the length of the extension.
    ///
    /// If the speed only touches a point of the law, rounding may switch the motion between two lines without end.
    /// After `STILL` pieces of length zero, the motion therefore continues on its line for the returned length, a
    /// fraction of the power series' length.
    pub(crate) fn leads_to(&mut self, next: LineCrossing, moves: bool) -> Option<S> {
        self.next = next;
        if moves || next == LineCrossing::None {
            (self.still, self.cut) = (0, 0);
            return None;
        }
        self.still += 1;
        if self.still < STILL {
            return None;
        }
        let mut length = S::constant(S::EPSILON).sqrt();
        for _ in 0..self.cut {
            length = length + length;
        }
        (self.still, self.cut) = (0, (self.cut + 1).min(CUTS));
        self.next = LineCrossing::None;
        Some(length)
    }

    /// Selects the line of the friction law for the motion after a piece. If the piece ended at rest, selects the first
    /// line.
    pub(crate) fn pass(&mut self, at_rest: bool) {
        self.place = match self.next {
            _ if at_rest => 0,
            LineCrossing::None => self.place,
            LineCrossing::Faster => self.place + 1,
            LineCrossing::Slower => self.place.saturating_sub(1),
        };
        self.next = LineCrossing::None;
    }
}

impl<'a, S: Float> KineticLaw<'a, S> for Lines<'a, S> {
    fn lines(&self) -> Option<&Lines<'a, S>> {
        (!self.points.is_empty()).then_some(self)
    }

    fn lines_mut(&mut self) -> Option<&mut Lines<'a, S>> {
        (!self.points.is_empty()).then_some(self)
    }
}

#[cfg(test)]
mod tests {
    use super::{KineticLaw, LineCrossing, Lines};

    const LAW: [[f64; 2]; 2] = [[0.1, 0.8], [0.3, 0.5]];

    #[test]
    fn lines_follow_each_other() {
        let mut lines = Lines::under(&LAW, 0.5, 2.0, 0.1);
        let mut found = Vec::new();
        for next in [
            LineCrossing::None,
            LineCrossing::Faster,
            LineCrossing::Faster,
            LineCrossing::Slower,
        ] {
            let line = lines.line();
            found.push((line.low, line.high));
            assert_eq!(lines.leads_to(next, true), None);
            lines.pass(false);
        }
        // The speeds of the law are divided by the unit of velocity, 0.5·2·0.1.
        let [low, high] = [0.1 / 0.1, 0.3 / 0.1];
        let first = (0.0, Some(low));
        assert_eq!(found, [first, first, (low, Some(high)), (high, None)]);
        lines.pass(true);
        assert_eq!((lines.line().low, lines.line().high), first);
        assert!(Lines::<f64>::none().lines().is_none() && lines.lines().is_some());
    }

    /// Checks that a motion cannot switch between two lines without end. The code must extend every fourth piece of
    /// length zero along its line. Each extension must be twice as long as the previous extension.
    #[test]
    fn to_and_fro_has_an_end() {
        let mut lines = Lines::under(&LAW, 1.0, 1.0, 1.0);
        let mut went = Vec::new();
        for stretch in 0..400 {
            let next = if stretch % 2 == 0 {
                LineCrossing::Faster
            } else {
                LineCrossing::Slower
            };
            if let Some(length) = lines.leads_to(next, false) {
                let before = lines.line();
                lines.pass(false);
                assert_eq!(lines.line(), before);
                went.push(length);
            }
        }
        let doubled = went
            .windows(2)
            .take(20)
            .all(|pair| pair[1] == 2.0 * pair[0]);
        assert_eq!(
            (went.len(), went[0], doubled),
            (100, f64::EPSILON.sqrt(), true)
        );
        assert_eq!(went[99], f64::EPSILON.sqrt() * f64::from(1 << 20));
        // A piece with a length resets the count of pieces of length zero.
        assert_eq!(lines.leads_to(LineCrossing::Faster, true), None);
        let next: Vec<_> = (0..4)
            .map(|_| lines.leads_to(LineCrossing::Slower, false))
            .collect();
        assert_eq!(next, [None, None, None, Some(f64::EPSILON.sqrt())]);
    }
}

//! A random scene, and the random points at which the test asks questions.

use crate::backward::asked::Place;
use crate::backward::inputs::Exact;
use crate::backward::random::{nearness, scene};
use frictiongen::study::System;
use frictiongen_kernel::Float;
use frictiongen_kernel::number::dd::Dd;
use fuzzing::Random;

/// Ranges of the random numbers. They depend on the scalar type.
pub struct Range {
    /// r is drawn between 2^−`exponents` and 2^`exponents`.
    exponents: f64,
    /// Masses and springs are spread between 10^−`decades` and 10^`decades`.
    decades: f64,
}

pub const DOUBLE: Range = Range {
    exponents: 300.0,
    decades: 3.0,
};
/// Ranges for single precision. Each link between the load and a far mass reduces the motion of the mass by r⁻².
/// Outside these ranges f32 contains nothing of that motion.
pub const SINGLE: Range = Range {
    exponents: 20.0,
    decades: 1.0,
};

/// A scene under test, with the same scene in double-double.
pub struct Subject<S> {
    pub seed: u64,
    pub system: System<S>,
    pub exact: Exact,
    pub(super) random: Random,
}

impl<S: Float> Subject<S> {
    /// Returns the scene with this seed, or `None` if `System` refuses the scene.
    pub fn of(seed: u64, range: &Range) -> Option<Self> {
        let mut random = Random(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ 0x5851_F42D);
        let text = scene(&mut random, range.decades);
        let system = text.parse::<System<S>>().ok()?;
        let exact = Exact::of(&text.parse::<System<Dd>>().ok()?);
        Some(Self {
            seed,
            system,
            exact,
            random,
        })
    }

    /// Draws the next point. r lies anywhere, near a resonance, or near a fraction of a resonance. β lies anywhere up
    /// to the limit, or near the limit.
    pub fn place(&mut self, range: &Range) -> (S, impl Fn(&mut Self, S) -> Place<S> + use<S>) {
        let random = &mut self.random;
        let resonances = &self.system.modal().resonances;
        let r = if random.unit() < 0.5 {
            random.between(-range.exponents, range.exponents).exp2()
        } else {
            let pole = resonances[random.below(resonances.len())].to_f64();
            let order = match random.below(3) {
                0 => 1.0,
                _ => (1 + random.below(40)) as f64,
            };
            pole / order * (1.0 + nearness(random, S::EPSILON))
        };
        let r = S::constant(r);
        (r, move |subject: &mut Self, limit: S| {
            let random = &mut subject.random;
            let share = match random.below(3) {
                0 => 1.0 - nearness(random, S::EPSILON).abs(),
                1 => random.unit(),
                _ => random.power(-12.0, 0.0),
            };
            Place {
                r,
                beta: limit * S::constant(share),
                tau: S::constant(random.between(0.0, 7.0)),
            }
        })
    }
}

//! Inputs displaced until the exact limit is the one under test.
//!
//! Beside a pole of U, and close to β_lim, a rounding of the inputs moves everything: the motion is that of a
//! chain whose resonance stands somewhat elsewhere, and there it has conditions of its own.  One and the same
//! displacement must explain all that is asked at a place.

use crate::asked::{Asked, Place};
use crate::displacement::Way;
use crate::measure::{Judge, Scene};
use frictiongen_kernel::Float;
use frictiongen_kernel::dd::Dd;
use generated_tests::data::Data;

/// Displaced inputs.
pub struct Matched {
    pub scene: Scene,
    pub place: Place<Dd>,
    /// By how many roundings at most.
    pub roundings: f64,
}

/// The closest displacements that are looked at, in roundings, as a power of two: beside a pole U may be 2¹⁵⁰
/// times what it is a rounding away.
const CLOSEST: i32 = -160;

impl Judge<'_> {
    /// The displacements within the bar at which the exact limit without search is `limit`.
    pub fn matched(&self, limit: Dd) -> Vec<Matched> {
        let of = |(data, place): &(Data<Dd>, Place<Dd>)| {
            data.at(place.r).continuous_limit_without_search()
        };
        let free = self.question(Asked::Free, None).slopes();
        let ways = [
            self.along_the_limit(),
            Way::along_a_part(&free, |slope| slope.re),
            Way::along_a_part(&free, |slope| slope.im),
        ];
        let here = self.at.continuous_limit_without_search() < limit;
        let all = ways.iter().flat_map(|way| {
            [1.0, -1.0].into_iter().filter_map(move |side| {
                let passed = |k: f64| (of(&self.moved_along(way, side * k)) < limit) != here;
                let k = first(passed, self.bar)?;
                Some((self.moved_along(way, side * k), k))
            })
        });
        let modes = 0..self.scene.exact.reduced.modes.len();
        let poles: Vec<_> = modes
            .filter_map(|mode| Some((mode, self.pole(mode)?)))
            .collect();
        // On the pole itself, where a rounding of r may have put the mode.
        let on = poles
            .iter()
            .map(|&(mode, pole)| self.with_resonance(mode, pole, 0.0));
        let beside = poles.iter().flat_map(|&(mode, pole)| {
            [1.0, -1.0].into_iter().filter_map(move |side| {
                let beside = |k: f64| self.with_resonance(mode, pole, side * k);
                let k = first(|k| limit <= of(&beside(k).0), self.bar)?;
                Some(beside(k))
            })
        });
        all.chain(beside)
            .chain(on)
            .filter(|(_, roundings)| *roundings <= self.bar)
            .map(|((data, place), roundings)| Matched {
                scene: Scene::new(data),
                place,
                roundings,
            })
            .collect()
    }

    fn moved_along(&self, way: &Way, k: f64) -> (Data<Dd>, Place<Dd>) {
        let (mut data, mut place) = (self.scene.exact.clone(), self.place);
        self.displace(way, k, Asked::WithoutSearch, &mut data, &mut place);
        (data, place)
    }

    fn resonance(&self, mode: usize) -> Dd {
        self.scene.exact.reduced.modes[mode].resonance
    }

    /// The resonance of a mode for which U has a pole at r, an odd multiple, if it is about the mode's own.
    fn pole(&self, mode: usize) -> Option<Dd> {
        let (half, one, two) = (Dd::from(0.5), Dd::from(1.0), Dd::from(2.0));
        let turns = self.resonance(mode) / self.place.r;
        let odd = Float::floor(turns * half) * two + one;
        let pole = odd * self.place.r;
        let away = ((pole - self.resonance(mode)) / pole).abs().to_f64();
        (away <= self.bar * self.epsilon).then_some(pole)
    }

    /// The scene with one resonance `k` roundings beside a pole, and how many from its own.
    fn with_resonance(&self, mode: usize, pole: Dd, k: f64) -> ((Data<Dd>, Place<Dd>), f64) {
        let mut data = self.scene.exact.clone();
        let resonance = pole + pole * Dd::from(self.epsilon) * Dd::from(k);
        data.reduced.modes[mode].resonance = resonance;
        let away = (resonance / self.resonance(mode) - Dd::from(1.0)).abs();
        ((data, self.place), away.to_f64() / self.epsilon)
    }
}

/// The least k at which something has passed, a power of two of at most `last`, and then to 20 digits.
fn first(passed: impl Fn(f64) -> bool, last: f64) -> Option<f64> {
    let top = last.log2().ceil() as i32;
    let power = (CLOSEST..=top).find(|power| passed(2f64.powi(*power)))?;
    let (mut low, mut high) = (0.5 * 2f64.powi(power), 2f64.powi(power));
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if passed(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(high)
}

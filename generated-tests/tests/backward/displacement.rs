//! Displaced inputs, whose exact answers pass the one that is judged.

use crate::asked::{Asked, Place, watched};
use crate::condition::inputs;
use crate::instant::{constraining, followed, lowest};
use crate::measure::{Judge, angle};
use frictiongen_kernel::Complex;
use frictiongen_kernel::dd::Dd;
use generated_tests::data::{Data, DataAt};

/// A little more than π.
const HALF_TURN: f64 = 3.2;

/// Which inputs move, and which way.
pub enum Way {
    /// β alone.
    Beta,
    /// r alone.
    Ratio,
    /// Every input, by its sign.
    Along(Vec<f64>),
}

impl Way {
    /// Every input the way that moves what has these slopes.
    pub fn along(slopes: &[Complex<Dd>]) -> Self {
        Self::along_a_part(slopes, |slope| slope.re)
    }

    /// The same for a part of what is complex.
    pub fn along_a_part(slopes: &[Complex<Dd>], part: impl Fn(&Complex<Dd>) -> Dd) -> Self {
        let sign = |slope: Dd| {
            if slope.is_zero() {
                0.0
            } else {
                1.0_f64.copysign(slope.to_f64())
            }
        };
        Self::Along(slopes.iter().map(|slope| sign(part(slope))).collect())
    }
}

impl Judge<'_> {
    /// What is watched at displaced inputs; a largest value with its instant moved to where it is there.
    fn value(&self, at: &DataAt<'_, Dd>, place: &Place<Dd>, asked: Asked, watch: Option<Dd>) -> Dd {
        let watch = watch.map(|tau| match asked {
            Asked::Amplitude(mass) => followed(&at.mass(mass, place.beta), tau, self.epsilon),
            Asked::ContinuousLimit => constraining(at, tau, self.epsilon),
            _ => tau,
        });
        watched(at, place, asked, watch).re
    }

    /// Displaces inputs of the scene and the place by `k` roundings.
    pub fn displace(
        &self,
        way: &Way,
        k: f64,
        asked: Asked,
        data: &mut Data<Dd>,
        place: &mut Place<Dd>,
    ) {
        let moved =
            |value: Dd, sign: f64| value + value * Dd::from(self.epsilon) * Dd::from(k * sign);
        match way {
            Way::Beta => place.beta = moved(place.beta, 1.0),
            Way::Ratio => place.r = moved(place.r, 1.0),
            Way::Along(signs) => {
                let mut signs = signs.iter();
                inputs(data, place, asked, |_, input| {
                    *input = moved(*input, *signs.next().unwrap_or(&0.0));
                });
            }
        }
    }

    /// What the scene says with inputs displaced by `k` roundings.
    fn displaced<T>(
        &self,
        asked: Asked,
        way: &Way,
        k: f64,
        read: impl FnOnce(&DataAt<'_, Dd>, &Place<Dd>) -> T,
    ) -> T {
        let (mut data, mut place) = (self.scene.exact.clone(), self.place);
        self.displace(way, k, asked, &mut data, &mut place);
        match way {
            Way::Beta => read(&self.at, &place),
            Way::Ratio | Way::Along(_) => read(&data.at(place.r), &place),
        }
    }

    /// By how much what is watched exceeds the answer with inputs displaced by `k` roundings.
    fn excess(&self, asked: Asked, watch: Option<Dd>, got: Dd, way: &Way, k: f64) -> f64 {
        let read = |at: &DataAt<'_, Dd>, place: &Place<Dd>| self.value(at, place, asked, watch);
        let excess = self.displaced(asked, way, k, read) - got;
        if asked == Asked::ContactPhase {
            angle(excess).to_f64()
        } else {
            excess.to_f64()
        }
    }

    /// The smallest k such that a mass stands still at this lag as the inputs move by k roundings, at about
    /// its largest, which it takes at `top`.
    pub fn stands_still(&self, mass: usize, lag: Dd, top: Dd, way: &Way) -> f64 {
        const ABOUT: f64 = 0.9;
        let asked = Asked::Phase(mass);
        let tall = |at: &DataAt<'_, Dd>, place: &Place<Dd>| {
            let motion = at.mass(mass, place.beta);
            let height = |tau: Dd| motion.displacement(tau).abs().to_f64();
            let top = height(followed(&motion, top, self.epsilon));
            height(lag - at.contact(place.beta).phase()) >= ABOUT * top
        };
        let k = self.passed(asked, Some(lag), Dd::from(0.0), way);
        let there = k.is_finite() && [k, -k].iter().any(|k| self.displaced(asked, way, *k, tall));
        if there { k } else { f64::INFINITY }
    }

    /// The smallest k, a power of two up to the bar, such that the exact answer passes `got` as the inputs
    /// move by k roundings to one side; infinite if there is none, and for a complex number, which has
    /// no sides.
    pub fn passed(&self, asked: Asked, watch: Option<Dd>, got: Dd, way: &Way) -> f64 {
        let idle = matches!(way, Way::Beta) && !asked.is_motion();
        if idle || matches!(asked, Asked::Stuck(_) | Asked::Free) {
            return f64::INFINITY;
        }
        let excess = |k: f64| self.excess(asked, watch, got, way, k);
        let here = excess(0.0);
        let passes = |k: f64| {
            let there = excess(k);
            let between = (here <= 0.0 && there >= 0.0) || (here >= 0.0 && there <= 0.0);
            // An angle may go the other way round, but by no more than the half turn of a pole.
            between && (asked != Asked::ContactPhase || (there - here).abs() < HALF_TURN)
        };
        self.powers()
            .find(|k| passes(*k) || passes(-*k))
            .unwrap_or(f64::INFINITY)
    }

    /// The same where the answer comes back to its side: a pole or a zero, narrower than a rounding, may
    /// reach the other.
    pub fn touched(&self, asked: Asked, watch: Option<Dd>, got: Dd, way: &Way) -> f64 {
        let excess = |k: f64| self.excess(asked, watch, got, way, k);
        let side = 1.0_f64.copysign(excess(0.0));
        let touches = |k: &f64| dips(|k| side * excess(k), *k);
        self.powers().find(touches).unwrap_or(f64::INFINITY)
    }

    fn powers(&self) -> impl Iterator<Item = f64> {
        let powers = std::iter::successors(Some(1.0), |k| Some(2.0 * k));
        powers.take_while(|k| *k <= self.bar)
    }
}

/// Whether a function is anywhere at or below 0 between −k and k: beside the lowest of its values there.
fn dips(of: impl Fn(f64) -> f64, k: f64) -> bool {
    const PARTS: i32 = 16;
    let part = |part: i32| k * f64::from(part) / f64::from(PARTS);
    let values: Vec<f64> = (-PARTS..=PARTS).map(|number| of(part(number))).collect();
    (1 - PARTS..PARTS)
        .zip(values.windows(3))
        .any(|(number, three)| {
            let [left, middle, right] = three else {
                return false;
            };
            let dips = middle <= left && middle <= right && (middle < left || middle < right);
            dips && of(lowest(&of, part(number - 1), part(number + 1), 0.0)) <= 0.0
        })
}

//! Finds all zeros of a function between two frequencies by interval arithmetic. The search misses no zero, and
//! mistakes no pole for a zero.
//!
//! The search covers intervals of y = 1/r. An *enclosure* is an interval that contains all values of a function over an
//! interval of y. The search discards an interval of y if the enclosure of the function excludes 0. If the interval
//! contains no pole and the enclosure of the slope excludes 0, the interval has at most one zero. The signs at both
//! bounds then show if the interval has a zero. If the interval contains one pole p, the search encloses the function
//! times y − p, which is finite. The search divides an undecided interval in two. Every zero therefore lies in an
//! interval that the search has not discarded.

use super::functions::{ChainNumbers, ModalPole, Target};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::number::dual::Dual;
use frictiongen_model::interval::{Interval, Jet};
use frictiongen_model::modal::Modal;

/// Largest number of poles in a range of frequencies. The search examines at most twenty times as many intervals.
pub(super) const MOST_POLES: usize = 20_000;
/// Largest number of intervals of y = 1/r that the search examines.
const MOST_INTERVALS: usize = 20 * MOST_POLES;
/// A zero and a pole of the function within this relative distance cancel. The search then finds neither of the two.
const CANCELLED: f64 = 1e-13;
/// Largest distance at which two zeros are treated as one point where the function touches 0. The distance is divided
/// by y = 1/r, or by the distance from a pole.
const TOUCH: f64 = 1e-9;
/// Largest relative distance at which two points are treated as one point where the function touches 0.
const ONE_TOUCH: f64 = 1e-6;
/// Position at which the search divides an interval, as a fraction of its width. It is not the middle, because the
/// middle is often a special point of a symmetric scene.
const CUT: f64 = 0.487_3;
/// Relative width of the interval around a zero at which the search changes from bisection to Newton's method.
const NEAR: f64 = 1e-6;

/// Error of a search whose range has more than `MOST_POLES` poles or needs more than `MOST_INTERVALS` intervals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Crowded;

/// A function of frequency for one motion of a chain, in the number types that the search needs.
pub(super) struct MotionFunction<'m> {
    pub target: Target<Dd>,
    modal: &'m Modal,
    mass: Option<usize>,
    exact: ChainNumbers<Dd>,
    plain: ChainNumbers<f64>,
    held: ChainNumbers<Interval>,
    sloped: ChainNumbers<Jet>,
}

/// A zero of a function of y = 1/r.
#[derive(Clone, Copy, Debug)]
pub(super) struct FunctionZero {
    /// Position of the zero, as y = 1/r.
    pub y: Dd,
    /// Slope df/dy at the zero.
    pub slope: Dd,
    /// True if the function changes its sign at the zero. False if the function only touches 0 to rounding, or if two
    /// zeros are too close to separate.
    pub crosses: bool,
}

impl FunctionZero {
    pub fn r(&self) -> f64 {
        (Dd::ONE / self.y).to_f64()
    }
}

/// Converts the numbers in a [`Target`] to another number type.
fn converted<T>(target: Target<Dd>, to: impl Fn(Dd) -> T) -> Target<T> {
    match target {
        Target::Free => Target::Free,
        Target::FreeContact => Target::FreeContact,
        Target::Receptance => Target::Receptance,
        Target::Quadrature => Target::Quadrature,
        Target::Estimate => Target::Estimate,
        Target::Fundamental => Target::Fundamental,
        Target::Sliding(beta) => Target::Sliding(to(beta)),
        Target::Continuous(beta) => Target::Continuous(to(beta)),
    }
}

fn enclosed(value: Dd) -> Interval {
    // An exact 0 stays exactly 0, without an interval of rounding errors. A term with this factor then has the value 0
    // and the slope 0.
    if value.is_zero() {
        Interval::point(0.0)
    } else {
        Interval::rounded(value.to_f64())
    }
}

impl<'m> MotionFunction<'m> {
    pub fn new(modal: &'m Modal, mass: Option<usize>, target: Target<Dd>) -> Self {
        let to_jet = |value: Dd| Jet::fixed(enclosed(value));
        Self {
            target,
            modal,
            mass,
            exact: ChainNumbers::of(modal, mass, |value: Dd| value),
            plain: ChainNumbers::of(modal, mass, |value: Dd| value.to_f64()),
            held: ChainNumbers::of(modal, mass, enclosed),
            sloped: ChainNumbers::of(modal, mass, to_jet),
        }
    }

    pub fn vanishes(&self) -> bool {
        self.target.vanishes(&self.exact)
    }

    /// Returns the function at a frequency ratio r, without the power of 1/r that is a common factor of its sums.
    pub fn at(&self, r: f64) -> f64 {
        let target = converted(self.target, |beta| beta.to_f64());
        self.plain.value(target, 1.0 / r, None)
    }

    fn over(&self, y: Interval) -> Interval {
        self.held.value(converted(self.target, enclosed), y, None)
    }

    /// Returns enclosures of the function and of its slope over an interval of y. An enclosure contains all values
    /// over the interval. The mean value form makes the enclosure of the function narrower.
    fn jet(&self, y: Interval) -> Jet {
        let target = converted(self.target, |beta| Jet::fixed(enclosed(beta)));
        let jet = self.sloped.value(target, Jet::variable(y), None);
        let middle = Interval::point(0.5 * (y.low + y.high));
        let mean = self.over(middle) + jet.slope * (y - middle);
        Jet {
            value: jet.value.both(mean),
            slope: jet.slope,
        }
    }

    /// Returns an interval that contains all values of the function times y − p, over an interval of y that contains
    /// the pole p.
    fn without_pole(&self, y: Interval, pole: &ModalPole) -> Option<Interval> {
        let near = self.held.near(y, pole)?;
        let target = converted(self.target, enclosed);
        Some(self.held.value(target, y, Some(&near)))
    }

    /// Returns the poles of the function between two frequency ratios, as values of y = 1/r, in ascending order of y.
    pub fn poles(&self, [from, to]: [f64; 2]) -> Result<Vec<ModalPole>, Crowded> {
        let poles = self
            .target
            .poles(&self.exact, [1.0 / to, 1.0 / from], MOST_POLES);
        poles.ok_or(Crowded)
    }

    /// Returns all zeros of the function between two frequency ratios r, in ascending order of r.
    pub fn zeros(&self, range: [f64; 2]) -> Result<Vec<FunctionZero>, Crowded> {
        if self.vanishes() {
            return Ok(Vec::new());
        }
        let poles = self.poles(range)?;
        let [from, to] = range;
        let mut search = ZeroSearch {
            function: self,
            poles: &poles,
            zeros: Vec::new(),
            touches: Vec::new(),
        };
        search.run([1.0 / to, 1.0 / from])?;
        let ZeroSearch {
            mut zeros,
            mut touches,
            ..
        } = search;
        touches.sort_by(f64::total_cmp);
        let mut last = 0.0_f64;
        for y in touches {
            if ONE_TOUCH * y < y - last {
                zeros.push(self.zero(Dd::from(y), false));
            }
            last = y;
        }
        zeros.sort_by(|a, b| b.y.to_f64().total_cmp(&a.y.to_f64()));
        // If a zero is the common bound of two intervals, the search finds this zero twice.
        zeros.dedup_by(|a, b| {
            a.crosses && b.crosses && (a.y - b.y).abs() <= b.y * Dd::from(CANCELLED)
        });
        Ok(zeros)
    }

    /// Returns the function and its slope at y in double-double arithmetic.
    fn exactly(&self, y: Dd) -> Dual<Dd> {
        let numbers = ChainNumbers::of(self.modal, self.mass, Dual::fixed);
        let target = converted(self.target, Dual::fixed);
        numbers.value(target, Dual::variable(y), None)
    }

    fn zero(&self, y: Dd, crosses: bool) -> FunctionZero {
        let slope = self.exactly(y).slope;
        FunctionZero { y, slope, crosses }
    }

    /// Returns the zero closest to y, refined in double-double arithmetic. `y` is the zero in double precision.
    fn polished(&self, y: f64) -> FunctionZero {
        let mut place = Dd::from(y);
        for _ in 0..3 {
            let found = self.exactly(place);
            let step = found.value / found.slope;
            if step.abs() <= place * Dd::from(CANCELLED) {
                place = place - step;
            }
        }
        self.zero(place, true)
    }

    /// Returns the zero between two values of y = 1/r. The function must be monotonic between them.
    fn refined(&self, [low, high]: [f64; 2], rising: bool) -> FunctionZero {
        let target = converted(self.target, |beta| beta.to_f64());
        let above = |y: f64| (0.0 < self.plain.value(target, y, None)) == rising;
        let (mut a, mut b) = (low, high);
        while NEAR * b < b - a {
            let middle = 0.5 * (a + b);
            if above(middle) {
                b = middle;
            } else {
                a = middle;
            }
        }
        let (mut a, mut b) = (Dd::from(a), Dd::from(b));
        let half = Dd::from(0.5);
        let mut y = (a + b) * half;
        let mut slope = Dd::ONE;
        for _ in 0..120 {
            let found = self.exactly(y);
            slope = found.slope;
            if found.value.is_zero() {
                break;
            }
            if (Dd::ZERO < found.value) == rising {
                b = y;
            } else {
                a = y;
            }
            let newton = y - found.value / slope;
            let next = if a < newton && newton < b {
                newton
            } else {
                (a + b) * half
            };
            let step = (next - y).abs();
            y = next;
            if step <= y * Dd::from(1e-24) {
                break;
            }
        }
        FunctionZero {
            y,
            slope,
            crosses: true,
        }
    }

    /// Returns ∂f/∂p, the derivative of the function f at a zero with respect to a parameter p. The modal analysis
    /// `along` and the friction ratio `beta` contain derivatives with respect to p.
    pub fn moved(&self, zero: &FunctionZero, along: &Modal<Dual<Dd>>, beta: Dual<Dd>) -> Dd {
        let numbers = ChainNumbers::of(along, self.mass, |value| value);
        let target = match self.target {
            Target::Sliding(value) => {
                // The target function may contain β or −β. The friction ratio `beta` gets the same sign.
                let sign = if value < Dd::ZERO { -Dd::ONE } else { Dd::ONE };
                Target::Sliding(beta * Dual::fixed(sign))
            }
            Target::Continuous(_) => Target::Continuous(beta),
            other => converted(other, Dual::fixed),
        };
        numbers.value(target, Dual::fixed(zero.y), None).slope
    }
}

struct ZeroSearch<'f, 'm> {
    function: &'f MotionFunction<'m>,
    poles: &'f [ModalPole],
    zeros: Vec<FunctionZero>,
    touches: Vec<f64>,
}

impl ZeroSearch<'_, '_> {
    fn run(&mut self, range: [f64; 2]) -> Result<(), Crowded> {
        let mut open = vec![range];
        let mut count = 0;
        while let Some([low, high]) = open.pop() {
            count += 1;
            if MOST_INTERVALS < count {
                return Err(Crowded);
            }
            let first = self.poles.partition_point(|pole| pole.y < low);
            let inside = self.poles.get(first..).unwrap_or_default();
            let inside = inside
                .get(..inside.partition_point(|pole| pole.y <= high))
                .unwrap_or_default();
            match inside {
                [] => self.between([low, high], &mut open),
                [pole] => self.about(pole, [low, high], &mut open),
                [..] => {
                    let middle = inside.len() / 2;
                    let of = |place: usize| inside.get(place).map_or(low, |pole| pole.y);
                    let (a, b) = (of(middle - 1), of(middle));
                    let cut = a + (b - a) * CUT;
                    open.extend([[low, cut], [cut, high]]);
                }
            }
        }
        Ok(())
    }

    /// Examines an interval that contains one pole. The method discards the interval, or adds up to three parts of the
    /// interval to `open`.
    fn about(&self, pole: &ModalPole, [low, high]: [f64; 2], open: &mut Vec<[f64; 2]>) {
        let value = self.function.without_pole(Interval::new(low, high), pole);
        let excluded = value.is_some_and(|value| !value.holds_zero());
        if excluded || high - low <= CANCELLED * pole.y {
            return;
        }
        let (a, b) = (
            pole.y - 0.25 * (pole.y - low),
            pole.y + 0.25 * (high - pole.y),
        );
        open.push([a, b]);
        for side in [[low, a], [b, high]] {
            if side[0] < side[1] {
                open.push(side);
            }
        }
    }

    /// Examines an interval without a pole. The method records a zero, discards the interval, or adds its two parts to
    /// `open`.
    fn between(&mut self, [low, high]: [f64; 2], open: &mut Vec<[f64; 2]>) {
        let jet = self.function.jet(Interval::new(low, high));
        if !jet.value.holds_zero() {
            return;
        }
        let rises = jet.slope.sign();
        if rises != 0 {
            let at = |y: f64| self.function.over(Interval::point(y)).sign();
            match (at(low), at(high)) {
                // This bound of the interval equals the zero to rounding.
                (0, _) => self.zeros.push(self.function.polished(low)),
                (_, 0) => self.zeros.push(self.function.polished(high)),
                (first, last) if first != last => {
                    let zero = self.function.refined([low, high], rises > 0);
                    self.zeros.push(zero);
                }
                _ => {}
            }
            return;
        }
        if high - low <= TOUCH * self.room(low, high) {
            let middle = 0.5 * (low + high);
            if self.function.over(Interval::point(middle)).holds_zero() {
                self.touches.push(middle);
                return;
            }
            if high - low <= CANCELLED * high {
                return;
            }
        }
        let cut = low + (high - low) * CUT;
        if low < cut && cut < high {
            open.extend([[low, cut], [cut, high]]);
        }
    }

    /// Returns the length scale of an interval of y = 1/r: y, or the distance to the nearest pole if this distance is
    /// smaller.
    fn room(&self, low: f64, high: f64) -> f64 {
        let next = self.poles.partition_point(|pole| pole.y < low);
        let above = self.poles.get(next).map_or(high, |pole| pole.y - high);
        let below = next
            .checked_sub(1)
            .and_then(|place| self.poles.get(place))
            .map_or(high, |pole| low - pole.y);
        high.min(above).min(below)
    }
}

//! Backward error: by how many roundings of its inputs an answer is the exact one.
//!
//! Inputs are r, β, τ, μ and the modal data, each on its own: λ, ζ, every residue, m*.  An answer is
//! as good as its inputs allow if some inputs within k roundings have it as their exact answer.  To
//! first order that is |error| ≤ k ε (Σ|x ∂f/∂x| + |f|), the last term for the answer's own rounding;
//! where r stands a few roundings beside a pole the first order says nothing, and the exact answer is
//! looked up at displaced inputs instead.
//!
//! What is found is an upper bound on k.  The cheapest arguments come first, and one that keeps the bar
//! ends the search for a better one.

use crate::asked::{Asked, Place, watched};
use crate::condition::{PLAIN, Question, modulus};
use crate::displacement::Way;
use crate::instant::{acceleration, constraining, largest, stationary};
use crate::matched::Matched;
use frictiongen_kernel::dd::Dd;
use frictiongen_kernel::dual::Dual;
use frictiongen_kernel::search::Peak;
use frictiongen_kernel::{Complex, Float};
use generated_tests::data::{Data, DataAt};
use std::cell::LazyCell;

/// How the answer of a scalar compares with the exact one of its own inputs.
#[derive(Clone, Copy, Debug)]
pub struct Error {
    /// |error|/(ε |f|).
    pub forward: f64,
    /// The smallest k found, in roundings of the inputs.
    pub backward: f64,
}

/// A scene as the code under test has it, read exactly.
pub struct Scene {
    pub exact: Data<Dd>,
    moving: Data<Dual<Dd>>,
}

impl Scene {
    pub fn new(exact: Data<Dd>) -> Self {
        let moving = exact.read(Dual::fixed);
        Self { exact, moving }
    }
}

/// Judges the answers at one place of a scene.
pub struct Judge<'a> {
    pub scene: &'a Scene,
    pub place: Place<Dd>,
    pub at: DataAt<'a, Dd>,
    /// A rounding.
    pub epsilon: f64,
    /// How many of them are allowed.
    pub bar: f64,
}

/// An angle's distance, within half a turn.
pub fn angle(difference: Dd) -> Dd {
    let turn = Dd::PI + Dd::PI;
    let turns = Float::floor(difference / turn + Dd::from(0.5));
    difference - turns * turn
}

fn real(value: Dd) -> Complex<Dd> {
    Complex::new(value, Dd::from(0.0))
}

fn distance(got: Complex<Dd>, want: Complex<Dd>, asked: Asked) -> Dd {
    if asked.is_angle() {
        return angle(got.re - want.re).abs();
    }
    if got.re == want.re && got.im == want.im {
        return Dd::from(0.0);
    }
    modulus(Complex::new(got.re - want.re, got.im - want.im))
}

/// Where a search ends.
pub fn first<S: Float>(peak: &Peak<S>) -> Option<S> {
    let mut places = peak.places.iter().flatten();
    places.next().map(|place| place.tau)
}

impl<'a> Judge<'a> {
    pub fn new(scene: &'a Scene, place: Place<Dd>, epsilon: f64, bar: f64) -> Self {
        Self {
            scene,
            place,
            at: scene.exact.at(place.r),
            epsilon,
            bar,
        }
    }

    pub fn question(&self, asked: Asked, instant: Option<Dd>) -> Question<'a> {
        Question {
            data: &self.scene.moving,
            place: self.place.read(Dual::fixed),
            asked,
            instant: instant.map(Dual::fixed),
        }
    }

    /// The error of `got`, whose scene has told the limit without search as `limit`.
    pub fn error_beside(
        &self,
        asked: Asked,
        got: Complex<Dd>,
        found: Option<Dd>,
        limit: Dd,
    ) -> Error {
        let mut error = self.error(asked, got, found);
        // Where rounding has left no maximum to be near, the exact one may be anywhere.
        let anew = matches!(asked, Asked::Amplitude(_) | Asked::Phase(_));
        if anew && !(error.backward <= self.bar) {
            let searched = self.error(asked, got, None).backward;
            error.backward = error.backward.min(searched);
        }
        if error.backward <= self.bar {
            return error;
        }
        for Matched {
            scene,
            place,
            roundings,
        } in self.matched(limit)
        {
            let there = Judge::new(&scene, place, self.epsilon, self.bar);
            let beside = there.error(asked, got, found).backward;
            error.backward = error.backward.min(beside + roundings);
        }
        error
    }

    /// The error of `got`.  `found` is where a search found the largest value: of the mass's motion, or of
    /// the velocity constraint, which has none where break-away decides.
    pub fn error(&self, asked: Asked, got: Complex<Dd>, found: Option<Dd>) -> Error {
        match asked {
            Asked::Phase(mass) => self.phase(mass, got.re, found),
            Asked::Amplitude(mass) => {
                let motion = self.at.mass(mass, self.place.beta);
                self.at_instant(asked, got, Some(largest(&motion, found, self.epsilon)))
            }
            Asked::ContinuousLimit => {
                let top = found.map(|tau| constraining(&self.at, tau, self.epsilon));
                self.at_instant(asked, got, top)
            }
            _ => self.at_instant(asked, got, None),
        }
    }

    fn at_instant(&self, asked: Asked, got: Complex<Dd>, instant: Option<Dd>) -> Error {
        let want = watched(&self.at, &self.place, asked, instant);
        self.against(asked, got, want, instant)
    }

    /// A phase is right if the mass is at a maximum there, and if that maximum is, to its own rounding,
    /// the largest: of maxima that are equal to rounding either may be the answer.
    fn phase(&self, mass: usize, got: Dd, found: Option<Dd>) -> Error {
        let motion = self.at.mass(mass, self.place.beta);
        let carrier = self.at.contact(self.place.beta).phase();
        let (asked, amplitude) = (Asked::Phase(mass), Asked::Amplitude(mass));
        let top = largest(&motion, found, self.epsilon);
        let largest = motion.displacement(top).abs();
        // Where so small a change of the inputs can undo the whole motion, it has no phase.
        let undone = || self.undone(amplitude, Some(top), largest);
        let Some(tau) = stationary(&motion, got - carrier, self.epsilon) else {
            // Where the force is released a mass may be at its largest without ever standing still.
            let off = angle(got - carrier - top).abs();
            let half = angle(got - carrier - top - Dd::PI).abs();
            let forward = (off.min(half) / (Dd::PI * Dd::from(self.epsilon))).to_f64();
            if forward <= PLAIN {
                return Error {
                    forward,
                    backward: forward,
                };
            }
            let still = |way: &Way| self.stands_still(mass, got, top, way);
            return Error {
                forward: f64::INFINITY,
                backward: self.least(&[
                    &|| still(&Way::Beta),
                    &|| still(&Way::Ratio),
                    &|| still(&self.along_the_limit()),
                    &|| self.nothing_known(),
                    &undone,
                ]),
            };
        };
        let lag = carrier + tau;
        let falls = acceleration(&motion, tau, self.epsilon).abs();
        let mut error = self.compared(asked, real(got), real(lag), Some(lag), falls);
        error.backward = self.least(&[&|| error.backward, &undone]);
        let there = real(motion.displacement(tau).abs());
        let height = self.against(amplitude, there, real(largest), Some(top));
        if height.backward > error.backward {
            height
        } else {
            error
        }
    }

    /// The error against a value that is known, of anything but a motion of a mass.
    pub fn known(&self, asked: Asked, got: Complex<Dd>, want: Dd) -> Error {
        let instant = match asked {
            Asked::ContinuousLimit => self.constraining(),
            _ => None,
        };
        self.against(asked, got, real(want), instant)
    }

    /// Where a search of its own finds the velocity constraint at its largest.
    pub fn constraining(&self) -> Option<Dd> {
        first(&self.at.constraint_peak())
    }

    fn against(
        &self,
        asked: Asked,
        got: Complex<Dd>,
        want: Complex<Dd>,
        instant: Option<Dd>,
    ) -> Error {
        self.compared(asked, got, want, instant, Dd::from(1.0))
    }

    /// `rate` is how fast what is watched changes with the answer.
    fn compared(
        &self,
        asked: Asked,
        got: Complex<Dd>,
        want: Complex<Dd>,
        instant: Option<Dd>,
        rate: Dd,
    ) -> Error {
        // An angle is known to the rounding of a half turn.
        let size = if matches!(asked, Asked::Phase(_)) {
            Dd::PI
        } else {
            modulus(want)
        };
        let epsilon = Dd::from(self.epsilon);
        let off = distance(got, want, asked);
        let forward = if off.is_zero() {
            0.0
        } else {
            (off / (epsilon * size)).to_f64()
        };
        // Scaling residues scales every answer but an angle: no condition is below 1.
        let backward = if forward <= PLAIN {
            forward
        } else {
            self.explained(asked, got, instant, off / epsilon * rate, size * rate)
        };
        Error { forward, backward }
    }

    /// What explains an error of `off` roundings: conditions, and displaced inputs.
    fn explained(
        &self,
        asked: Asked,
        got: Complex<Dd>,
        instant: Option<Dd>,
        off: Dd,
        size: Dd,
    ) -> f64 {
        let question = self.question(asked, instant);
        let slopes = LazyCell::new(|| question.slopes());
        let (watch, aim) = match asked {
            // The velocity at the answer, which it should be the zero of.
            Asked::Phase(_) => (Some(got.re), Dd::from(0.0)),
            _ => (instant, got.re),
        };
        let passed = |way: &Way| self.passed(asked, watch, aim, way);
        let touched = |way: &Way| self.touched(asked, watch, aim, way);
        let bounds: [&dyn Fn() -> f64; 8] = [
            &|| question.roughly(off, size),
            &|| passed(&Way::Beta),
            &|| passed(&Way::Ratio),
            &|| question.exactly(off, size, &slopes),
            &|| passed(&Way::along(&slopes)),
            &|| touched(&Way::along(&slopes)),
            &|| passed(&self.along_the_limit()),
            &|| self.nothing_known(),
        ];
        let of_all = if asked.is_motion() { 8 } else { 6 };
        self.least(&bounds[..of_all])
    }

    /// The least of these bounds, up to the first that keeps the bar.
    fn least(&self, bounds: &[&dyn Fn() -> f64]) -> f64 {
        let mut least = f64::INFINITY;
        for bound in bounds {
            least = least.min(bound());
            if least <= self.bar {
                break;
            }
        }
        least
    }

    /// Q vanishes as a square root does and has no slope at its end, and beside a pole of U the slopes
    /// change within a rounding: a motion may be explained along what moves the limit.
    pub fn along_the_limit(&self) -> Way {
        Way::along(&self.question(Asked::WithoutSearch, None).slopes())
    }

    /// How many roundings of the inputs undo an answer of this size altogether.
    fn undone(&self, asked: Asked, instant: Option<Dd>, size: Dd) -> f64 {
        let question = self.question(asked, instant);
        let whole = size / Dd::from(self.epsilon);
        let slopes = || question.slopes();
        self.least(&[&|| question.roughly(whole, size), &|| {
            question.exactly(whole, size, &slopes())
        }])
    }

    /// Where so small a change of the inputs undoes V itself, nothing about the motion is known.
    fn nothing_known(&self) -> f64 {
        self.undone(Asked::SlidingLimit, None, self.at.sliding_limit())
    }
}

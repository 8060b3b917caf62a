//! Asks a system all questions at one point, and collects the answers.

use crate::backward::asked::{Asked, Of, Watched, motion};
use crate::backward::instant::{acceleration, constraining, largest};
use crate::backward::judge::{Answer, Judge, modulus};
use frictiongen::study::{SystemAt, response::SystemMotion};
use frictiongen_kernel::modal_sum::search::Peak;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::{Complex, Float};
use generated_tests::data::DataMotion;

/// Fraction of the largest motion in the chain. A motion below this fraction is that of a mass far from load and
/// contact. Its error is measured against this fraction of the largest motion.
const FAR: f64 = 1e-3;
/// Smallest size against which the error of a motion is measured, as a fraction of the largest motion. A sum over
/// modes, whose modal data is rounded once, has an error of a few rounding units of the largest motion. The accepted
/// error of 64 rounding units of this size is four rounding units of the largest motion.
const SUM: f64 = 1.0 / 16.0;
/// Size against which the error of a motion below [`FAR`] of the largest motion is measured, as a multiple of the
/// largest motion. A motion below [`FAR`] is a remainder of larger motions that cancel. Near a resonance of the stuck
/// chain, the remainder has an error of hundreds of rounding units of these larger motions.
const LEFT: f64 = 256.0;
/// Fraction of the largest motion below which a mass counts as not moving. A smaller motion is rounding of
/// double-double.
const UNREACHED: f64 = 1e-20;
/// Ratio of the largest response to V above which V counts as 0, because double-double rounds it away too.
const NOTHING: f64 = 1e25;
/// Orders of the harmonics for which the test asks.
const HARMONICS: [u32; 2] = [1, 3];
/// Instants at which the test samples a velocity for its size, in half periods.
const SAMPLES: [f64; 5] = [0.0, 0.15, 0.35, 0.6, 0.85];

/// Returns the instant of the maximum that a search has found, or `None` if there is none.
pub fn first<S: Float>(peak: &Peak<S>) -> Option<S> {
    let mut places = peak.places.iter().flatten();
    places.next().map(|place| place.tau)
}

/// Collects the answers at one point.
pub struct Questions<'j, 'a, S, E> {
    judge: &'j Judge<'a>,
    /// Conversion of a scalar to double-double without loss.
    exact: E,
    epsilon: f64,
    /// True if the test itself searches for every maximum in double-double.
    searched: bool,
    /// Ratio of the largest response to V. V is a difference of the masses' responses, so it has their rounding
    /// errors. Phase and limits have the same errors.
    faint: Dd,
    pub told: Vec<Answer>,
    /// Number of masses that the load does not reach while the contact is stuck.
    pub unreached: u64,
    /// Number of searches for an amplitude that ended without a result.
    pub given_up: u64,
    scalar: std::marker::PhantomData<S>,
}

impl<'j, 'a, S: Float, E: Fn(S) -> Dd + Copy> Questions<'j, 'a, S, E> {
    pub fn new(judge: &'j Judge<'a>, exact: E, searched: bool, masses: usize) -> Self {
        Self {
            judge,
            exact,
            epsilon: S::EPSILON,
            searched,
            faint: faint(judge, masses),
            told: Vec::new(),
            unreached: 0,
            given_up: 0,
            scalar: std::marker::PhantomData,
        }
    }

    fn note(&mut self, watched: Watched<Dd>, got: Complex<Dd>, own: Dd, largest: Dd) {
        self.told.push(Answer {
            watched,
            got,
            searched: false,
            size: if own < largest * Dd::from(FAR) {
                largest * Dd::from(LEFT)
            } else {
                own.max(largest * Dd::from(SUM))
            },
            strict: own.max(largest * Dd::from(FAR)),
            own,
        });
    }

    /// Returns the ratio of the largest response to V.
    pub fn faint(&self) -> f64 {
        self.faint.to_f64()
    }

    /// Adds an answer whose error is measured against its own size. `largest` is the largest answer of its kind.
    fn plain(&mut self, asked: Asked, got: Complex<S>, instant: Option<Dd>, largest: Dd) {
        let watched = Watched {
            asked,
            instant,
            lag: None,
        };
        let [own] = self.judge.exact(&[watched])[..] else {
            return;
        };
        let got = Complex::new((self.exact)(got.re), (self.exact)(got.im));
        let own = modulus(own);
        let carried = own * self.faint;
        self.note(watched, got, own, largest.max(carried));
    }

    /// Adds the answers for all variants of β_lim.
    pub fn limits(&mut self, at: &SystemAt<'_, S>, found: Option<S>, per_mode: bool) {
        let zero = Dd::from(0.0);
        let real = |value: S| Complex::new(value, S::constant(0.0));
        let without = at.continuous_limit_without_search();
        self.plain(Asked::WithoutSearch, real(without), None, zero);
        let found = if self.searched {
            first(&self.judge.at().velocity_constraint())
        } else {
            found.map(self.exact)
        };
        let top = found.map(|tau| constraining(self.judge.at(), tau, self.epsilon));
        self.plain(
            Asked::ContinuousLimit,
            real(at.continuous_limit()),
            top,
            zero,
        );
        if per_mode {
            let limit = at.continuous_limit_per_mode();
            self.plain(Asked::PerMode, real(limit), None, zero);
        }
    }

    /// Returns true if V is larger than the rounding error of the difference that gives it, in double-double.
    pub fn is_reached(&self) -> bool {
        self.faint() < NOTHING
    }

    /// Adds the answer for β*_lim.
    pub fn sliding(&mut self, at: &SystemAt<'_, S>) {
        let limit = Complex::new(at.sliding_limit(), S::constant(0.0));
        self.plain(Asked::SlidingLimit, limit, None, Dd::from(0.0));
    }

    /// Adds the stuck response of masses. Returns true if a stuck response exists.
    pub fn stuck(&mut self, at: &SystemAt<'_, S>, asked: &[usize], masses: usize) -> bool {
        let Ok(stuck) = at.stuck() else { return false };
        let every = (0..masses).map(|mass| modulus(self.judge.at().stuck_amplitude(mass)));
        let largest = every.fold(Dd::from(0.0), Dd::max);
        for &mass in asked {
            let Some(got) = stuck.mass_at(mass) else {
                continue;
            };
            let own = modulus(self.judge.at().stuck_amplitude(mass));
            if own.to_f64() <= UNREACHED * largest.to_f64() {
                // The terms cancel altogether, so that only rounding is left.
                let exact = Complex::new((self.exact)(got.re), (self.exact)(got.im));
                let left = modulus(exact).to_f64() / largest.to_f64();
                let nothing = own.is_zero() && got.re.is_zero() && got.im.is_zero();
                if nothing || left <= S::EPSILON.sqrt() {
                    self.unreached += 1;
                    continue;
                }
                // A larger remainder is judged as any other answer, against a size of nearly zero.
            }
            self.plain(Asked::Stuck(mass), got, None, largest);
        }
        true
    }

    /// Adds the answers for the contact's motion.
    pub fn contact(&mut self, motion: &SystemMotion<'_, S>, tau: S) {
        let zero = S::constant(0.0);
        let contact = motion.contact();
        let exact = self.judge.at().contact(self.judge.place().beta);
        // Near a limit the exact contact may not move at all, although it moves at a β that differs by one rounding
        // unit.
        let told = (self.exact)(contact.amplitude());
        let own = exact.amplitude().max(told);
        let real = |value: S| Complex::new(value, zero);
        let amplitude = real(contact.amplitude());
        self.wide(
            Asked::Amplitude(Of::Contact),
            amplitude,
            None,
            own,
            own * self.faint,
        );
        let phase = (self.exact)(contact.phase());
        let watched = Watched {
            asked: Asked::Phase(Of::Contact),
            instant: None,
            lag: None,
        };
        // The rounding error of an angle is that of half a turn, π.
        self.note(
            watched,
            Complex::new(phase, Dd::from(0.0)),
            Dd::PI,
            Dd::PI * self.faint,
        );
        self.wide(
            Asked::Displacement(Of::Contact),
            real(contact.displacement(tau)),
            None,
            own,
            own * self.faint,
        );
        let speed = speed(&exact).max(own);
        self.wide(
            Asked::Velocity(Of::Contact),
            real(contact.velocity(tau)),
            None,
            speed,
            own * self.faint,
        );
        for n in HARMONICS {
            let largest = self.whole(&exact, Of::Contact, n);
            self.harmonic(Of::Contact, n, contact.harmonic(n), Dd::from(0.0), largest);
        }
    }

    /// Adds the answers for the motions of masses.
    pub fn masses(&mut self, motion: &SystemMotion<'_, S>, asked: &[usize], masses: usize, tau: S) {
        let zero = Dd::from(0.0);
        let (at, beta) = (self.judge.at(), self.judge.place().beta);
        let mut widest = at.contact(beta).amplitude();
        let mut harmonics = HARMONICS.map(|_| zero);
        for mass in 0..masses {
            let exact = at.mass(mass, beta);
            widest = widest.max(exact.amplitude_monoharmonic());
            for (largest, n) in harmonics.iter_mut().zip(HARMONICS) {
                *largest = largest.max(modulus(exact.harmonic(n)));
            }
        }
        for &mass in asked {
            if let Some(of_mass) = motion.mass_at(mass) {
                let exact = at.mass(mass, beta);
                let place = MassPlace {
                    mass,
                    exact,
                    widest,
                };
                self.mass(&of_mass, &place, tau);
                for (largest, n) in harmonics.iter().zip(HARMONICS) {
                    let of = Of::Mass(mass);
                    let whole = self.whole(&at.mass(mass, beta), of, n);
                    self.harmonic(of, n, of_mass.harmonic(n), *largest, whole);
                }
            }
        }
    }

    fn mass(
        &mut self,
        of_mass: &frictiongen::study::response::SystemSteady<'_, S>,
        place: &MassPlace<'_>,
        tau: S,
    ) {
        let MassPlace {
            mass,
            exact,
            widest,
        } = place;
        let (mass, widest) = (*mass, *widest);
        let of = Of::Mass(mass);
        let real = |value: S| Complex::new(value, S::constant(0.0));
        let peak = of_mass.peak();
        // A motion this small is a remainder of larger motions that cancel. In double-double too, it consists of
        // rounding only.
        let is_far = exact.amplitude_monoharmonic() < widest * Dd::from(FAR);
        let found = if self.searched && !is_far {
            None
        } else {
            first(&peak).map(self.exact)
        };
        let estimate = real(of_mass.amplitude_monoharmonic());
        let given_up = peak.exceeded;
        let top = largest(exact, found, self.epsilon);
        let amplitude = exact.displacement(top).abs();
        if given_up {
            self.given_up += 1;
        } else {
            let told = real(of_mass.amplitude());
            self.wide(Asked::Amplitude(of), told, Some(top), amplitude, widest);
            self.mark_searched(found.is_none());
        }
        self.wide(Asked::Estimate(mass), estimate, None, amplitude, widest);
        // τ counts from the maximum of the contact's motion, whose phase has the rounding error of V.
        let carried = widest.max(amplitude * self.faint);
        let there = real(of_mass.displacement(tau));
        self.wide(Asked::Displacement(of), there, None, amplitude, carried);
        let quick = speed(exact).max(amplitude);
        let there = real(of_mass.velocity(tau));
        self.wide(Asked::Velocity(of), there, None, quick, carried);
        if given_up {
            return;
        }
        // A lag is right if the mass has zero velocity and its largest displacement at that lag.
        let lag = (self.exact)(of_mass.phase());
        let contact = motion(self.judge.at(), Of::Contact, self.judge.place().beta);
        let falls = acceleration(exact, lag - contact.phase(), self.epsilon).abs();
        let turn = falls * (Dd::PI + Dd::PI);
        let still = Watched {
            asked: Asked::Phase(of),
            instant: None,
            lag: Some(lag),
        };
        self.note(
            still,
            zero_at(lag),
            quick + turn,
            carried.max(turn * self.faint),
        );
        let height = Watched {
            asked: Asked::Height(mass),
            instant: Some(top),
            lag: Some(lag),
        };
        self.note(height, zero_at(lag), amplitude, carried);
    }

    /// Returns the size that measures the error of harmonic n. For the fundamental it is the larger of the free
    /// response and the fundamental itself. For other orders it is 0. The fundamental is the free response minus the
    /// response to friction. Near a resonance both responses are larger than their difference.
    fn whole(&self, exact: &DataMotion<Dd>, of: Of, n: u32) -> Dd {
        if n != 1 {
            return Dd::from(0.0);
        }
        let free = motion(self.judge.at(), of, Dd::from(0.0));
        modulus(free.harmonic(1)).max(modulus(exact.harmonic(1)))
    }

    fn harmonic(&mut self, of: Of, n: u32, got: Complex<S>, largest: Dd, whole: Dd) {
        let asked = Asked::Harmonic(of, n);
        self.plain(asked, got, None, largest);
        if let Some(answer) = self.told.last_mut() {
            answer.size = answer.size.max(whole);
        }
    }

    fn mark_searched(&mut self, searched: bool) {
        if let Some(answer) = self.told.last_mut() {
            answer.searched = searched;
        }
    }

    /// Adds an answer whose error is measured against the size `own`. `largest` is the largest answer of its kind.
    fn wide(&mut self, asked: Asked, got: Complex<S>, instant: Option<Dd>, own: Dd, largest: Dd) {
        let watched = Watched {
            asked,
            instant,
            lag: None,
        };
        let got = Complex::new((self.exact)(got.re), (self.exact)(got.im));
        self.note(watched, got, own, largest);
    }
}

struct MassPlace<'d> {
    mass: usize,
    exact: DataMotion<'d, Dd>,
    widest: Dd,
}

/// Returns 0, which is the exact velocity at a lag, or NaN if the lag is NaN.
fn zero_at(lag: Dd) -> Complex<Dd> {
    Complex::new(lag * Dd::from(0.0), Dd::from(0.0))
}

/// Returns the ratio of the largest free response of a mass to the free response V of the contact.
fn faint(judge: &Judge<'_>, masses: usize) -> Dd {
    let (at, zero) = (judge.at(), Dd::from(0.0));
    let own = at.contact(zero).amplitude();
    let every = (0..masses).map(|mass| at.mass(mass, zero).amplitude_monoharmonic());
    every.fold(own, Dd::max) / own
}

/// Returns an estimate of the largest velocity of a motion, from samples.
fn speed(motion: &DataMotion<'_, Dd>) -> Dd {
    let speeds = SAMPLES.map(|t| motion.velocity(Dd::PI * Dd::from(t)).abs());
    speeds.into_iter().fold(Dd::from(0.0), Dd::max)
}

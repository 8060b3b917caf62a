//! A scene as something to sample: the response in whatever regime it is, its limits, and the
//! event-driven simulation to check it with.

pub use frictiongen::Of;
use std::f64::consts::TAU;

/// Cycles from rest before a simulated response counts as steady.  The thesis takes 200 (3.6.1); five
/// masses with little friction need more.
pub const CYCLES: usize = 1000;
/// Instants of a cycle at which a simulated motion is read.
const INSTANTS: usize = 720;

/// How a motion becomes an amplitude and a phase.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// Its largest |x̄| and the lag of that maximum.
    Peak,
    /// Its first harmonic, the thesis's frequency-based amplitude and phase (4.3.3).
    Fundamental,
}

/// An amplitude, and a lag behind the excitation in degrees.
#[derive(Clone, Copy, Debug)]
pub struct Polar {
    /// |x̄|.
    pub amplitude: f64,
    /// Degrees.
    pub lag: f64,
}

impl Polar {
    /// From a lag in rad.
    #[must_use]
    pub fn new(amplitude: f64, lag: f64) -> Self {
        Self {
            amplitude,
            lag: lag.to_degrees(),
        }
    }

    /// From X with x̄ = Re X e^{iτ}: its angle is a lead.
    #[must_use]
    pub fn of_complex(x: frictiongen::Complex<f64>) -> Self {
        Self::new(x.re.hypot(x.im), -x.im.atan2(x.re))
    }
}

/// One cycle of motion; the load is cos(τ + origin).
#[derive(Debug)]
pub struct Cycle {
    /// The excitation's angle at τ = 0.
    pub origin: f64,
    /// x̄ at each asked τ.
    pub motion: Vec<f64>,
}

/// A scene that can be sampled; [`scene!`](crate::scene!) provides it for an emitted one.
pub trait Scene {
    /// Undamped resonances.
    fn resonances(&self) -> Vec<f64>;
    /// β_lim and β*_lim.
    fn limits(&self, r: f64) -> Option<(f64, f64)>;
    /// The closed form; none outside the continuous regime.
    fn continuous(&self, r: f64, beta: f64, of: Of, measure: Measure) -> Option<Polar>;
    /// The steady state with stops.
    fn stick_slip(&self, r: f64, beta: f64, of: Of, measure: Measure) -> Option<Polar>;
    /// The response with the contact stuck.
    fn stuck(&self, r: f64, of: Of) -> Option<Polar>;
    /// One cycle of the steady state, at each τ from a maximum of the relative motion.
    fn cycle(&self, r: f64, beta: f64, of: Of, taus: &[f64]) -> Option<Cycle>;
    /// x̄ of a run from rest after [`CYCLES`] cycles, at each rising angle of the excitation.
    fn run(&self, r: f64, beta: f64, of: Of, angles: &[f64]) -> Option<Vec<f64>>;

    /// The response at the limit of continuous motion, where that is met before the contact sticks.
    fn at_limit(&self, r: f64, of: Of, measure: Measure) -> Option<Polar> {
        let (continuous, sliding) = self.limits(r)?;
        // Just inside: on the limit itself the motion is no longer continuous.
        (continuous < sliding)
            .then(|| self.continuous(r, continuous * (1.0 - 1e-13), of, measure))
            .flatten()
    }

    /// The response of a run from rest.
    fn simulated(&self, r: f64, beta: f64, of: Of, measure: Measure) -> Option<Polar> {
        let angles: Vec<f64> = (0..INSTANTS)
            .map(|i| TAU * i as f64 / INSTANTS as f64)
            .collect();
        let motion = self.run(r, beta, of, &angles)?;
        Some(match measure {
            Measure::Peak => {
                let (lag, amplitude) = angles
                    .iter()
                    .zip(&motion)
                    .map(|(angle, x)| (if *x < 0.0 { angle + TAU / 2.0 } else { *angle }, x.abs()))
                    .fold(
                        (0.0, 0.0),
                        |best, next| if best.1 < next.1 { next } else { best },
                    );
                Polar::new(amplitude, lag)
            }
            Measure::Fundamental => {
                let (re, im) = angles
                    .iter()
                    .zip(&motion)
                    .fold((0.0, 0.0), |sum, (angle, x)| {
                        (sum.0 + x * angle.cos(), sum.1 + x * angle.sin())
                    });
                let share = 2.0 / INSTANTS as f64;
                Polar::new(share * re.hypot(im), im.atan2(re))
            }
        })
    }
}

/// Makes an emitted scene one that can be sampled; it must provide limits, motion, stuck, orbit and
/// simulation.
#[macro_export]
macro_rules! scene {
    ($($name:ident),+ $(,)?) => {$(
        impl $crate::scene::Scene for $name {
            fn resonances(&self) -> Vec<f64> {
                $name::RESONANCES.to_vec()
            }

            fn limits(&self, r: f64) -> Option<(f64, f64)> {
                let at = $name::at(r).ok()?;
                Some((at.continuous_limit(), at.sliding_limit()))
            }

            fn continuous(
                &self,
                r: f64,
                beta: f64,
                of: $crate::scene::Of,
                measure: $crate::scene::Measure,
            ) -> Option<$crate::scene::Polar> {
                use $crate::scene::{Measure, Polar};
                let motion = $name::at(r).ok()?.motion(beta).ok()?;
                frictiongen::ContinuousMotion::ask(&motion, of, |motion| match measure {
                    Measure::Peak => Polar::new(motion.amplitude(), motion.phase()),
                    Measure::Fundamental => Polar::of_complex(motion.harmonic(1)),
                })
            }

            fn stick_slip(
                &self,
                r: f64,
                beta: f64,
                of: $crate::scene::Of,
                measure: $crate::scene::Measure,
            ) -> Option<$crate::scene::Polar> {
                use $crate::scene::{Measure, Of, Polar};
                let orbit = $name::at(r).ok()?.orbit(beta).ok()?;
                let motion = match of {
                    Of::Contact => orbit.contact(),
                    Of::Mass(index) => orbit.mass(index),
                };
                Some(match measure {
                    Measure::Peak => Polar::new(motion.amplitude(), motion.phase()),
                    Measure::Fundamental => Polar::of_complex(motion.harmonic(1)),
                })
            }

            fn stuck(&self, r: f64, of: $crate::scene::Of) -> Option<$crate::scene::Polar> {
                use $crate::scene::{Of, Polar};
                match of {
                    Of::Contact => Some(Polar::new(0.0, f64::NAN)),
                    Of::Mass(index) => frictiongen::StuckAt::stuck_mass(&$name::at(r).ok()?, index)
                        .ok()?
                        .map(Polar::of_complex),
                }
            }

            fn cycle(
                &self,
                r: f64,
                beta: f64,
                of: $crate::scene::Of,
                taus: &[f64],
            ) -> Option<$crate::scene::Cycle> {
                use $crate::scene::{Cycle, Of};
                let at = $name::at(r).ok()?;
                if let Ok(motion) = at.motion(beta) {
                    let origin = motion.contact().phase();
                    return frictiongen::ContinuousMotion::ask(&motion, of, |motion| Cycle {
                        origin,
                        motion: taus.iter().map(|tau| motion.displacement(*tau)).collect(),
                    });
                }
                let orbit = at.orbit(beta).ok()?;
                let motion = match of {
                    Of::Contact => orbit.contact(),
                    Of::Mass(index) => orbit.mass(index),
                };
                Some(Cycle {
                    origin: orbit.origin(),
                    motion: taus.iter().map(|tau| motion.displacement(*tau)).collect(),
                })
            }

            fn run(
                &self,
                r: f64,
                beta: f64,
                of: $crate::scene::Of,
                angles: &[f64],
            ) -> Option<Vec<f64>> {
                use $crate::scene::{CYCLES, Of};
                let mut run = $name::simulation(r, beta).ok()?;
                let settled = std::f64::consts::TAU * CYCLES as f64;
                let mut passed = 0.0;
                angles
                    .iter()
                    .map(|angle| {
                        while passed < settled + angle {
                            let segment = run.advance(settled + angle - passed).ok()?;
                            // The last piece may be lost in the rounding of what has passed.
                            if segment.length <= 1e-9 && segment.event.is_none() {
                                break;
                            }
                            passed += segment.length;
                        }
                        Some(match of {
                            Of::Contact => run.relative().0,
                            Of::Mass(index) => run.mass(index).displacement(),
                        })
                    })
                    .collect()
            }
        }
    )+};
}

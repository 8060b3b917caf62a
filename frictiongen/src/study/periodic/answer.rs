//! The steady state under a periodic load.

use super::error::PeriodicError;
use super::load::Sampled;
use super::walk::{FixedPoint, Walk};
use crate::{Complex, Of};
use frictiongen_kernel::motion::Contact;
use frictiongen_kernel::stepper::Work;

/// Largest distance of a Floquet multiplier from the unit circle at which the multiplier is treated as lying on the
/// circle. The code computes the multipliers from differences, which have rounding errors.
const ON_CIRCLE: f64 = 1e-7;

/// Steady state under a periodic load, over one of its periods, in the units of the scene.
#[derive(Clone, Debug)]
pub struct PeriodicState {
    period: usize,
    multipliers: Vec<Complex<f64>>,
    events: u64,
    stuck: usize,
    work: Work<f64>,
    residual: f64,
    step: f64,
    start: usize,
    tracks: Vec<PeriodicTrack>,
    forces: Vec<f64>,
}

/// A motion of the scene, or the force of a spring, over one period of a steady state.
#[derive(Clone, Debug, PartialEq)]
pub struct PeriodicTrack {
    /// Motion or spring whose samples the track contains.
    pub of: Of,
    /// Value and time derivative at the start of each step, and at the end of the period.
    pub values: Vec<[f64; 2]>,
    step: f64,
    /// One flag for each step. It is true if the acceleration may jump in this step at velocity 0: at an event in the
    /// motion of a rigid contact. The force of an elastic contact, and therefore the acceleration, is continuous.
    kinks: Vec<bool>,
}

impl PeriodicTrack {
    /// Returns the smallest and the largest value of this track in the period. Within a step the value follows the
    /// cubic through the values and derivatives at both ends of the step. If the motion of a rigid contact reverses in
    /// a step, two parabolas replace the cubic. The parabolas meet at the contact's largest displacement.
    #[must_use]
    pub fn extremes(&self) -> [f64; 2] {
        let mut extremes = [f64::INFINITY, f64::NEG_INFINITY];
        let mut note = |value: f64| {
            let [least, most] = extremes;
            extremes = [least.min(value), most.max(value)];
        };
        for (place, pair) in self.values.windows(2).enumerate() {
            let [[x0, v0], [x1, v1]] =
                [pair.first(), pair.last()].map(|at| at.copied().unwrap_or_default());
            note(x0);
            note(x1);
            let (v0, v1, rise) = (v0 * self.step, v1 * self.step, x1 - x0);
            let (c, d) = (3.0 * rise - 2.0 * v0 - v1, v0 + v1 - 2.0 * rise);
            let kink = self.kinks.get(place).copied().unwrap_or(false);
            if kink && v0 * v1 < 0.0 {
                // Each parabola has velocity 0 at the point where the two parabolas meet. With the fraction s of the
                // step, this point satisfies x0 + v0·s/2 = x1 − v1·(1 − s)/2.
                let share = ((2.0 * rise - v1) / (v0 - v1)).clamp(0.0, 1.0);
                note(x0 + 0.5 * v0 * share);
            } else if v0 * v1 < 0.0 {
                // The velocity of the cubic is v0 + 2cs + 3ds² at the fraction s of the step. The form −v0/(c ± root)
                // of its zeros avoids a cancellation.
                let root = (c * c - 3.0 * d * v0).max(0.0).sqrt();
                for share in [-v0 / (c + root), -v0 / (c - root)] {
                    if (0.0..=1.0).contains(&share) {
                        note(x0 + share * (v0 + share * (c + share * d)));
                    }
                }
            }
        }
        extremes
    }
}

impl PeriodicState {
    /// Records one period of the motion from the present state of `walk`, which repeats after this period.
    pub(super) fn of(
        walk: &mut Walk<'_>,
        load: &Sampled,
        fixed: &FixedPoint,
        of: &[Of],
    ) -> Result<Self, PeriodicError> {
        walk.stepper.restart_work();
        let tracks = of.iter().map(|of| PeriodicTrack {
            of: *of,
            values: Vec::new(),
            step: load.step,
            kinks: Vec::new(),
        });
        let mut state = Self {
            period: fixed.period,
            multipliers: fixed.multipliers.clone(),
            events: 0,
            stuck: 0,
            work: walk.stepper.work(),
            residual: fixed.residual,
            step: load.step,
            start: walk.at,
            tracks: tracks.collect(),
            forces: Vec::new(),
        };
        state.note(walk);
        for _ in 0..fixed.period * load.points.len() {
            let stepped = walk.step()?;
            state.events += u64::from(stepped.events);
            state.stuck += usize::from(stepped.contact == Contact::Stuck);
            state.note(walk);
            for track in &mut state.tracks {
                let system = walk.stepper.system;
                let own = system.moves_as_contact(track.of) && system.scene().stiffness.is_none();
                track.kinks.push(own && stepped.events > 0);
            }
        }
        state.work = walk.stepper.work();
        Ok(state)
    }

    fn note(&mut self, walk: &Walk<'_>) {
        for track in &mut self.tracks {
            let (value, rate) = walk.stepper.motion_of(track.of).unwrap_or_default();
            track.values.push([value, rate]);
        }
        self.forces.push(walk.stepper.contact().force());
    }

    /// Returns the number of periods of the load after which the motion repeats.
    #[must_use]
    pub fn period(&self) -> usize {
        self.period
    }

    /// Returns the Floquet multipliers over a period of the motion, in descending order of their modulus. The
    /// multipliers are the factors by which small deviations change in the period. The code computes them from central
    /// differences, with an error of about 1e-9. If the contact never slides, one multiplier is 1, because the contact
    /// keeps its position.
    #[must_use]
    pub fn multipliers(&self) -> &[Complex<f64>] {
        &self.multipliers
    }

    /// Returns true if every small deviation from the steady state decays, so that all Floquet multipliers lie inside
    /// the unit circle.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.multipliers
            .iter()
            .all(|value| value.norm() < 1.0 - ON_CIRCLE)
    }

    /// Returns the number of stops, break-aways and reversals of the contact in a period of the motion.
    #[must_use]
    pub fn events(&self) -> u64 {
        self.events
    }

    /// Returns the fraction of the period during which the contact sticks. The function counts the steps at whose end
    /// the contact sticks.
    #[must_use]
    pub fn stuck_fraction(&self) -> f64 {
        let steps = self.forces.len().saturating_sub(1).max(1);
        self.stuck as f64 / steps as f64
    }

    /// Returns the work of the load and the energy losses in a period of the motion. The loss in damping is the work of
    /// the load, minus the loss in friction.
    #[must_use]
    pub fn work(&self) -> Work<f64> {
        self.work
    }

    /// Returns the difference between the states at the start and at the end of a period, divided by the size of the
    /// motion.
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.residual
    }

    /// Returns the length of a step of the tracks, in s.
    #[must_use]
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Returns the time at which the tracks begin, in s after the start of the load's period.
    #[must_use]
    pub fn start(&self) -> f64 {
        self.start as f64 * self.step
    }

    /// Returns the requested motions and spring forces over a period.
    #[must_use]
    pub fn tracks(&self) -> &[PeriodicTrack] {
        &self.tracks
    }

    /// Returns the friction force in the contact at the start of each step and at the end of the period, in the
    /// scene's unit of force.
    #[must_use]
    pub fn forces(&self) -> &[f64] {
        &self.forces
    }
}

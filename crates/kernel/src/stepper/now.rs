//! Results of a stepper at the end of the last step: the motion of the masses and of the contact, and the friction
//! force.

use super::cost::Cost;
use super::interval::ROUNDINGS;
use super::law::StepContact;
use super::state::{FixedStore, Store};
use super::table::StepTables;
use super::types::{ContactNow, MassNow, Stepper};
use crate::motion::{Contact, Law, line};
use crate::number::scalar::Float;

impl<S: Float, const D: usize, T: StepTables<S, D>, V: Store<S, D>, K: StepContact<S>>
    Stepper<'_, S, D, T, V, K>
{
    /// Returns the cost of a step, in floating-point operations. With a budget of a few events, the upper bound
    /// [`Cost::most`] is much smaller than without an event budget.
    #[must_use]
    pub fn cost(&self) -> Cost {
        let pace = self.tables.view().pace;
        let extent = self.scene.extent(D, pace.parts, pace.terms);
        Cost::within(&extent, self.status.budget)
    }

    /// Returns the time step of the stepper, in seconds.
    #[must_use]
    pub fn dt(&self) -> S {
        self.tables.view().pace.step
    }

    /// Returns the number of steps that the stepper has taken since its start.
    #[must_use]
    pub fn steps(&self) -> u64 {
        self.status.steps
    }

    /// Returns the time since the start of the stepper, in seconds.
    #[must_use]
    pub fn time(&self) -> S {
        elapsed(self.status.steps, self.dt())
    }

    /// Returns the number of steps in which a sub-interval has reached the bound on events or on pieces of motion.
    #[must_use]
    pub fn exceeded(&self) -> u64 {
        self.status.exceeded
    }

    /// Returns μ, the ratio of the static to the kinetic friction force.
    #[must_use]
    pub fn stiction(&self) -> S {
        self.status.stiction
    }

    /// Returns the state of the contact, determined from its velocity. The velocity is a sum over the modes. A
    /// velocity smaller than the rounding error of this sum counts as zero.
    pub(super) fn direction(&self) -> Contact {
        let [_, velocity] = self.carrying();
        let (mut sum, mut size) = (-velocity, velocity.abs() + self.status.given);
        for (index, mode) in self.scene.dynamics.driven().iter().enumerate() {
            let [_, rate] = self.mode(index);
            let term = mode.contact * rate;
            (sum, size) = (sum + term, size + term.abs());
        }
        if sum.abs() <= size * S::constant(ROUNDINGS * S::EPSILON) {
            Contact::Stuck
        } else {
            Contact::along(sum)
        }
    }

    /// Returns the relative displacement and velocity of the contact, each as a sum over the modes.
    fn contact_sum(&self) -> MassNow<S> {
        let zero = S::constant(0.0);
        let modes = self.scene.dynamics.driven();
        let sum = self.sum(|mode| modes.get(mode).map_or(zero, |mode| mode.contact));
        let [place, velocity] = self.carrying();
        MassNow {
            displacement: sum.displacement - place,
            velocity: sum.velocity - velocity * self.scene.units.rate,
        }
    }

    /// Returns the displacement and velocity of the contact point while the contact sticks, including the motion of the
    /// base. The velocity is the derivative with respect to the non-dimensional time t√(k₁/m₁).
    pub(super) fn lifted(&self) -> (S, S) {
        let [place, velocity] = self.carrying();
        (self.status.stuck_at + place, velocity)
    }

    /// Returns the displacement and velocity of the base on which the contact rubs. The velocity is the derivative with
    /// respect to the non-dimensional time t√(k₁/m₁). If the contact does not rub on a moving base, both numbers are
    /// zero.
    fn carrying(&self) -> [S; 2] {
        if self.scene.rubs_on_base() {
            let [place, velocity] = self.status.base;
            [place, velocity / self.scene.units.rate]
        } else {
            [S::constant(0.0); 2]
        }
    }

    /// Returns the displacement and velocity of a mass at the end of the last step. `index` is the index of the mass in
    /// the scene description. For an invalid index, displacement and velocity are 0.
    #[must_use]
    pub fn mass(&self, index: usize) -> MassNow<S> {
        if self.rests() && self.scene.dynamics.moves_as_contact(index) {
            return MassNow {
                displacement: self.status.stuck_at,
                velocity: S::constant(0.0),
            };
        }
        let shape = self.scene.dynamics.shape(index);
        self.sum(|mode| shape.get(mode).copied().unwrap_or(S::constant(0.0)))
    }

    /// Writes the motions of all masses at the end of the last step to `to`, in the order of the scene description. The
    /// function computes each mode once. The cost of the call is therefore one product of the mode shapes with the
    /// modes ([`Cost::masses`]). The results have the same bits as those of [`mass`](Self::mass). Entries of `to` after
    /// the last mass become motions at rest.
    pub fn read_masses(&self, to: &mut [MassNow<S>]) {
        let zero = S::constant(0.0);
        let dynamics = &self.scene.dynamics;
        to.fill(MassNow {
            displacement: zero,
            velocity: zero,
        });
        for index in 0..dynamics.modes.len() {
            let [y, rate] = self.mode(index);
            let shapes = dynamics.shapes.iter().skip(index);
            let shapes = shapes.step_by(dynamics.modes.len().max(1));
            for (now, shape) in to.iter_mut().zip(shapes) {
                now.displacement = now.displacement + *shape * y;
                now.velocity = now.velocity + *shape * rate;
            }
        }
        for now in &mut *to {
            now.velocity = now.velocity * self.scene.units.rate;
        }
        if self.rests()
            && let Some(index) = dynamics
                .rubbing
                .filter(|index| dynamics.moves_as_contact(*index))
            && let Some(now) = to.get_mut(index)
        {
            now.displacement = self.status.stuck_at;
            now.velocity = zero;
        }
    }

    /// Returns true if the contact is rigid and sticks. An elastic contact moves while it sticks.
    #[inline]
    fn rests(&self) -> bool {
        let rigid = self.scene.dynamics.chain.remembered() == 0;
        rigid && self.status.contact == Contact::Stuck && !self.status.unknown
    }

    /// Returns the displacement and velocity of the base at the end of the last step.
    #[must_use]
    pub fn base(&self) -> MassNow<S> {
        let [displacement, velocity] = self.status.base;
        MassNow {
            displacement,
            velocity,
        }
    }

    /// Returns two weighted sums over the modes: the sum of their displacements and the sum of their velocities.
    /// `weight` returns the weight of the mode with a given index.
    pub(super) fn sum(&self, weight: impl Fn(usize) -> S) -> MassNow<S> {
        let zero = S::constant(0.0);
        let (mut displacement, mut velocity) = (zero, zero);
        for index in 0..self.scene.dynamics.modes.len() {
            let [y, rate] = self.mode(index);
            displacement = displacement + weight(index) * y;
            velocity = velocity + weight(index) * rate;
        }
        MassNow {
            displacement,
            velocity: velocity * self.scene.units.rate,
        }
    }

    /// Returns the displacement of a mode, and its velocity with respect to the non-dimensional time t√(k₁/m₁).
    pub(super) fn mode(&self, index: usize) -> [S; 2] {
        let zero = S::constant(0.0);
        let dynamics = &self.scene.dynamics;
        let store = self.store.read();
        let sticks = self.status.contact == Contact::Stuck && !self.status.unknown;
        let Some(mode) = dynamics.modes.get(index) else {
            return [zero; 2];
        };
        if sticks && index < dynamics.in_contact() {
            let receptance = self.tables.view().pace.receptance;
            let held = store.held.iter().copied();
            let [y, u] = dynamics.released(receptance, held, self.lifted(), index);
            return [y, u * mode.resonance];
        }
        let [y, u] = store.modes.get(index).copied().unwrap_or([zero; 2]);
        [y, u * mode.resonance]
    }

    /// Returns the displacement, velocity, state and friction force of the contact at the end of the last step.
    #[must_use]
    pub fn contact(&self) -> ContactNow<S> {
        let contact = self.status.contact;
        let motion = if self.rests() {
            MassNow {
                displacement: self.status.stuck_at,
                velocity: S::constant(0.0),
            }
        } else {
            self.contact_sum()
        };
        ContactNow {
            motion,
            contact,
            force: self.force(),
        }
    }

    /// Returns the friction force in the contact at the end of the last step, in the scene's unit of force.
    pub(super) fn force(&self) -> S {
        let zero = S::constant(0.0);
        let status = &self.status;
        let force = if status.contact != Contact::Stuck && !status.unknown {
            let line = line(self.scene.law, status.line);
            let slides = !line.slope.is_zero();
            let speed = if slides {
                self.contact_sum().velocity.abs()
            } else {
                zero
            };
            status
                .law(&self.scene)
                .kinetic_at(&line, status.contact, speed)
        } else {
            status.contact_force
        };
        force * self.scene.units.stiffness
    }
}

impl<
    S: Float,
    const D: usize,
    T: StepTables<S, D>,
    const MODES: usize,
    const HELD: usize,
    const INPUTS: usize,
    K: StepContact<S>,
> Stepper<'_, S, D, T, FixedStore<S, D, MODES, HELD, INPUTS>, K>
{
    /// Returns the motions of all masses at the end of the last step, in the order of the scene description. One call
    /// computes each mode once. The call therefore costs about as much as one call of [`mass`](Self::mass) and one
    /// product of the mode shapes with the modes.
    #[must_use]
    pub fn all_masses(&self) -> [MassNow<S>; MODES] {
        let zero = S::constant(0.0);
        let mut masses = [MassNow {
            displacement: zero,
            velocity: zero,
        }; MODES];
        self.read_masses(&mut masses);
        masses
    }
}

/// Returns the duration of `steps` steps of the length `dt`.
pub(crate) fn elapsed<S: Float>(steps: u64, dt: S) -> S {
    // A conversion of 64 bits would need double precision, which a microcontroller emulates slowly. Two conversions of 32
    // bits do not need double precision.
    let [high, low] = [steps >> 32, steps & u64::from(u32::MAX)]
        .map(|half| S::constant(f64::from(u32::try_from(half).unwrap_or(u32::MAX))));
    (high * S::constant(4_294_967_296.0) + low) * dt
}

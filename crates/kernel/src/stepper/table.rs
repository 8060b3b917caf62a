//! Constant tables of a stepper: the response of every oscillator in a sub-interval of the step.

use super::MAX_PARTS;
use super::pace::Pace;
use super::rows::{HeldStep, ModeStep};
use super::scene::StepScene;
use crate::errors::{Given, OutOfDomain, Slice};
use crate::motion::{ContactChain, TERMS, lift};
use crate::number::scalar::Float;

/// Factor by which the first neglected term of a power series is smaller than the rounding unit.
const BELOW_ROUNDING: f64 = 16.0;

/// Coupling of one input with one mode of the chain with its contact stuck.
#[derive(Clone, Copy, Debug)]
pub struct HeldLoad<S> {
    /// Rates of the mode's displacement y and of its scaled velocity u caused by one unit of the input.
    pub drive: [S; 2],
    /// Displacement of the point on which the input acts. The first number is caused by a unit displacement y of the
    /// mode, the second number by a unit scaled velocity u. The code computes the work of the input from these
    /// numbers. For the velocity of the base the numbers have the opposite sign, because damping relative to the base
    /// also acts on the base.
    pub reach: [S; 2],
}

/// Coupling of one input of the stepper with the contact.
#[derive(Clone, Copy, Debug)]
pub struct Channel<S> {
    /// wᵀΓ⁻¹p, the contact's acceleration caused by one unit of the input. w is the direction vector of the contact, Γ
    /// is the mass matrix divided by m₁, and p is the load vector of the input.
    pub acceleration: S,
    /// Displacement of the point on which the input acts, caused by a unit displacement of the stuck contact. The sign
    /// follows the rule of [`HeldLoad::reach`].
    pub lift: S,
}

/// View of a stepper's tables for one scene and one length of the time step.
#[derive(Clone, Copy, Debug)]
pub struct View<'t, S, const D: usize> {
    /// Division of the step into sub-intervals.
    pub pace: Pace<S>,
    /// Tables of all modes of the chain over a sub-interval.
    pub modes: &'t [ModeStep<S, D>],
    /// Tables of the modes of the chain with its contact stuck, over a sub-interval.
    pub held: &'t [HeldStep<S, D>],
    /// Rate of a mode's scaled velocity u caused by one unit of an input, for each mode and input.
    pub loads: &'t [S],
    /// Coupling of each input with each mode of the chain with its contact stuck.
    pub held_loads: &'t [HeldLoad<S>],
    /// Coupling of each input with the contact.
    pub channels: &'t [Channel<S>],
}

impl<'t, S, const D: usize> View<'t, S, D> {
    /// Returns the rate of a mode's scaled velocity u caused by one unit of each input.
    #[inline]
    pub(super) fn loads_of(&self, mode: usize) -> &'t [S] {
        row(self.loads, mode, self.channels.len())
    }

    /// Returns the coupling of each input with a mode of the chain with its contact stuck.
    #[inline]
    pub(super) fn held_loads_of(&self, mode: usize) -> &'t [HeldLoad<S>] {
        row(self.held_loads, mode, self.channels.len())
    }
}

/// Returns the row with the index `index` from a slice. Each row of the slice has `length` entries.
#[inline]
fn row<T>(entries: &[T], index: usize, length: usize) -> &[T] {
    let start = index * length;
    entries.get(start..start + length).unwrap_or_default()
}

/// Storage of a stepper's tables: arrays, constants or vectors.
pub trait StepTables<S, const D: usize> {
    /// Returns a view of all tables of the stepper.
    fn view(&self) -> View<'_, S, D>;
}

/// Tables of a stepper for one scene and one length of the time step, in arrays.
#[derive(Clone, Copy, Debug)]
pub struct FixedTables<
    S,
    const D: usize,
    const MODES: usize,
    const HELD: usize,
    const INPUTS: usize,
> {
    /// Division of the step into sub-intervals.
    pub pace: Pace<S>,
    /// Tables of all modes of the chain over a sub-interval.
    pub modes: [ModeStep<S, D>; MODES],
    /// Tables of the modes of the chain with its contact stuck, over a sub-interval.
    pub held: [HeldStep<S, D>; HELD],
    /// Rate of a mode's scaled velocity u caused by one unit of an input, for each mode and input.
    pub loads: [[S; INPUTS]; MODES],
    /// Coupling of each input with each mode of the chain with its contact stuck.
    pub held_loads: [[HeldLoad<S>; INPUTS]; HELD],
    /// Coupling of each input with the contact.
    pub channels: [Channel<S>; INPUTS],
}

impl<S: Float, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
    FixedTables<S, D, MODES, HELD, INPUTS>
{
    /// Creates the tables of a scene for one length of the time step, in seconds.
    ///
    /// # Errors
    /// The errors of [`fill`].
    pub fn new<K: ContactChain<S>>(
        scene: &StepScene<'_, S, K>,
        step: S,
    ) -> Result<Self, OutOfDomain> {
        let mut tables = Self {
            pace: Pace::zero(),
            modes: [ModeStep::zero(); MODES],
            held: [HeldStep::zero(); HELD],
            loads: [[S::constant(0.0); INPUTS]; MODES],
            held_loads: [[HeldLoad::zero(); INPUTS]; HELD],
            channels: [Channel::zero(); INPUTS],
        };
        tables.pace = fill(
            scene,
            step,
            (&mut tables.modes, &mut tables.held),
            (
                tables.loads.as_flattened_mut(),
                tables.held_loads.as_flattened_mut(),
                &mut tables.channels,
            ),
        )?;
        Ok(tables)
    }
}

impl<S: Float, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
    StepTables<S, D> for FixedTables<S, D, MODES, HELD, INPUTS>
{
    #[inline]
    fn view(&self) -> View<'_, S, D> {
        View {
            pace: self.pace,
            modes: &self.modes,
            held: &self.held,
            loads: self.loads.as_flattened(),
            held_loads: self.held_loads.as_flattened(),
            channels: &self.channels,
        }
    }
}

impl<S, const D: usize, T: StepTables<S, D>> StepTables<S, D> for &T {
    #[inline]
    fn view(&self) -> View<'_, S, D> {
        (**self).view()
    }
}

/// Fills the tables of a scene for one length of the time step, in seconds.
///
/// Each slice must have a fixed number of entries. `modes` has one entry for each mode, and `held` has one entry for
/// each mode of the chain with its contact stuck. `loads` has one entry for each pair of a mode in `modes` and an
/// input. `held_loads` has one entry for each pair of a mode in `held` and an input. `channels` has one entry for each
/// input.
///
/// # Errors
/// [`OutOfDomain::Step`] if the step is not positive and finite, or if the fastest oscillator advances by more than
/// [`MAX_PARTS`] radians in the step. [`OutOfDomain::Length`] if a slice has a wrong length.
pub fn fill<S: Float, const D: usize, K: ContactChain<S>>(
    scene: &StepScene<'_, S, K>,
    step: S,
    (modes, held): (&mut [ModeStep<S, D>], &mut [HeldStep<S, D>]),
    (loads, held_loads, channels): (&mut [S], &mut [HeldLoad<S>], &mut [Channel<S>]),
) -> Result<Pace<S>, OutOfDomain> {
    let dynamics = &scene.dynamics;
    let inputs = scene.channels();
    let fits = modes.len() == dynamics.modes.len()
        && held.len() == dynamics.held.len()
        && loads.len() == modes.len() * inputs
        && held_loads.len() == held.len() * inputs
        && channels.len() == inputs;
    if !fits {
        return Err(OutOfDomain::Length(Slice::StepTables));
    }
    let pace = pace(scene, step)?;
    for (index, (entry, mode)) in modes.iter_mut().zip(dynamics.modes).enumerate() {
        let angle = mode.resonance * pace.span;
        *entry = ModeStep::new(angle, mode.zeta, pace.span / mode.resonance, mode.contact);
        let row = loads.iter_mut().skip(index * inputs).take(inputs);
        for (channel, load) in row.enumerate() {
            *load = scene.load(channel, index) * entry.per_force;
        }
    }
    for (channel, entry) in channels.iter_mut().enumerate() {
        *entry = Channel::zero();
        for (index, mode) in dynamics.driven().iter().enumerate() {
            let load = scene.load(channel, index);
            entry.acceleration = entry.acceleration + mode.contact * load;
            entry.lift = entry.lift + load * lift(mode, pace.receptance);
        }
        if scene.is_base_velocity(channel) {
            entry.lift = -entry.lift;
        }
    }
    let mut entries = held_loads.iter_mut();
    for (entry, (mode, participations)) in held.iter_mut().zip(dynamics.held_modes()) {
        *entry = HeldStep::new(mode.frequency * pace.span, mode.zeta, mode.force);
        let zero = S::constant(0.0);
        for (channel, load) in entries.by_ref().take(inputs).enumerate() {
            let mut reach = [zero; 2];
            for (index, [g, h]) in participations.iter().enumerate() {
                let of = scene.load(channel, index);
                reach = [reach[0] + *g * of, reach[1] + *h * of];
            }
            let (first, second) = mode.state(reach[0], reach[1]);
            if scene.is_base_velocity(channel) {
                reach = reach.map(|reach| -reach);
            }
            *load = HeldLoad {
                drive: [first * pace.span, second * pace.span],
                reach,
            };
        }
        if scene.rubs_on_base() {
            let two = S::constant(2.0);
            let mut sums = [[zero; 2]; 2];
            for (driven, [g, h]) in dynamics.driven().iter().zip(participations) {
                let lift = lift(driven, pace.receptance);
                let loss = two * driven.zeta * driven.resonance * lift;
                sums = [
                    [sums[0][0] - *g * loss, sums[0][1] - *h * loss],
                    [sums[1][0] - *g * lift, sums[1][1] - *h * lift],
                ];
            }
            let [velocity, acceleration] = sums.map(|[first, second]| mode.state(first, second));
            let inverse = S::constant(1.0) / pace.span;
            entry.from_base = [
                [velocity.0, velocity.1],
                [acceleration.0 * inverse, acceleration.1 * inverse],
            ];
        }
    }
    Ok(pace)
}

/// Returns the number of terms that a power series over a sub-interval needs. `rate` is the angle by which the fastest
/// oscillator advances in the sub-interval, at most 1 rad. The neglected terms are smaller than a sixteenth of the
/// rounding unit `epsilon`.
#[must_use]
pub fn series_terms<S: Float>(rate: S, epsilon: f64) -> u32 {
    let one = S::constant(1.0);
    let (mut terms, mut order, mut size) = (0, one, one);
    while terms < TERMS && S::constant(epsilon / BELOW_ROUNDING) < size {
        size = size * rate / order;
        (terms, order) = (terms + 1, order + one);
    }
    u32::try_from(terms).unwrap_or(u32::MAX)
}

/// Divides a step of the stepper into sub-intervals. Returns an error if the length of the step is outside its
/// permitted range.
fn pace<S: Float, K: ContactChain<S>>(
    scene: &StepScene<'_, S, K>,
    step: S,
) -> Result<Pace<S>, OutOfDomain> {
    let (zero, one, two) = (S::constant(0.0), S::constant(1.0), S::constant(2.0));
    let dynamics = &scene.dynamics;
    let rate = scene.turning();
    let whole = step * scene.units.rate;
    let (_, most) = S::inverse_ratio_range();
    let angle = rate * whole;
    let short = zero < step && zero < whole && one / most < angle;
    if !(short && angle <= S::constant(f64::from(MAX_PARTS))) {
        return Err(OutOfDomain::Step(Given::of(step)));
    }
    let mut parts = 1;
    while S::constant(f64::from(parts)) < angle {
        parts += 1;
    }
    let span = whole / S::constant(f64::from(parts));
    let rate = rate * span;
    let mut drag = zero;
    for mode in dynamics.driven() {
        drag = drag + two * mode.zeta * mode.contact_squared / mode.resonance;
    }
    let mut receptance = dynamics.receptance();
    if 0 < dynamics.chain.remembered() {
        receptance = receptance + dynamics.chain.compliance();
    }
    Ok(Pace {
        step,
        parts,
        span,
        rate,
        terms: series_terms(rate, S::EPSILON),
        receptance,
        drag: drag / receptance,
    })
}

impl<S: Float> HeldLoad<S> {
    /// Returns a table entry whose numbers are all 0. The code uses it to initialise arrays.
    #[must_use]
    pub fn zero() -> Self {
        let zero = S::constant(0.0);
        Self {
            drive: [zero; 2],
            reach: [zero; 2],
        }
    }
}

impl<S: Float> Channel<S> {
    /// Returns a table entry whose numbers are all 0. The code uses it to initialise arrays.
    #[must_use]
    pub fn zero() -> Self {
        Self {
            acceleration: S::constant(0.0),
            lift: S::constant(0.0),
        }
    }
}

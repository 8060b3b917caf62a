//! Energy balance of a stepper: the work of the loads and of the base, and the dissipated and stored energy.
//!
//! The friction dissipates ∫ f ż dt over all contacts, minus the increase of the energy f²/2k in the springs of elastic
//! contacts. This sum contains what a contact loses when it breaks away. The tables contain rows for the integrals over
//! a sub-interval that inputs with slopes need: ∫ t ẋ dt for a load, ∫ t ż dt for a contact, and ∫ R dt, ∫ t R dt and
//! ∫ t² R dt for the force R of the base on the chain.

use super::Stepper;
use super::table::Layout;
use crate::Float;
use crate::joints::base::Curve;
use crate::joints::cycle::{integral, work};
use crate::joints::least::dot;
use crate::joints::model::Model;
use crate::joints::poly::{Poly, nothing, value};
use crate::joints::run::Motion;
use crate::joints::series::Series;
use crate::joints::size::{Size, at, sign};
use crate::joints::state::{FREE, STUCK, State};
use crate::motion::Total;
use crate::stepper::{Input, Work};

/// Sums of work since the start.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sums<S> {
    /// Work of the loads and of the base.
    pub load: Total<S>,
    /// Work that the contacts take from the chain: ∫ f ż dt.
    pub contacts: Total<S>,
    /// Stored energy at the start.
    pub stored: S,
}

impl<S: Float> Sums<S> {
    pub(super) const fn zero(zero: S) -> Self {
        Self {
            load: Total::of_parts([zero; 2]),
            contacts: Total::of_parts([zero; 2]),
            stored: zero,
        }
    }

    pub(super) fn add_load(&mut self, work: S) {
        self.load = self.load.plus(work);
    }

    pub(super) fn add_contact(&mut self, work: S) {
        self.contacts = self.contacts.plus(work);
    }

    /// Adds the work over a stretch, from the power series of the motion.
    pub(super) fn follow<Z: Size>(
        &mut self,
        model: &Model<S, Z>,
        series: &Series<S, Z>,
        end: S,
        state: &State<S, Z>,
    ) {
        let (start, length) = (series.start, series.length);
        let moved = |terms: &Poly<S>| {
            let later = series.used_of(terms).get(1..);
            end * value(later.unwrap_or_default(), end)
        };
        for (mass, load) in model.loads.as_ref() {
            let done = if load.slope.is_zero() && load.amplitude.is_zero() {
                load.constant * moved(&series.displacement_terms(*mass))
            } else {
                let force = load.terms(start, length, 0);
                let speed = series.velocity_terms(*mass);
                work(series.used_of(&force), series.used_of(&speed), length, end)
            };
            self.add_load(done);
        }
        if !model.base.is_zero() {
            let speed = model.base.terms(start, length, 1);
            let force = reaction(model, state, series);
            let (speed, force) = (series.used_of(&speed), series.used_of(&force));
            self.add_load(work(speed, force, length, end));
        }
        for (j, contact) in model.contacts().iter().enumerate() {
            let sides = contact.sides();
            let speed = model.speed(j);
            if !speed.is_zero() {
                // The moving surface works on the chain, too.
                let force = integral(&series.force_terms(j), end);
                self.add_load(-speed * length * force);
            }
            match (state.phase(j), contact.stiffness) {
                (FREE, _) | (STUCK, None) => {}
                (STUCK, Some(stiffness)) => {
                    let [from, to] = [S::constant(0.0), end].map(|end| series.force(j, end));
                    self.add_contact(stored((from, to), stiffness));
                }
                (side, _) if contact.has_constant_level() && !model.has_lines(contact) => {
                    let slid = moved(&series.place_terms(sides.plus, sides.minus));
                    let slid = slid - speed * length * end;
                    self.add_contact(sign::<S>(side) * contact.level.constant * slid);
                }
                _ => {
                    let ends = (sides.plus, sides.minus);
                    self.add_contact(series.work(j, (ends, speed), end));
                }
            }
        }
    }
}

/// Returns the energy that the spring of an elastic contact gains while its force changes from `from` to `to`.
fn stored<S: Float>((from, to): (S, S), stiffness: S) -> S {
    (to - from) * (to + from) / (stiffness + stiffness)
}

/// Returns the power series of the force of the base on the chain.
pub(super) fn reaction<S: Float, Z: Size>(
    model: &Model<S, Z>,
    state: &State<S, Z>,
    series: &Series<S, Z>,
) -> Poly<S> {
    let base = model.base_node();
    let (x, v) = series.nodes();
    let mut force = nothing();
    let mut add = |terms: &Poly<S>, factor: S| {
        for (sum, term) in force.iter_mut().zip(series.used_of(terms)) {
            *sum = *sum + factor * *term;
        }
    };
    let springs = model.springs.as_ref().iter().map(|link| (link, x));
    let dashpots = model.dashpots.as_ref().iter().map(|link| (link, v));
    for ((plus, minus, value), nodes) in springs.chain(dashpots) {
        let side = match (*plus == base, *minus == base) {
            (true, false) => *value,
            (false, true) => -*value,
            _ => continue,
        };
        for (node, factor) in [(*plus, side), (*minus, -side)] {
            nodes
                .get(node)
                .into_iter()
                .for_each(|terms| add(terms, factor));
        }
    }
    if model.damping_from_base {
        for row in model.damping_rows() {
            for (coefficient, terms) in row.iter().zip(v) {
                add(terms, -*coefficient);
                v.get(base)
                    .into_iter()
                    .for_each(|base| add(base, *coefficient));
            }
        }
    }
    for (j, contact) in model.contacts().iter().enumerate() {
        let side = match (contact.plus == base, contact.minus == base) {
            (true, false) => S::constant(1.0),
            (false, true) => S::constant(-1.0),
            _ => continue,
        };
        if state.phase(j) != FREE {
            add(&series.force_terms(j), side);
        }
    }
    force
}

/// Returns the integrals ∫ tⁿ q dt of a power series over the whole sub-interval, for the power n in `power`.
pub(super) fn moment<S: Float>(terms: &Poly<S>, power: usize, length: S) -> S {
    let scale = core::iter::repeat_n(length, power + 1).fold(S::constant(1.0), |a, b| a * b);
    let terms = terms.iter().enumerate().rev();
    let sum = terms.fold(S::constant(0.0), |sum, (order, term)| {
        sum + *term / S::whole(order + power + 1)
    });
    scale * sum
}

/// Rows of a table for the work in a sub-interval: those of the loads, of the contacts, and of the base.
pub(super) struct Moments<'t, S> {
    pub rows: &'t [S],
    pub layout: &'t Layout,
    /// Increments of the displacements of the masses.
    pub moved: &'t [S],
    /// Increment of the displacement of the base.
    pub moved_base: S,
}

impl<S: Float> Moments<'_, S> {
    /// Adds the work in a sub-interval that starts at the instant `time`. The two slices are the coordinates at its start,
    /// and displacements, velocities and forces at its end.
    pub(super) fn add<Z: Size>(
        &self,
        sums: &mut Sums<S>,
        motion: &Motion<S, Z>,
        time: S,
        (before, after): (&[S], &[S]),
    ) {
        let (model, state) = (motion.model(), motion.state());
        let layout = self.layout;
        let is_linear = layout.input == Input::Linear;
        let mut rows = self.rows.chunks_exact(before.len().max(1));
        let mut moment = || dot(rows.next().unwrap_or_default(), before);
        for (mass, load) in model.loads.as_ref() {
            let later = if is_linear {
                load.slope * moment()
            } else {
                S::constant(0.0)
            };
            sums.add_load((load.constant + load.slope * time) * at(self.moved, *mass) + later);
        }
        for (j, contact) in model.contacts().iter().enumerate() {
            let later = if is_linear {
                contact.level.slope * moment()
            } else {
                S::constant(0.0)
            };
            match (state.phase(j), contact.stiffness) {
                (FREE, _) | (STUCK, None) => {}
                (STUCK, Some(stiffness)) => {
                    let force = 2 * layout.masses + j;
                    sums.add_contact(stored((at(before, force), at(after, force)), stiffness));
                }
                (side, _) => {
                    let slid = contact.relative(self.moved, self.moved_base);
                    let level = contact.level.value(time, 0);
                    sums.add_contact(sign::<S>(side) * (level * slid + later));
                }
            }
        }
        if layout.on_base {
            let [_, speed, square, cube] = model.base.about(time);
            let mut work = speed * moment();
            if is_linear {
                let (two, three) = (S::constant(2.0), S::constant(3.0));
                work = work + two * square * moment() + three * cube * moment();
            }
            sums.add_load(work);
        }
    }
}

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Returns the energy balance of the chain since the start, in the scene's unit of force times its unit of length.
    pub fn work(&self) -> Work<S> {
        let sums = &self.status.work;
        let [springs, contacts] = self.energies();
        let stored = springs + contacts - sums.stored;
        let load = sums.load.value;
        let friction = -sums.contacts.short_of(contacts);
        Work {
            load,
            friction,
            damping: load - friction - stored,
            stored,
        }
    }

    /// Returns the kinetic energy plus that of the springs, and the energy of the springs of elastic contacts.
    pub(super) fn energies(&self) -> [S; 2] {
        let (model, state) = (self.motion.model(), self.motion.state());
        let half = S::constant(0.5);
        let (mut x, _) = state.nodes(model, self.motion.time());
        let masses = model.masses().iter().zip(state.v.as_ref());
        let kinetic = masses.fold(S::constant(0.0), |sum, (m, v)| sum + half * *m * *v * *v);
        let x = x.as_mut();
        let springs = model.springs.as_ref().iter();
        let springs = springs.fold(kinetic, |sum, (plus, minus, k)| {
            let strain = at(x, *plus) - at(x, *minus);
            sum + half * *k * strain * strain
        });
        let forces = self.motion.forces();
        let contacts = model.contacts().iter().zip(forces.as_ref()).enumerate();
        let contacts = contacts.fold(S::constant(0.0), |sum, (j, (contact, force))| {
            let spring = at(state.forces.as_ref(), j);
            let force = if model.is_stop(j) { &spring } else { force };
            let energy = contact.stiffness.map(|k| half * *force * *force / k);
            sum + energy.unwrap_or(S::constant(0.0))
        });
        [springs, contacts]
    }

    /// Starts the sums of work at the present instant.
    pub(super) fn restart_work(&mut self) {
        let zero = S::constant(0.0);
        let [springs, contacts] = self.energies();
        self.status.work = Sums {
            contacts: Total::of_parts([contacts, zero]),
            stored: springs + contacts,
            ..Sums::zero(zero)
        };
    }

    /// Changes the motion of the base by a jump, and counts the energy that the springs gain as work of the base.
    pub(super) fn jolt(&mut self, to: Curve<S>) -> Result<(), crate::errors::Halt> {
        let [springs, contacts] = self.energies();
        self.motion.jolt_base(to)?;
        let [springs_after, contacts_after] = self.energies();
        let gained = contacts_after - contacts;
        self.status.work.add_load(springs_after - springs + gained);
        self.status.work.add_contact(gained);
        Ok(())
    }
}

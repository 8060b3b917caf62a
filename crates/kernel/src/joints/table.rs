//! Tables that advance a motion by one whole stretch in which no contact changes its phase.
//!
//! Between events the motion is linear in its *coordinates*: those of a deviation (displacements, velocities and
//! contact forces), and two coordinates a cos θ and a sin θ for each load and for the base, where θ = ωt + φ. The
//! table of a stretch is the power series of the motion for each coordinate equal to 1 and all others equal to 0. Its sum
//! is a matrix that advances the coordinates by the stretch, or by a fraction of it. The same series gives the first
//! coefficients of each watched quantity: the relative velocity of a contact that slides, and the force of one that
//! sticks.

use super::least::dot;
use super::model::{Contact, Model};
use super::poly::{Poly, angle_of, nothing, terms_of};
use super::rates::{Unit, UnitMotion};
use super::roots::{QUICK, stays_above};
use super::run::{Observe, next_event};
use super::series::Series;
use super::size::{Size, add, at, set, sign};
use super::state::{FREE, STUCK, State};
use super::tree::Tree;
use super::wave::Wave;
use crate::Float;

/// Tables of a motion, one for each set of sticking contacts.
pub trait Tables<S: Float, Z: Size>: Clone + core::fmt::Debug {
    /// A table of the storage.
    type Found: AsRef<Table<S, Z>>;

    /// Makes the motion use tables from now on. `coordinates` has one entry for each coordinate, and `matrix` is a square
    /// matrix of them.
    fn enable(&mut self, coordinates: Z::Cells<S>, matrix: Z::Cells<S>);
    /// Takes the table with the given key. If the storage has none, it keeps the result of `make`. Returns `None` if
    /// the motion uses no tables.
    fn take(&mut self, key: u64, make: impl FnOnce() -> Table<S, Z>) -> Option<Self::Found>;
    /// Keeps a table for the next call of [`take`](Self::take) with the same key.
    fn keep(&mut self, found: Self::Found);
    /// Forgets the table that [`keep`](Self::keep) has received, because the set of sticking contacts changes.
    fn change(&mut self);
    /// Returns the memory for a stretch.
    fn room(&mut self) -> &mut Room<Z::Cells<S>>;
}

/// Memory for a stretch: the coordinates at its start and at its end, and a matrix that maps the first to the second.
#[derive(Clone, Copy, Debug, Default)]
pub struct Room<C> {
    pub(super) before: C,
    pub(super) after: C,
    pub(super) matrix: C,
}

impl<S> Room<[S; 0]> {
    /// Memory of a motion without tables.
    pub(super) const EMPTY: Self = Self {
        before: [],
        after: [],
        matrix: [],
    };
}

/// A storage without tables, for emitted code.
#[derive(Clone, Copy, Debug)]
pub struct NoTables<C>(pub(super) Room<C>);

impl<S: Float, Z: Size> Tables<S, Z> for NoTables<Z::Cells<S>> {
    type Found = Table<S, Z>;

    fn enable(&mut self, _: Z::Cells<S>, _: Z::Cells<S>) {}

    fn take(&mut self, _: u64, _: impl FnOnce() -> Table<S, Z>) -> Option<Table<S, Z>> {
        None
    }

    fn keep(&mut self, _: Table<S, Z>) {}

    fn change(&mut self) {}

    fn room(&mut self) -> &mut Room<Z::Cells<S>> {
        &mut self.0
    }
}

/// Table of one set of sticking contacts, for one duration of a stretch.
#[derive(Clone, Debug)]
pub struct Table<S: Float, Z: Size> {
    /// Number of coordinates of a deviation.
    width: usize,
    /// Number of all coordinates.
    count: usize,
    /// Matrix that advances all coordinates by the stretch, row by row.
    whole: Z::Cells<S>,
    /// The coefficients of this matrix as a power series of the elapsed fraction of the stretch: a matrix for each order.
    orders: Z::Cells<S>,
    /// Accelerations of the masses, one row for each mass.
    accelerations: Z::Cells<S>,
    /// Forces of the rigid contacts that stick, one row for each contact.
    holds: Z::Cells<S>,
    /// Stiffness of each elastic contact that sticks and whose force changes, otherwise 0.
    stiffnesses: Z::Contacts<S>,
    /// Angular frequencies of the loads and of the base.
    omegas: Z::Cells<S>,
    /// Power series of the watched quantities: a row for each coefficient of each contact.
    watched: Z::Cells<S>,
    /// For each contact, a row whose product with the absolute values of the coordinates is a bound on the sum of the
    /// coefficients from the order [`QUICK`] on.
    tails: Z::Cells<S>,
}

/// A stretch that a table has advanced: the coordinates of the motion at both ends.
pub struct Leap<'t, S: Float, Z: Size> {
    pub(super) table: &'t Table<S, Z>,
    /// Matrix that maps the coordinates at the start to those at the end, row by row.
    pub(super) matrix: &'t [S],
    /// Coordinates at the start of the stretch.
    pub(super) before: &'t [S],
    /// Coordinates at the end of the stretch.
    pub(super) after: &'t [S],
    /// State at the end of the stretch. The phases of the contacts are those during the stretch.
    pub(super) state: &'t State<S, Z>,
    /// True if the stretch has its full duration.
    pub(super) is_whole: bool,
}

impl<S: Float, Z: Size> Leap<'_, S, Z> {
    /// Passes the stretch to an observer, as a power series if the observer needs one. `start` is the instant at which the
    /// stretch starts, and `fraction` its duration over that of a whole stretch.
    pub(super) fn show<W: Observe<S, Z>>(
        &self,
        model: &Model<S, Z>,
        (start, fraction): (S, S),
        watch: &mut W,
    ) {
        if !W::NEEDS_SERIES {
            watch.leap(self);
            return;
        }
        let series = self.table.series(model, start, self.before);
        watch.follow(model, &series, fraction, self.state);
        watch.stretch(&series, fraction, self.state);
    }

    /// Returns the relative displacement of a contact between two nodes, at the start and at the end of the stretch.
    pub(super) fn places(&self, (plus, minus): (usize, usize)) -> (S, S) {
        let masses = self.state.x.as_ref().len();
        let place = |coordinates: &[S]| {
            let [plus, minus] =
                [plus, minus].map(|node| self.table.place(masses, node, coordinates));
            plus - minus
        };
        (place(self.before), place(self.after))
    }
}

impl<S: Float, Z: Size> Model<S, Z> {
    /// Returns the functions of time that act on the chain: the loads, then the displacement of the base.
    fn waves(&self) -> impl Iterator<Item = &Wave<S>> {
        let loads = self.loads.as_ref().iter().map(|(_, wave)| wave);
        loads.chain([&self.base.wave])
    }

    /// Returns the number of coordinates of a deviation: 2N + M.
    pub(super) fn width(&self) -> usize {
        2 * self.wall() + self.contacts().len()
    }

    /// Returns the number of coordinates of a motion.
    pub(super) fn coordinates(&self) -> usize {
        self.width() + 2 * (self.loads.as_ref().len() + 1)
    }

    /// Returns true if tables can advance the motion: all loads and the base are harmonic, and the friction of no
    /// contact changes with time or speed.
    pub(super) fn has_tables(&self) -> bool {
        let steady = |wave: &Wave<S>| wave.constant.is_zero() && wave.slope.is_zero();
        self.contacts().len() <= 64
            && self.waves().all(steady)
            && !self.base.bends()
            && self.contacts().iter().all(Contact::has_constant_level)
            && self.law.as_ref().is_empty()
            && !self.has_stops()
            && !self.has_belts()
    }

    /// Writes the coordinates of a motion at an instant.
    pub(super) fn write_coordinates(&self, state: &State<S, Z>, time: S, into: &mut [S]) {
        let deviation = state.x.as_ref().iter().chain(state.v.as_ref());
        let contacts = self.contacts().iter().enumerate();
        let forces = contacts.map(|(j, contact)| match state.phase(j) {
            FREE => S::constant(0.0),
            STUCK if contact.is_rigid() => S::constant(0.0),
            STUCK => at(state.forces.as_ref(), j),
            side => sign::<S>(side) * contact.level.constant,
        });
        let waves = self.waves().flat_map(|wave| wave.quadrature(time));
        let values = deviation.copied().chain(forces).chain(waves);
        for (entry, value) in into.iter_mut().zip(values) {
            *entry = value;
        }
    }
}

impl<S: Float, Z: Size> AsRef<Self> for Table<S, Z> {
    fn as_ref(&self) -> &Self {
        self
    }
}

impl<S: Float, Z: Size> Table<S, Z> {
    /// Computes the table for the phases in `state`. `tree` contains the trees of the rigid contacts that stick.
    pub(super) fn new(model: &Model<S, Z>, state: &State<S, Z>, tree: &Tree<S, Z>) -> Self {
        Builder::new(model, state, tree).table()
    }

    /// Returns the acceleration of each mass as a row of all coordinates.
    pub(super) fn accelerations(&self) -> impl Iterator<Item = &[S]> {
        self.accelerations.as_ref().chunks_exact(self.count.max(1))
    }

    /// Returns the force of a rigid contact that sticks as a row of all coordinates.
    pub(super) fn hold(&self, contact: usize) -> &[S] {
        let hold = self.holds.as_ref().get(contact * self.count..);
        hold.and_then(|row| row.get(..self.count))
            .unwrap_or_default()
    }

    /// Returns the matrix that advances the coordinates by a fraction of the stretch. `room` has the size of the matrix.
    pub(super) fn matrix<'r>(&'r self, fraction: S, room: &'r mut [S]) -> &'r [S] {
        if fraction == S::constant(1.0) {
            return self.whole.as_ref();
        }
        let size = room.len();
        room.fill(S::constant(0.0));
        for order in (0..orders_of(fraction)).rev() {
            let terms = self.orders.as_ref().get(order * size..(order + 1) * size);
            for (entry, term) in room.iter_mut().zip(terms.unwrap_or_default()) {
                *entry = fraction * *entry + *term;
            }
        }
        room
    }

    /// Returns the power series of the motion over a whole stretch that starts at the instant `start`.
    fn series(&self, model: &Model<S, Z>, start: S, before: &[S]) -> Series<S, Z> {
        let mut series = Series::nothing(model, (start, model.stretch));
        let mut term = model.size.cells(self.count, S::constant(0.0));
        let mut raised = term.clone();
        for (term, value) in term.as_mut().iter_mut().zip(before) {
            *term = *value;
        }
        let mut forces = model.size.contacts(S::constant(0.0));
        for order in 0..terms_of::<S>() {
            let terms = term.as_ref();
            for (j, force) in forces.as_mut().iter_mut().enumerate() {
                *force = self.force(model, (j, terms));
            }
            let base = [
                self.place(model.wall(), model.base_node(), terms),
                self.speed(model, model.base_node(), terms),
            ];
            series.put(order, terms, (base, forces.as_ref()));
            self.rates(model, terms, raised.as_mut());
            let next = model.stretch / S::whole(order + 1);
            for (term, rate) in term.as_mut().iter_mut().zip(raised.as_ref()) {
                *term = next * *rate;
            }
        }
        series
    }

    /// Writes the derivatives of the coordinates with respect to time.
    pub(super) fn rates(&self, model: &Model<S, Z>, coordinates: &[S], rates: &mut [S]) {
        let masses = model.wall();
        let (places, rest) = rates.split_at_mut_checked(masses).unwrap_or_default();
        let (speeds, rest) = rest.split_at_mut_checked(masses).unwrap_or_default();
        let forces = model.contacts().len();
        let (forces, waves) = rest.split_at_mut_checked(forces).unwrap_or_default();
        let velocities = coordinates.get(masses..).unwrap_or_default();
        for (rate, velocity) in places.iter_mut().zip(velocities) {
            *rate = *velocity;
        }
        for (rate, row) in speeds.iter_mut().zip(self.accelerations()) {
            *rate = dot(row, coordinates);
        }
        let contacts = model.contacts().iter().zip(self.stiffnesses.as_ref());
        for (rate, (contact, stiffness)) in forces.iter_mut().zip(contacts) {
            *rate = if stiffness.is_zero() {
                *stiffness
            } else {
                let speed = |node| self.speed(model, node, coordinates);
                *stiffness * (speed(contact.plus) - speed(contact.minus))
            };
        }
        let values = coordinates.get(self.width..).unwrap_or_default();
        let (rates, values) = (waves.as_chunks_mut::<2>().0, values.as_chunks::<2>().0);
        for ((rate, [cosine, sine]), omega) in
            rates.iter_mut().zip(values).zip(self.omegas.as_ref())
        {
            *rate = [-*omega * *sine, *omega * *cosine];
        }
    }

    /// Returns the displacement of a node from the coordinates of a motion.
    fn place(&self, masses: usize, node: usize, coordinates: &[S]) -> S {
        match node.checked_sub(masses) {
            None => at(coordinates, node),
            Some(0) => S::constant(0.0),
            // The displacement of the base is a cos θ, the second last coordinate.
            Some(_) => at(coordinates, self.count.saturating_sub(2)),
        }
    }

    /// Returns the velocity of a node from the coordinates of a motion, or its acceleration from their derivatives.
    fn speed(&self, model: &Model<S, Z>, node: usize, coordinates: &[S]) -> S {
        let masses = model.wall();
        match node.checked_sub(masses) {
            None => at(coordinates, masses + node),
            Some(0) => S::constant(0.0),
            // The velocity of the base is −ω a sin θ, and a sin θ is the last coordinate.
            Some(_) => -model.base.wave.omega * at(coordinates, self.count.saturating_sub(1)),
        }
    }

    /// Returns the force of a contact. The coordinate of a rigid contact is 0 while it sticks, and its row of holding forces
    /// is 0 while it slides.
    pub(super) fn force(&self, model: &Model<S, Z>, (j, coordinates): (usize, &[S])) -> S {
        let own = at(coordinates, 2 * model.wall() + j);
        match model.contact(j) {
            Some(contact) if contact.is_rigid() => own + dot(self.hold(j), coordinates),
            _ => own,
        }
    }

    /// Returns the derivative of the watched quantity of a contact. `rates` contains those of the coordinates.
    pub(super) fn slope(
        &self,
        model: &Model<S, Z>,
        state: &State<S, Z>,
        (j, rates): (usize, &[S]),
    ) -> S {
        let Some(contact) = model.contact(j) else {
            return S::constant(0.0);
        };
        if state.phase(j) == STUCK {
            return self.force(model, (j, rates));
        }
        self.speed(model, contact.plus, rates) - self.speed(model, contact.minus, rates)
    }

    /// Returns the power series of the watched quantity of a contact: its relative velocity while it slides, its force
    /// while it sticks.
    fn watched(&self, j: usize, coordinates: &[S]) -> Poly<S> {
        let mut terms = nothing();
        for (term, row) in terms.iter_mut().zip(self.watched_rows(j)) {
            *term = dot(row, coordinates);
        }
        terms
    }

    fn watched_rows(&self, j: usize) -> impl Iterator<Item = &[S]> {
        let size = terms_of::<S>() * self.count;
        let rows = self.watched.as_ref().get(j * size..(j + 1) * size);
        rows.unwrap_or_default().chunks_exact(self.count.max(1))
    }

    /// Returns the next event of each contact in a stretch, as [`next_event`] does. `start` contains the instant at which
    /// the stretch starts, and its duration.
    pub(super) fn next_events(
        &self,
        (model, state): (&Model<S, Z>, &State<S, Z>),
        coordinates: &[S],
        start: (S, S),
    ) -> Z::Contacts<Option<(S, i8)>> {
        let mut roots = model.size.contacts(None);
        for (j, root) in roots.as_mut().iter_mut().enumerate() {
            if !self.is_quiet(model, state, (j, coordinates)) {
                let watched = self.watched(j, coordinates);
                *root = next_event(model, state, (j, &watched), start);
            }
        }
        roots
    }

    /// Returns true if the contact `j` cannot change its phase during the stretch.
    fn is_quiet(
        &self,
        model: &Model<S, Z>,
        state: &State<S, Z>,
        (j, coordinates): (usize, &[S]),
    ) -> bool {
        let phase = state.phase(j);
        let Some(contact) = model.contact(j).filter(|_| phase != FREE) else {
            return true;
        };
        let mut low = [S::constant(0.0); QUICK];
        for (term, row) in low.iter_mut().zip(self.watched_rows(j)) {
            *term = dot(row, coordinates);
        }
        let sizes = self.tails.as_ref().chunks_exact(self.count.max(1)).nth(j);
        let sizes = sizes.unwrap_or_default().iter().zip(coordinates);
        let tail = sizes.fold(S::constant(0.0), |sum, (size, u)| sum + *size * u.abs());
        let (zeros, zero_side) = state.zeros.as_ref().get(j).copied().unwrap_or_default();
        if phase != STUCK {
            return stays_above(
                without(zeros, low.map(|term| sign::<S>(phase) * term)),
                tail,
            );
        }
        [1, -1].into_iter().all(|side: i8| {
            let mut margin = low.map(|term| -sign::<S>(side) * term);
            add(&mut margin, 0, contact.stiction * contact.level.constant);
            let zeros = if side == zero_side { zeros } else { 0 };
            stays_above(without(zeros, margin), tail)
        })
    }
}

/// Multiplies a square matrix, stored row by row, by the coordinates `before`.
pub(super) fn advance<S: Float>(matrix: &[S], before: &[S], after: &mut [S]) {
    let rows = matrix.chunks_exact(before.len().max(1));
    for (entry, row) in after.iter_mut().zip(rows) {
        *entry = dot(row, before);
    }
}

/// Returns the number of coefficients that a power series needs up to a fraction of a stretch.
fn orders_of<S: Float>(fraction: S) -> usize {
    let (ratio, mut size) = (S::constant(angle_of::<S>()) * fraction, S::constant(1.0));
    for order in 1..terms_of::<S>() {
        if size < S::constant(0.1 * S::EPSILON) {
            return order;
        }
        size = size * ratio / S::whole(order);
    }
    terms_of::<S>()
}

/// Divides a polynomial by a power of its variable. The first `zeros` coefficients are 0.
fn without<S: Float>(zeros: usize, terms: [S; QUICK]) -> [S; QUICK] {
    let mut divided = [S::constant(0.0); QUICK];
    for (entry, term) in divided.iter_mut().zip(terms.iter().skip(zeros)) {
        *entry = *term;
    }
    divided
}

/// Adds the product of a row and a factor to another row.
pub(super) fn add_row<S: Float>(sum: &mut [S], row: &[S], factor: S) {
    for (sum, value) in sum.iter_mut().zip(row) {
        *sum = *sum + factor * *value;
    }
}

/// Computes a table: sums the power series of all coordinates.
struct Builder<'m, S: Float, Z: Size> {
    model: &'m Model<S, Z>,
    state: &'m State<S, Z>,
    count: usize,
    /// Accelerations of the masses, one row of all coordinates for each mass.
    accelerations: Z::Cells<S>,
    /// Forces of the rigid contacts that stick, one row for each contact.
    holds: Z::Cells<S>,
    /// Stiffness of each elastic contact that sticks and whose force changes, otherwise 0. The force does not change if
    /// rigid contacts hold the two nodes together. Rounding would else move it beyond its limit.
    stiffnesses: Z::Contacts<S>,
    /// Coefficients of one order: one row for each coordinate, one column for each initial coordinate.
    term: Z::Cells<S>,
    /// Coefficients of the next order.
    raised: Z::Cells<S>,
}

impl<'m, S: Float, Z: Size> Builder<'m, S, Z> {
    fn new(model: &'m Model<S, Z>, state: &'m State<S, Z>, tree: &Tree<S, Z>) -> Self {
        let zero = S::constant(0.0);
        let (masses, contacts) = (model.wall(), model.contacts().len());
        let count = model.coordinates();
        let cells = |rows: usize| model.size.cells(rows * count, zero);
        let mut builder = Self {
            model,
            state,
            count,
            accelerations: cells(masses),
            holds: cells(contacts),
            stiffnesses: model.size.contacts(zero),
            term: cells(count),
            raised: cells(count),
        };
        for (j, contact) in model.contacts().iter().enumerate() {
            let stiffness = contact.stiffness.filter(|_| state.phase(j) == STUCK);
            if let Some(stiffness) = stiffness.filter(|_| !tree.connects(contact)) {
                set(builder.stiffnesses.as_mut(), j, stiffness);
            }
        }
        let mut unit = UnitMotion::new(model, state, tree);
        for column in 0..count {
            let Some(coordinate) = builder.unit(column) else {
                continue;
            };
            unit.solve(zero, coordinate);
            let rows = [
                (builder.accelerations.as_mut(), unit.accelerations.as_ref()),
                (builder.holds.as_mut(), unit.holds.as_ref()),
            ];
            for (rows, values) in rows {
                for (row, value) in rows.chunks_exact_mut(count).zip(values) {
                    set(row, column, *value);
                }
            }
        }
        builder
    }

    /// Returns what acts on the chain if only the coordinate with this index is 1. Returns `None` if nothing does.
    fn unit(&self, column: usize) -> Option<Unit<S>> {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let model = self.model;
        let Some(wave) = column.checked_sub(model.width()) else {
            return Some(Unit::of_deviation(model, column));
        };
        let is_cosine = wave % 2 == 0;
        if wave / 2 < model.loads.as_ref().len() {
            return is_cosine.then_some(Unit::Load(wave / 2));
        }
        let omega = model.base.wave.omega;
        Some(if is_cosine {
            Unit::Base {
                x: one,
                v: zero,
                a: -omega * omega,
            }
        } else {
            Unit::Base {
                x: zero,
                v: -omega,
                a: zero,
            }
        })
    }

    fn table(mut self) -> Table<S, Z> {
        let (zero, one) = (S::constant(0.0), S::constant(1.0));
        let (model, count) = (self.model, self.count);
        for index in 0..count {
            set(self.term.as_mut(), index * count + index, one);
        }
        let mut whole = model.size.cells(count * count, zero);
        let contacts = model.contacts().len();
        let terms = terms_of::<S>();
        let mut orders = model.size.cells(terms * count * count, zero);
        let mut watched = model.size.cells(contacts * terms * count, zero);
        let mut tails = model.size.cells(contacts * count, zero);
        for order in 0..terms {
            for (sum, term) in whole.as_mut().iter_mut().zip(self.term.as_ref()) {
                *sum = *sum + *term;
            }
            let mut matrices = orders.as_mut().chunks_exact_mut((count * count).max(1));
            let matrix = matrices.nth(order).unwrap_or_default();
            for (entry, term) in matrix.iter_mut().zip(self.term.as_ref()) {
                *entry = *term;
            }
            let rows = watched.as_mut().chunks_exact_mut(terms * count);
            let tails = tails.as_mut().chunks_exact_mut(count);
            for (j, (rows, tail)) in rows.zip(tails).enumerate() {
                let row = rows.chunks_exact_mut(count).nth(order);
                let row = row.unwrap_or_default();
                self.watch(j, row);
                for (sum, value) in tail.iter_mut().zip(row).filter(|_| order >= QUICK) {
                    *sum = *sum + value.abs();
                }
            }
            self.raise(model.stretch / S::whole(order + 1));
        }
        let mut omegas = model.size.cells(model.waves().count(), zero);
        for (omega, wave) in omegas.as_mut().iter_mut().zip(model.waves()) {
            *omega = wave.omega;
        }
        Table {
            width: model.width(),
            count,
            omegas,
            whole,
            orders,
            accelerations: self.accelerations,
            holds: self.holds,
            stiffnesses: self.stiffnesses,
            watched,
            tails,
        }
    }

    /// Writes the coefficients of the watched quantity of a contact: its relative velocity while it slides, its force
    /// while it sticks.
    fn watch(&self, j: usize, row: &mut [S]) {
        let Some(contact) = self.model.contact(j) else {
            return;
        };
        // The row of a contact without friction is that of a contact that slides, so that both have the same table.
        match self.state.phase(j) {
            STUCK if contact.is_rigid() => {
                let hold = self.holds.as_ref().chunks_exact(self.count).nth(j);
                self.combine(hold.unwrap_or_default(), row);
            }
            STUCK => add_row(
                row,
                self.coordinate(2 * self.model.wall() + j),
                S::constant(1.0),
            ),
            _ => self.add_speed(j, S::constant(1.0), row),
        }
    }

    /// Returns the coefficients of one coordinate.
    fn coordinate(&self, index: usize) -> &[S] {
        let row = self
            .term
            .as_ref()
            .get(index * self.count..(index + 1) * self.count);
        row.unwrap_or_default()
    }

    /// Adds the coefficients of a linear function of the coordinates.
    fn combine(&self, factors: &[S], sum: &mut [S]) {
        let rows = self.term.as_ref().chunks_exact(self.count);
        for (factor, row) in factors
            .iter()
            .zip(rows)
            .filter(|(factor, _)| !factor.is_zero())
        {
            add_row(sum, row, *factor);
        }
    }

    /// Adds the coefficients of the relative velocity of a contact, times `factor`.
    fn add_speed(&self, j: usize, factor: S, sum: &mut [S]) {
        let Some(contact) = self.model.contact(j) else {
            return;
        };
        let masses = self.model.wall();
        for (node, factor) in [(contact.plus, factor), (contact.minus, -factor)] {
            if node < masses {
                add_row(sum, self.coordinate(masses + node), factor);
            } else if node == self.model.base_node() {
                let omega = self.model.base.wave.omega;
                add_row(sum, self.coordinate(self.count - 1), -omega * factor);
            }
        }
    }

    /// Replaces the coefficients by those of the next order. `next` is the duration of the stretch over the order.
    fn raise(&mut self, next: S) {
        let (model, count, zero) = (self.model, self.count, S::constant(0.0));
        let masses = model.wall();
        let mut raised = core::mem::replace(&mut self.raised, model.size.cells(0, zero));
        raised.as_mut().fill(zero);
        for (index, row) in raised.as_mut().chunks_exact_mut(count).enumerate() {
            if index < masses {
                add_row(row, self.coordinate(masses + index), next);
            } else if index < 2 * masses {
                let rates = self.accelerations.as_ref().chunks_exact(count);
                self.combine(
                    rates.take(masses).nth(index - masses).unwrap_or_default(),
                    row,
                );
                for entry in row.iter_mut() {
                    *entry = next * *entry;
                }
            } else if index < model.width() {
                let j = index - 2 * masses;
                let stiffness = at(self.stiffnesses.as_ref(), j);
                if !stiffness.is_zero() {
                    self.add_speed(j, next * stiffness, row);
                }
            } else {
                let wave = index - model.width();
                let omega = model.waves().nth(wave / 2).map_or(zero, |wave| wave.omega);
                // The derivatives of a cos θ and a sin θ are −ω a sin θ and ω a cos θ.
                if wave % 2 == 0 {
                    add_row(row, self.coordinate(index + 1), -next * omega);
                } else {
                    add_row(row, self.coordinate(index - 1), next * omega);
                }
            }
        }
        self.raised = core::mem::replace(&mut self.term, raised);
    }
}

//! Tables that advance a motion by one whole stretch in which no contact changes its phase.
//!
//! Between events the motion is linear in its *coordinates*: those of a deviation (displacements, velocities and
//! contact forces), and two coordinates a cos θ and a sin θ for each load and for the base, where θ = ωt + φ. The
//! table of a stretch is the power series of the motion for each coordinate equal to 1 and all others equal to 0. Its sum
//! is a matrix that advances the coordinates by the stretch. The same series gives the coefficients of each watched
//! quantity: the relative velocity of a contact that slides, and the force of one that sticks. The power series of one
//! motion advances its coordinates by a fraction of the stretch.

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

/// A table, and the memory for a stretch.
pub type Found<'t, S, Z> = (&'t Table<S, Z>, &'t mut Room<<Z as Size>::Coordinates<S>>);

/// Tables of a search, one for each set of sticking contacts.
pub trait Tables<S: Float, Z: Size>: core::fmt::Debug {
    /// Returns the table with the given key, and the memory for a stretch. If the storage has no such table, it keeps the
    /// result of `make`. Returns `None` if the search uses no tables.
    fn find(&mut self, key: u64, make: impl FnOnce() -> Table<S, Z>) -> Option<Found<'_, S, Z>>;
}

/// Memory for a stretch: the coordinates at its start and at its end, and two coefficients of their power series.
#[derive(Clone, Debug)]
pub struct Room<C> {
    pub(super) before: C,
    pub(super) after: C,
    pub(super) term: C,
    pub(super) raised: C,
}

impl<C: Clone> Room<C> {
    pub(super) fn new(zeros: C) -> Self {
        Self {
            before: zeros.clone(),
            after: zeros.clone(),
            term: zeros.clone(),
            raised: zeros,
        }
    }
}

/// Storage of a motion that advances by power series alone.
#[derive(Clone, Copy, Debug)]
pub struct NoTables;

impl<S: Float, Z: Size> Tables<S, Z> for NoTables {
    fn find(&mut self, _: u64, _: impl FnOnce() -> Table<S, Z>) -> Option<Found<'_, S, Z>> {
        None
    }
}

/// A storage that may be missing.
impl<S: Float, Z: Size, T: Tables<S, Z>> Tables<S, Z> for Option<T> {
    fn find(&mut self, key: u64, make: impl FnOnce() -> Table<S, Z>) -> Option<Found<'_, S, Z>> {
        self.as_mut()?.find(key, make)
    }
}

/// Storage of emitted code: at most `KEPT` tables. A further table replaces the oldest.
#[derive(Clone, Debug)]
pub struct LastTables<S: Float, Z: Size, const KEPT: usize> {
    tables: [Option<(u64, Table<S, Z>)>; KEPT],
    /// Index of the oldest table.
    oldest: usize,
    room: Room<Z::Coordinates<S>>,
}

impl<S: Float, Z: Size, const KEPT: usize> LastTables<S, Z, KEPT> {
    pub(super) fn new(size: &Z) -> Self {
        Self {
            tables: [const { None }; KEPT],
            oldest: 0,
            room: Room::new(size.coordinates(0, S::constant(0.0))),
        }
    }
}

impl<S: Float, Z: Size, const KEPT: usize> Tables<S, Z> for LastTables<S, Z, KEPT> {
    fn find(&mut self, key: u64, make: impl FnOnce() -> Table<S, Z>) -> Option<Found<'_, S, Z>> {
        let mut kept = self.tables.iter();
        let is_found = |kept: &Option<(u64, _)>| kept.as_ref().is_some_and(|(own, _)| *own == key);
        let index = match kept.position(is_found) {
            Some(index) => index,
            None => {
                let index = self.oldest;
                *self.tables.get_mut(index)? = Some((key, make()));
                self.oldest = if index + 1 < KEPT { index + 1 } else { 0 };
                index
            }
        };
        let (_, table) = self.tables.get(index)?.as_ref()?;
        Some((table, &mut self.room))
    }
}

/// Table of one set of sticking contacts, for one duration of a stretch.
#[derive(Clone, Debug)]
pub struct Table<S: Float, Z: Size> {
    /// Number of coordinates of a deviation.
    width: usize,
    /// Number of all coordinates.
    count: usize,
    /// Blocks of rows with one entry for each coordinate, in the order of [`Block`].
    rows: Z::Rows<S>,
    /// Stiffness of each elastic contact that sticks and whose force changes, otherwise 0. The force does not change if
    /// rigid contacts hold the two nodes together. Rounding would else move it beyond its limit.
    stiffnesses: Z::Contacts<S>,
}

/// A block of rows in a table.
#[derive(Clone, Copy)]
enum Block {
    /// Matrix that advances all coordinates by the stretch.
    Whole,
    /// Angular frequencies of the loads and of the base, in one row.
    Frequencies,
    /// Accelerations of the masses: a row for each mass.
    Accelerations,
    /// Forces of the rigid contacts that stick: a row for each contact.
    Holds,
    /// For each contact, two rows whose products with the absolute values of the coordinates are bounds on sums of
    /// absolute coefficients: from the order 1 on, and from the order [`QUICK`] on.
    Tails,
    /// Power series of the watched quantities: a row for each coefficient of each contact.
    Watched,
}

impl Block {
    /// Returns the index of the first row. The table has the given numbers of coordinates, masses and contacts.
    const fn first(self, [count, masses, contacts]: [usize; 3]) -> usize {
        let accelerations = count + 1;
        let holds = accelerations + masses;
        match self {
            Self::Whole => 0,
            Self::Frequencies => count,
            Self::Accelerations => accelerations,
            Self::Holds => holds,
            Self::Tails => holds + contacts,
            Self::Watched => holds + 3 * contacts,
        }
    }
}

/// Returns the number of rows of a table with the given numbers of coordinates, masses and contacts, and of coefficients
/// of a power series.
const fn rows_of(counts: [usize; 3], terms: usize) -> usize {
    Block::Watched.first(counts) + counts[2] * terms
}

/// Returns the numbers of coordinates and of rows of a table for a chain with the given numbers of masses, contacts and
/// waves. A wave is a load, or the motion of the base. `S` is the number type.
#[must_use]
pub fn table_sizes<S: Float>([masses, contacts, waves]: [usize; 3]) -> [usize; 2] {
    let count = 2 * masses + contacts + 2 * waves;
    [count, rows_of([count, masses, contacts], terms_of::<S>())]
}

/// A stretch that a table has advanced: the coordinates of the motion at both ends.
pub struct Leap<'t, S: Float, Z: Size> {
    pub(super) table: &'t Table<S, Z>,
    pub(super) model: &'t Model<S, Z>,
    /// Duration of the stretch.
    pub(super) length: S,
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
    pub(super) fn show<W: Observe<S, Z>>(&self, (start, fraction): (S, S), watch: &mut W) {
        if !W::NEEDS_SERIES {
            watch.leap(self);
            return;
        }
        let series = self.table.series(self.model, start, self.before);
        watch.follow(self.model, &series, fraction, self.state);
        watch.stretch(&series, fraction, self.state);
    }

    /// Returns the relative displacement of a contact between two nodes, at the start and at the end of the stretch.
    pub(super) fn places(&self, (plus, minus): (usize, usize)) -> (S, S) {
        let place = |coordinates: &[S]| {
            let [plus, minus] =
                [plus, minus].map(|node| self.table.place(self.model, node, coordinates));
            plus - minus
        };
        (place(self.before), place(self.after))
    }
}

impl<S: Float, Z: Size> Model<S, Z> {
    /// Returns the functions of time that act on the chain: the loads, then the displacement of a base that moves.
    fn waves(&self) -> impl Iterator<Item = &Wave<S>> {
        let loads = self.loads.as_ref().iter().map(|(_, wave)| wave);
        loads.chain(self.base_moves().then_some(&self.base.wave))
    }

    /// Returns true if the displacement of the base is a coordinate.
    fn base_moves(&self) -> bool {
        !self.base.wave.omega.is_zero()
    }

    /// Returns the number of coordinates of a deviation: 2N + M.
    pub(super) fn width(&self) -> usize {
        2 * self.wall() + self.contacts().len()
    }

    /// Returns the number of coordinates of a motion.
    pub(super) fn coordinates(&self) -> usize {
        self.width() + 2 * self.waves().count()
    }

    /// Returns true if tables can advance the motion: all loads and the base are harmonic, and the friction of no
    /// contact changes with time or speed.
    pub(super) fn has_tables(&self) -> bool {
        let steady = |wave: &Wave<S>| wave.constant.is_zero() && wave.slope.is_zero();
        self.contacts().len() <= 64
            && self.waves().all(steady)
            && (self.base_moves() || self.base.is_zero())
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

impl<S: Float, Z: Size> Table<S, Z> {
    /// Computes the table for the phases in `state`. `tree` contains the trees of the rigid contacts that stick.
    pub(super) fn new(model: &Model<S, Z>, state: &State<S, Z>, tree: &Tree<S, Z>) -> Self {
        Builder::new(model, state, tree).table()
    }

    fn counts(&self) -> [usize; 3] {
        let contacts = self.stiffnesses.as_ref().len();
        [self.count, (self.width - contacts) / 2, contacts]
    }

    /// Returns the rows of a block from the given row on, one after the other. Rows of further blocks follow.
    fn block(&self, block: Block, row: usize) -> &[S] {
        let first = block.first(self.counts()) + row;
        let rows = self.rows.as_ref().get(first * self.count..);
        rows.unwrap_or_default()
    }

    fn block_mut(&mut self, block: Block, row: usize) -> &mut [S] {
        let first = block.first(self.counts()) + row;
        let rows = self.rows.as_mut().get_mut(first * self.count..);
        rows.unwrap_or_default()
    }

    fn row(&self, block: Block, row: usize) -> &[S] {
        let row = self.block(block, row).get(..self.count);
        row.unwrap_or_default()
    }

    /// Returns the matrix that advances the coordinates by the whole stretch, row by row.
    pub(super) fn whole(&self) -> &[S] {
        let matrix = self.rows.as_ref().get(..self.count * self.count);
        matrix.unwrap_or_default()
    }

    /// Returns the acceleration of each mass as a row of all coordinates.
    pub(super) fn accelerations(&self) -> impl Iterator<Item = &[S]> {
        let [_, masses, _] = self.counts();
        let rows = self.block(Block::Accelerations, 0);
        rows.chunks_exact(self.count.max(1)).take(masses)
    }

    /// Returns the force of a rigid contact that sticks as a row of all coordinates.
    pub(super) fn hold(&self, contact: usize) -> &[S] {
        self.row(Block::Holds, contact)
    }

    /// Advances the coordinates in `room` by a fraction of the stretch.
    pub(super) fn advance(
        &self,
        model: &Model<S, Z>,
        fraction: S,
        room: &mut Room<Z::Coordinates<S>>,
    ) {
        let (before, after) = (room.before.as_ref(), room.after.as_mut());
        if fraction == S::constant(1.0) {
            let rows = self.whole().chunks_exact(self.count.max(1));
            for (entry, row) in after.iter_mut().zip(rows) {
                *entry = dot(row, before);
            }
            return;
        }
        copy(after, before);
        copy(room.term.as_mut(), before);
        for order in 1..orders_of(fraction) {
            let terms = (room.term.as_mut(), room.raised.as_mut());
            self.raise(model, fraction * model.stretch / S::whole(order), terms);
            let after = room.after.as_mut().iter_mut();
            for (sum, term) in after.zip(room.term.as_ref()) {
                *sum = *sum + *term;
            }
        }
    }

    /// Replaces the coefficients of a power series by those of the next order. `next` is the duration of the stretch over
    /// the order, and `rates` is working memory.
    fn raise(&self, model: &Model<S, Z>, next: S, (term, rates): (&mut [S], &mut [S])) {
        self.rates(model, term, rates);
        for (term, rate) in term.iter_mut().zip(rates) {
            *term = next * *rate;
        }
    }

    /// Returns the power series of the motion over a whole stretch that starts at the instant `start`.
    fn series(&self, model: &Model<S, Z>, start: S, before: &[S]) -> Series<S, Z> {
        let mut series = Series::nothing(model, (start, model.stretch));
        let mut term = model.size.coordinates(self.count, S::constant(0.0));
        let mut raised = term.clone();
        copy(term.as_mut(), before);
        let mut forces = model.size.contacts(S::constant(0.0));
        for order in 0..terms_of::<S>() {
            let terms = term.as_ref();
            for (j, force) in forces.as_mut().iter_mut().enumerate() {
                *force = self.force(model, (j, terms));
            }
            let base = [
                self.place(model, model.base_node(), terms),
                self.speed(model, model.base_node(), terms),
            ];
            series.put(order, terms, (base, forces.as_ref()));
            let next = model.stretch / S::whole(order + 1);
            self.raise(model, next, (term.as_mut(), raised.as_mut()));
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
        let omegas = self.row(Block::Frequencies, 0);
        for ((rate, [cosine, sine]), omega) in rates.iter_mut().zip(values).zip(omegas) {
            *rate = [-*omega * *sine, *omega * *cosine];
        }
    }

    /// Returns the displacement of a node from the coordinates of a motion.
    fn place(&self, model: &Model<S, Z>, node: usize, coordinates: &[S]) -> S {
        match node.checked_sub(model.wall()) {
            None => at(coordinates, node),
            // The displacement of the base is a cos θ, the second last coordinate.
            Some(1) if model.base_moves() => at(coordinates, self.count.saturating_sub(2)),
            Some(_) => S::constant(0.0),
        }
    }

    /// Returns the velocity of a node from the coordinates of a motion, or its acceleration from their derivatives.
    fn speed(&self, model: &Model<S, Z>, node: usize, coordinates: &[S]) -> S {
        let masses = model.wall();
        match node.checked_sub(masses) {
            None => at(coordinates, masses + node),
            // The velocity of the base is −ω a sin θ, and a sin θ is the last coordinate.
            Some(1) if model.base_moves() => {
                -model.base.wave.omega * at(coordinates, self.count.saturating_sub(1))
            }
            Some(_) => S::constant(0.0),
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
        let rows = self.block(Block::Watched, j * terms_of::<S>());
        let rows = rows.chunks_exact(self.count.max(1));
        rows.take(terms_of::<S>())
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
        let (zeros, zero_side) = state.zeros.as_ref().get(j).copied().unwrap_or_default();
        let sizes = |row: usize| {
            let sizes = self.row(Block::Tails, row).iter().zip(coordinates);
            sizes.fold(S::constant(0.0), |sum, (size, u)| sum + *size * u.abs())
        };
        let limit = contact.stiction * contact.level.constant;
        let first = dot(self.row(Block::Watched, j * terms_of::<S>()), coordinates);
        // The margin, 1e-3 times the first coefficient, is far larger than rounding errors.
        let margin = |value: S| S::constant(1.0 - 1e-3) * value;
        if zeros == 0 {
            let least = if phase == STUCK {
                limit - first.abs()
            } else {
                sign::<S>(phase) * first
            };
            if margin(least) > sizes(2 * j) {
                return true;
            }
        }
        let mut low = [first; QUICK];
        let rows = self.watched_rows(j).skip(1);
        for (term, row) in low.iter_mut().skip(1).zip(rows) {
            *term = dot(row, coordinates);
        }
        let tail = sizes(2 * j + 1);
        if phase != STUCK {
            let low = low.map(|term| sign::<S>(phase) * term);
            return stays_above(without(zeros, low), tail);
        }
        [1, -1].into_iter().all(|side: i8| {
            let mut margin = low.map(|term| -sign::<S>(side) * term);
            add(&mut margin, 0, limit);
            let zeros = if side == zero_side { zeros } else { 0 };
            stays_above(without(zeros, margin), tail)
        })
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

/// Copies numbers. Slices of different lengths cause no panic.
fn copy<S: Float>(to: &mut [S], from: &[S]) {
    for (to, from) in to.iter_mut().zip(from) {
        *to = *from;
    }
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
    table: Table<S, Z>,
    /// Coefficients of one order: one row for each coordinate, one column for each initial coordinate.
    term: Z::Matrix<S>,
    /// Coefficients of the next order.
    raised: Z::Matrix<S>,
}

impl<'m, S: Float, Z: Size> Builder<'m, S, Z> {
    fn new(model: &'m Model<S, Z>, state: &'m State<S, Z>, tree: &Tree<S, Z>) -> Self {
        let zero = S::constant(0.0);
        let (masses, contacts) = (model.wall(), model.contacts().len());
        let count = model.coordinates();
        let rows = rows_of([count, masses, contacts], terms_of::<S>());
        let mut table: Table<S, Z> = Table {
            width: model.width(),
            count,
            rows: model.size.rows(rows * count, zero),
            stiffnesses: model.size.contacts(zero),
        };
        for (j, contact) in model.contacts().iter().enumerate() {
            let stiffness = contact.stiffness.filter(|_| state.phase(j) == STUCK);
            if let Some(stiffness) = stiffness.filter(|_| !tree.connects(contact)) {
                set(table.stiffnesses.as_mut(), j, stiffness);
            }
        }
        let omegas = table.block_mut(Block::Frequencies, 0).iter_mut();
        for (omega, wave) in omegas.zip(model.waves()) {
            *omega = wave.omega;
        }
        let mut builder = Self {
            model,
            state,
            count,
            table,
            term: model.size.matrix(count, zero),
            raised: model.size.matrix(count, zero),
        };
        let mut unit = UnitMotion::new(model, state, tree);
        for column in 0..count {
            let Some(coordinate) = builder.unit(column) else {
                continue;
            };
            unit.solve(zero, coordinate);
            let values = [
                (Block::Accelerations, unit.accelerations.as_ref(), masses),
                (Block::Holds, unit.holds.as_ref(), contacts),
            ];
            for (block, values, rows) in values {
                let block = builder
                    .table
                    .block_mut(block, 0)
                    .chunks_exact_mut(count.max(1));
                for (row, value) in block.zip(values).take(rows) {
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
        let one = S::constant(1.0);
        let (model, count) = (self.model, self.count);
        for index in 0..count {
            set(self.term.as_mut(), index * count + index, one);
        }
        let terms = terms_of::<S>();
        let mut row = model.size.coordinates(count, one);
        for order in 0..terms {
            let whole = self.table.block_mut(Block::Whole, 0).iter_mut();
            for (sum, term) in whole.zip(self.term.as_ref()) {
                *sum = *sum + *term;
            }
            for j in 0..model.contacts().len() {
                let row = row.as_mut();
                row.fill(S::constant(0.0));
                self.watch(j, row);
                let kept = self.table.block_mut(Block::Watched, j * terms + order);
                for (kept, value) in kept.iter_mut().zip(row.iter()) {
                    *kept = *value;
                }
                for (tail, first) in [(2 * j, 1), (2 * j + 1, QUICK)] {
                    let tail = self.table.block_mut(Block::Tails, tail).iter_mut();
                    for (sum, value) in tail.zip(row.iter()).filter(|_| order >= first) {
                        *sum = *sum + value.abs();
                    }
                }
            }
            self.raise(model.stretch / S::whole(order + 1));
        }
        self.table
    }

    /// Writes the coefficients of the watched quantity of a contact: its relative velocity while it slides, its force
    /// while it sticks.
    fn watch(&self, j: usize, row: &mut [S]) {
        let Some(contact) = self.model.contact(j) else {
            return;
        };
        // The row of a contact without friction is that of a contact that slides, so that both have the same table.
        match self.state.phase(j) {
            STUCK if contact.is_rigid() => self.combine(self.table.hold(j), row),
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
        let rows = self.term.as_ref().chunks_exact(self.count.max(1));
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
            } else if node == self.model.base_node() && self.model.base_moves() {
                let omega = self.model.base.wave.omega;
                add_row(sum, self.coordinate(self.count - 1), -omega * factor);
            }
        }
    }

    /// Replaces the coefficients by those of the next order. `next` is the duration of the stretch over the order.
    fn raise(&mut self, next: S) {
        let (model, count, zero) = (self.model, self.count, S::constant(0.0));
        let masses = model.wall();
        let mut raised = core::mem::replace(&mut self.raised, model.size.matrix(0, zero));
        raised.as_mut().fill(zero);
        for (index, row) in raised.as_mut().chunks_exact_mut(count.max(1)).enumerate() {
            if index < masses {
                add_row(row, self.coordinate(masses + index), next);
            } else if index < 2 * masses {
                let rates = self.table.row(Block::Accelerations, index - masses);
                self.combine(rates, row);
                for entry in row.iter_mut() {
                    *entry = next * *entry;
                }
            } else if index < model.width() {
                let j = index - 2 * masses;
                let stiffness = at(self.table.stiffnesses.as_ref(), j);
                if !stiffness.is_zero() {
                    self.add_speed(j, next * stiffness, row);
                }
            } else {
                let wave = index - model.width();
                let omega = at(self.table.row(Block::Frequencies, 0), wave / 2);
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

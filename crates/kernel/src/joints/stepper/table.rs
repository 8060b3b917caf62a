//! Tables that advance a stepper by one sub-interval in which no contact changes its phase.
//!
//! Between events the motion is linear in its *coordinates*: the displacements and velocities of the masses, the forces
//! of the contacts, and the coefficients of the inputs, which are polynomials over a sub-interval. A *pattern* is a set
//! of sticking contacts. The table of a pattern contains a row of coordinates for each result: the increments of
//! displacements and velocities, for each contact six rows from which `leap` proves that it has no event, and rows for
//! the work. One column of the table is the power series of the motion for one coordinate equal to 1 and all others equal
//! to 0.

use super::Pace;
use super::shears::{Shears, has_shears};
use super::work::{moment, reaction};
use crate::Float;
use crate::joints::base::Curve;
use crate::joints::model::Model;
use crate::joints::poly::Poly;
use crate::joints::series::Series;
use crate::joints::size::{Size, add, at, set};
use crate::joints::state::{STUCK, State};
use crate::joints::tree::Tree;
use crate::joints::wave::Wave;
use crate::stepper::Input;

/// Largest number of contacts in a scene whose stepper uses tables. A scene of M contacts has 2^M patterns.
pub const MAX_TABLE_CONTACTS: usize = 4;
/// Largest number of entries in the tables of a stepper. With more entries the stepper uses power series only.
pub const MAX_TABLE_ENTRIES: usize = 4096;

/// Number of rows of a contact: a bound on the change of its watched quantity in the sub-interval, its derivative at both
/// ends, a bound on its difference from a cubic polynomial, and the quantity at both ends.
pub(super) const ROWS: usize = 6;

/// Numbers of coordinates and rows in the tables of a stepper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Layout {
    /// Number of masses.
    pub masses: usize,
    /// Number of contacts.
    pub contacts: usize,
    /// Number of loads.
    pub loads: usize,
    /// Interpolation of the inputs between two samples.
    pub input: Input,
    /// True if the base moves.
    pub on_base: bool,
    /// True if the free motion advances by shears, which keep the energy of an undamped chain in `f32`.
    pub shears: bool,
    /// True if the chain has dashpots or a damping matrix.
    pub damped: bool,
    /// Numbers of coordinates, of those in the rows of the increments, and of entries of the shears.
    lengths: [usize; 3],
}

impl Layout {
    /// Returns the layout for the given numbers of masses, contacts and loads. The last argument contains the fields
    /// `on_base`, `shears` and `damped`.
    #[must_use]
    pub const fn new(
        (masses, contacts, loads): (usize, usize, usize),
        input: Input,
        [on_base, shears, damped]: [bool; 3],
    ) -> Self {
        let mut layout = Self {
            masses,
            contacts,
            loads,
            input,
            on_base,
            shears,
            damped,
            lengths: [0; 3],
        };
        let (load, base, friction) = layout.coefficients();
        let coordinates = 2 * masses + (1 + friction) * contacts + load * loads + base;
        // Shears give the effect of the motion of an undamped chain, so that its rows contain only forces and inputs.
        let skipped = if shears && !damped { 2 * masses } else { 0 };
        let sheared = if shears {
            masses * (2 * masses + contacts)
        } else {
            0
        };
        layout.lengths = [coordinates, coordinates - skipped, sheared];
        layout
    }

    /// Returns the layout of a chain and the pace of its stepper.
    pub fn of<S: Float, Z: Size>(model: &Model<S, Z>, pace: &Pace<S>) -> Self {
        let counts = (
            model.wall(),
            model.contacts().len(),
            model.loads.as_ref().len(),
        );
        let properties = [pace.on_base, has_shears::<S>(), model.is_damped()];
        Self::new(counts, pace.input, properties)
    }

    /// Returns the properties beside the numbers of masses, contacts and loads as a number.
    #[must_use]
    pub const fn properties(&self) -> usize {
        let is_linear = matches!(self.input, Input::Linear);
        is_linear as usize
            | (self.on_base as usize) << 1
            | (self.shears as usize) << 2
            | (self.damped as usize) << 3
    }

    /// Returns the layout with the given numbers of masses, contacts and loads, and with the given
    /// [`properties`](Self::properties).
    #[must_use]
    pub const fn of_properties(counts: (usize, usize, usize), properties: usize) -> Self {
        let input = if properties & 1 == 0 {
            Input::Hold
        } else {
            Input::Linear
        };
        let is = [
            properties & 2 != 0,
            properties & 4 != 0,
            properties & 8 != 0,
        ];
        Self::new(counts, input, is)
    }

    /// Returns the numbers of coefficients of a load, of the base, and of the change of a contact's friction force.
    #[inline]
    const fn coefficients(&self) -> (usize, usize, usize) {
        let (load, base, friction) = match self.input {
            Input::Hold => (1, 2, 0),
            Input::Linear => (2, 4, 1),
        };
        (load, if self.on_base { base } else { 0 }, friction)
    }

    /// Returns the number of coordinates.
    #[inline]
    #[must_use]
    pub const fn coordinates(&self) -> usize {
        self.lengths[0]
    }

    /// Returns the number of the last coordinates that the rows of the increments contain.
    #[inline]
    pub(super) const fn width(&self) -> usize {
        self.lengths[1]
    }

    /// Returns the number of rows for the work: one for each load and contact with linear input, and one for each
    /// coefficient of the velocity of the base.
    pub(super) const fn moments(&self) -> usize {
        let (_, base, friction) = self.coefficients();
        let base = if self.on_base { base - 1 } else { 0 };
        friction * (self.loads + self.contacts) + base
    }

    /// Returns the number of entries in the table of one pattern.
    const fn table(&self) -> usize {
        let rows = ROWS * self.contacts + self.moments();
        self.sheared() + self.increments() + rows * self.coordinates()
    }

    /// Returns the number of entries of the shears: a matrix for the velocities, and one for displacements and forces.
    #[inline]
    const fn sheared(&self) -> usize {
        self.lengths[2]
    }

    /// Returns the number of entries in the rows of the increments of displacements and velocities.
    #[inline]
    const fn increments(&self) -> usize {
        2 * self.masses * self.width()
    }

    /// Returns the number of entries in the tables of all patterns. It is 0 for a scene of more than
    /// [`MAX_TABLE_CONTACTS`] contacts, and where the tables would have more than [`MAX_TABLE_ENTRIES`] entries.
    #[must_use]
    pub const fn entries(&self) -> usize {
        if self.contacts > MAX_TABLE_CONTACTS {
            return 0;
        }
        let entries = self.table() << self.contacts;
        if entries > MAX_TABLE_ENTRIES {
            0
        } else {
            entries
        }
    }

    /// Returns the parts of the table of one pattern.
    #[inline]
    pub(super) fn rows<'t, S>(&self, tables: &'t [S], pattern: u64) -> Option<Rows<'t, S>> {
        // All patterns have tables of the same length.
        let length = tables.len() >> self.contacts;
        let start = length.checked_mul(usize::try_from(pattern).ok()?)?;
        let table = tables.get(start..start + length)?;
        let (shears, table) = table.split_at_checked(self.sheared())?;
        let (increments, table) = table.split_at_checked(self.increments())?;
        let (contacts, moments) =
            table.split_at_checked(ROWS * self.contacts * self.coordinates())?;
        Some(Rows {
            shears,
            increments,
            contacts,
            moments,
        })
    }
}

/// Parts of the table of one pattern.
pub(super) struct Rows<'t, S> {
    /// Matrices of the shears.
    pub shears: &'t [S],
    /// Rows of the increments of all displacements, then of all velocities.
    pub increments: &'t [S],
    /// The rows of each contact, [`ROWS`] in number.
    pub contacts: &'t [S],
    /// Rows for the work.
    pub moments: &'t [S],
}

/// Computes the tables of all patterns for the length `part` of a sub-interval. `tables` has the length
/// [`Layout::entries`]. A shorter slice stays empty.
pub fn fill<S: Float, Z: Size>(model: &Model<S, Z>, part: S, layout: &Layout, tables: &mut [S]) {
    let (table, count) = (layout.table().max(1), layout.coordinates().max(1));
    let width = layout.width().max(1);
    if tables.len() < layout.entries() {
        return;
    }
    for (pattern, table) in tables.chunks_exact_mut(table).enumerate() {
        let sticks = |contact: usize| pattern >> contact & 1 == 1;
        let tree = Tree::new(model, sticks);
        let parts = table.split_at_mut_checked(layout.sheared());
        let (shears, rows) = parts.unwrap_or_default();
        let parts = rows.split_at_mut_checked(layout.increments());
        let (gains, rows) = parts.unwrap_or_default();
        let mut shears = layout.shears.then(|| Shears::new(layout, shears));
        for column in 0..count {
            let (model, state) = unit(model, layout, (sticks, column));
            let time = (S::constant(0.0), part);
            let series = Series::new(&model, &state, &tree, time);
            let place = (column + width).checked_sub(count);
            let entries = || place.into_iter().flat_map(|place| (place..).step_by(width));
            for (entry, value) in entries().zip(increments(&model, &series)) {
                set(gains, entry, value);
            }
            let values = column_of(layout, &model, &state, &series);
            let others = rows.iter_mut().skip(column).step_by(count);
            for (entry, value) in others.zip(values) {
                *entry = value;
            }
            if let Some(shears) = &mut shears {
                let undamped = model.undamped();
                let free = Series::new(&undamped, &state, &tree, time);
                if shears.add(column, (&undamped, &state, &free)) {
                    for (entry, free) in entries().zip(increments(&undamped, &free)) {
                        add(gains, entry, -free);
                    }
                }
            }
        }
        if let Some(shears) = shears {
            shears.finish(model, &tree, (gains, width));
        }
    }
}

/// Returns the entries of one column in the rows of the contacts and of the work, from the power series of the motion.
fn column_of<S: Float, Z: Size>(
    layout: &Layout,
    model: &Model<S, Z>,
    state: &State<S, Z>,
    series: &Series<S, Z>,
) -> impl Iterator<Item = S> {
    let contacts = model.contacts().iter();
    let watched = contacts.clone().enumerate().flat_map(|(j, contact)| {
        let terms = match state.phase(j) {
            STUCK => series.force_terms(j),
            _ => series.speed_terms(contact.plus, contact.minus),
        };
        watch(&terms)
    });
    let length = series.length;
    let loads = model.loads.as_ref().iter();
    let loads = loads.map(move |(mass, _)| moment(&series.velocity_terms(*mass), 1, length));
    let slips = contacts
        .map(move |contact| moment(&series.speed_terms(contact.plus, contact.minus), 1, length));
    let (_, base, friction) = layout.coefficients();
    let inputs = loads.chain(slips).filter(move |_| friction > 0);
    let reaction = reaction(model, state, series);
    let base = (0..base.saturating_sub(1)).map(move |power| moment(&reaction, power, length));
    watched.chain(inputs).chain(base)
}

/// Returns the increments of the displacements and of the velocities.
fn increments<S: Float, Z: Size>(
    model: &Model<S, Z>,
    series: &Series<S, Z>,
) -> impl Iterator<Item = S> {
    let masses = 0..model.wall();
    let places = masses
        .clone()
        .map(|mass| increment(&series.displacement_terms(mass)));
    let speeds = masses.map(|mass| increment(&series.velocity_terms(mass)));
    places.chain(speeds)
}

/// Returns the value of a power series at the end of the sub-interval, minus its value at the start.
pub(super) fn increment<S: Float>(terms: &Poly<S>) -> S {
    let later = terms.iter().skip(1).rev();
    later.fold(S::constant(0.0), |sum, term| sum + *term)
}

/// Returns the entries of one column in the rows of a contact, from the power series of its watched quantity. The second
/// bound is that on its difference from the cubic polynomial that has its values and derivatives at both ends. The difference
/// is at most the largest fourth derivative, divided by 384.
fn watch<S: Float>(terms: &Poly<S>) -> [S; ROWS] {
    let zero = S::constant(0.0);
    let (mut reach, mut end, mut bound) = (zero, zero, zero);
    for (order, term) in terms.iter().enumerate().rev() {
        end = end + S::whole(order) * *term;
        if order > 0 {
            reach = reach + term.abs();
        }
        if order > 3 {
            let factor = S::whole(order * (order - 1)) * S::whole((order - 2) * (order - 3));
            bound = bound + factor / S::constant(384.0) * term.abs();
        }
    }
    let value = at(terms, 0);
    let last = value + increment(terms);
    [reach, at(terms, 1), end, bound, value, last]
}

/// Returns the chain and its state for one coordinate equal to 1 and all others equal to 0. All contacts that do not
/// stick slide forward.
fn unit<S: Float, Z: Size>(
    model: &Model<S, Z>,
    layout: &Layout,
    (sticks, column): (impl Fn(usize) -> bool, usize),
) -> (Model<S, Z>, State<S, Z>) {
    let (zero, one) = (S::constant(0.0), S::constant(1.0));
    let (mut model, mut state) = (model.clone(), State::at_rest(&model.size));
    let (load, base, _) = layout.coefficients();
    model.base = Curve::zero();
    for (_, load) in model.loads.as_mut() {
        *load = Wave::zero();
    }
    for (j, contact) in model.contacts.as_mut().iter_mut().enumerate() {
        contact.level = Wave::zero();
        state.set_phase(j, if sticks(j) { STUCK } else { 1 });
    }
    let line = |slope: bool| {
        let mut line = Wave::constant(if slope { zero } else { one });
        line.slope = if slope { one } else { zero };
        line
    };
    let sections = [
        layout.masses,
        layout.masses,
        layout.contacts,
        load * layout.loads,
        base,
        layout.contacts,
    ];
    let (section, index) = section(&sections, column);
    match section {
        0 => set(state.x.as_mut(), index, one),
        1 => set(state.v.as_mut(), index, one),
        2 if sticks(index) => set(state.forces.as_mut(), index, one),
        2 | 5 => {
            if let Some(contact) = model.contacts.as_mut().get_mut(index) {
                contact.level = line(section == 5);
            }
        }
        3 => {
            // A load has one or two coefficients.
            let (load, slope) = if load == 1 {
                (index, false)
            } else {
                (index / 2, index % 2 == 1)
            };
            if let Some((_, wave)) = model.loads.as_mut().get_mut(load) {
                *wave = line(slope);
            }
        }
        _ => match index {
            0 | 1 => model.base = line(index == 1).into(),
            2 => model.base.square = one,
            _ => model.base.cube = one,
        },
    }
    // The relative displacements of rigid contacts that stick are those of the unit displacement.
    let (x, _) = state.nodes(&model, zero);
    for (contact, place) in model.contacts().iter().zip(state.places.as_mut()) {
        *place = contact.across(x.as_ref());
    }
    (model, state)
}

/// Returns the section to which an index belongs, and the index in this section.
fn section(lengths: &[usize], index: usize) -> (usize, usize) {
    let mut left = index;
    for (section, length) in lengths.iter().enumerate() {
        if left < *length {
            return (section, left);
        }
        left -= length;
    }
    (lengths.len(), left)
}

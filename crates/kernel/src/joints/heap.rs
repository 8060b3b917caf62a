//! Arrays and tables at run time, in memory that the program allocates.
//!
//! The functions of this module are not generic, so that this crate compiles the search for steady states with its own
//! optimisation.

use super::run::Motion;
use super::size::{Size, Value};
use super::steady::{Place, Soon, Steady};
use super::stepper::Layout;
use super::table::{Room, Table, Tables};
use crate::Float;
use crate::errors::Halt;
use smallvec::{SmallVec, smallvec};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

/// An array with one entry for each mass, node, contact or load. Up to six entries need no allocation.
pub type Short<T> = SmallVec<[T; 6]>;

/// Size of a chain at run time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Heap {
    /// Number of masses of the chain.
    pub masses: usize,
    /// Number of contacts of the chain.
    pub contacts: usize,
    /// Number of loads of the chain.
    pub loads: usize,
}

impl Heap {
    /// Returns the number of unknowns in the search for a steady state.
    fn unknowns(&self) -> usize {
        2 * self.masses + self.contacts
    }
}

impl Size for Heap {
    type Masses<T: Value> = Short<T>;
    type Nodes<T: Value> = Short<T>;
    type Contacts<T: Value> = Short<T>;
    type Loads<T: Value> = Short<T>;
    type Unknowns<T: Value> = Vec<T>;
    type Square<T: Value> = Vec<T>;
    type Points<T: Value> = Vec<T>;
    type Row<T: Value> = Vec<T>;
    type Constants<T: Value> = Arc<[T]>;
    type Coordinates<T: Value> = Vec<T>;
    type Matrix<T: Value> = Vec<T>;
    type Rows<T: Value> = Vec<T>;
    type Shared<S: Float> = Arc<Mutex<TableMap<S>>>;
    type Tables<S: Float> = KeptTables<S>;

    const HAS_PARTS: bool = true;

    fn coordinates<T: Value>(&self, count: usize, value: T) -> Vec<T> {
        vec![value; count]
    }

    fn matrix<T: Value>(&self, count: usize, value: T) -> Vec<T> {
        vec![value; count * count]
    }

    fn rows<T: Value>(&self, count: usize, value: T) -> Vec<T> {
        vec![value; count]
    }

    fn shared<S: Float>(&self) -> Arc<Mutex<TableMap<S>>> {
        Arc::default()
    }

    fn tables<S: Float>(&self, shared: &Arc<Mutex<TableMap<S>>>, count: usize) -> KeptTables<S> {
        KeptTables {
            shared: Arc::clone(shared),
            last: None,
            room: Room::new(vec![S::constant(0.0); count]),
        }
    }

    fn none<T: Value>(&self) -> Arc<[T]> {
        Arc::new([])
    }

    fn masses<T: Value>(&self, value: T) -> Short<T> {
        smallvec![value; self.masses]
    }

    fn nodes<T: Value>(&self, value: T) -> Short<T> {
        smallvec![value; self.masses + 2]
    }

    fn contacts<T: Value>(&self, value: T) -> Short<T> {
        smallvec![value; self.contacts]
    }

    fn loads<T: Value>(&self, value: T) -> Short<T> {
        smallvec![value; self.loads]
    }

    fn unknowns<T: Value>(&self, value: T) -> Vec<T> {
        vec![value; self.unknowns()]
    }

    fn square<T: Value>(&self, value: T) -> Vec<T> {
        vec![value; self.unknowns() * self.unknowns()]
    }

    fn row<T: Value>(&self, count: usize, value: T) -> Vec<T> {
        vec![value; count]
    }

    fn layout(stored: &Layout) -> Layout {
        *stored
    }
}

/// Tables by the sets of sticking contacts to which they belong.
type TableMap<S> = BTreeMap<u64, Arc<Table<S, Heap>>>;

/// Tables that motions share. Their chains differ only in the amplitudes of the loads, in the friction forces and in μ.
#[derive(Clone, Debug, Default)]
pub struct SharedTables(Arc<Mutex<TableMap<f64>>>);

impl Motion<f64, Heap> {
    /// Makes searches for the steady state of this motion use, and complete, the tables of similar motions.
    #[must_use]
    pub fn sharing(mut self, tables: &SharedTables) -> Self {
        self.shared = Arc::clone(&tables.0);
        self
    }
}

/// Tables of the sets of sticking contacts that have occurred so far.
#[derive(Debug)]
pub struct KeptTables<S: Float> {
    shared: Arc<Mutex<TableMap<S>>>,
    /// The table of the last stretch.
    last: Option<(u64, Arc<Table<S, Heap>>)>,
    room: Room<Vec<S>>,
}

impl<S: Float> Tables<S, Heap> for KeptTables<S> {
    fn find(
        &mut self,
        key: u64,
        make: impl FnOnce() -> Table<S, Heap>,
    ) -> Option<(&Table<S, Heap>, &mut Room<Vec<S>>)> {
        let last = self.last.take().filter(|(own, _)| *own == key);
        let (_, table) = self.last.insert(last.unwrap_or_else(|| {
            let mut all = self.shared.lock().unwrap_or_else(PoisonError::into_inner);
            let table = all.entry(key).or_insert_with(|| Arc::new(make()));
            (key, Arc::clone(table))
        }));
        Some((table, &mut self.room))
    }
}

/// Searches for a steady state by [`Motion::settle_or_other`].
///
/// # Errors
///
/// [`Halt`] if the motion exceeds a bound.
pub fn settle_or_other(
    motion: &Motion<f64, Heap>,
    omega: f64,
    place: Place,
    near: Option<&Steady<f64, Heap>>,
) -> Result<Steady<f64, Heap>, Halt> {
    motion.settle_or_other(omega, place, near)
}

/// Searches for a steady state by [`Motion::settle_soon`].
///
/// # Errors
///
/// [`Halt`] if the motion exceeds a bound.
pub fn settle_soon(
    motion: &Motion<f64, Heap>,
    omega: f64,
    attempts: usize,
    place: Place,
) -> Result<Soon<f64, Heap>, Halt> {
    motion.settle_soon(omega, attempts, place)
}

/// Searches for a steady state by [`Motion::refine`].
///
/// # Errors
///
/// [`Halt`] if the motion exceeds a bound.
pub fn refine(
    motion: &Motion<f64, Heap>,
    omega: f64,
    near: (usize, f64),
) -> Result<Option<Steady<f64, Heap>>, Halt> {
    motion.refine(omega, near)
}

/// Searches for a steady state by [`Motion::refine_symmetric`].
///
/// # Errors
///
/// [`Halt`] if the motion exceeds a bound.
pub fn refine_symmetric(
    motion: &Motion<f64, Heap>,
    omega: f64,
    place: f64,
) -> Result<Option<Steady<f64, Heap>>, Halt> {
    motion.refine_symmetric(omega, place)
}

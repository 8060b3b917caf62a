//! Arrays that store the quantities of a chain. They have a fixed length in emitted code, and are vectors at run time.

use super::stepper::Layout;
use super::table::{LastTables, Tables};
use core::fmt::Debug;

/// A type whose values can be entries of the arrays.
pub trait Value: Copy + Debug + PartialEq + 'static {}

impl<T: Copy + Debug + PartialEq + 'static> Value for T {}

/// An array whose entries can be read and changed.
pub trait Array<T>: AsRef<[T]> + AsMut<[T]> + Clone + Debug + PartialEq {}

impl<T, A: AsRef<[T]> + AsMut<[T]> + Clone + Debug + PartialEq> Array<T> for A {}

/// Numbers of masses, contacts and loads of a chain. The trait also selects the arrays that have these lengths.
pub trait Size: Clone + Debug + PartialEq + Sized {
    /// Type of an array with one entry for each mass.
    type Masses<T: Value>: Array<T>;
    /// Type of an array with one entry for each node: the masses, the wall and the base, in this order.
    type Nodes<T: Value>: Array<T>;
    /// Type of an array with one entry for each contact.
    type Contacts<T: Value>: Array<T>;
    /// Type of an array with one entry for each load.
    type Loads<T: Value>: Array<T>;
    /// Type of an array with one entry for each unknown of a steady state. Each mass has two entries, and each contact
    /// one.
    type Unknowns<T: Value>: Array<T>;
    /// Type of a square matrix with a row and a column for each unknown of a steady state. The matrix is stored column
    /// by column.
    type Square<T: Value>: Array<T>;
    /// Type of an array with one entry for each point of the friction law.
    type Points<T: Value>: Array<T>;
    /// Type of an array with one entry for each coordinate of a stepper.
    type Row<T: Value>: Array<T>;
    /// Type of an array of any length whose entries do not change.
    type Constants<T: Value>: AsRef<[T]> + Clone + Debug;

    /// Type of an array with one entry for each coordinate of the tables of a search.
    type Coordinates<T: Value>: Array<T>;
    /// Type of a square matrix of these coordinates, row by row.
    type Matrix<T: Value>: AsRef<[T]> + AsMut<[T]>;
    /// Type of the rows of a table. Each row has one entry for each coordinate.
    type Rows<T: Value>: AsRef<[T]> + AsMut<[T]> + Clone + Debug;
    /// Tables that several searches share.
    type Shared<S: crate::Float>: Clone + Debug;
    /// Storage of the tables of a search.
    type Tables<S: crate::Float>: Tables<S, Self>;

    /// True if contacts can be stops, or have a moving surface. If false, the compiler removes all code for them.
    const HAS_PARTS: bool;

    /// Returns an array that contains `value` for each of the `count` coordinates.
    fn coordinates<T: Value>(&self, count: usize, value: T) -> Self::Coordinates<T>;
    /// Returns a square matrix of `count` coordinates. All its entries are `value`.
    fn matrix<T: Value>(&self, count: usize, value: T) -> Self::Matrix<T>;
    /// Returns rows with together `count` entries, which are all `value`.
    fn rows<T: Value>(&self, count: usize, value: T) -> Self::Rows<T>;
    /// Returns tables that no other search shares.
    fn shared<S: crate::Float>(&self) -> Self::Shared<S>;
    /// Returns a storage for the tables of a search with `count` coordinates.
    fn tables<S: crate::Float>(&self, shared: &Self::Shared<S>, count: usize) -> Self::Tables<S>;
    /// Returns an array without entries that do not change.
    fn none<T: Value>(&self) -> Self::Constants<T>;
    /// Returns an array that contains `value` for each mass.
    fn masses<T: Value>(&self, value: T) -> Self::Masses<T>;
    /// Returns an array that contains `value` for each node.
    fn nodes<T: Value>(&self, value: T) -> Self::Nodes<T>;
    /// Returns an array that contains `value` for each contact.
    fn contacts<T: Value>(&self, value: T) -> Self::Contacts<T>;
    /// Returns an array that contains `value` for each load.
    fn loads<T: Value>(&self, value: T) -> Self::Loads<T>;
    /// Returns an array that contains `value` for each unknown of a steady state.
    fn unknowns<T: Value>(&self, value: T) -> Self::Unknowns<T>;
    /// Returns a square matrix for the unknowns of a steady state. All its entries are `value`.
    fn square<T: Value>(&self, value: T) -> Self::Square<T>;
    /// Returns an array that contains `value` for each of the `count` coordinates of a stepper.
    fn row<T: Value>(&self, count: usize, value: T) -> Self::Row<T>;
    /// Returns the layout of a stepper's tables, which is `stored`. In emitted code the result consists of constants, so
    /// that the compiler knows the lengths of all loops.
    fn layout(stored: &Layout) -> Layout;
}

/// Size of a chain in emitted code, with N masses, NODES = N + 2 nodes, M contacts and L loads. For steady states, U =
/// 2N + M is the number of unknowns, and SQUARE = U² is the number of entries of a matrix. If the code needs only
/// closed forms, U is 2N. LAW is the number of points of the friction law, or 0 if the kinetic friction is constant.
/// ROW is the number of coordinates of a stepper that uses tables. PARTS is the number of stops and moving
/// surfaces. STEP contains the other properties of a stepper that uses tables, as [`Layout::properties`] writes them.
/// The search for a steady state keeps KEPT tables of C coordinates and ROWS rows, as
/// [`table_sizes`](super::table_sizes) returns them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fixed<
    const N: usize,
    const NODES: usize,
    const M: usize,
    const L: usize,
    const U: usize = 0,
    const SQUARE: usize = 0,
    const LAW: usize = 0,
    const ROW: usize = 0,
    const PARTS: usize = 0,
    const STEP: usize = 0,
    const C: usize = 0,
    const ROWS: usize = 0,
    const KEPT: usize = 0,
>;

/// Rows of an array of fixed length, one after the other.
#[derive(Clone, Copy, Debug)]
pub struct Rows<T, const C: usize, const ROWS: usize>([[T; C]; ROWS]);

impl<T, const C: usize, const ROWS: usize> AsRef<[T]> for Rows<T, C, ROWS> {
    fn as_ref(&self) -> &[T] {
        self.0.as_flattened()
    }
}

impl<T, const C: usize, const ROWS: usize> AsMut<[T]> for Rows<T, C, ROWS> {
    fn as_mut(&mut self) -> &mut [T] {
        self.0.as_flattened_mut()
    }
}

impl<
    const N: usize,
    const NODES: usize,
    const M: usize,
    const L: usize,
    const U: usize,
    const SQUARE: usize,
    const LAW: usize,
    const ROW: usize,
    const PARTS: usize,
    const STEP: usize,
    const C: usize,
    const ROWS: usize,
    const KEPT: usize,
> Size for Fixed<N, NODES, M, L, U, SQUARE, LAW, ROW, PARTS, STEP, C, ROWS, KEPT>
{
    type Masses<T: Value> = [T; N];
    type Nodes<T: Value> = [T; NODES];
    type Contacts<T: Value> = [T; M];
    type Loads<T: Value> = [T; L];
    type Unknowns<T: Value> = [T; U];
    type Square<T: Value> = [T; SQUARE];
    type Points<T: Value> = [T; LAW];
    type Row<T: Value> = [T; ROW];
    type Constants<T: Value> = &'static [T];
    type Coordinates<T: Value> = [T; C];
    type Matrix<T: Value> = Rows<T, C, C>;
    type Rows<T: Value> = Rows<T, C, ROWS>;
    type Shared<S: crate::Float> = ();
    type Tables<S: crate::Float> = LastTables<S, Self, KEPT>;

    const HAS_PARTS: bool = PARTS > 0;

    fn coordinates<T: Value>(&self, _: usize, value: T) -> [T; C] {
        [value; C]
    }

    fn matrix<T: Value>(&self, _: usize, value: T) -> Rows<T, C, C> {
        Rows([[value; C]; C])
    }

    fn rows<T: Value>(&self, _: usize, value: T) -> Rows<T, C, ROWS> {
        Rows([[value; C]; ROWS])
    }

    fn shared<S: crate::Float>(&self) {}

    fn tables<S: crate::Float>(&self, (): &(), _: usize) -> LastTables<S, Self, KEPT> {
        LastTables::new(self)
    }

    fn none<T: Value>(&self) -> &'static [T] {
        &[]
    }

    fn masses<T: Value>(&self, value: T) -> [T; N] {
        [value; N]
    }

    fn nodes<T: Value>(&self, value: T) -> [T; NODES] {
        [value; NODES]
    }

    fn contacts<T: Value>(&self, value: T) -> [T; M] {
        [value; M]
    }

    fn loads<T: Value>(&self, value: T) -> [T; L] {
        [value; L]
    }

    fn unknowns<T: Value>(&self, value: T) -> [T; U] {
        [value; U]
    }

    fn square<T: Value>(&self, value: T) -> [T; SQUARE] {
        [value; SQUARE]
    }

    fn row<T: Value>(&self, _: usize, value: T) -> [T; ROW] {
        [value; ROW]
    }

    #[inline]
    fn layout(stored: &Layout) -> Layout {
        if ROW == 0 {
            *stored
        } else {
            const { Layout::of_properties((N, M, L), STEP) }
        }
    }
}

/// Returns one entry of an array, or 0 for an index beyond its end. For example, the wall and the base have no entry
/// in the array of the masses, so that their mass is 0.
pub fn at<S: crate::Float>(values: &[S], index: usize) -> S {
    values.get(index).copied().unwrap_or(S::constant(0.0))
}

/// Adds `value` to one entry of an array.
pub fn add<S: crate::Float>(values: &mut [S], index: usize, value: S) {
    if let Some(entry) = values.get_mut(index) {
        *entry = *entry + value;
    }
}

/// Sets one entry of an array to `value`.
pub fn set<T>(values: &mut [T], index: usize, value: T) {
    if let Some(entry) = values.get_mut(index) {
        *entry = value;
    }
}

/// Converts a direction of sliding (−1 or 1) to a scalar.
pub fn sign<S: crate::Float>(phase: i8) -> S {
    S::constant(f64::from(phase))
}

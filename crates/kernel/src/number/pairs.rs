//! Iterators over the pairs (displacement, velocity) of a state vector. The standard iterators over chunks divide by
//! the size of a chunk. If the compiler does not know this size, the compiled code may contain a panic. The iterators
//! in this module never contain a panic.

/// Returns an iterator over the pairs (displacement, velocity) of a state vector.
pub(crate) fn pairs<S>(numbers: &[S]) -> impl Iterator<Item = &[S]> + Clone {
    numbers.as_chunks::<2>().0.iter().map(<[S; 2]>::as_slice)
}

/// Returns an iterator over the pairs (displacement, velocity) of a state vector, as mutable slices.
pub(crate) fn pairs_mut<S>(numbers: &mut [S]) -> impl Iterator<Item = &mut [S]> {
    let pairs = numbers.as_chunks_mut::<2>().0;
    pairs.iter_mut().map(<[S; 2]>::as_mut_slice)
}

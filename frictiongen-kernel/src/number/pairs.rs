//! Iterators over the pairs (displacement, velocity) of a state vector. Standard chunk iterators divide by the chunk
//! size, which the compiler does not always know. The compiled code may then contain a panic. The iterators here
//! contain none.

/// Returns an iterator over the pairs (displacement, velocity) of a state vector.
pub(crate) fn pairs<S>(numbers: &[S]) -> impl Iterator<Item = &[S]> + Clone {
    numbers.as_chunks::<2>().0.iter().map(<[S; 2]>::as_slice)
}

/// Returns an iterator over the pairs (displacement, velocity) of a state vector, as mutable slices.
pub(crate) fn pairs_mut<S>(numbers: &mut [S]) -> impl Iterator<Item = &mut [S]> {
    let pairs = numbers.as_chunks_mut::<2>().0;
    pairs.iter_mut().map(<[S; 2]>::as_mut_slice)
}

//! Iterators over a state's numbers in pairs. The standard iterators over chunks divide by a size that the compiler
//! does not always know, and may then contain a panic. These iterators contain none.

/// Returns the pairs of a state, each a displacement and a velocity.
pub(crate) fn pairs<S>(numbers: &[S]) -> impl Iterator<Item = &[S]> + Clone {
    numbers.as_chunks::<2>().0.iter().map(<[S; 2]>::as_slice)
}

/// Returns the pairs of a state as mutable slices.
pub(crate) fn pairs_mut<S>(numbers: &mut [S]) -> impl Iterator<Item = &mut [S]> {
    let pairs = numbers.as_chunks_mut::<2>().0;
    pairs.iter_mut().map(<[S; 2]>::as_mut_slice)
}

//! A state's numbers two by two.  The standard iterators over chunks divide by a size that the
//! compiler does not always see, and could panic then; these cannot.

/// Each two numbers of a state, displacement and velocity.
pub(crate) fn pairs<S>(numbers: &[S]) -> impl Iterator<Item = &[S]> + Clone {
    numbers.as_chunks::<2>().0.iter().map(<[S; 2]>::as_slice)
}

/// The same, to be changed.
pub(crate) fn pairs_mut<S>(numbers: &mut [S]) -> impl Iterator<Item = &mut [S]> {
    let pairs = numbers.as_chunks_mut::<2>().0;
    pairs.iter_mut().map(<[S; 2]>::as_mut_slice)
}

//! A list with one entry for each mode. For one or two modes, the list needs no memory allocation.

/// A list with one entry for each mode. Up to two entries are stored in the list itself, and more entries in a vector.
/// For one or two modes, an allocation would take a large fraction of the time of a search.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "room in place is what it is for")]
pub enum Few<T> {
    /// One entry, for a chain with one mode.
    One([T; 1]),
    /// Two entries, for a chain with two modes.
    Two([T; 2]),
    /// Any number of entries, one for each mode.
    Many(Vec<T>),
}

impl<T> AsRef<[T]> for Few<T> {
    #[inline]
    fn as_ref(&self) -> &[T] {
        match self {
            Self::One(one) => one,
            Self::Two(two) => two,
            Self::Many(many) => many,
        }
    }
}

impl<T> AsMut<[T]> for Few<T> {
    #[inline]
    fn as_mut(&mut self) -> &mut [T] {
        match self {
            Self::One(one) => one,
            Self::Two(two) => two,
            Self::Many(many) => many,
        }
    }
}

impl<T> std::ops::Deref for Few<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        self.as_ref()
    }
}

//! A value for each mode, of one or two modes without an allocation.

/// One or two values in place, more in a vector: of one or two modes an allocation takes as long as half of a search.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant, reason = "room in place is what it is for")]
pub enum Few<T> {
    /// One mode's.
    One([T; 1]),
    /// Those of two.
    Two([T; 2]),
    /// Those of any number.
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

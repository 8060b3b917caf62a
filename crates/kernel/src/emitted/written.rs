//! Writes and reads, by serde, structures of emitted code whose fields are numbers or structures of numbers.
//!
//! A derived implementation would name serde and types of the prelude in the user's module, where other items may have
//! these names. The macro [`written`](crate::written) therefore implements [`WrittenFields`] with absolute paths. The
//! functions of this module use `WrittenFields`.

use core::fmt;
use core::marker::PhantomData;
use serde::de::{DeserializeSeed, Error, MapAccess, SeqAccess, Visitor};
use serde::ser::SerializeStruct;
pub use serde::{Deserialize, Deserializer, Serialize, Serializer, ser};

/// A structure whose fields can be written and read by name.
pub trait WrittenFields: Default {
    /// Name of the structure.
    const NAME: &'static str;
    /// Names of the fields, in their order.
    const NAMES: &'static [&'static str];
    /// An array with one flag for each field.
    type Flags: AsMut<[bool]>;

    /// Returns an array of flags, none of which is set.
    fn flags() -> Self::Flags;

    /// Writes all fields with their names.
    ///
    /// # Errors
    /// Errors of the format.
    fn write<F: SerializeStruct>(&self, form: &mut F) -> Result<(), F::Error>;

    /// Sets the field `name` to the next value. Leaves the structure unchanged if no field has this name.
    ///
    /// # Errors
    /// Errors of the format.
    fn set<'de, N: Next<'de>>(&mut self, name: &str, next: N) -> Result<(), N::Error>;
}

/// The next value of a list or of a map that is being read.
pub trait Next<'de> {
    /// Error of the format.
    type Error;

    /// Reads the value.
    ///
    /// # Errors
    /// Errors of the format, among them the end of a list that is too short.
    fn value<V: Deserialize<'de>>(self) -> Result<V, Self::Error>;
}

/// Returns the name of a field without the `r#` of a raw identifier.
#[must_use]
pub const fn plain(name: &'static str) -> &'static str {
    match name.as_bytes() {
        [b'r', b'#', rest @ ..] => match core::str::from_utf8(rest) {
            Ok(rest) => rest,
            Err(_) => name,
        },
        _ => name,
    }
}

/// Writes a structure with the names of its fields.
///
/// # Errors
/// Errors of the format.
pub fn write<T: WrittenFields, S: Serializer>(fields: &T, to: S) -> Result<S::Ok, S::Error> {
    let mut form = to.serialize_struct(T::NAME, T::NAMES.len())?;
    fields.write(&mut form)?;
    form.end()
}

/// Reads a structure from a map or from a list of all fields in their order.
///
/// # Errors
/// Errors of the format, and an error for a field that is missing, unknown or given twice.
pub fn read<'de, T: WrittenFields, D: Deserializer<'de>>(from: D) -> Result<T, D::Error> {
    from.deserialize_struct(T::NAME, T::NAMES, FieldsVisitor(PhantomData))
}

struct FieldsVisitor<T>(PhantomData<T>);

impl<'de, T: WrittenFields> Visitor<'de> for FieldsVisitor<T> {
    type Value = T;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "the {} fields of {}", T::NAMES.len(), T::NAME)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut from: A) -> Result<T, A::Error> {
        let mut fields = T::default();
        for (index, name) in T::NAMES.iter().enumerate() {
            let from = &mut from;
            fields.set(
                name,
                NextOfList::<'_, _, T> {
                    from,
                    index,
                    of: PhantomData,
                },
            )?;
        }
        Ok(fields)
    }

    fn visit_map<A: MapAccess<'de>>(self, mut from: A) -> Result<T, A::Error> {
        let (mut fields, mut flags) = (T::default(), T::flags());
        let read = flags.as_mut();
        while let Some((index, name)) = from.next_key_seed(FieldName(T::NAMES))? {
            match read.get_mut(index) {
                Some(read) if !*read => *read = true,
                _ => return Err(A::Error::duplicate_field(name)),
            }
            fields.set(name, NextOfMap(&mut from))?;
        }
        let unread = read.iter().zip(T::NAMES).find(|(read, _)| !**read);
        match unread {
            Some((_, name)) => Err(A::Error::missing_field(name)),
            None => Ok(fields),
        }
    }
}

struct NextOfList<'a, A, T> {
    from: &'a mut A,
    index: usize,
    of: PhantomData<T>,
}

impl<'de, A: SeqAccess<'de>, T: WrittenFields> Next<'de> for NextOfList<'_, A, T> {
    type Error = A::Error;

    fn value<V: Deserialize<'de>>(self) -> Result<V, A::Error> {
        let next = self.from.next_element()?;
        next.ok_or_else(|| A::Error::invalid_length(self.index, &FieldsVisitor::<T>(PhantomData)))
    }
}

struct NextOfMap<'a, A>(&'a mut A);

impl<'de, A: MapAccess<'de>> Next<'de> for NextOfMap<'_, A> {
    type Error = A::Error;

    fn value<V: Deserialize<'de>>(self) -> Result<V, A::Error> {
        self.0.next_value()
    }
}

/// Reads the name or the index of a field, and returns the index and the name.
struct FieldName(&'static [&'static str]);

impl<'de> DeserializeSeed<'de> for FieldName {
    type Value = (usize, &'static str);

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<Self::Value, D::Error> {
        from.deserialize_identifier(self)
    }
}

impl Visitor<'_> for FieldName {
    type Value = (usize, &'static str);

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("the name of a field")
    }

    fn visit_u64<E: Error>(self, index: u64) -> Result<Self::Value, E> {
        let place = usize::try_from(index).ok();
        let named = place.and_then(|place| Some((place, *self.0.get(place)?)));
        named.ok_or_else(|| E::invalid_value(serde::de::Unexpected::Unsigned(index), &self))
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<Self::Value, E> {
        let mut names = self.0.iter().copied().enumerate();
        let named = names.find(|(_, known)| *known == name);
        named.ok_or_else(|| E::unknown_field(name, self.0))
    }

    fn visit_bytes<E: Error>(self, name: &[u8]) -> Result<Self::Value, E> {
        match core::str::from_utf8(name) {
            Ok(name) => self.visit_str(name),
            Err(_) => Err(E::invalid_value(serde::de::Unexpected::Bytes(name), &self)),
        }
    }
}

/// Implements `Serialize` and `Deserialize` for a structure of emitted code. Without the feature `serde` of this crate
/// the macro expands to nothing.
#[doc(hidden)]
#[macro_export]
macro_rules! written {
    ($name:ident, $($field:ident),*) => {
        impl $crate::emitted::written::WrittenFields for $name {
            const NAME: &'static ::core::primitive::str = ::core::stringify!($name);
            const NAMES: &'static [&'static ::core::primitive::str] =
                &[$($crate::emitted::written::plain(::core::stringify!($field))),*];
            type Flags = [::core::primitive::bool; [$(::core::stringify!($field)),*].len()];

            fn flags() -> Self::Flags {
                [false; [$(::core::stringify!($field)),*].len()]
            }

            fn write<F: $crate::emitted::written::ser::SerializeStruct>(
                &self,
                form: &mut F,
            ) -> ::core::result::Result<(), F::Error> {
                $($crate::emitted::written::ser::SerializeStruct::serialize_field(
                    form,
                    $crate::emitted::written::plain(::core::stringify!($field)),
                    &self.$field,
                )?;)*
                ::core::result::Result::Ok(())
            }

            fn set<'de, N: $crate::emitted::written::Next<'de>>(
                &mut self,
                name: &::core::primitive::str,
                next: N,
            ) -> ::core::result::Result<(), N::Error> {
                $(if name == $crate::emitted::written::plain(::core::stringify!($field)) {
                    self.$field = $crate::emitted::written::Next::value(next)?;
                    return ::core::result::Result::Ok(());
                })*
                ::core::result::Result::Ok(())
            }
        }

        impl $crate::emitted::written::Serialize for $name {
            fn serialize<S: $crate::emitted::written::Serializer>(
                &self,
                to: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                $crate::emitted::written::write(self, to)
            }
        }

        impl<'de> $crate::emitted::written::Deserialize<'de> for $name {
            fn deserialize<D: $crate::emitted::written::Deserializer<'de>>(
                from: D,
            ) -> ::core::result::Result<Self, D::Error> {
                $crate::emitted::written::read(from)
            }
        }
    };
}

//! Writes and reads saved states of a stepper by serde.
//!
//! A written state contains a version, and a hash of the scene and of the step. Reading checks the version.
//! [`Stepper::restore`](super::Stepper::restore) checks the hash.

use super::saved::Saved;
use super::state::{FixedStore, SCALARS, Status, Store};
use crate::motion::Contact;
use crate::number::scalar::Float;
use core::fmt;
use core::marker::PhantomData;
use serde::de::{Error, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// Version of the written form of a saved state.
const VERSION: u8 = 1;

/// The version of a written state. Reading fails for another version.
struct Version;

impl Serialize for Version {
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        to.serialize_u8(VERSION)
    }
}

impl<'de> Deserialize<'de> for Version {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        match u8::deserialize(from)? {
            VERSION => Ok(Self),
            other => Err(D::Error::custom(format_args!(
                "the saved state has version {other}, but this version of frictiongen reads version {VERSION}; continue from a state that it has written"
            ))),
        }
    }
}

/// The written form of a saved state. The version comes first, so that reading fails at once for a state of another
/// version.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Saved", deny_unknown_fields)]
struct StepperForm<S, V> {
    version: Version,
    scene: u64,
    steps: u64,
    exceeded: u64,
    line: u32,
    contact: Contact,
    unknown: bool,
    wedged: bool,
    budget: u8,
    numbers: [S; SCALARS],
    store: V,
}

impl<S: Float + Serialize, V: Serialize> Serialize for Saved<S, V> {
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        let status = &self.status;
        let form = StepperForm {
            version: Version,
            scene: self.mark,
            steps: status.steps,
            exceeded: status.exceeded,
            line: u32::try_from(status.line).unwrap_or(u32::MAX),
            contact: status.contact,
            unknown: status.unknown,
            wedged: status.wedged,
            budget: status.budget,
            numbers: status.scalars(),
            store: &self.store,
        };
        form.serialize(to)
    }
}

impl<'de, S, V> Deserialize<'de> for Saved<S, V>
where
    S: Float + Deserialize<'de>,
    V: Deserialize<'de>,
{
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let form = StepperForm::<S, V>::deserialize(from)?;
        if !form.numbers.iter().all(|number| number.is_finite()) {
            return Err(D::Error::custom(NOT_FINITE));
        }
        let status = Status {
            contact: form.contact,
            unknown: form.unknown,
            wedged: form.wedged,
            budget: form.budget,
            line: usize::try_from(form.line).unwrap_or(usize::MAX),
            steps: form.steps,
            exceeded: form.exceeded,
            ..Status::of_scalars(form.numbers)
        };
        Ok(Self {
            status,
            store: form.store,
            mark: form.scene,
        })
    }
}

/// Error message for a saved state that contains a number that is not finite. No stepper writes such a number.
pub const NOT_FINITE: &str = "a number of the saved state is not finite, so that no stepper has written it; continue from a state that a stepper has written";

/// The written form of the states of all oscillators and of the last forces.
#[derive(Serialize, Deserialize)]
#[serde(rename = "Store", deny_unknown_fields)]
struct FixedStoreForm<M, H, L> {
    modes: M,
    held: H,
    last: L,
}

impl<S, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize> Serialize
    for FixedStore<S, D, MODES, HELD, INPUTS>
where
    S: Float + Serialize,
{
    fn serialize<T: Serializer>(&self, to: T) -> Result<T::Ok, T::Error> {
        let store = self.read();
        let form = FixedStoreForm {
            modes: store.modes,
            held: store.held,
            last: store.last,
        };
        form.serialize(to)
    }
}

impl<'de, S, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
    Deserialize<'de> for FixedStore<S, D, MODES, HELD, INPUTS>
where
    S: Float + Default + Deserialize<'de>,
{
    fn deserialize<T: Deserializer<'de>>(from: T) -> Result<Self, T::Error> {
        let form: FixedStoreForm<
            WrittenList<[S; 2], MODES>,
            WrittenList<[S; 2], HELD>,
            WrittenList<S, INPUTS>,
        > = FixedStoreForm::deserialize(from)?;
        let mut store = Self::new();
        let numbers = store.change();
        numbers.modes.copy_from_slice(&form.modes.0);
        numbers.held.copy_from_slice(&form.held.0);
        numbers.last.copy_from_slice(&form.last.0);
        match store.read().is_finite() {
            true => Ok(store),
            false => Err(T::Error::custom(NOT_FINITE)),
        }
    }
}

/// A list of N values, which serde can read for every N.
struct WrittenList<V, const N: usize>([V; N]);

impl<'de, V: Copy + Default + Deserialize<'de>, const N: usize> Deserialize<'de>
    for WrittenList<V, N>
{
    fn deserialize<T: Deserializer<'de>>(from: T) -> Result<Self, T::Error> {
        from.deserialize_seq(Values::<V, N>(PhantomData))
    }
}

/// Reads the values of a [`WrittenList`].
struct Values<V, const N: usize>(PhantomData<V>);

impl<'de, V: Copy + Default + Deserialize<'de>, const N: usize> Visitor<'de> for Values<V, N> {
    type Value = WrittenList<V, N>;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(to, "a list of {N} values, as this scene has them")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut from: A) -> Result<Self::Value, A::Error> {
        let mut values = [V::default(); N];
        for (index, value) in values.iter_mut().enumerate() {
            let next = from.next_element()?;
            *value = next.ok_or_else(|| A::Error::invalid_length(index, &self))?;
        }
        if from.next_element::<V>()?.is_some() {
            return Err(A::Error::invalid_length(N + 1, &self));
        }
        Ok(WrittenList(values))
    }
}

//! The state of an instance as bytes.

use crate::instance::{Phase, Refusal, State};
use crate::scene::{self, Stepper};

/// First bytes of a serialised state, with the version of its form.
const MARK: [u8; 8] = *b"fmi3 v02";

/// Returns a checksum (FNV-1a).
fn checksum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
    })
}

impl State {
    /// Returns the state as bytes.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = MARK.to_vec();
        bytes.extend(scene::HASH.to_le_bytes());
        bytes.extend([self.phase as u8, u8::from(self.stepper.is_some())]);
        bytes.extend(self.events.to_le_bytes());
        let numbers = [self.start, self.stop, self.event_time]
            .into_iter()
            .chain(self.values)
            .chain(self.last);
        bytes.extend(numbers.flat_map(f64::to_le_bytes));
        match &self.stepper {
            Some(stepper) => bytes.extend(stepper.image()),
            None => bytes.extend([0; Stepper::IMAGE]),
        }
        bytes.extend(checksum(&bytes).to_le_bytes());
        bytes
    }

    /// Reads a state from bytes.
    pub fn of(bytes: &[u8]) -> Result<Self, Refusal> {
        let refused = |why: &dyn std::fmt::Display| {
            Refusal::error(format!("the bytes are not a state of this FMU: {why}"))
        };
        let length = State::new().bytes().len();
        let Some((body, sum)) = bytes.split_last_chunk().filter(|_| bytes.len() == length) else {
            return Err(refused(&format_args!(
                "they are {} bytes, but a state has {length}",
                bytes.len()
            )));
        };
        if checksum(body) != u64::from_le_bytes(*sum) {
            return Err(refused(&"a bit has changed"));
        }
        let mut reader = Reader(body);
        if reader.take() != MARK {
            return Err(refused(&"they have another version"));
        }
        if u64::from_le_bytes(reader.take()) != scene::HASH {
            return Err(refused(&"they belong to another scene"));
        }
        let mut state = Self::new();
        let [phase, has_stepper] = reader.take();
        state.phase = match phase {
            0 => Phase::Instantiated,
            1 => Phase::Initialization,
            2 => Phase::Step,
            _ => Phase::Terminated,
        };
        state.events = u64::from_le_bytes(reader.take());
        let State {
            start,
            stop,
            event_time,
            values,
            last,
            ..
        } = &mut state;
        let numbers = [start, stop, event_time].into_iter();
        for place in numbers.chain(values).chain(last) {
            *place = f64::from_le_bytes(reader.take());
        }
        if has_stepper == 1 {
            state.stepper = Some(scene::restored(&reader.take()).map_err(|error| refused(&error))?);
        }
        Ok(state)
    }
}

/// Reads bytes whose number has been checked.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let (found, rest) = self.0.split_first_chunk().unwrap_or((&[0; N], &[]));
        self.0 = rest;
        *found
    }
}

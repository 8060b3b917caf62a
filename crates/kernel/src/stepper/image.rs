//! Image of a stepper's state: bytes for a file or for flash memory, from which a later run can continue.
//!
//! | bytes | contents |
//! |---|---|
//! | 2 | `fs` |
//! | 1 | version of the form |
//! | 1 | bytes of a scalar: 4 or 8 |
//! | 8 | hash of the scene and of the step, as of a saved state |
//! | 8, 8 | steps; steps that reached the bound on events |
//! | 4 | line of the friction law |
//! | 4 | state of the contact, two flags, and the event budget |
//! | scalars | dt, the status, the modes, the modes of the stuck chain, the last sample |
//! | 4 | CRC-32 of all bytes before |
//!
//! The stuck chain is the chain with its contact stuck. All numbers are little-endian: their lowest byte comes first.

use super::law::StepContact;
use super::state::{FixedStore, Status, Store};
use super::table::StepTables;
use super::types::Stepper;
use crate::errors::OutOfDomain;
use crate::motion::Contact;
use crate::number::scalar::Float;

/// First bytes of every image (saved state of a stepper).
pub(crate) const NAME: [u8; 2] = *b"fs";
/// Version of the image format that [`Stepper::write_image`] writes.
const VERSION: u8 = 1;
/// Length in bytes of the first section of an image (saved state of a stepper). This section contains the name, the
/// version, the size of a scalar, and the hash of scene and step.
pub(crate) const HEAD: usize = 12;
/// Length in bytes of the second section of an image (saved state of a stepper). This section contains the counts of
/// steps, the line of the friction law, the state of the contact, two flags and the event budget.
const COUNTS: usize = 24;
/// Number of bytes of the checksum at the end of an image (saved state of a stepper).
pub(crate) const CHECKSUM: usize = 4;
/// Number of scalars in an image (saved state of a stepper) that come before the scalars of the modes. They are the
/// time step dt and the numbers of the status.
const SCALARS: usize = 1 + super::state::SCALARS;

/// Returns the length of an image (saved state of a stepper) in bytes. `scalar` is the size of a scalar in bytes.
/// `modes` is the number of modes of the chain, and `held` the number of modes of the chain with its contact stuck.
/// `inputs` is the number of inputs.
#[doc(hidden)]
#[must_use]
pub const fn image_bytes(scalar: usize, modes: usize, held: usize, inputs: usize) -> usize {
    HEAD + COUNTS + scalar * (SCALARS + 2 * modes + 2 * held + inputs) + CHECKSUM
}

/// Checks all bytes of an image (saved state of a stepper), and returns the image's time step dt in seconds.
///
/// # Errors
/// [`OutOfDomain::ImageDamaged`] if the image is too short or has a wrong checksum. [`OutOfDomain::ImageVersion`] for
/// another version of the image. [`OutOfDomain::Saved`] for another number type.
#[doc(hidden)]
pub fn image_step<S: Float>(bytes: &[u8]) -> Result<S, OutOfDomain> {
    let mut reader = checked::<S>(bytes, (VERSION, HEAD + COUNTS))?;
    reader.skip(8 + COUNTS);
    Ok(reader.scalar())
}

/// Returns the checksum CRC-32 (IEEE 802.3) of bytes. The checksum detects every change that is limited to 32
/// neighbouring bits.
pub(crate) fn crc<'b>(bytes: impl Iterator<Item = &'b u8>) -> u32 {
    !bytes.fold(u32::MAX, |sum, byte| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            (sum >> 1) ^ if sum & 1 == 1 { 0xedb8_8320 } else { 0 }
        })
    })
}

/// Checks the name, the version, the size of a scalar and the checksum of an image (saved state of a stepper). The image
/// must have the version `own`, and more than `least` bytes. Returns a reader that is positioned at the hash of scene and
/// step.
pub(crate) fn checked<S: Float>(
    bytes: &[u8],
    (own, least): (u8, usize),
) -> Result<Reader<'_>, OutOfDomain> {
    let body = bytes.len().checked_sub(CHECKSUM);
    let (body, sum) = body
        .filter(|body| least < *body)
        .and_then(|body| bytes.split_at_checked(body))
        .ok_or(OutOfDomain::ImageDamaged)?;
    let sum = Reader(sum.iter()).word();
    let mut reader = Reader(body.iter());
    let name: [u8; 2] = reader.bytes();
    if name != NAME || crc(body.iter()) != sum {
        return Err(OutOfDomain::ImageDamaged);
    }
    let [version, scalar] = reader.bytes();
    if version != own {
        return Err(OutOfDomain::ImageVersion);
    }
    if usize::from(scalar) != size_of::<S>() || !(scalar == 4 || scalar == 8) {
        return Err(OutOfDomain::Saved);
    }
    Ok(reader)
}

/// Reads numbers from bytes, one after the other. After the end of the bytes, the reader returns zeros.
#[derive(Clone)]
pub(crate) struct Reader<'b>(pub(crate) core::slice::Iter<'b, u8>);

impl Reader<'_> {
    pub(crate) fn bytes<const N: usize>(&mut self) -> [u8; N] {
        core::array::from_fn(|_| self.0.next().copied().unwrap_or(0))
    }

    pub(crate) fn skip(&mut self, bytes: usize) {
        for _ in 0..bytes {
            self.0.next();
        }
    }

    pub(crate) fn word(&mut self) -> u32 {
        u32::from_le_bytes(self.bytes())
    }

    pub(crate) fn long(&mut self) -> u64 {
        u64::from_le_bytes(self.bytes())
    }

    pub(crate) fn scalar<S: Float>(&mut self) -> S {
        S::constant(if size_of::<S>() == 4 {
            f64::from(f32::from_bits(self.word()))
        } else {
            f64::from_bits(self.long())
        })
    }

    pub(crate) fn scalars<S: Float, const N: usize>(&mut self) -> [S; N] {
        core::array::from_fn(|_| self.scalar())
    }
}

/// Writes numbers into bytes, one after the other, until the bytes are full.
pub(crate) struct Writer<'b>(pub(crate) core::slice::IterMut<'b, u8>);

impl Writer<'_> {
    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        // The bytes of the number come first in `zip`. In the other order, `zip` would take one byte too many from
        // `self.0`.
        for (byte, to) in bytes.iter().zip(self.0.by_ref()) {
            *to = *byte;
        }
    }

    pub(crate) fn scalar<S: Float>(&mut self, number: S) {
        let bits = number.bits().to_le_bytes();
        let [a, b, c, d, ..] = bits;
        if size_of::<S>() == 4 {
            self.bytes(&[a, b, c, d]);
        } else {
            self.bytes(&bits);
        }
    }

    pub(crate) fn scalars<'s, S: Float + 's>(&mut self, numbers: impl IntoIterator<Item = &'s S>) {
        for number in numbers {
            self.scalar(*number);
        }
    }
}

impl<S: Float> Status<S> {
    /// Reads the status of a stepper from an image. Returns `None` if no stepper can have written the contents.
    fn read(reader: &mut Reader<'_>, lines: usize) -> Option<Self> {
        let (steps, exceeded) = (reader.long(), reader.long());
        let line = usize::try_from(reader.word())
            .ok()
            .filter(|line| *line <= lines)?;
        let [contact, unknown, wedged, budget] = reader.bytes();
        if unknown > 1 || wedged > 1 {
            return None;
        }
        let contact = match contact {
            0 => Contact::Stuck,
            1 => Contact::Forward,
            2 => Contact::Backward,
            _ => return None,
        };
        let _: S = reader.scalar();
        Some(Self {
            contact,
            unknown: unknown == 1,
            wedged: wedged == 1,
            budget,
            line,
            steps,
            exceeded,
            ..Self::of_scalars(reader.scalars())
        })
    }
}

impl<S: Float, const D: usize, T: StepTables<S, D>, V: Store<S, D>, K: StepContact<S>>
    Stepper<'_, S, D, T, V, K>
{
    /// Returns the length of this stepper's image (saved state) in bytes.
    #[doc(hidden)]
    #[must_use]
    pub fn image_len(&self) -> usize {
        let store = self.store.read();
        let (modes, held) = (store.modes.len(), store.held.len());
        image_bytes(size_of::<S>(), modes, held, store.last.len())
    }

    /// Writes an image of the stepper's state. The slice `to` must have [`image_len`](Self::image_len) bytes.
    #[doc(hidden)]
    pub fn write_image(&self, to: &mut [u8]) {
        let (status, store) = (&self.status, self.store.read());
        let body = to.len().saturating_sub(CHECKSUM);
        let Some((body, sum)) = to.split_at_mut_checked(body) else {
            return;
        };
        let mut writer = Writer(body.iter_mut());
        writer.bytes(&NAME);
        writer.bytes(&[VERSION, u8::try_from(size_of::<S>()).unwrap_or(0)]);
        writer.bytes(&self.mark().to_le_bytes());
        writer.bytes(&status.steps.to_le_bytes());
        writer.bytes(&status.exceeded.to_le_bytes());
        writer.bytes(&u32::try_from(status.line).unwrap_or(u32::MAX).to_le_bytes());
        let contact = match status.contact {
            Contact::Stuck => 0,
            Contact::Forward => 1,
            Contact::Backward => 2,
        };
        writer.bytes(&[
            contact,
            u8::from(status.unknown),
            u8::from(status.wedged),
            status.budget,
        ]);
        writer.scalar(self.dt());
        writer.scalars(&status.scalars());
        writer.scalars(store.modes.iter().flatten());
        writer.scalars(store.held.iter().flatten());
        writer.scalars(store.last);
        Writer(sum.iter_mut()).bytes(&crc(body.iter()).to_le_bytes());
    }

    /// Restores the state that an image contains. From this state, the same inputs give the same results to the last
    /// bit.
    ///
    /// # Errors
    /// After an error the stepper keeps its state.
    ///
    /// - [`OutOfDomain::ImageDamaged`] if the image is too short, has a wrong checksum, or contains numbers that no
    ///   stepper writes. Any single changed bit makes the checksum wrong.
    /// - [`OutOfDomain::ImageVersion`] for an image of another version of this library.
    /// - [`OutOfDomain::Saved`] for an image of another scene, another time step or another number type.
    pub fn restore_image(&mut self, bytes: &[u8]) -> Result<(), OutOfDomain> {
        let mut reader = checked::<S>(bytes, (VERSION, HEAD + COUNTS))?;
        if reader.long() != self.mark() || bytes.len() != self.image_len() {
            return Err(OutOfDomain::Saved);
        }
        let status = Status::read(&mut reader, self.scene.law.len());
        let status = status.ok_or(OutOfDomain::ImageDamaged)?;
        let mut rest = reader.clone();
        let numbers =
            self.image_len().saturating_sub(HEAD + COUNTS + CHECKSUM) / size_of::<S>().max(1);
        let numbers = numbers.saturating_sub(SCALARS);
        let finite = |number: S| number.is_finite();
        if !(status.scalars().into_iter().all(finite)
            && (0..numbers).all(|_| finite(rest.scalar())))
        {
            return Err(OutOfDomain::ImageDamaged);
        }
        let store = self.store.change();
        for number in store.modes.iter_mut().chain(store.held).flatten() {
            *number = reader.scalar();
        }
        for number in store.last {
            *number = reader.scalar();
        }
        self.status = status;
        Ok(())
    }
}

impl<S: Float, const D: usize, T, const MODES: usize, const HELD: usize, const INPUTS: usize, K>
    Stepper<'_, S, D, T, FixedStore<S, D, MODES, HELD, INPUTS>, K>
{
    /// Length of an image (saved state of this stepper), in bytes.
    pub const IMAGE: usize = image_bytes(size_of::<S>(), MODES, HELD, INPUTS);
}

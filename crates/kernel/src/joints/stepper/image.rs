//! Image of a stepper's state: bytes for a file or for flash memory, from which a later run can continue.
//!
//! | bytes | contents |
//! |---|---|
//! | 2 | `fs` |
//! | 1 | version of the form |
//! | 1 | bytes of a scalar: 4 or 8 |
//! | 8 | hash of the scene and of the step |
//! | 8, 8 | steps; steps that reached the bound on events |
//! | 1 | event budget |
//! | 3 for each contact | phase; number of leading zeros of its next event, and their side |
//! | scalars | dt, the status, the inputs, μ of the contacts, the motion |
//! | 4 | CRC-32 of all bytes before |
//!
//! All numbers are little-endian: their lowest byte comes first.

use super::{Status, Stepper};
use crate::Float;
use crate::errors::OutOfDomain;
use crate::joints::size::{Array, Size};
use crate::joints::state::State;
use crate::motion::Total;
use crate::stepper::Input;
use crate::stepper::image::{CHECKSUM, HEAD, NAME, Reader, Writer, checked, crc};
use crate::stepper::saved::Hash;

/// Version of the form.
const VERSION: u8 = 2;
/// Number of bytes of the counts of steps and of the event budget.
const COUNTS: usize = 17;
/// Number of scalars whose count does not depend on the scene: dt, the base and its acceleration, the origin and the
/// sums of work.
const SCALARS: usize = 11;

/// Returns the length of an image in bytes, for a scalar of `scalar` bytes.
#[must_use]
pub const fn image_bytes(scalar: usize, masses: usize, contacts: usize, loads: usize) -> usize {
    let scalars = SCALARS + loads + 4 * contacts + 2 * masses;
    HEAD + COUNTS + 3 * contacts + scalar * scalars + CHECKSUM
}

/// State of a stepper without its tables.
#[derive(Clone, Debug)]
pub struct Saved<S: Float, Z: Size> {
    state: State<S, Z>,
    status: Status<S, Z>,
    stictions: Z::Contacts<S>,
    /// Hash of the scene and of the time step.
    mark: u64,
}

impl<S: Float, Z: Size, T: AsRef<[S]>> Stepper<S, Z, T> {
    /// Returns the present state of the stepper. [`restore`](Self::restore) continues the run from this state.
    pub fn save(&self) -> Saved<S, Z> {
        let model = self.motion.model();
        let mut stictions = model.size.contacts(S::constant(1.0));
        for (stiction, contact) in stictions.as_mut().iter_mut().zip(model.contacts()) {
            *stiction = contact.stiction;
        }
        Saved {
            state: self.motion.state().clone(),
            status: self.status.clone(),
            stictions,
            mark: self.mark(),
        }
    }

    /// Restores a saved state. From this state, the same inputs give the same results to the last bit.
    ///
    /// # Errors
    ///
    /// [`OutOfDomain::Saved`] if the state comes from a stepper with another scene or time step.
    pub fn restore(&mut self, saved: &Saved<S, Z>) -> Result<(), OutOfDomain> {
        if self.mark() != saved.mark {
            return Err(OutOfDomain::Saved);
        }
        for (contact, stiction) in saved.stictions.as_ref().iter().enumerate() {
            self.motion.set_stiction(contact, *stiction);
        }
        self.status = saved.status.clone();
        self.resume(saved.state.clone());
        Ok(())
    }

    /// Returns the length of this stepper's image in bytes.
    pub fn image_len(&self) -> usize {
        let model = self.motion.model();
        let (masses, loads) = (model.wall(), model.loads.as_ref().len());
        image_bytes(size_of::<S>(), masses, model.contacts().len(), loads)
    }

    /// Writes the state to the first [`image_len`](Self::image_len) bytes of `to`. If `to` is shorter, nothing is written.
    pub fn write_image(&self, to: &mut [u8]) {
        let length = self.image_len();
        let image = to.get_mut(..length);
        let parts =
            image.and_then(|image| image.split_at_mut_checked(length.saturating_sub(CHECKSUM)));
        let Some((body, sum)) = parts else {
            return;
        };
        let mut saved = self.save();
        let mut writer = Writer(body.iter_mut());
        writer.bytes(&NAME);
        writer.bytes(&[VERSION, u8::try_from(size_of::<S>()).unwrap_or(0)]);
        writer.bytes(&saved.mark.to_le_bytes());
        writer.bytes(&saved.status.steps.to_le_bytes());
        writer.bytes(&saved.status.exceeded.to_le_bytes());
        writer.bytes(&[saved.status.budget]);
        let phases = saved.state.phases.as_ref().iter();
        for (phase, (zeros, side)) in phases.zip(saved.state.zeros.as_ref()) {
            let zeros = u8::try_from(*zeros).unwrap_or(u8::MAX);
            writer.bytes(&[byte(*phase), zeros, byte(*side)]);
        }
        writer.scalar(self.dt());
        saved.visit(|number| writer.scalar(*number));
        Writer(sum.iter_mut()).bytes(&crc(body.iter()).to_le_bytes());
    }

    /// Restores the state that an image contains. From this state, the same inputs give the same results to the last
    /// bit.
    ///
    /// # Errors
    /// After an error the stepper keeps its state.
    ///
    /// - [`OutOfDomain::ImageDamaged`] if the image is too short, has a wrong checksum, or contains numbers that no
    ///   stepper writes.
    /// - [`OutOfDomain::ImageVersion`] for an image of another version of this library.
    /// - [`OutOfDomain::Saved`] for an image of another scene, another time step or another number type.
    pub fn restore_image(&mut self, bytes: &[u8]) -> Result<(), OutOfDomain> {
        let mut reader = checked::<S>(bytes, (VERSION, HEAD + COUNTS))?;
        let mut saved = self.save();
        if reader.long() != saved.mark || bytes.len() != self.image_len() {
            return Err(OutOfDomain::Saved);
        }
        saved.read(&mut reader)?;
        self.restore(&saved)
    }

    /// Returns a hash of the scene and of the time step.
    fn mark(&self) -> u64 {
        let (model, pace) = (self.motion.model(), &self.pace);
        let mut hash = Hash::new();
        hash.count(usize::from(pace.on_base));
        hash.count(usize::from(pace.input == Input::Linear));
        hash.count(usize::from(model.damping_from_base));
        hash.number(pace.dt);
        for number in model.masses().iter().chain(model.damping.as_ref()) {
            hash.number(*number);
        }
        let links = model.springs.as_ref().iter().chain(model.dashpots.as_ref());
        for (plus, minus, value) in links {
            hash.count(*plus).count(*minus).number(*value);
        }
        for contact in model.contacts() {
            hash.count(contact.plus).count(contact.minus);
            hash.number(contact.stiffness.unwrap_or(S::constant(0.0)));
            if Z::HAS_PARTS {
                hash.number(contact.speed);
                if let Some(stop) = contact.stop {
                    hash.number(stop.side).number(stop.gap);
                    hash.number(stop.damping).number(stop.restitution);
                }
            }
        }
        for (mass, load) in model.loads.as_ref() {
            hash.count(*mass);
            if Z::HAS_PARTS && load.is_constant_load() {
                hash.number(load.amplitude);
            }
        }
        for number in model.law.as_ref().iter().flatten() {
            hash.number(*number);
        }
        hash.0
    }
}

impl<S: Float, Z: Size> Saved<S, Z> {
    /// Calls `visit` for each scalar, always in the same order.
    fn visit(&mut self, mut visit: impl FnMut(&mut S)) {
        let (status, state) = (&mut self.status, &mut self.state);
        let (mut origin, mut load) = (status.origin.parts(), status.work.load.parts());
        let mut contacts = status.work.contacts.parts();
        let sums = origin.iter_mut().chain(&mut load).chain(&mut contacts);
        let scalars = status.base.iter_mut().chain([&mut status.lift]);
        let scalars = scalars.chain(sums).chain([&mut status.work.stored]);
        scalars.for_each(&mut visit);
        status.origin = Total::of_parts(origin);
        status.work.load = Total::of_parts(load);
        status.work.contacts = Total::of_parts(contacts);
        each(&mut status.forces, &mut visit);
        each(&mut status.levels, &mut visit);
        each(&mut self.stictions, &mut visit);
        each(&mut state.x, &mut visit);
        each(&mut state.v, &mut visit);
        each(&mut state.forces, &mut visit);
        each(&mut state.places, &mut visit);
    }

    /// Reads the state after the hash of an image.
    fn read(&mut self, reader: &mut Reader<'_>) -> Result<(), OutOfDomain> {
        (self.status.steps, self.status.exceeded) = (reader.long(), reader.long());
        let [budget] = reader.bytes();
        self.status.budget = budget;
        self.status.last_event = None;
        let phases = self.state.phases.as_mut().iter_mut();
        for (phase, zeros) in phases.zip(self.state.zeros.as_mut()) {
            let [own, count, side] = reader.bytes().map(|byte: u8| i8::from_le_bytes([byte]));
            if !(-1..=2).contains(&own) || !(0..=4).contains(&count) || !(-1..=1).contains(&side) {
                return Err(OutOfDomain::ImageDamaged);
            }
            (*phase, *zeros) = (own, (usize::from(count.unsigned_abs()), side));
        }
        let _: S = reader.scalar();
        let mut is_finite = true;
        self.visit(|number| {
            *number = reader.scalar();
            is_finite &= number.is_finite();
        });
        if is_finite {
            Ok(())
        } else {
            Err(OutOfDomain::ImageDamaged)
        }
    }
}

fn byte(number: i8) -> u8 {
    let [byte] = number.to_le_bytes();
    byte
}

fn each<S, A: Array<S>>(numbers: &mut A, visit: &mut impl FnMut(&mut S)) {
    numbers.as_mut().iter_mut().for_each(visit);
}

/// Returns the time step of the stepper that wrote an image, in seconds.
///
/// # Errors
/// [`OutOfDomain::ImageDamaged`] if the image is too short or has a wrong checksum. [`OutOfDomain::ImageVersion`] for
/// another version of the image. [`OutOfDomain::Saved`] for another number type.
pub fn image_step<S: Float>(bytes: &[u8], contacts: usize) -> Result<S, OutOfDomain> {
    let mut reader = checked::<S>(bytes, (VERSION, HEAD + COUNTS))?;
    reader.skip(8 + COUNTS + 3 * contacts);
    Ok(reader.scalar())
}

//! Known results of an emitted scene, which the code generator wrote. The self-check compares them with the results
//! that the scene computes.

use super::{Fault, Listed};
use crate::Complex;
use crate::contact::regime::Limits;
use crate::errors::NotContinuous;
use crate::number::scalar::Float;

/// Known results of an emitted scene at one frequency ratio.
#[derive(Clone, Copy, Debug)]
pub struct Known<S, const MASSES: usize, const FORCES: usize> {
    /// Frequency ratio r at which the known results are valid.
    pub r: S,
    /// Known values of the limits β_lim and β*_lim, in this order.
    pub limits: [S; 2],
    /// Known motion at one friction ratio. `None` if the scene does not provide motions.
    pub motion: Option<KnownMotion<S, MASSES>>,
    /// Real and imaginary part of each known response while the contact is stuck. The displacements of the masses come
    /// first. The force that keeps the contact stuck comes last. The list is empty if the scene does not provide stuck
    /// responses.
    pub stuck: [[S; 2]; FORCES],
}

/// Known results of an emitted scene at one friction ratio.
#[derive(Clone, Copy, Debug)]
pub struct KnownMotion<S, const MASSES: usize> {
    /// Friction ratio β at which the known results are valid.
    pub beta: S,
    /// Reason why no continuous motion exists at this friction ratio, or `None` if a continuous motion exists.
    pub error: Option<NotContinuous>,
    /// Known amplitude and phase of the contact. Amplitude and phase are 0 if no continuous motion exists.
    pub contact: [S; 2],
    /// Known displacement and velocity of each provided mass. The instant is one radian after a maximum of the
    /// contact's motion.
    pub masses: [[S; 2]; MASSES],
}

/// Returns true if two numbers differ by at most `error`. The result is false for NaN.
fn is_near<S: Float>(own: S, known: S, error: S) -> bool {
    (own.to_f64() - known.to_f64()).abs() <= error.to_f64()
}

/// Compares two pairs of numbers. A pair is a complex number, or a displacement and a velocity. `tolerance` is relative
/// to the sum of the absolute values in the known pair.
fn compared<S: Float>(
    name: &'static str,
    own: [S; 2],
    known: [S; 2],
    tolerance: S,
) -> Result<(), Fault> {
    let [one, other] = known;
    let error = tolerance * (one.abs() + other.abs());
    let mut pairs = own.into_iter().zip(known);
    if pairs.all(|(own, known)| is_near(own, known, error)) {
        Ok(())
    } else {
        Err(Fault::Answer(name))
    }
}

impl<S: Float, const MASSES: usize, const FORCES: usize> Known<S, MASSES, FORCES> {
    /// Compares the computed β_lim and β*_lim with the known limits. Each limit may differ from its known value by at
    /// most `tolerance` times this value.
    ///
    /// # Errors
    /// [`Fault::Answer`] if a limit differs from its known value by more than `tolerance` times the known value.
    pub fn limits(&self, own: Limits<S>, tolerance: S) -> Result<(), Fault> {
        let [continuous, sliding] = self.limits;
        if is_near(own.continuous, continuous, tolerance * continuous)
            && is_near(own.sliding, sliding, tolerance * sliding)
        {
            Ok(())
        } else {
            Err(Fault::Answer("limits"))
        }
    }

    /// Compares a computed response with the known response while the contact is stuck. `place` is the index of the
    /// response in [`stuck`](Self::stuck).
    ///
    /// # Errors
    /// [`Fault::Answer`] if the response differs by more than `tolerance` times the size of the known response.
    pub fn stuck(
        &self,
        place: usize,
        name: &'static str,
        own: Complex<S>,
        tolerance: S,
    ) -> Result<(), Fault> {
        let known = self.stuck.get(place).ok_or(Fault::Answer(name))?;
        compared(name, [own.re, own.im], *known, tolerance)
    }
}

impl<S: Float, const MASSES: usize> KnownMotion<S, MASSES> {
    /// Returns the computed motion if the known results also contain a motion. Returns `None` if both the scene and
    /// the known results give the same reason why no continuous motion exists.
    ///
    /// # Errors
    /// [`Fault::Answer`] if only the scene or only the known results have a motion, or if they give different reasons
    /// why no motion exists.
    pub fn found<M>(&self, own: Result<M, NotContinuous>) -> Result<Option<M>, Fault> {
        match (own, self.error) {
            (Ok(motion), None) => Ok(Some(motion)),
            (Err(error), Some(known)) if error == known => Ok(None),
            _ => Err(Fault::Answer("motion")),
        }
    }

    /// Compares the computed amplitude and phase of the contact with the known amplitude and phase.
    ///
    /// # Errors
    /// [`Fault::Answer`] if the amplitude differs by more than `tolerance` times its known value, or the phase by more
    /// than `tolerance` in rad.
    pub fn contact(&self, [size, lag]: [S; 2], tolerance: S) -> Result<(), Fault> {
        let [amplitude, phase] = self.contact;
        if is_near(size, amplitude, tolerance * amplitude) && is_near(lag, phase, tolerance) {
            Ok(())
        } else {
            Err(Fault::Answer("contact"))
        }
    }

    /// Compares the computed displacement and velocity of a mass with the known values. `place` is the index of the
    /// mass in [`masses`](Self::masses).
    ///
    /// # Errors
    /// [`Fault::Answer`] with the name of the mass, if the displacement or the velocity differs by more than
    /// `tolerance` times the known size. The known size is |displacement| + |velocity|.
    pub fn mass(
        &self,
        place: usize,
        name: &'static str,
        own: [S; 2],
        tolerance: S,
    ) -> Result<(), Fault> {
        let known = self.masses.get(place).ok_or(Fault::Answer(name))?;
        compared(name, own, *known, tolerance)
    }
}

impl<S: Float + Listed<S>, const MASSES: usize, const FORCES: usize> Listed<S>
    for Known<S, MASSES, FORCES>
{
    fn list(&self, see: &mut impl FnMut(S)) {
        self.r.list(see);
        self.limits.list(see);
        if let Some(motion) = &self.motion {
            motion.beta.list(see);
            motion.contact.list(see);
            motion.masses.list(see);
        }
        self.stuck.list(see);
    }
}

//! Spectra of motions. The spectrum of a steady state is exact. The spectrum of a run in time comes from samples.

use super::History;
use crate::study::response::SystemResponse;
use crate::study::units::polar;
use crate::{Complex, Of};
use rustfft::FftPlanner;

/// Spectrum of a motion: x̄ = Re Σ X e^{inτ}, a sum of components of order n. The order is an integer for a harmonic,
/// and a fraction for a component between two harmonics.
#[derive(Clone, Debug, PartialEq)]
pub struct Spectrum {
    /// The motion that has this spectrum: that of the contact, of a mass, or a combination.
    pub of: Of,
    /// The components in ascending order of n. The first component is the mean, n = 0.
    pub lines: Vec<SpectralLine>,
}

/// One component of a motion in its spectrum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpectralLine {
    /// Order n of the component: its frequency divided by the frequency of the excitation.
    pub order: f64,
    /// Complex amplitude X in Re(X e^{inτ}), divided by P/k₁ (by Y for base motion). The phase τ is 0 at a maximum of
    /// the excitation. The component of order 0 is the mean.
    pub component: Complex<f64>,
}

impl SpectralLine {
    /// Returns |X|, the amplitude of the component.
    #[must_use]
    pub fn amplitude(&self) -> f64 {
        polar(self.component).0
    }

    /// Returns the lag of the component's maximum in rad, in (−π, π]. A whole cycle of the component is 2π.
    #[must_use]
    pub fn phase(&self) -> f64 {
        polar(self.component).1
    }
}

impl History {
    /// Returns the spectrum of a motion from its samples. Returns `None` if the history does not contain the motion.
    ///
    /// The call computes the spectrum by a fast Fourier transform over whole cycles, which need no window. The orders
    /// are multiples of 1/c, where c is the number of cycles, up to half the number of samples in a cycle. The phase τ
    /// is 0 at the first sample.
    ///
    /// Components with frequencies above half the sampling rate appear as components of lower orders (aliasing).
    /// Because friction changes its sign at reversals, the harmonics decrease with the third power of their order. The
    /// error of a harmonic therefore decreases with the third power of the number of samples. For a steady state,
    /// [`SystemResponse::spectrum`] is exact.
    ///
    /// ```
    /// use frictiongen::study::history::HistoryRequest;
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let block: System = "struct Block {
    ///     masses: { block: 1 },
    ///     springs: { base - block: 1 },
    ///     contact: block - wall,
    ///     excitation: block,
    ///     damping: modal(0.02),
    /// }"
    /// .parse()?;
    /// let request = HistoryRequest { skip: 1000, cycles: 4, ..HistoryRequest::new(&[Of::Contact]) };
    /// let spectrum = block.history(0.3, 0.4, &request)?.spectrum(Of::Contact).ok_or("not asked for")?;
    /// let third = spectrum.lines[3 * 4];
    /// assert_eq!(third.order, 3.0);
    /// let exact = block.at(0.3)?.response(0.4)?.harmonic(Of::Contact, 3).ok_or("no such mass")?;
    /// assert!((third.amplitude() - exact.norm()).abs() < 1e-6);
    /// # Ok(())
    /// # }
    /// ```
    #[must_use]
    pub fn spectrum(&self, of: Of) -> Option<Spectrum> {
        let values = self.track(of)?.whole();
        let mut values: Vec<Complex<f64>> = values
            .iter()
            .map(|value| Complex::new(*value, 0.0))
            .collect();
        let count = values.len();
        FftPlanner::new()
            .plan_fft_forward(count)
            .process(&mut values);
        let one_sided = |(index, value): (usize, &Complex<f64>)| {
            // A component with its counterpart of negative order counts twice. The mean and the component of the
            // highest order have no such counterpart.
            let sides = if index == 0 || index == count / 2 {
                1.0
            } else {
                2.0
            };
            SpectralLine {
                order: index as f64 / f64::from(self.cycles),
                component: *value * (sides / count as f64),
            }
        };
        let lines = values.iter().take(count / 2 + 1).enumerate();
        Some(Spectrum {
            of,
            lines: lines.map(one_sided).collect(),
        })
    }
}

impl SystemResponse<'_> {
    /// Returns X in Re(X e^{ikτ/p}), the component of order k/p of the contact or of a mass. Returns `None` if the
    /// scene does not have this motion.
    ///
    /// p is the [`period`](Self::period) in cycles of the excitation. Component k = np is the
    /// [`harmonic`](Self::harmonic) of order n. The phase τ is 0 at a maximum of the excitation. If the period has
    /// several maxima of the excitation, τ is 0 at the maximum closest to the instant at which the contact's relative
    /// motion leaves its maximum.
    #[must_use]
    pub fn subharmonic(&self, of: Of, k: u32) -> Option<Complex<f64>> {
        match self {
            Self::StickSlip(orbit) => orbit.ask_of(of, |motion| motion.subharmonic(k)),
            _ => self.harmonic(of, k),
        }
    }

    /// Returns the exact spectrum of the contact or of a mass up to the order `highest`. Returns `None` if the scene
    /// does not have the mass. If the motion does not settle, the spectrum belongs to a periodic repetition of its last
    /// 64 cycles.
    #[must_use]
    pub fn spectrum(&self, of: Of, highest: u32) -> Option<Spectrum> {
        let period = self.period();
        let lines = (0..=highest.saturating_mul(period)).map(|k| {
            Some(SpectralLine {
                order: f64::from(k) / f64::from(period),
                component: self.subharmonic(of, k)?,
            })
        });
        Some(Spectrum {
            of,
            lines: lines.collect::<Option<_>>()?,
        })
    }
}

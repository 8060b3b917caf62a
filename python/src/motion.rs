//! Columns of motions: amplitude, phase and further quantities of the contact and of masses.

use crate::asked::{Measure, Part};
use crate::columns::{Columns, cell};
use frictiongen::Complex;
use frictiongen::study::columns::Dimension;
use frictiongen::study::units::{fundamental_phase, polar, reversed_phase};
use frictiongen::study::{Swing, SystemOrbitMotion, SystemResponse};
use pyo3::prelude::*;

/// One motion at one point, in non-dimensional form. Missing quantities are `None`.
#[derive(Clone, Debug, Default)]
pub struct Movement {
    /// Amplitude and phase of the largest displacement.
    pub swing: Option<Swing>,
    /// Half the distance between the smallest and the largest displacement.
    pub centred: Option<f64>,
    /// Lag of the fundamental component.
    pub fundamental_phase: Option<f64>,
    /// Monoharmonic estimate of the amplitude, if it is computed.
    pub monoharmonic: Option<f64>,
    /// Largest velocity and acceleration.
    pub rates: Option<(f64, f64)>,
    /// The requested harmonics.
    pub harmonics: Vec<Complex<f64>>,
}

impl Movement {
    /// Takes the motion of a response in any regime, with the opposite sign if `measure` asks for it.
    pub fn of(
        response: &SystemResponse<'_>,
        part: &Part,
        orders: &[u32],
        measure: &Measure,
    ) -> Self {
        let harmonics = orders
            .iter()
            .map(|order| response.harmonic(part.of, *order));
        let mut movement = Self {
            swing: response.swing(part.of),
            centred: response.centred_amplitude(part.of),
            fundamental_phase: response.fundamental_phase(part.of),
            monoharmonic: response.monoharmonic(part.of),
            rates: None,
            harmonics: harmonics.collect::<Option<_>>().unwrap_or_default(),
        };
        if measure.turns(part.of) {
            movement.turn(response.reversed_contact_phase());
        }
        movement
    }

    /// Takes the motion of a steady state.
    pub fn of_orbit(motion: &SystemOrbitMotion<'_, '_>, orders: &[u32]) -> Self {
        let (amplitude, phase) = motion.largest();
        let centred = motion.centred_amplitude();
        Self {
            swing: Some(Swing {
                amplitude,
                phase: Some(phase),
            }),
            centred: Some(centred),
            fundamental_phase: fundamental_phase(motion.harmonic(1), centred),
            harmonics: orders.iter().map(|order| motion.harmonic(*order)).collect(),
            ..Self::default()
        }
    }

    /// Reverses the sign of the motion, which then has this phase.
    pub fn turn(&mut self, phase: Option<f64>) {
        if let Some(swing) = &mut self.swing {
            swing.phase = phase;
        }
        self.fundamental_phase = self.fundamental_phase.map(reversed_phase);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(0.0 - harmonic.re, 0.0 - harmonic.im);
        }
    }

    /// Sets displacements that vanish at r = ∞ to zero. The formulas are evaluated at a large, finite r.
    pub fn settle(&mut self) {
        let settled = |value: f64| if value.abs() < 1e-100 { 0.0 } else { value };
        if let Some(swing) = &mut self.swing {
            swing.amplitude = settled(swing.amplitude);
            swing.phase = swing.phase.filter(|_| swing.amplitude != 0.0);
        }
        self.centred = self.centred.map(settled);
        self.monoharmonic = self.monoharmonic.map(settled);
        for harmonic in &mut self.harmonics {
            *harmonic = Complex::new(settled(harmonic.re), settled(harmonic.im));
        }
    }
}

/// Columns of a motion besides amplitude and phase.
#[derive(Clone, Copy, Debug)]
pub struct Extent<'a> {
    /// Whether it has the monoharmonic amplitude.
    pub monoharmonic: bool,
    /// Whether it has velocity and acceleration.
    pub rates: bool,
    /// Orders of the harmonics.
    pub orders: &'a [u32],
}

impl Extent<'_> {
    /// Returns the number of columns.
    pub fn numbers(&self) -> usize {
        4 + usize::from(self.monoharmonic) + 2 * usize::from(self.rates) + 2 * self.orders.len()
    }
}

/// Adds the columns of one motion over all points. The second value of each movement is ω, which scales velocities.
pub fn put(
    columns: &mut Columns<'_>,
    (name, measure): (&str, &Measure),
    extent: Extent<'_>,
    movements: &[(Movement, f64)],
) -> PyResult<()> {
    let full = |what: &str, unit: Dimension| measure.name(&format!("{name}.{what}"), unit);
    let all = |read: &dyn Fn(&Movement, f64) -> Option<f64>| -> Vec<f64> {
        let cells = movements
            .iter()
            .map(|(movement, omega)| cell(read(movement, *omega)));
        cells.collect()
    };
    columns.numbers(
        full("amplitude", Dimension::Length),
        all(&|movement, _| Some(measure.length(movement.swing?.amplitude))),
    )?;
    columns.numbers(
        full("centred", Dimension::Length),
        all(&|movement, _| Some(measure.length(movement.centred?))),
    )?;
    columns.numbers(
        full("phase", Dimension::Angle),
        all(&|movement, _| Some(measure.angle(movement.swing?.phase?))),
    )?;
    columns.numbers(
        full("fundamental_phase", Dimension::Angle),
        all(&|movement, _| Some(measure.angle(movement.fundamental_phase?))),
    )?;
    if extent.monoharmonic {
        columns.numbers(
            full("amplitude_monoharmonic", Dimension::Length),
            all(&|movement, _| Some(measure.length(movement.monoharmonic?))),
        )?;
    }
    if extent.rates {
        columns.numbers(
            full("velocity", Dimension::Velocity),
            all(&|movement, omega| Some(measure.velocity(movement.rates?.0, omega))),
        )?;
        columns.numbers(
            full("acceleration", Dimension::Acceleration),
            all(&|movement, omega| Some(measure.acceleration(movement.rates?.1, omega))),
        )?;
    }
    for (place, order) in extent.orders.iter().enumerate() {
        columns.numbers(
            full(&format!("X{order}.amplitude"), Dimension::Length),
            all(&|movement, _| Some(measure.length(polar(*movement.harmonics.get(place)?).0))),
        )?;
        columns.numbers(
            full(&format!("X{order}.phase"), Dimension::Angle),
            all(&|movement, _| Some(measure.angle(polar(*movement.harmonics.get(place)?).1))),
        )?;
    }
    Ok(())
}

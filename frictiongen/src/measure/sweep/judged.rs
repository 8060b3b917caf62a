//! Converts a fit to a sweep into the result with 95 % intervals.

use super::answer::SweepFit;
use super::model::Sweep;
use crate::Complex;
use crate::measure::identify::Estimate;
use crate::measure::least_squares::FitResult;
use crate::measure::statistics::{NORMAL, excess, student};
use crate::measure::{MeasureError, SweepPoint};
use crate::study::System;
use crate::study::units::hertz;
use nalgebra::DVector;

/// Largest unexplained fraction of the measured amplitudes, as root mean square over the points. With a larger
/// fraction, the fit has failed.
const GROSS: f64 = 0.5;

pub(super) fn answer(sweep: &Sweep<'_>, fit: &FitResult) -> Result<SweepFit, MeasureError> {
    let system = sweep.at(&fit.parameters).ok_or(MeasureError::NoFit)?;
    let values = sweep.values(&system, 1.0).ok_or(MeasureError::NoFit)?;
    let pairs = sweep.points.iter().zip(&values);
    let residuals: Vec<f64> = pairs
        .map(|(point, value)| point.amplitude - value.norm())
        .collect();
    let relative = sweep.points.iter().zip(&residuals);
    let relative = relative.map(|(point, residual)| (residual / point.amplitude).powi(2));
    let scatter = (relative.sum::<f64>() / residuals.len() as f64).sqrt();
    if GROSS < scatter
        && let Some((point, value)) = sweep.points.iter().zip(&values).max_by(|a, b| {
            let off = |(point, value): &(&SweepPoint, &Complex<f64>)| {
                (1.0 - value.norm() / point.amplitude).abs()
            };
            off(a).total_cmp(&off(b))
        })
    {
        let mass = sweep.system.scene().masses.get(point.mass);
        return Err(MeasureError::NotExplained {
            mass: mass.map_or_else(String::new, |mass| mass.name.clone()),
            measured: point.amplitude,
            nearest: value.norm(),
        });
    }
    let freedom = residuals.len() - fit.rank;
    let weighed = sweep.points.iter().all(|point| point.deviation.is_some());
    let reduced = (freedom > 0).then(|| fit.squares / freedom as f64);
    let reach = if weighed {
        NORMAL * excess(reduced, freedom).sqrt()
    } else {
        reduced.map_or(f64::INFINITY, |reduced| student(freedom) * reduced.sqrt())
    };
    // Returns the 95 % interval of a quantity from the quantity's derivatives with respect to the parameters.
    let interval = |value: f64, gradient: &DVector<f64>| {
        let reach = reach * fit.variance(gradient).sqrt();
        Estimate {
            value,
            from: (value - reach).max(0.0),
            to: value + reach,
        }
    };
    let own = |index: usize| {
        let mut gradient = DVector::zeros(fit.parameters.len());
        if let Some(entry) = gradient.get_mut(index) {
            *entry = 1.0;
        }
        interval(
            fit.parameters.get(index).copied().unwrap_or(f64::NAN),
            &gradient,
        )
    };
    let (masses, last) = (sweep.masses(), fit.parameters.len() - 1);
    let springs = system.scene().springs.len();
    let factor = own(0);
    let unit = hertz(sweep.system.angular_frequency(1.0));
    let natural = system.natural_frequencies();
    let natural: Vec<Estimate> = natural
        .iter()
        .enumerate()
        .filter_map(|(mode, omega)| {
            Some(interval(
                hertz(*omega),
                &gradient(sweep, (fit, &system), mode, *omega)?,
            ))
        })
        .collect();
    Ok(SweepFit {
        reference: Estimate {
            value: factor.value * unit,
            from: factor.from * unit,
            to: factor.to * unit,
        },
        masses: (1..masses).map(own).collect(),
        springs: (1..springs)
            .map(|spring| own(masses + spring - 1))
            .collect(),
        damping: sweep.damping.then(|| own(last)),
        natural,
        misfit: reduced.filter(|_| weighed),
        freedom,
        scatter,
        condition: fit.condition,
        residuals,
        system,
    })
}

/// Returns the derivatives of a natural frequency in Hz with respect to the parameters of the fit.
fn gradient(
    sweep: &Sweep<'_>,
    (fit, system): (&FitResult, &System),
    mode: usize,
    omega: f64,
) -> Option<DVector<f64>> {
    let slopes = fit.parameters.iter().enumerate().map(|(index, value)| {
        if index == 0 {
            // The first parameter multiplies all frequencies. The derivative is therefore the frequency divided by this
            // parameter.
            return Some(hertz(omega) / value);
        }
        let mut sum = 0.0;
        for (quantity, scale) in sweep.directions(index, system) {
            let modal = system.modal().along(system.scene(), quantity)?;
            let natural = *modal.resonances.get(mode)? * modal.reference;
            sum += scale * hertz(natural.slope.to_f64());
        }
        Some(sum)
    });
    Some(DVector::from_vec(slopes.collect::<Option<Vec<f64>>>()?))
}

//! A quantity of the scene that is chosen together with friction.

use super::peaks::Band;
use super::search::{self, Least};
use super::{Optimum, OptimumError, Problem};
use crate::study::Quantity;
use crate::study::scene::{Damping, Scene};
use crate::study::system::System;

/// What is chosen, and from which range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vary {
    /// The stiffness of a spring or the damping ratio of a mode.
    pub quantity: Quantity,
    /// From this value,
    pub from: f64,
    /// to this one.
    pub to: f64,
}

/// Values of the scan.
const SCAN: usize = 10;
/// Steps of the search between two of them.
const STEPS: usize = 48;
/// How near to the optimum, in the logarithm of the quantity.
const NEAR: f64 = 1e-7;
/// The golden section's smaller part.
const GOLDEN: f64 = 0.381_966_011_250_105_1;

impl Vary {
    /// From a quarter of what the scene says to four times that; none for what cannot be chosen or is 0.
    #[must_use]
    pub fn around(system: &System, quantity: Quantity) -> Option<Self> {
        let value = value(system.scene(), quantity)?;
        (0.0 < value).then_some(Self {
            quantity,
            from: 0.25 * value,
            to: 4.0 * value,
        })
    }
}

fn value(scene: &Scene, quantity: Quantity) -> Option<f64> {
    match (quantity, &scene.damping) {
        (Quantity::Stiffness(place), _) => Some(scene.springs.get(place)?.stiffness),
        (Quantity::DampingRatio(mode), Damping::Modal(ratios)) => ratios.get(mode).copied(),
        (Quantity::DampingRatio(mode), Damping::Uniform(ratio)) => {
            (mode < scene.masses.len()).then_some(*ratio)
        }
        _ => None,
    }
}

/// The scene with another value.
fn with(scene: &Scene, quantity: Quantity, value: f64) -> Option<System> {
    let mut scene = scene.clone();
    if let (Quantity::DampingRatio(_), Damping::Uniform(ratio)) = (quantity, &scene.damping) {
        scene.damping = Damping::Modal(vec![*ratio; scene.masses.len()]);
    }
    match (quantity, &mut scene.damping) {
        (Quantity::Stiffness(place), _) => scene.springs.get_mut(place)?.stiffness = value,
        (Quantity::DampingRatio(mode), Damping::Modal(ratios)) => *ratios.get_mut(mode)? = value,
        _ => return None,
    }
    System::try_from(scene).ok()
}

/// One value of the quantity with the best friction for it.
struct Chosen {
    value: f64,
    least: Least,
    /// The largest amplitude in the original's unit of length.
    amplitude: f64,
}

/// The optimum over friction and a quantity.
pub(super) fn solved(problem: &Problem<'_>, vary: &Vary) -> Result<Optimum, OptimumError> {
    let scene = problem.original.scene();
    value(scene, vary.quantity).ok_or(OptimumError::NoSuchQuantity)?;
    if !(0.0 < vary.from && vary.from < vary.to && vary.to.is_finite()) {
        return Err(OptimumError::Range);
    }
    let at = |value: f64, near: Option<&Chosen>| -> Option<Chosen> {
        let system = with(scene, vary.quantity, value)?;
        let band = Band::new(&system, problem.request.of, problem.ratios(&system));
        // Beside a known optimum it lies near; where it does not, all is looked at.
        let near = near.and_then(|near| {
            let width = (4.0 * (value / near.value).ln().abs()).clamp(1e-6, 0.5);
            let least = search::least_near(&band, near.least.at.beta, width)?;
            let inner =
                least.scan.first()?.beta < least.at.beta && least.at.beta < least.scan.last()?.beta;
            inner.then_some(least)
        });
        let least = match near {
            Some(least) => least,
            None => search::least(&band)?,
        };
        let amplitude = least.at.value * problem.unit(&system).ok()?;
        Some(Chosen {
            value,
            least,
            amplitude,
        })
    };
    let (low, high) = (vary.from.ln(), vary.to.ln());
    let places = (0..=SCAN).map(|place| (low + (high - low) * place as f64 / SCAN as f64).exp());
    let mut scan: Vec<Chosen> = Vec::new();
    for value in places {
        scan.extend(at(value, scan.last()));
    }
    let best = scan
        .iter()
        .enumerate()
        .min_by(|(_, a), (_, b)| a.amplitude.total_cmp(&b.amplitude))
        .map(|(place, _)| place)
        .ok_or(OptimumError::Unbounded)?;
    let bound = |place: Option<usize>, own: f64| {
        place
            .and_then(|place| scan.get(place))
            .map_or(own, |chosen| chosen.value.ln())
    };
    let (mut a, mut b) = (bound(best.checked_sub(1), low), bound(Some(best + 1), high));
    let mut x = scan.swap_remove(best);
    // The golden section: the least over friction bends where three peaks are equal.
    for _ in 0..STEPS {
        if b - a <= NEAR {
            break;
        }
        let middle = x.value.ln();
        let to = if middle - a > b - middle {
            middle - GOLDEN * (middle - a)
        } else {
            middle + GOLDEN * (b - middle)
        };
        let Some(found) = at(to.exp(), Some(&x)) else {
            break;
        };
        if found.amplitude <= x.amplitude {
            if to < middle {
                b = middle
            } else {
                a = middle
            }
            x = found;
        } else if to < middle {
            a = to;
        } else {
            b = to;
        }
    }
    let system = with(scene, vary.quantity, x.value).ok_or(OptimumError::NoSuchQuantity)?;
    // The whole of friction once more, for what stands beside the optimum.
    let band = Band::new(&system, problem.request.of, problem.ratios(&system));
    let least = search::least(&band).ok_or(OptimumError::Unbounded)?;
    let near = |end: f64| (x.value.ln() - end).abs() <= 1e-5;
    let at_end = near(low) || near(high);
    drop(band);
    problem.solved(Some((system, least, (x.value, at_end))))
}

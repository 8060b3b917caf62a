//! Computes the sizes of a stepper, of its saved state and of a simulation in bytes, so that C can allocate their
//! memory.

use frictiongen::kernel::motion::ElasticChain;
use frictiongen::kernel::simulation::{FixedLinesSimulation, FixedSimulation};
use frictiongen::kernel::stepper::{FixedStepper, FixedStore, Saved};
use frictiongen::study::scene::Precision;
use frictiongen_codegen::standalone::StepperShape;

/// Number of bytes that padding may add to an extrapolated size.
const PADDING: i64 = 16;

/// Size of a stepper and size of its saved state, in bytes, for one combination of three counts. The stepper has one or
/// two modes, one or two modes with the contact stuck, and one or two inputs.
type Corner = [usize; 2];

/// Returns the size of a stepper and the size of its saved state, in words of 64 bits. Each size includes one word that
/// marks an initialised struct.
///
/// The size of a stepper is linear in each of three numbers: modes, modes with the contact stuck, and inputs. The sizes
/// for eight combinations therefore determine all sizes. The exported crate asserts at compile time that the size
/// suffices on its target.
pub fn words(shape: &StepperShape, precision: Precision) -> [usize; 2] {
    let corners = match precision {
        Precision::F64 => corners::<f64>(shape),
        Precision::F32 => corners::<f32>(shape),
    };
    let weights = [shape.modes, shape.held, shape.inputs].map(|size| {
        let size = i64::try_from(size).unwrap_or(i64::MAX);
        [2 - size, size - 1]
    });
    [0, 1].map(|of| {
        let corners = corners.iter().enumerate();
        let sum = corners.fold(0_i64, |sum, (index, corner)| {
            let size = corner.get(of).copied().unwrap_or(0);
            let size = i64::try_from(size).unwrap_or(i64::MAX);
            let places = [index >> 2, (index >> 1) & 1, index & 1];
            let weight = weights
                .iter()
                .zip(places)
                .fold(1, |product, (pair, place)| {
                    product * pair.get(place).copied().unwrap_or(0)
                });
            sum + weight * size
        });
        // The word that marks an initialised struct comes before the contents.
        usize::try_from((sum + PADDING + 7) / 8).unwrap_or(0) + 1
    })
}

/// Returns the size of a simulation in words of 64 bits, including one word that marks an initialised struct. The size
/// is linear in `parts`, the number of the simulation's oscillators. The first flag in `of` is true for a friction law
/// that depends on the speed. The second flag is true for an elastic contact.
pub fn simulation_words(parts: usize, of: (bool, bool), precision: Precision) -> usize {
    let [one, two] = match precision {
        Precision::F64 => simulations::<f64>(of),
        Precision::F32 => simulations::<f32>(of),
    };
    let size = one + (two - one) * parts.saturating_sub(1);
    size.div_ceil(8) + 1
}

/// Returns the size of a simulation with one oscillator and of a simulation with two oscillators, in bytes.
fn simulations<S: frictiongen::scalar::Float + 'static>(
    (law, elastic): (bool, bool),
) -> [usize; 2] {
    if law {
        [
            size_of::<FixedLinesSimulation<S, 1>>(),
            size_of::<FixedLinesSimulation<S, 2>>(),
        ]
    } else if elastic {
        [
            size_of::<FixedSimulation<S, 1, ElasticChain<S>>>(),
            size_of::<FixedSimulation<S, 2, ElasticChain<S>>>(),
        ]
    } else {
        [
            size_of::<FixedSimulation<S, 1>>(),
            size_of::<FixedSimulation<S, 2>>(),
        ]
    }
}

fn corners<S: frictiongen::scalar::Float>(shape: &StepperShape) -> [Corner; 8] {
    match shape.coefficients {
        1 => of_inputs::<S, 1>(shape.elastic),
        2 => of_inputs::<S, 2>(shape.elastic),
        _ => of_inputs::<S, 4>(shape.elastic),
    }
}

fn of_inputs<S: frictiongen::scalar::Float, const D: usize>(elastic: bool) -> [Corner; 8] {
    [
        sizes::<S, D, 1, 1, 1>(elastic),
        sizes::<S, D, 1, 1, 2>(elastic),
        sizes::<S, D, 1, 2, 1>(elastic),
        sizes::<S, D, 1, 2, 2>(elastic),
        sizes::<S, D, 2, 1, 1>(elastic),
        sizes::<S, D, 2, 1, 2>(elastic),
        sizes::<S, D, 2, 2, 1>(elastic),
        sizes::<S, D, 2, 2, 2>(elastic),
    ]
}

fn sizes<
    S: frictiongen::scalar::Float,
    const D: usize,
    const M: usize,
    const H: usize,
    const I: usize,
>(
    elastic: bool,
) -> Corner {
    let stepper = if elastic {
        size_of::<FixedStepper<S, D, M, H, I, ElasticChain<S>>>()
    } else {
        size_of::<FixedStepper<S, D, M, H, I>>()
    };
    [stepper, size_of::<Saved<S, FixedStore<S, D, M, H, I>>>()]
}

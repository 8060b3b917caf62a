//! Computes the sizes of a stepper, of its saved state and of a simulation in bytes, so that C can allocate their
//! memory.

use frictiongen::kernel::joints::{self, Fixed, Stepper};
use frictiongen::kernel::motion::ElasticChain;
use frictiongen::kernel::simulation::{FixedLinesSimulation, FixedSimulation};
use frictiongen::kernel::stepper::{FixedStepper, FixedStore, Saved};
use frictiongen::scalar::Float;
use frictiongen::study::scene::Precision;
use frictiongen_codegen::standalone::StepperSizes;

/// Number of bytes that padding may add to an extrapolated size.
const PADDING: i64 = 16;
/// Number of bytes that padding may add to the extrapolated size of a stepper of several contacts, which consists of more
/// structs.
const JOINTS_PADDING: i64 = 64;

/// Size of a stepper and size of its saved state, in bytes, for one combination of three counts. The stepper has one or
/// two modes, one or two modes with the contact stuck, and one or two inputs.
type Corner = [usize; 2];

/// Returns the size of a stepper and the size of its saved state, in words of 64 bits. Each size includes one word that
/// marks an initialised struct. The exported crate asserts at compile time that the size suffices on its target.
pub fn words(sizes: &StepperSizes, precision: Precision) -> [usize; 2] {
    let bytes = match precision {
        Precision::F64 => bytes::<f64>(sizes),
        Precision::F32 => bytes::<f32>(sizes),
    };
    // The word that marks an initialised struct comes before the contents.
    bytes.map(|bytes| usize::try_from((bytes + 7) / 8).unwrap_or(0) + 1)
}

fn bytes<S: Float>(sizes: &StepperSizes) -> [i64; 2] {
    match sizes {
        StepperSizes::Modes {
            coefficients,
            modes,
            held,
            inputs,
            elastic,
        } => {
            let corners = match coefficients {
                1 => of_inputs::<S, 1>(*elastic),
                2 => of_inputs::<S, 2>(*elastic),
                _ => of_inputs::<S, 4>(*elastic),
            };
            of_corners(&corners, [*modes, *held, *inputs])
        }
        StepperSizes::Joints {
            sizes,
            points,
            row,
            entries,
        } => {
            let count = |index: usize| sizes.get(index).copied().unwrap_or(0);
            of_joints::<S>([count(0), count(2), count(3), *points, *row, *entries])
        }
    }
}

/// Returns the sizes of a stepper and of its saved state in bytes. Both are linear in each of three numbers: modes, modes
/// with the contact stuck, and inputs. The sizes for eight combinations therefore determine all sizes.
fn of_corners(corners: &[Corner; 8], counts: [usize; 3]) -> [i64; 2] {
    let weights = counts.map(|size| {
        let size = i64::try_from(size).unwrap_or(i64::MAX);
        [2 - size, size - 1]
    });
    [0, 1].map(|of| {
        let corners = corners.iter().enumerate();
        let sum = corners.fold(0_i64, |sum, (index, corner)| {
            let size = signed(corner.get(of).copied().unwrap_or(0));
            let places = [index >> 2, (index >> 1) & 1, index & 1];
            let weight = weights
                .iter()
                .zip(places)
                .fold(1, |product, (pair, place)| {
                    product * pair.get(place).copied().unwrap_or(0)
                });
            sum + weight * size
        });
        sum + PADDING
    })
}

/// Returns the sizes of a stepper and of its saved state in bytes, for a scene with several contacts or dashpots. Both are
/// linear in the numbers of masses, contacts, loads, points of the friction law, coordinates, and entries of the tables.
fn of_joints<S: Float>(counts: [usize; 6]) -> [i64; 2] {
    // The step of 8 keeps the alignment of all fields.
    let base = joints::<S, 1, 3, 1, 0, 0, 0, 0>();
    let ends = [
        joints::<S, 9, 11, 1, 0, 0, 0, 0>(),
        joints::<S, 1, 3, 9, 0, 0, 0, 0>(),
        joints::<S, 1, 3, 1, 8, 0, 0, 0>(),
        joints::<S, 1, 3, 1, 0, 8, 0, 0>(),
        joints::<S, 1, 3, 1, 0, 0, 8, 0>(),
        joints::<S, 1, 3, 1, 0, 0, 0, 8>(),
    ];
    let starts = [1, 1, 0, 0, 0, 0];
    let at = |corner: &Corner, of: usize| signed(corner.get(of).copied().unwrap_or(0));
    [0, 1].map(|of| {
        let first = at(&base, of);
        let steps = counts.iter().zip(starts).zip(&ends);
        steps.fold(first + JOINTS_PADDING, |sum, ((count, start), end)| {
            sum + (signed(*count) - start) * (at(end, of) - first) / 8
        })
    })
}

fn joints<
    S: Float,
    const N: usize,
    const NODES: usize,
    const M: usize,
    const L: usize,
    const LAW: usize,
    const ROW: usize,
    const ENTRIES: usize,
>() -> Corner {
    [
        size_of::<Stepper<S, Fixed<N, NODES, M, L, 0, 0, LAW, ROW>, [S; ENTRIES]>>(),
        size_of::<joints::Saved<S, Fixed<N, NODES, M, L, 0, 0, LAW, ROW>>>(),
    ]
}

fn signed(size: usize) -> i64 {
    i64::try_from(size).unwrap_or(i64::MAX)
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
fn simulations<S: Float + 'static>((law, elastic): (bool, bool)) -> [usize; 2] {
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

fn of_inputs<S: Float, const D: usize>(elastic: bool) -> [Corner; 8] {
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

fn sizes<S: Float, const D: usize, const M: usize, const H: usize, const I: usize>(
    elastic: bool,
) -> Corner {
    let stepper = if elastic {
        size_of::<FixedStepper<S, D, M, H, I, ElasticChain<S>>>()
    } else {
        size_of::<FixedStepper<S, D, M, H, I>>()
    };
    [stepper, size_of::<Saved<S, FixedStore<S, D, M, H, I>>>()]
}

//! Free motion of an undamped chain by three shears, which keep its energy in spite of rounding errors.
//!
//! A table of rounded numbers makes the energy of an undamped chain grow or decay: in `f32` by some per cent in ten
//! million steps. With Ω² = M⁻¹K and the length h of a sub-interval, the motion is also
//!
//! * x += A p, v += M⁻¹(B x + C g), x += A p, where p = Mv, A = Ω⁻¹ tan(Ωh/2) M⁻¹ and B = −MΩ sin Ωh.
//!
//! K contains the springs of the elastic contacts that stick. Their forces are f = kz + g, and g does not change while a
//! contact sticks. For each shear there is an exact inverse. As long as no rigid contact sticks, A and B are symmetric,
//! also as rounded numbers, and the energy does not drift. The rows of the increments contain only what damping changes,
//! and the columns of the inputs: those of the velocities are added in the second shear, those of the displacements in
//! the third. A power series gives (Ωh)²ᵏ for each unit velocity, and the expansion tan(θ/2)/θ = Σ cₖθ²ᵏ the matrix A.

use super::table::{Layout, increment};
use crate::Float;
use crate::joints::least::dot;
use crate::joints::model::Model;
use crate::joints::poly::terms_of;
use crate::joints::series::Series;
use crate::joints::size::{Size, add, at, set};
use crate::joints::state::{STUCK, State};
use crate::joints::tree::Tree;

/// Coefficients cₖ = 4 Σ (mπ)⁻²ᵏ⁻² over all odd m, in the expansion of tan(θ/2)/θ.
const COEFFICIENTS: [f64; 11] = [
    0.5,
    1.0 / 24.0,
    1.0 / 240.0,
    17.0 / 40_320.0,
    31.0 / 725_760.0,
    691.0 / 159_667_200.0,
    5461.0 / 12_454_041_600.0,
    929_569.0 / 20_922_789_888_000.0,
    3_202_291.0 / 711_374_856_192_000.0,
    221_930_581.0 / 486_580_401_635_328_000.0,
    4_722_116_521.0 / 102_181_884_343_418_880_000.0,
];

/// Returns true if steppers of this number type use shears. In `f64` a table drifts by 1e-9 in ten million steps.
pub(super) fn has_shears<S: Float>() -> bool {
    S::EPSILON > 1e-10
}

/// A chain without damping, its state, and the power series of its motion from this state.
type FreeMotion<'f, S, Z> = (&'f Model<S, Z>, &'f State<S, Z>, &'f Series<S, Z>);

/// Matrices of the shears of one pattern, stored row by row.
pub(super) struct Shears<'t, S> {
    masses: usize,
    /// A: a row of N entries for each mass.
    places: &'t mut [S],
    /// A row for each mass, with N entries of B for the displacements, and M of C for the forces g of the contacts.
    forces: &'t mut [S],
}

impl<'t, S: Float> Shears<'t, S> {
    pub(super) fn new(layout: &Layout, entries: &'t mut [S]) -> Self {
        let masses = layout.masses;
        let parts = entries.split_at_mut_checked(masses * masses);
        let (places, forces) = parts.unwrap_or_default();
        Self {
            masses,
            places,
            forces,
        }
    }

    /// Adds the coordinate with the index `column`, which is 1 in `state`. `model` has no damping, and `free` is the power
    /// series of its motion. Returns true if the coordinate belongs to the free motion. Its increments by damping must
    /// then be without those of the free motion.
    pub(super) fn add<Z: Size>(
        &mut self,
        column: usize,
        (model, state, free): FreeMotion<'_, S, Z>,
    ) -> bool {
        let masses = self.masses;
        let force = column.checked_sub(2 * masses);
        let is_inert = |contact: usize| {
            state.phase(contact) != STUCK || model.contact(contact).is_none_or(|c| c.is_rigid())
        };
        if force.is_some_and(is_inert) {
            return false;
        }
        let by_force = masses + model.contacts().len();
        for (mass, own) in model.masses().iter().enumerate() {
            match column.checked_sub(masses) {
                Some(velocity) if velocity < masses => {
                    let divisor = at(model.masses(), velocity);
                    let value = half_turn(free, mass) / divisor;
                    set(self.places, mass * masses + velocity, value);
                }
                _ => {
                    let index = force.map_or(column, |contact| masses + contact);
                    let value = *own * increment(&free.velocity_terms(mass));
                    set(self.forces, mass * by_force + index, value);
                }
            }
        }
        true
    }

    /// Completes B after all columns have been added: the columns of the displacements assume forces f of 0 at the start,
    /// and B assumes forces g of 0. Makes both matrices symmetric if all masses move independently. Then subtracts from
    /// the increments of the displacements what the third shear makes of those of the velocities. `gains` are the rows of
    /// the increments, each of `count` entries.
    pub(super) fn finish<Z: Size>(
        self,
        model: &Model<S, Z>,
        tree: &Tree<S, Z>,
        (gains, count): (&mut [S], usize),
    ) {
        let width = self.masses + model.contacts().len();
        for row in self.forces.chunks_exact_mut(width.max(1)) {
            for (j, contact) in model.contacts().iter().enumerate() {
                let Some(stiffness) = contact.stiffness else {
                    continue;
                };
                let strained = stiffness * at(row, self.masses + j);
                for (node, value) in [(contact.plus, strained), (contact.minus, -strained)] {
                    if node < self.masses {
                        add(row, node, value);
                    }
                }
            }
        }
        if tree.is_empty() {
            symmetrise(self.places, (self.masses, self.masses));
            symmetrise(self.forces, (self.masses, width));
        }
        let parts = gains.split_at_mut_checked(self.masses * count);
        let (places, speeds) = parts.unwrap_or_default();
        let rows = self.places.chunks_exact(self.masses.max(1));
        for (gains, row) in places.chunks_exact_mut(count.max(1)).zip(rows) {
            let factors = row.iter().zip(model.masses());
            for ((factor, mass), gained) in factors.zip(speeds.chunks_exact(count.max(1))) {
                for (gain, gained) in gains.iter_mut().zip(gained) {
                    *gain = *gain - *factor * *mass * *gained;
                }
            }
        }
    }
}

/// Returns the displacement Σ cₖ h (−1)ᵏ(Ωh)²ᵏ v of a mass, for the velocity v at the start of a power series of the
/// undamped motion.
fn half_turn<S: Float, Z: Size>(series: &Series<S, Z>, mass: usize) -> S {
    let terms = series.velocity_terms(mass);
    let (mut sum, mut factorial, mut sign) = (S::constant(0.0), S::constant(1.0), S::constant(1.0));
    for (k, coefficient) in COEFFICIENTS.iter().enumerate() {
        if 2 * k >= terms_of::<S>() {
            break;
        }
        // The coefficient of order 2k of the velocity is (−1)ᵏ(Ωh)²ᵏ v/(2k)!.
        sum = sum + S::constant(*coefficient) * sign * factorial * at(&terms, 2 * k);
        factorial = factorial * S::whole((2 * k + 1) * (2 * k + 2));
        sign = -sign;
    }
    series.length * sum
}

/// Replaces the lower and the upper half of the square matrix in the first columns by their mean. The matrix has `size`
/// rows, each of `width` entries.
fn symmetrise<S: Float>(matrix: &mut [S], (size, width): (usize, usize)) {
    for row in 0..size {
        for column in 0..row {
            let (lower, upper) = (row * width + column, column * width + row);
            let mean = S::constant(0.5) * (at(matrix, lower) + at(matrix, upper));
            set(matrix, lower, mean);
            set(matrix, upper, mean);
        }
    }
}

/// Advances the displacements and velocities, which are the first coordinates in `after`, from the coordinates in
/// `before`. The increments `moved` and `gained` contain those of the inputs and of damping, and the function adds those
/// of the free motion. They are more accurate than differences of rounded numbers.
pub(super) fn shear<S: Float, Z: Size>(
    (model, state, masses): (&Model<S, Z>, &State<S, Z>, usize),
    (shears, before, after): (&[S], &[S], &mut [S]),
    (moved, gained): (&mut [S], &mut [S]),
) {
    let (by_speed, by_place) = shears.split_at_checked(masses * masses).unwrap_or_default();
    let (old_places, rest) = before.split_at_checked(masses).unwrap_or_default();
    let (old_speeds, forces) = rest.split_at_checked(masses).unwrap_or_default();
    let (places, rest) = after.split_at_mut_checked(masses).unwrap_or_default();
    let speeds = rest.get_mut(..masses).unwrap_or_default();
    let mut kept = model.size.contacts(S::constant(0.0));
    keep(model, state, (old_places, forces), kept.as_mut());
    let mut numbers = model.size.masses(S::constant(0.0));
    let numbers = numbers.as_mut();
    moments(model, old_speeds, numbers);
    let rows = by_speed.chunks_exact(masses.max(1));
    let ends = places.iter_mut().zip(old_places);
    let mut firsts = model.size.masses(S::constant(0.0));
    for (((place, old), first), row) in ends.zip(firsts.as_mut()).zip(rows.clone()) {
        *first = dot(row, numbers);
        *place = *old + *first;
    }
    let origin = origin(model, state, places);
    for (strain, place) in numbers.iter_mut().zip(&*places) {
        *strain = *place - origin;
    }
    let by_place = by_place.chunks_exact((masses + model.contacts().len()).max(1));
    let ends = speeds.iter_mut().zip(old_speeds);
    let results = ends.zip(gained.iter_mut().zip(model.masses()));
    for (((speed, old), (gained, mass)), row) in results.zip(by_place) {
        let (of_places, of_forces) = row.split_at_checked(masses).unwrap_or_default();
        let pull = dot(of_places, numbers) + dot(of_forces, kept.as_ref());
        // One rounding of the velocity in place of two: its errors add up while a chain slides far.
        *gained = *gained + pull / *mass;
        *speed = *old + *gained;
    }
    moments(model, speeds, numbers);
    let results = places.iter_mut().zip(moved.iter_mut().zip(firsts.as_ref()));
    for ((place, (moved, first)), row) in results.zip(rows) {
        let last = *moved + dot(row, numbers);
        *place = *place + last;
        *moved = *first + last;
    }
}

/// Writes the momentum of each mass.
fn moments<S: Float, Z: Size>(model: &Model<S, Z>, speeds: &[S], to: &mut [S]) {
    for ((moment, mass), speed) in to.iter_mut().zip(model.masses()).zip(speeds) {
        *moment = *mass * *speed;
    }
}

/// Writes the forces g of elastic contacts that stick.
fn keep<S: Float, Z: Size>(
    model: &Model<S, Z>,
    state: &State<S, Z>,
    (places, forces): (&[S], &[S]),
    kept: &mut [S],
) {
    for (j, (contact, kept)) in model.contacts().iter().zip(kept).enumerate() {
        if let Some(stiffness) = contact.stiffness.filter(|_| state.phase(j) == STUCK) {
            *kept = at(forces, j) - stiffness * contact.across(places);
        }
    }
}

/// Returns the displacement of the first mass if nothing holds the chain, and otherwise 0. The rows of B then have the sum
/// 0 only up to rounding errors, and displacements relative to a mass cause no force if all masses move alike.
fn origin<S: Float, Z: Size>(model: &Model<S, Z>, state: &State<S, Z>, places: &[S]) -> S {
    let wall = model.wall();
    let mut contacts = model.contacts().iter().enumerate();
    let is_held = contacts
        .any(|(j, contact)| state.phase(j) == STUCK && contact.plus.max(contact.minus) >= wall);
    if is_held || !model.is_unheld() {
        return S::constant(0.0);
    }
    at(places, 0)
}

impl<S: Float, Z: Size> Model<S, Z> {
    /// Returns true if the chain has dashpots or a damping matrix.
    pub(super) fn is_damped(&self) -> bool {
        !self.dashpots.as_ref().is_empty() || !self.damping.as_ref().is_empty()
    }

    /// Returns the chain without dashpots and without its damping matrix.
    pub(super) fn undamped(&self) -> Self {
        Self {
            dashpots: self.size.none(),
            damping: self.size.none(),
            ..self.clone()
        }
    }
}

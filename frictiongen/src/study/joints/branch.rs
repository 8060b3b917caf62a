//! Follows a steady state along a parameter p by pseudo-arclength continuation.
//!
//! The unknowns u of a steady state satisfy P(u, p) = u, where P maps the unknowns at the start of a period to those at
//! its end. The point (u, p) moves along a curve. A step goes along the tangent of the curve, and Newton's method then
//! returns to the curve in the plane that is normal to the tangent. It solves
//!
//! ```text
//! | ∂P/∂u − 1   ∂P/∂p | |δu|   |u − P|
//! |    tᵀu        tp   | |δp| = |  0  |
//! ```
//!
//! so that neither a fold nor an unstable state is an obstacle. ∂P/∂u is exact through all events. ∂P/∂p is a central
//! difference, which only guides the search.

use super::run::Motion;
use super::{Chain, Steady};
use frictiongen_kernel::joints::{self, Period};
use nalgebra::{Complex, DMatrix, DVector};

/// Largest number of Newton steps to a point.
const NEWTON: usize = 12;
/// Residual, relative to the size of the state, at which a point counts as found.
const FOUND: f64 = 1e-12;
/// Residual, divided by the largest derivative of the map, at which a point counts as found if further steps do not
/// reduce it. It is the rounding that an unstable motion has amplified.
const ROUNDED: f64 = 1e-12;
/// Largest ratio of the residuals after and before a step at which the next step uses the same derivatives.
const FAST: f64 = 0.05;
/// Ratio of singular values below which a direction changes nothing.
const RANK: f64 = 1e-13;
/// Half the step of the parameter in the difference ∂P/∂p, divided by the interval of the parameter.
const DIFFERENCE: f64 = 1e-6;
/// First, smallest and largest step along a branch. Displacements count in multiples of the size of the first state,
/// and the parameter in multiples of its interval.
const FIRST: f64 = 2e-3;
const SMALLEST: f64 = 1e-9;
const LARGEST: f64 = 0.02;
/// Smallest cosine of the angle between the tangents at two neighbouring points, for a step above [`CORNER`].
const STRAIGHT: f64 = 0.96;
/// Step below which the tangent may turn by any angle. At a corner, where an event appears or vanishes, it jumps.
const CORNER: f64 = 1e-5;
/// Smallest distance of a multiplier from the unit circle that counts as unstable.
const NOISE: f64 = 1e-7;
/// Largest distance of a multiplier from ±1 or the unit circle at a bifurcation. At a larger distance it has jumped.
const CRITICAL: f64 = 1e-2;
/// Largest distance of two points that count as the same.
const SAME: f64 = 1e-5;
/// Number of halvings that locate an event of a branch.
const HALVINGS: usize = 34;

/// The scene and the angular frequency of the load for a value of the parameter, or `None` outside the domain.
pub type Family<'f> = dyn Fn(f64) -> Option<(Chain, f64)> + 'f;

/// An event on a branch of steady states.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BranchEvent {
    /// The parameter turns back. A real multiplier passes 1, unless the point is also a corner.
    Fold,
    /// A multiplier passes −1. A branch with twice the period begins.
    PeriodDoubling,
    /// A multiplier of a symmetric state passes 1. Two asymmetric branches begin, mirror images of each other.
    SymmetryBreaking,
    /// A multiplier of an asymmetric state passes 1. Two branches cross.
    Crossing,
    /// Two complex multipliers pass the unit circle.
    Torus,
    /// Multipliers jump across the unit circle, because an event of the motion appears or vanishes.
    Jump,
    /// Stops or reversals of a contact appear or vanish (grazing). The number is the index of the contact.
    Stops(usize),
    /// A contact begins or ceases to slide. The number is the index of the contact.
    Slides(usize),
}

/// The reason why a branch ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BranchEnd {
    /// The parameter has reached a bound of its interval.
    Bound,
    /// The branch has returned to its first point.
    Closed,
    /// A branch of asymmetric states has met one of symmetric states.
    Symmetric,
    /// No next point was found, even with the smallest step.
    Lost,
    /// The largest number of points is reached.
    Points,
}

/// A point of a branch.
#[derive(Clone, Debug)]
pub struct BranchPoint {
    /// Value of the parameter.
    pub value: f64,
    /// The steady state.
    pub steady: Steady,
    /// True if the motion repeats with the opposite sign after half a cycle, as all motions of the branch do.
    pub is_symmetric: bool,
    /// Events at this point. The list is empty at an ordinary point.
    pub events: Vec<BranchEvent>,
    unknowns: DVector<f64>,
    moving: Vec<bool>,
    /// Direction of the branch. The last entry is that of the parameter.
    tangent: DVector<f64>,
}

/// A branch of steady states.
#[derive(Clone, Debug)]
pub struct Branch {
    /// Points in the order along the branch, with a point at each event.
    pub points: Vec<BranchPoint>,
    /// The reason why the branch ends.
    pub end: BranchEnd,
}

/// Interval of a parameter, and the scene as a function of the parameter.
pub struct Follower<'f> {
    /// The scene for each value of the parameter.
    pub family: &'f Family<'f>,
    /// First and last value of the parameter.
    pub interval: (f64, f64),
    /// Largest number of points on a branch.
    pub most: usize,
    /// Size of the displacements.
    pub size: f64,
    /// Number of masses.
    pub masses: usize,
}

/// A motion of the engine.
type Engine = joints::Motion<f64, joints::Heap>;

/// The map of a period at one point, with its derivatives.
struct Shot {
    period: Period,
    start: Engine,
    mapped: joints::Mapped,
}

/// A plane in which Newton's method stays, and a guess of the point in it.
struct Plane<'p> {
    unknowns: &'p DVector<f64>,
    place: f64,
    normal: &'p DVector<f64>,
}

impl Follower<'_> {
    /// Follows a steady state from the first value of the parameter. Returns `None` if there is no point on a branch
    /// close to the steady state.
    pub fn follow(&self, steady: &Steady) -> Option<Branch> {
        let unknowns = self.read(steady)?;
        let normal = towards(unknowns.len(), 1.0);
        let mut seed = BranchPoint {
            value: self.interval.0,
            steady: steady.clone(),
            is_symmetric: false,
            events: Vec::new(),
            unknowns,
            moving: moves(steady),
            tangent: normal.clone(),
        };
        seed.is_symmetric = self.is_symmetric(&seed);
        let plane = Plane {
            unknowns: &seed.unknowns,
            place: 0.0,
            normal: &normal,
        };
        let first = self.corrected(&seed, &plane)?;
        Some(self.walk(first, true))
    }

    /// Returns true if a branch ends at the first value of the parameter with this steady state.
    pub fn ends_at(&self, branch: &Branch, steady: &Steady) -> bool {
        let last = branch
            .points
            .last()
            .filter(|last| last.value == self.interval.0);
        let unknowns = self.read(steady);
        last.zip(unknowns).is_some_and(|(last, unknowns)| {
            last.unknowns.len() == unknowns.len()
                && (&last.unknowns - unknowns).amax() <= SAME
                && last.steady.period == steady.period
        })
    }

    /// Returns true if a branch passes through a point of another branch.
    pub fn passes(&self, branch: &Branch, at: &BranchPoint) -> bool {
        branch.points.iter().any(|point| {
            let along = self.place(point.value) - self.place(at.value);
            let amplitudes = |point: &BranchPoint| {
                DVector::from_column_slice(&point.steady.cycle.amplitudes) / self.size
            };
            along.abs() <= SAME && (amplitudes(point) - amplitudes(at)).amax() <= SAME
        })
    }

    /// Follows a branch that begins at a bifurcation of another branch. Returns `None` if the search finds no direction.
    pub fn switch(&self, at: &BranchPoint) -> Option<Branch> {
        let mut seed = at.clone();
        seed.events.clear();
        seed.is_symmetric = false;
        seed.moving = moves(&seed.steady);
        if at.events.contains(&BranchEvent::PeriodDoubling) {
            seed.steady.period *= 2;
        }
        let shot = self.shot(&seed, (&seed.unknowns, self.place(seed.value)), true)?;
        let matrix = self.augmented(&shot, &seed, &seed.tangent)?;
        let count = seed.unknowns.len();
        let rows = matrix.rows(0, count).into_owned();
        seed.tangent = self.other_direction(&rows, &seed)?;
        Some(self.walk(seed, false))
    }

    /// Returns the direction of the second branch through a point: the singular direction of the equations that is
    /// normal to the tangent of the first branch.
    fn other_direction(&self, rows: &DMatrix<f64>, at: &BranchPoint) -> Option<DVector<f64>> {
        // With the tangent as another row, only the second branch keeps a small singular value.
        let mut matrix = rows.clone().insert_row(rows.nrows(), 0.0);
        matrix
            .row_mut(rows.nrows())
            .copy_from(&at.tangent.transpose());
        let turned = matrix.svd(false, true);
        let directions = turned.v_t?;
        let smallest = turned.singular_values.imin();
        Some(directions.row(smallest).transpose())
    }

    /// Follows a branch from its first point, in the direction of its tangent. `is_first` is true unless the point is a
    /// bifurcation of another branch.
    fn walk(&self, first: BranchPoint, is_first: bool) -> Branch {
        let mut points = vec![first];
        let mut step = FIRST;
        let end = loop {
            if points.len() >= self.most {
                break BranchEnd::Points;
            }
            let Some(last) = points.last() else {
                break BranchEnd::Lost;
            };
            let Some((next, used)) = self.stepped(last, &mut step) else {
                break BranchEnd::Lost;
            };
            let place = self.place(next.value);
            if !(0.0..=1.0).contains(&place) {
                if let Some((end, step)) = self.at_bound(last, place) {
                    let located = self.located(last, &end, step);
                    points.extend(located);
                    points.push(end);
                }
                break BranchEnd::Bound;
            }
            let meets = !next.is_symmetric && self.is_symmetric(&next) && self.is_symmetric(last);
            // The first step onto a branch leaves the bifurcation, at which the other branch has its point.
            let located = match points.len() > 1 || is_first {
                true => self.located(last, &next, used),
                false => Vec::new(),
            };
            points.extend(located);
            points.push(next);
            if self.closes(&points) {
                break BranchEnd::Closed;
            }
            if meets {
                break BranchEnd::Symmetric;
            }
        };
        Branch { points, end }
    }

    /// Returns true if the steady state of a point repeats with the opposite sign after half a cycle.
    fn is_symmetric(&self, point: &BranchPoint) -> bool {
        let steady = &point.steady;
        let at = (self.family)(point.value).filter(|_| steady.period == 1);
        at.is_some_and(|(chain, omega)| steady.is_symmetric(&chain, omega).unwrap_or(false))
    }

    /// Returns the next point of a branch and the step to it. Adapts the step to the next one.
    fn stepped(&self, from: &BranchPoint, step: &mut f64) -> Option<(BranchPoint, f64)> {
        while *step >= SMALLEST {
            let used = *step;
            if let Some(next) = self.along(from, used) {
                let tangents =
                    [&next, from].map(|point| self.of_masses(&point.tangent).normalize());
                let straight = tangents[0].dot(&tangents[1]);
                if straight >= STRAIGHT || used <= CORNER {
                    let size = next.unknowns.norm().max(1.0);
                    if straight >= 0.5 * (1.0 + STRAIGHT) {
                        *step = (1.6 * used).min(LARGEST * size);
                    }
                    return Some((next, used));
                }
            }
            *step = 0.4 * used;
        }
        None
    }

    /// Returns the components of the masses and of the parameter in a change of a point. The position of a rigid contact
    /// is left out, because it is an unknown only while the contact sticks at the start of the period.
    fn of_masses(&self, change: &DVector<f64>) -> DVector<f64> {
        let masses = change.rows(0, self.masses * 2).into_owned();
        masses.push(along(change))
    }

    /// Returns the point at a distance along the tangent of a point.
    fn along(&self, from: &BranchPoint, step: f64) -> Option<BranchPoint> {
        let count = from.unknowns.len();
        let unknowns = &from.unknowns + from.tangent.rows(0, count) * step;
        let plane = Plane {
            unknowns: &unknowns,
            place: self.place(from.value) + step * along(&from.tangent),
            normal: &from.tangent,
        };
        let next = self.corrected(from, &plane)?;
        let moved =
            (&next.unknowns - &from.unknowns).push(self.place(next.value) - self.place(from.value));
        (self.of_masses(&moved).norm() <= 2.0 * step + SAME * SAME).then_some(next)
    }

    /// Returns the point at the bound of the interval that a step has passed, and the step to it.
    fn at_bound(&self, from: &BranchPoint, passed: f64) -> Option<(BranchPoint, f64)> {
        let count = from.unknowns.len();
        let slope = along(&from.tangent);
        let normal = towards(count, slope.signum());
        let bound = passed.clamp(0.0, 1.0);
        let step = (bound - self.place(from.value)) / slope;
        let unknowns = &from.unknowns + from.tangent.rows(0, count) * step;
        let plane = Plane {
            unknowns: &unknowns,
            place: bound,
            normal: &normal,
        };
        let end = self.corrected(from, &plane).filter(|_| step.is_finite())?;
        Some((end, step))
    }

    /// Returns the points at which something changes between two neighbouring points of a branch, in their order.
    /// `step` is the distance between the points.
    fn located(&self, from: &BranchPoint, to: &BranchPoint, step: f64) -> Vec<BranchPoint> {
        let mut all: Vec<(f64, BranchPoint)> = Vec::new();
        for event in changes(from, to) {
            let (mut low, mut high) = (0.0, step);
            let (mut before, mut after) = (from.clone(), to.clone());
            for _ in 0..HALVINGS {
                let middle = 0.5 * (low + high);
                let Some(point) = self.along(from, middle) else {
                    break;
                };
                if changes(from, &point).contains(&event) {
                    (high, after) = (middle, point);
                } else {
                    (low, before) = (middle, point);
                }
            }
            let event = if event.is_smooth() && jumps(&before, &after) {
                BranchEvent::Jump
            } else {
                event
            };
            match all
                .iter_mut()
                .find(|known| (known.0 - high).abs() <= 1e-6 * step)
            {
                Some((_, known)) if known.events.contains(&event) => {}
                Some((_, known)) => known.events.push(event),
                None => {
                    after.events = vec![event];
                    all.push((high, after));
                }
            }
        }
        all.sort_by(|one, other| one.0.total_cmp(&other.0));
        all.into_iter().map(|(_, point)| point).collect()
    }

    /// Returns true if the last step of a branch has passed its first point in the direction of that point.
    fn closes(&self, points: &[BranchPoint]) -> bool {
        let [first, _, _, .., before, last] = points else {
            return false;
        };
        let apart = |point: &BranchPoint| {
            let away = &point.unknowns - &first.unknowns;
            let place = self.place(point.value) - self.place(first.value);
            let tangent = &first.tangent;
            let height = away.dot(&tangent.rows(0, away.len())) + place * along(tangent);
            (height, away.norm().hypot(place))
        };
        let (one, other) = (apart(before), apart(last));
        let step = (&last.unknowns - &before.unknowns).norm();
        let step = step.hypot(self.place(last.value) - self.place(before.value));
        one.0 <= 0.0 && other.0 > 0.0 && one.1.max(other.1) <= 1.5 * step
    }

    /// Returns the point of a branch in a plane, by Newton's method. Returns `None` if the method does not converge.
    ///
    /// While the residual falls fast, steps use the derivatives of an earlier step.
    fn corrected(&self, near: &BranchPoint, plane: &Plane<'_>) -> Option<BranchPoint> {
        let count = near.unknowns.len();
        let mut seed = near.clone();
        let (mut unknowns, mut place) = (plane.unknowns.clone(), plane.place);
        let mut before = f64::INFINITY;
        let mut known: Option<DMatrix<f64>> = None;
        for _ in 0..NEWTON {
            seed.value = self.value(place);
            let shot = self.shot(&seed, (&unknowns, place), known.is_none())?;
            seed.moving = shot.period.moving().to_vec();
            if shot.start.state().phases != shot.mapped.end.state().phases {
                // A contact that sticks at the start slides there in the steady state, or the reverse.
                unknowns = DVector::from_column_slice(&shot.mapped.to);
                seed.steady.state = shot.mapped.end.state().clone();
                known = None;
                continue;
            }
            seed.steady.state = shot.start.state().clone();
            let mut from = DVector::from_column_slice(&shot.mapped.from);
            let residual = &from - DVector::from_column_slice(&shot.mapped.to);
            keep_unused(&mut from, &residual, plane.unknowns);
            let size = residual.amax();
            let rounding = ROUNDED * known.as_ref().map_or(0.0, |known| self.largest(known));
            if size <= FOUND || (size <= rounding && size >= 0.5 * before) {
                return self.point((&from, place), seed);
            }
            if size > FAST * before || known.is_none() {
                let shot = match shot.mapped.derivatives.is_empty() {
                    true => self.shot(&seed, (&from, place), true)?,
                    false => shot,
                };
                known = Some(self.augmented(&shot, &seed, plane.normal)?);
            }
            before = size;
            let away = (&from - plane.unknowns).dot(&plane.normal.rows(0, count))
                + (place - plane.place) * along(plane.normal);
            let right = residual.insert_row(count, -away);
            let change = known.clone()?.svd(true, true).solve(&right, RANK).ok()?;
            unknowns = from + change.rows(0, count);
            place += along(&change);
            if !(unknowns.iter().all(|u| u.is_finite()) && place.is_finite()) {
                return None;
            }
        }
        None
    }

    /// Returns the largest derivative with respect to the state of the masses in the matrix of the equations of a point.
    fn largest(&self, matrix: &DMatrix<f64>) -> f64 {
        let masses = 2 * self.masses;
        1.0 + matrix.view((0, 0), (masses, masses)).amax()
    }

    /// Returns a found point with its steady state and its tangent.
    fn point(
        &self,
        (unknowns, place): (&DVector<f64>, f64),
        seed: BranchPoint,
    ) -> Option<BranchPoint> {
        let shot = self.shot(&seed, (unknowns, place), true)?;
        let matrix = self.augmented(&shot, &seed, &seed.tangent)?;
        let unit = towards(unknowns.len(), 1.0);
        let tangent = matrix.svd(true, true).solve(&unit, RANK).ok()?;
        let tangent = tangent.try_normalize(0.0)?;
        let Shot {
            mut period,
            start,
            mapped,
        } = shot;
        let moving = period.moving().to_vec();
        let steady = Steady::new(period.steady(start, mapped.derivatives).ok()?);
        Some(BranchPoint {
            value: seed.value,
            is_symmetric: seed.is_symmetric,
            steady,
            events: Vec::new(),
            unknowns: unknowns.clone(),
            moving,
            tangent,
        })
    }

    /// Returns the matrix of the equations of a point, with the normal of a plane as last row.
    fn augmented(
        &self,
        shot: &Shot,
        seed: &BranchPoint,
        normal: &DVector<f64>,
    ) -> Option<DMatrix<f64>> {
        let count = shot.mapped.from.len();
        let map = DMatrix::from_column_slice(count, count, &shot.mapped.derivatives);
        let mut matrix = DMatrix::zeros(count + 1, count + 1);
        matrix
            .view_mut((0, 0), (count, count))
            .copy_from(&(map - DMatrix::identity(count, count)));
        let slope = self.slope(shot, seed)?;
        matrix.view_mut((0, count), (count, 1)).copy_from(&slope);
        matrix.row_mut(count).copy_from(&normal.transpose());
        Some(matrix)
    }

    /// Returns ∂P/∂p as a difference over two neighbouring values of the parameter. At the edge of the domain, or where a
    /// contact begins or ceases to stick at the end of the period, it is a difference over one of them.
    fn slope(&self, shot: &Shot, seed: &BranchPoint) -> Option<DVector<f64>> {
        let unknowns = DVector::from_column_slice(&shot.mapped.from);
        let place = self.place(seed.value);
        let phases = &shot.mapped.end.state().phases;
        let side = |step: f64| -> Option<(DVector<f64>, f64)> {
            let shot = self.shot(seed, (&unknowns, place + step), false)?;
            let same = shot.mapped.end.state().phases == *phases;
            same.then(|| (DVector::from_column_slice(&shot.mapped.to), step))
        };
        let own = || (DVector::from_column_slice(&shot.mapped.to), 0.0);
        let (above, up) = side(DIFFERENCE).unwrap_or_else(own);
        let (below, down) = side(-DIFFERENCE).unwrap_or_else(own);
        (up > down).then(|| (above - below) / (up - down))
    }

    /// Follows the motion from the given unknowns over one period.
    fn shot(
        &self,
        seed: &BranchPoint,
        (unknowns, place): (&DVector<f64>, f64),
        derives: bool,
    ) -> Option<Shot> {
        let (motion, omega) = self.motion(&seed.steady, self.value(place))?;
        let mut period = self.period(&motion, omega, seed);
        let start = period.start(&motion, &unknowns.as_slice().to_vec());
        let mapped = period.map(&start, derives).ok()?;
        Some(Shot {
            period,
            start,
            mapped,
        })
    }

    /// Returns the motion from the state of a steady state at a value of the parameter, and the angular frequency of the
    /// load there.
    fn motion(&self, steady: &Steady, value: f64) -> Option<(Engine, f64)> {
        let (chain, omega) = (self.family)(value)?;
        let mut motion = Motion::from_rest(&chain).ok()?;
        motion.restart(steady.state.clone());
        Some((motion.into_engine(), omega))
    }

    /// Returns the map of which the states of a branch are fixed points. On a branch of symmetric states, it is that over
    /// half a cycle, which stays regular where the symmetry breaks.
    fn period(&self, motion: &Engine, omega: f64, seed: &BranchPoint) -> Period {
        if seed.is_symmetric {
            return Period::half(motion, omega, self.size);
        }
        let mut period = Period::new(motion, omega, (seed.steady.period, self.size));
        period.set_moving(&seed.moving);
        period
    }

    /// Returns the unknowns of a steady state at the first value of the parameter.
    fn read(&self, steady: &Steady) -> Option<DVector<f64>> {
        let (motion, omega) = self.motion(steady, self.interval.0)?;
        let mut period = Period::new(&motion, omega, (steady.period, self.size));
        period.set_moving(&moves(steady));
        let mapped = period.map(&motion, false).ok()?;
        Some(DVector::from_vec(mapped.from))
    }

    /// Returns the value of the parameter at a place. The places 0 and 1 are the ends of the interval.
    fn value(&self, place: f64) -> f64 {
        let (from, to) = self.interval;
        from + (to - from) * place
    }

    fn place(&self, value: f64) -> f64 {
        let (from, to) = self.interval;
        (value - from) / (to - from)
    }
}

/// Gives unknowns that do not affect the motion their guessed values. They are 0 at the start and at the end.
fn keep_unused(from: &mut DVector<f64>, residual: &DVector<f64>, guess: &DVector<f64>) {
    let others = residual.iter().zip(guess);
    for (own, (residual, guess)) in from.iter_mut().zip(others) {
        if *own == 0.0 && *residual == 0.0 {
            *own = *guess;
        }
    }
}

/// Returns the component of the parameter in a direction of a branch.
fn along(direction: &DVector<f64>) -> f64 {
    direction.as_slice().last().copied().unwrap_or_default()
}

/// Returns the direction of the parameter, for a number of unknowns.
fn towards(unknowns: usize, sense: f64) -> DVector<f64> {
    DVector::zeros(unknowns).push(sense)
}

/// Returns true for each contact that slides in a steady state.
fn moves(steady: &Steady) -> Vec<bool> {
    let contacts = 0..steady.state.phases.len();
    contacts.map(|j| !steady.marginal.contains(&j)).collect()
}

impl BranchPoint {
    /// Returns true if another branch begins at this point.
    pub fn begins_branch(&self) -> bool {
        let begins = [
            BranchEvent::PeriodDoubling,
            BranchEvent::SymmetryBreaking,
            BranchEvent::Crossing,
        ];
        self.events.iter().any(|event| begins.contains(event))
    }
}

impl BranchEvent {
    /// Returns true for a bifurcation at which a multiplier passes the unit circle continuously.
    fn is_smooth(self) -> bool {
        let smooth = [
            Self::PeriodDoubling,
            Self::SymmetryBreaking,
            Self::Crossing,
            Self::Torus,
        ];
        smooth.contains(&self)
    }
}

/// Numbers of multipliers outside the unit circle: real ones above 1, real ones below −1, and complex ones.
fn outside(multipliers: &[Complex<f64>]) -> [usize; 3] {
    let mut counts = [0; 3];
    for multiplier in multipliers.iter().filter(|m| m.norm() > 1.0 + NOISE) {
        let kind = match multiplier {
            m if m.im.abs() > NOISE => 2,
            m if m.re > 0.0 => 0,
            _ => 1,
        };
        if let Some(count) = counts.get_mut(kind) {
            *count += 1;
        }
    }
    counts
}

/// Returns what changes between two neighbouring points of a branch.
fn changes(from: &BranchPoint, to: &BranchPoint) -> Vec<BranchEvent> {
    let mut all = Vec::new();
    let rises = |point: &BranchPoint| along(&point.tangent) > 0.0;
    let (before, after) = (
        outside(&from.steady.multipliers),
        outside(&to.steady.multipliers),
    );
    let folds = rises(from) != rises(to);
    if folds {
        all.push(BranchEvent::Fold);
    } else if before[0] != after[0] {
        all.push(if from.is_symmetric {
            BranchEvent::SymmetryBreaking
        } else {
            BranchEvent::Crossing
        });
    }
    if before[1] != after[1] {
        all.push(BranchEvent::PeriodDoubling);
    }
    if before[2] != after[2] {
        all.push(BranchEvent::Torus);
    }
    let contacts = from
        .steady
        .cycle
        .contacts
        .iter()
        .zip(&to.steady.cycle.contacts);
    for (j, (one, other)) in contacts.enumerate() {
        let slid = |point: &BranchPoint| !point.steady.marginal.contains(&j);
        if slid(from) != slid(to) {
            all.push(BranchEvent::Slides(j));
        } else if (one.stops, one.reversals) != (other.stops, other.reversals) {
            all.push(BranchEvent::Stops(j));
        }
    }
    all
}

/// Returns true if no multiplier is close to the unit circle just before or just after a change of stability.
fn jumps(before: &BranchPoint, after: &BranchPoint) -> bool {
    let nearest = |point: &BranchPoint| {
        let away = point
            .steady
            .multipliers
            .iter()
            .map(|m| (m.norm() - 1.0).abs());
        away.fold(f64::INFINITY, f64::min)
    };
    nearest(before).max(nearest(after)) > CRITICAL
}

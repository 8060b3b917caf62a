//! Derivatives of a steady state with respect to one parameter of its chain, through all events.
//!
//! The unknowns u at the start of a period satisfy u = P(u, p), where P is the map over a period and p is the parameter.
//! The derivative therefore satisfies (1 − ∂P/∂u) du/dp = ∂P/∂p. The code follows the motion with dual numbers, in which
//! the instant of every event has a derivative, too. From the present du/dp, one period gives the derivative of P(u, p).
//! Its difference from du/dp is the residual of the equation, and corrects du/dp. The results of the period then have
//! derivatives.
//!
//! A motion that repeats with the opposite sign after half a cycle is a fixed point of the map over half a cycle. This map
//! also determines the positions of contacts that never slide: they stay in the middle of the interval in which they can
//! stick.

use super::cycle::{Cycle, Watch};
use super::heap::{Heap, Short};
use super::model::{Contact, Model};
use super::poly::Poly;
use super::roots::first_negative;
use super::run::{Motion, Observe};
use super::series::Series;
use super::size::{add, sign};
use super::state::{FREE, STUCK, State};
use super::steady::{Search, Steady};
use super::tangent::{Both, ShotSpan};
use crate::Float;
use crate::number::dual::Dual;
use crate::number::matrix::SquareMatrix;
use crate::orbit::NoDerivative;

/// Largest number of periods that the motion is followed for the derivative of the state.
const PERIODS: usize = 8;
/// Largest residual of the derivative of the state, divided by this derivative.
const CLOSED: f64 = 1e-11;
/// Largest residual that rounding causes if a change of the parameter by 100 % hardly changes the state.
const ROUNDING: f64 = 1e-14;
/// Largest residual that the code accepts if further periods do not reduce it.
const NEARLY: f64 = 1e-7;
/// Largest change of the unknowns over half a cycle at which the motion repeats with the opposite sign.
const SYMMETRIC: f64 = 1e-9;
/// Distance from 0 below which the watched quantity of a contact grazes 0, divided by its size. The watched quantity is
/// 0 at an event.
const GRAZE: f64 = 1e-9;
/// Part of a stretch before an event in which the watched quantity may be that close to 0.
const WIDE: f64 = 1e-5;

/// A number with its derivative.
type Number = Dual<f64>;

/// Computes the derivatives of a steady state with respect to the parameter of the numbers in `model` and `omega`. Their
/// values are those of the chain of the steady state. `parameter` is the size of the parameter, above 0. `watch` observes
/// one period with derivatives.
///
/// # Errors
///
/// [`NoDerivative::Marginal`] if the state depends on the initial state. [`NoDerivative::Graze`] if an event is about to
/// appear or to vanish. [`NoDerivative::Unsettled`] if the motion does not repeat.
pub fn vary(
    model: Model<Number, Heap>,
    (omega, parameter): (Number, f64),
    steady: &Steady<f64, Heap>,
    watch: &mut impl Observe<Number, Heap>,
) -> Result<Cycle<Number, Heap>, NoDerivative> {
    let amplitudes = steady.cycle.amplitudes.iter().copied();
    let place = Number::fixed(amplitudes.fold(f64::from(f32::MIN_POSITIVE), f64::max));
    let unsettled = |_| NoDerivative::Unsettled;
    let mut start = Motion::new(model, &[], &[]).map_err(unsettled)?;
    start.restart(with_derivatives(&steady.state));
    let mut closing = Closing {
        search: Search::new(&start, omega, place),
        span: ShotSpan::Half,
        rounding: ROUNDING / parameter,
    };
    let mut start = closing.closed(start, steady)?;
    let mut results = Watch::new(start.model());
    let mut grazes = Grazes {
        contacts: start.model().contacts.clone(),
        phases: start.state().phases.clone(),
        found: false,
    };
    let first = start.state().phases.clone();
    let mut both = Both(&mut grazes, watch);
    let mut all = Both(&mut results, &mut both);
    let search = &mut closing.search;
    let run = search.advance(&mut start, steady.period, &mut all);
    run.map_err(unsettled)?;
    results.close(&first, &start.state().phases);
    let cycle = results.cycle(search.length(steady.period));
    if grazes.found || events(&cycle) != events(&steady.cycle) {
        return Err(NoDerivative::Graze);
    }
    Ok(cycle)
}

/// Returns the numbers of stops and reversals of each contact.
fn events<S: Float>(cycle: &Cycle<S, Heap>) -> Short<(usize, usize)> {
    let contacts = cycle.contacts.iter();
    contacts.map(|own| (own.stops, own.reversals)).collect()
}

/// Returns a state whose numbers have the derivative 0.
fn with_derivatives(state: &State<f64, Heap>) -> State<Number, Heap> {
    let fixed = |values: &[f64]| values.iter().copied().map(Number::fixed).collect();
    State {
        x: fixed(&state.x),
        v: fixed(&state.v),
        forces: fixed(&state.forces),
        places: fixed(&state.places),
        phases: state.phases.clone(),
        zeros: state.zeros.clone(),
    }
}

/// Search for the derivative of the state at the start of a period.
struct Closing {
    search: Search<Number, Heap>,
    span: ShotSpan,
    /// Largest residual that rounding causes.
    rounding: f64,
}

impl Closing {
    /// Returns the motion at the start of the period, with the derivative of its state.
    fn closed(
        &mut self,
        mut start: Motion<Number, Heap>,
        steady: &Steady<f64, Heap>,
    ) -> Result<Motion<Number, Heap>, NoDerivative> {
        let matrix = self.matrix(&start, steady)?;
        let mut before = f64::INFINITY;
        for _ in 0..PERIODS {
            let shot = self.search.shoot(&start, self.span, false);
            let end = shot.map_err(|_| NoDerivative::Unsettled)?.end;
            if end.state().phases != start.state().phases {
                return Err(NoDerivative::Graze);
            }
            let unknowns = self.search.unknowns();
            let (from, to) = (unknowns.read(&start), unknowns.read(&end));
            let mut change: Vec<f64> = to
                .iter()
                .zip(&from)
                .map(|(to, from)| to.slope - from.slope)
                .collect();
            let size = |values: &[f64]| values.iter().fold(0.0, |most, x| f64::max(most, x.abs()));
            let slopes: Vec<f64> = to.iter().map(|number| number.slope).collect();
            let (residual, whole) = (size(&change), size(&slopes));
            if !slopes.iter().all(|slope| slope.is_finite()) {
                return Err(NoDerivative::Graze);
            }
            let is_least = residual <= NEARLY * whole && residual >= 0.5 * before;
            if residual <= CLOSED * whole + self.rounding || is_least {
                return Ok(start);
            }
            before = residual;
            let mut work = matrix.clone();
            let count = change.len();
            if !SquareMatrix::new(&mut work, count).solve_shifted(1.0, &mut change) {
                return Err(NoDerivative::Graze);
            }
            let moved = from.iter().zip(change).map(|(from, change)| Number {
                slope: from.slope + change,
                ..*from
            });
            start = unknowns.write(&start, &moved.collect());
        }
        Err(NoDerivative::Graze)
    }

    /// Selects the map over half a cycle or over a period, and returns its derivatives with respect to the unknowns, column
    /// by column.
    fn matrix(
        &mut self,
        start: &Motion<Number, Heap>,
        steady: &Steady<f64, Heap>,
    ) -> Result<Vec<f64>, NoDerivative> {
        let values = |matrix: Option<Vec<Number>>| {
            let matrix = matrix.unwrap_or_default().into_iter();
            matrix.map(|entry| entry.value).collect()
        };
        let unsettled = |_| NoDerivative::Unsettled;
        self.search.moving.fill(true);
        if steady.period == 1 && self.search.is_odd(start.model()) {
            let shot = self.search.shoot(start, ShotSpan::Half, true);
            let shot = shot.map_err(unsettled)?;
            let unknowns = self.search.unknowns();
            let (from, to) = (unknowns.read(start), unknowns.read(&shot.end));
            let mut pairs = from.iter().zip(&to);
            if pairs.all(|(from, to)| (to.value - from.value).abs() <= SYMMETRIC) {
                return Ok(values(shot.derivatives));
            }
        }
        if steady.neutral > 0 || steady.marginal.contains(&true) {
            return Err(NoDerivative::Marginal);
        }
        self.span = ShotSpan::Cycles(steady.period);
        let shot = self.search.shoot(start, self.span, true);
        let shot = shot.map_err(unsettled)?;
        self.search.moving = shot.moving;
        Ok(values(shot.derivatives))
    }
}

/// Observer of a period that detects grazes: instants at which an event is about to appear or to vanish.
struct Grazes {
    contacts: Short<Contact<Number>>,
    /// Phases of the contacts in the last stretch.
    phases: Short<i8>,
    found: bool,
}

impl Observe<Number, Heap> for Grazes {
    fn stretch(&mut self, series: &Series<Number, Heap>, end: Number, state: &State<Number, Heap>) {
        for (j, contact) in self.contacts.iter().enumerate() {
            let phase = state.phase(j);
            let begins = self.phases.get(j) != Some(&phase);
            let (zeros, zero_side) = state.zeros.get(j).copied().unwrap_or_default();
            let mut check = |terms: Poly<Number>, zeros| {
                self.found |= is_near_zero(&terms, zeros, (end.value, begins));
            };
            if let Some(stop) = contact.stop {
                let opening = match phase {
                    STUCK => series.force_terms(j).map(|term| stop.side * term),
                    _ => series.opening_terms(contact, &stop),
                };
                check(opening, zeros);
                continue;
            }
            match phase {
                FREE => {}
                STUCK => {
                    let most = contact.stiction * contact.level.constant;
                    // An elastic contact begins to stick with the rate 0 of its force, of which rounding may hide the zero.
                    let rest = if contact.is_rigid() {
                        zeros
                    } else {
                        zeros.max(2)
                    };
                    for side in [1, -1] {
                        let force = series.force_terms(j);
                        let mut margin = force.map(|term| -(sign::<Number>(side) * term));
                        add(&mut margin, 0, most);
                        let is_at_limit = zeros > 0 && side == zero_side;
                        check(margin, if is_at_limit { rest } else { 0 });
                    }
                }
                side => {
                    let speed = series.slip_terms(contact.sides());
                    check(speed.map(|term| sign::<Number>(side) * term), zeros);
                }
            }
        }
        self.phases = state.phases.clone();
    }
}

/// Returns true if a quantity with the coefficients `terms` comes close to 0 without an event, or long before its event.
/// The quantity is 0 at an event. The first `zeros` coefficients are 0, because the stretch begins with an event. `end` is
/// the end of the stretch, and `begins` is true if the contact has its phase since the start of the stretch.
fn is_near_zero(terms: &Poly<Number>, zeros: usize, (end, begins): (f64, bool)) -> bool {
    let used = terms.iter().skip(zeros);
    let size = used.fold(0.0, |sum, term| sum + term.value.abs());
    let mut lowered = *terms;
    add(&mut lowered, zeros, Number::fixed(-GRAZE * size));
    first_negative(&lowered, zeros).is_some_and(|at| {
        let is_at_start = begins && at.value == 0.0;
        is_at_start || end - at.value > WIDE
    })
}

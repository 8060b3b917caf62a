//! Integrates the governing equations in time by the classical Runge-Kutta method.

use super::plain::Plain;
use nalgebra::DVector;
use std::f64::consts::{PI, TAU};

/// Number of steps in a half period. For frequencies of order 1, the relative error of Runge-Kutta is then about
/// 1e-11.
const STEPS: usize = 400;

/// Displacements and velocities of all masses.
type State = (DVector<f64>, DVector<f64>);

/// The motion after the transient has decayed.
#[derive(Clone, Debug)]
pub struct Steady {
    plain: Plain,
    beta: f64,
    /// Number of stops of the contact in the last ten periods.
    pub stops: usize,
    /// Angle of the excitation at the last maximum of z̄, in (−π, π].
    pub phi: f64,
    /// Largest |x̄₁| at the steps of the last period.
    pub largest: f64,
    start: State,
}

fn derivative(plain: &Plain, t: f64, (x, v): &State, friction: Option<f64>) -> State {
    let force = friction.unwrap_or_else(|| plain.holding_force(t, x, v));
    let load = &plain.p * t.cos() - &plain.c * v - &plain.k * x - &plain.w * force;
    (
        v.clone(),
        load.component_div(&plain.gamma) / plain.r.powi(2),
    )
}

fn step(plain: &Plain, t: f64, y: &State, h: f64, friction: Option<f64>) -> State {
    let add = |k: &State, by: f64| (&y.0 + &k.0 * by, &y.1 + &k.1 * by);
    let k1 = derivative(plain, t, y, friction);
    let k2 = derivative(plain, t + 0.5 * h, &add(&k1, 0.5 * h), friction);
    let k3 = derivative(plain, t + 0.5 * h, &add(&k2, 0.5 * h), friction);
    let k4 = derivative(plain, t + h, &add(&k3, h), friction);
    let sum = |a: &DVector<f64>, b: &DVector<f64>, c: &DVector<f64>, d: &DVector<f64>| {
        (a + b * 2.0 + c * 2.0 + d) * (h / 6.0)
    };
    (
        &y.0 + sum(&k1.0, &k2.0, &k3.0, &k4.0),
        &y.1 + sum(&k1.1, &k2.1, &k3.1, &k4.1),
    )
}

/// Integrates from rest for some periods of the excitation. The contact sticks whenever friction can keep it stuck.
pub fn run(plain: &Plain, beta: f64, periods: usize) -> Steady {
    run_from(plain, beta, periods, DVector::zeros(plain.n()))
}

/// Integrates from given displacements without velocity. The start is at a maximum of the excitation.
pub fn run_from(plain: &Plain, beta: f64, periods: usize, start: DVector<f64>) -> Steady {
    let velocity = DVector::zeros(plain.n());
    integrate(plain, beta, periods, 0.0, (start, velocity), None)
}

/// Integrates from the formal continuous motion, starting at the maximum of the contact's motion.
pub fn run_on(plain: &Plain, beta: f64, periods: usize) -> Steady {
    let (x, phi) = (plain.motion(beta), plain.amplitude_phase(beta).1);
    let h = 1e-4;
    let start = DVector::from_fn(plain.n(), |k, _| x(k, 0.0));
    let velocity = DVector::from_fn(plain.n(), |k, _| (x(k, h) - x(k, -h)) / (2.0 * h));
    integrate(plain, beta, periods, phi, (start, velocity), Some(-beta))
}

/// Integrates the motion. `friction` is the force of a sliding contact; it is `None` while the contact is stuck.
fn integrate(
    plain: &Plain,
    beta: f64,
    periods: usize,
    mut t: f64,
    mut y: State,
    mut friction: Option<f64>,
) -> Steady {
    let slip = |t: f64, y: &State| plain.w.dot(&y.1) + plain.s * t.sin();
    let (mut stops, mut largest, mut start) = (0, 0.0_f64, (t, y.clone()));
    let end = t + TAU * periods as f64;
    while t < end {
        if end - TAU < t {
            largest = largest.max(y.0[0].abs());
        }
        let h = PI / STEPS as f64;
        let Some(force) = friction else {
            let holding = plain.holding_force(t, &y.0, &y.1);
            if holding.abs() > plain.mu * beta {
                friction = Some(beta * holding.signum());
            } else {
                (t, y) = (t + h, step(plain, t, &y, h, None));
            }
            continue;
        };
        let next = step(plain, t, &y, h, friction);
        // A contact that has just begun to slide has no velocity yet.
        if force * slip(t + h, &next) > 0.0 {
            (t, y) = (t + h, next);
            continue;
        }
        let (mut low, mut high) = (0.0, h);
        while high - low > 1e-15 {
            let middle = 0.5 * (low + high);
            if force * slip(t + middle, &step(plain, t, &y, middle, friction)) > 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        y = step(plain, t, &y, high, friction);
        t += high;
        let holding = plain.holding_force(t, &y.0, &y.1);
        if holding.abs() > plain.mu * beta {
            friction = Some(beta * holding.signum());
        } else {
            friction = None;
            stops += 1;
        }
        if force > 0.0 {
            start = (t, y.clone());
        }
    }
    let (t, start) = start;
    Steady {
        plain: plain.clone(),
        beta,
        stops,
        phi: (t + PI).rem_euclid(TAU) - PI,
        largest,
        start,
    }
}

impl Steady {
    /// Returns displacements and velocities of a motion without stops, at the angle τ in [0, π] after a maximum of
    /// z̄.
    pub fn at(&self, tau: f64) -> State {
        assert_eq!(self.stops, 0);
        let h = tau / STEPS as f64;
        let mut y = self.start.clone();
        for i in 0..STEPS {
            let t = self.phi + h * i as f64;
            y = step(&self.plain, t, &y, h, Some(-self.beta));
        }
        y
    }
}

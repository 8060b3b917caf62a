//! The closed forms against plain time integration.
//!
//! Nothing here is shared with the project but the numbers of the scenes: hand-written matrices,
//! the classical Runge-Kutta method with a fixed step, and the reversals found by bisection within
//! a step.  Damped scenes run until the transient has gone; of undamped ones the periodic state is
//! found by Newton's method on the half-period map of that same integration.
//!
//! Tolerance: with [`STEPS`] steps to a half period the fastest mode of the scenes compared advances
//! by less than 4e-3 rad a step, so Runge-Kutta's error is some 1e-11, and what remains of the transient or
//! of Newton's residual is asserted below 1e-11 too.  The reversal instants and the
//! displacements then agree within 1e-11; [`TOLERANCE`] leaves a digit.

use frictiongen::study::System;
use std::f64::consts::PI;

/// Steps to a half period.
const STEPS: usize = 2000;
/// Relative to the motion, of everything compared.
const TOLERANCE: f64 = 1e-10;

/// A scene as equations: r²Γx̄″ + C̄x̄′ + K̄x̄ + wf = p cos τ_e and z̄ = wᵀx̄ − s cos τ_e.
#[derive(Clone)]
struct Chain {
    /// Up to three masses; the rest stays idle.
    n: usize,
    gamma: [f64; 3],
    c: [[f64; 3]; 3],
    k: [[f64; 3]; 3],
    w: [f64; 3],
    p: [f64; 3],
    s: f64,
    mu: f64,
    r: f64,
    beta: f64,
}

/// Displacements, then velocities with respect to τ.
type State = [f64; 6];

/// What the contact does.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Contact {
    /// Slides in the direction of this sign.
    Slides(f64),
    Holds,
}

fn dot(a: &[f64; 3], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Chain {
    /// p cos τ_e − C̄x̄′ − K̄x̄, what is left for inertia and contact.
    fn load(&self, t: f64, y: &State) -> [f64; 3] {
        std::array::from_fn(|i| {
            self.p[i] * t.cos() - dot(&self.c[i], &y[3..]) - dot(&self.k[i], &y[..3])
        })
    }

    /// The contact force that keeps z̄′ as it is: from z̄″ = 0.
    fn holding_force(&self, t: f64, y: &State) -> f64 {
        let load = self.load(t, y);
        let free: f64 = (0..self.n)
            .map(|i| self.w[i] * load[i] / self.gamma[i])
            .sum();
        let mobility: f64 = (0..self.n)
            .map(|i| self.w[i] * self.w[i] / self.gamma[i])
            .sum();
        (free + self.r * self.r * self.s * t.cos()) / mobility
    }

    fn derivative(&self, t: f64, y: &State, contact: Contact) -> State {
        let force = match contact {
            Contact::Slides(sign) => self.beta * sign,
            Contact::Holds => self.holding_force(t, y),
        };
        let load = self.load(t, y);
        let mut out = [0.0; 6];
        for i in 0..self.n {
            out[i] = y[3 + i];
            out[3 + i] = (load[i] - self.w[i] * force) / (self.r * self.r * self.gamma[i]);
        }
        out
    }

    /// One step of the classical Runge-Kutta method.
    fn step(&self, t: f64, y: &State, h: f64, contact: Contact) -> State {
        let add = |k: &State, by: f64| -> State { std::array::from_fn(|i| y[i] + by * k[i]) };
        let k1 = self.derivative(t, y, contact);
        let k2 = self.derivative(t + 0.5 * h, &add(&k1, 0.5 * h), contact);
        let k3 = self.derivative(t + 0.5 * h, &add(&k2, 0.5 * h), contact);
        let k4 = self.derivative(t + h, &add(&k3, h), contact);
        std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    }

    fn relative(&self, t: f64, y: &State) -> f64 {
        dot(&self.w, &y[..3]) - self.s * t.cos()
    }

    fn relative_velocity(&self, t: f64, y: &State) -> f64 {
        dot(&self.w, &y[3..]) + self.s * t.sin()
    }

    /// The response without friction at τ_e, of [`Chain::linear`] equations: where to begin.
    fn frictionless(&self, t: f64) -> State {
        let n = self.n;
        // [K̄ − r²Γ, C̄; −C̄, K̄ − r²Γ][a; b] = [p; 0] with x̄ = a cos τ_e + b sin τ_e.
        let rows: Vec<Vec<f64>> = (0..2 * n)
            .map(|row| {
                let (i, lower) = (row % n, row >= n);
                let mut line = vec![0.0; 2 * n + 1];
                for j in 0..n {
                    let dynamic = self.k[i][j]
                        - if i == j {
                            self.r * self.r * self.gamma[i]
                        } else {
                            0.0
                        };
                    line[j] = if lower { -self.c[i][j] } else { dynamic };
                    line[n + j] = if lower { dynamic } else { self.c[i][j] };
                }
                line[2 * n] = if lower { 0.0 } else { self.p[i] };
                line
            })
            .collect();
        let ab = solve(rows);
        let mut y = [0.0; 6];
        for i in 0..n {
            y[i] = ab[i] * t.cos() + ab[n + i] * t.sin();
            y[3 + i] = ab[n + i] * t.cos() - ab[i] * t.sin();
        }
        y
    }
}

/// Gaussian elimination with pivoting, on rows with their right-hand side.
fn solve(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for column in 0..n {
        let pivot = (column..n)
            .max_by(|a, b| rows[*a][column].abs().total_cmp(&rows[*b][column].abs()))
            .unwrap();
        rows.swap(column, pivot);
        for row in 0..n {
            if row != column {
                let factor = rows[row][column] / rows[column][column];
                for j in column..=n {
                    rows[row][j] -= factor * rows[column][j];
                }
            }
        }
    }
    (0..n).map(|i| rows[i][n] / rows[i][i]).collect()
}

/// One step of an integration.
#[derive(Clone, Copy)]
struct Piece {
    t: f64,
    y: State,
    h: f64,
    contact: Contact,
}

/// A reversal of the contact.
#[derive(Clone, Copy, Debug)]
struct Reversal {
    t: f64,
    y: State,
    /// The direction of sliding before it.
    from: f64,
}

/// Integrates from t over `span` with the contact sliding all the time; errors where it would stop
/// or where it turns more often than the motion of two reversals a period does.
fn integrate(
    chain: &Chain,
    (t0, y0, sign): (f64, State, f64),
    span: f64,
    mut pieces: Option<&mut Vec<Piece>>,
) -> Result<(State, f64, Vec<Reversal>), String> {
    let (mut t, mut y, mut sign) = (t0, y0, sign);
    let mut reversals = Vec::new();
    let full = PI / STEPS as f64;
    let mut done = 0.0;
    while span - done > 1e-14 {
        let h = full.min(span - done);
        let contact = Contact::Slides(sign);
        let next = chain.step(t, &y, h, contact);
        if sign * chain.relative_velocity(t + h, &next) > 0.0 {
            if let Some(pieces) = &mut pieces {
                pieces.push(Piece { t, y, h, contact });
            }
            (t, y, done) = (t + h, next, done + h);
            continue;
        }
        // The instant of reversal, to the last bits: z̄′ changes sign once in so short a step.
        let (mut low, mut high) = (0.0, h);
        while high - low > 1e-15 {
            let middle = 0.5 * (low + high);
            let velocity = chain.relative_velocity(t + middle, &chain.step(t, &y, middle, contact));
            if sign * velocity > 0.0 {
                low = middle
            } else {
                high = middle
            }
        }
        let at = 0.5 * (low + high);
        let next = chain.step(t, &y, at, contact);
        if let Some(pieces) = &mut pieces {
            pieces.push(Piece {
                t,
                y,
                h: at,
                contact,
            });
        }
        (t, y, done) = (t + at, next, done + at);
        reversals.push(Reversal { t, y, from: sign });
        let force = chain.holding_force(t, &y);
        if -sign * force <= chain.mu * chain.beta {
            return Err(format!(
                "stops at {t}: holding force {force}, at most {}",
                chain.mu * chain.beta
            ));
        }
        if reversals.len() > 2 * (span / PI).ceil() as usize {
            return Err(format!("turns again at {t}"));
        }
        sign = -sign;
    }
    Ok((y, sign, reversals))
}

/// The steady motion: its pieces over one period, from the middle of a slide towards −z̄, and the
/// maximum of z̄ in it.
struct Steady {
    pieces: Vec<Piece>,
    top: Reversal,
}

fn distance(chain: &Chain, a: &State, b: &State) -> f64 {
    (0..chain.n).fold(0.0, |most: f64, i| {
        most.max((a[i] + b[i]).abs())
            .max((a[3 + i] + b[3 + i]).abs())
    })
}

/// By Newton's method on y ↦ −y(τ + π), or by waiting until the transient has gone.
fn steady(chain: &Chain, damped: bool) -> Steady {
    // A quarter of a period after the maximum of the frictionless z̄ the contact slides fast.
    let velocity = |t: f64| chain.relative_velocity(t, &chain.frictionless(t));
    let start = (0..400)
        .map(|i| f64::from(i) * PI / 200.0)
        .min_by(|a, b| velocity(*a).total_cmp(&velocity(*b)));
    let start = start.unwrap();
    let mut y = chain.frictionless(start);
    let half = |y: &State| -> State {
        let (end, sign, reversals) = integrate(chain, (start, *y, -1.0), PI, None).unwrap();
        assert_eq!(
            (sign, reversals.len()),
            (1.0, 1),
            "the contact turns once in a half period"
        );
        end
    };
    if damped {
        // As time goes by: the sections alternate in sign, which the symmetry of the equations
        // turns into the same half period again and again.
        for _ in 0..400 {
            let end = half(&y).map(|value| -value);
            let change = (0..6).fold(0.0, |most: f64, i| most.max((end[i] - y[i]).abs()));
            y = end;
            if change < 1e-13 {
                break;
            }
        }
    } else {
        for _ in 0..12 {
            let end = half(&y);
            let m = 2 * chain.n;
            let place = |i: usize| if i < chain.n { i } else { 3 + i - chain.n };
            let mut rows = vec![vec![0.0; m + 1]; m];
            for j in 0..m {
                let step = 1e-5;
                let (mut more, mut less) = (y, y);
                more[place(j)] += step;
                less[place(j)] -= step;
                let (more, less) = (half(&more), half(&less));
                for i in 0..m {
                    let unit = if i == j { 1.0 } else { 0.0 };
                    rows[i][j] = (more[place(i)] - less[place(i)]) / (2.0 * step) + unit;
                }
            }
            for i in 0..m {
                rows[i][m] = -(end[place(i)] + y[place(i)]);
            }
            for (j, change) in solve(rows).into_iter().enumerate() {
                y[place(j)] += change;
            }
            if distance(chain, &half(&y), &y) < 2e-13 {
                break;
            }
        }
    }
    let remaining = distance(chain, &half(&y), &y);
    assert!(remaining < 1e-11, "not periodic yet: {remaining:e}");
    let mut pieces = Vec::new();
    let (_, _, reversals) =
        integrate(chain, (start, y, -1.0), 2.0 * PI, Some(&mut pieces)).unwrap();
    let top = *reversals
        .iter()
        .find(|reversal| reversal.from > 0.0)
        .unwrap();
    Steady { pieces, top }
}

fn wrapped(angle: f64) -> f64 {
    angle - 2.0 * PI * (angle / (2.0 * PI)).round()
}

impl Steady {
    /// x̄_k and x̄_k′ at an instant of the excitation's time.
    fn at(&self, chain: &Chain, t: f64, k: usize) -> f64 {
        let first = self.pieces[0].t;
        let t = first + (t - first).rem_euclid(2.0 * PI);
        let piece = self.pieces.iter().rev().find(|piece| piece.t <= t).unwrap();
        chain.step(piece.t, &piece.y, t - piece.t, piece.contact)[k]
    }

    /// The largest |x̄_k|, with the lag of that maximum.
    fn amplitude(&self, chain: &Chain, k: usize) -> (f64, f64) {
        let mut best = (0.0, 0.0);
        for piece in &self.pieces {
            let end = chain.step(piece.t, &piece.y, piece.h, piece.contact);
            if piece.y[3 + k] * end[3 + k] > 0.0 {
                continue;
            }
            let (mut low, mut high) = (0.0, piece.h);
            while high - low > 1e-15 {
                let middle = 0.5 * (low + high);
                let velocity = chain.step(piece.t, &piece.y, middle, piece.contact)[3 + k];
                if velocity * piece.y[3 + k] > 0.0 {
                    low = middle
                } else {
                    high = middle
                }
            }
            let value = chain.step(piece.t, &piece.y, low, piece.contact)[k];
            // The half periods mirror each other: by its sign each maximum is the same one.
            if value.abs() > best.0 {
                best = (
                    value.abs(),
                    piece.t + low + if value < 0.0 { PI } else { 0.0 },
                );
            }
        }
        best
    }

    /// X_n by Simpson's rule on every step.
    fn harmonic(&self, chain: &Chain, k: usize, n: u32) -> (f64, f64) {
        let (mut re, mut im) = (0.0, 0.0);
        for Piece { t, y, h, contact } in &self.pieces {
            for (share, weight) in [(0.0, 1.0), (0.5, 4.0), (1.0, 1.0)] {
                let value = chain.step(*t, y, share * h, *contact)[k];
                let angle = f64::from(n) * (t + share * h);
                re += weight * h / 6.0 * value * angle.cos() / PI;
                im -= weight * h / 6.0 * value * angle.sin() / PI;
            }
        }
        (re, im)
    }
}

fn compare(chain: &Chain, damped: bool, text: &str, names: &[&str]) {
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let at = system.at(chain.r).unwrap();
    let motion = at
        .motion(chain.beta)
        .unwrap_or_else(|error| panic!("{error:?}: {}", at.continuous_limit()));
    let steady = steady(chain, damped);

    let z = chain.relative(steady.top.t, &steady.top.y);
    let contact = motion.contact();
    let near = |label: &str, found: f64, expected: f64, size: f64| {
        let error = (found - expected).abs();
        assert!(
            error < TOLERANCE * size,
            "{label}: {found} against {expected}, {error:e} of {size}"
        );
    };
    near("contact amplitude", contact.amplitude(), z, z);
    let slack = wrapped(contact.phase() - steady.top.t);
    near("contact phase", slack, 0.0, 1.0);
    assert!(contact.phase() > -PI && contact.phase() <= PI);

    for (k, name) in names.iter().enumerate() {
        let mass = motion.mass(name).unwrap();
        let (amplitude, lag) = steady.amplitude(chain, k);
        near(
            &format!("amplitude of {name}"),
            mass.amplitude(),
            amplitude,
            amplitude,
        );
        // A maximum's place is known to the square root of its value's accuracy, but here both
        // sides solve for zero velocity.
        near(
            &format!("phase of {name}"),
            wrapped(mass.phase() - lag),
            0.0,
            10.0,
        );
        for tau in [0.0, 0.4, 1.1, 2.3, PI, 4.0, 5.9, -0.7, 13.0] {
            let value = steady.at(chain, steady.top.t + tau, k);
            near(
                &format!("{name} at {tau}"),
                mass.displacement(tau),
                value,
                amplitude,
            );
            let velocity = steady.at(chain, steady.top.t + tau, 3 + k);
            near(
                &format!("velocity of {name} at {tau}"),
                mass.velocity(tau),
                velocity,
                10.0 * amplitude,
            );
        }
        for n in [1, 3, 5] {
            let (re, im) = steady.harmonic(chain, k, n);
            let harmonic = mass.harmonic(n);
            near(&format!("Re X_{n} of {name}"), harmonic.re, re, amplitude);
            near(&format!("Im X_{n} of {name}"), harmonic.im, im, amplitude);
        }
    }
}

/// 3 masses, kg 2, 3, 1.5; N/m 50, 40, 60, 20: γ and κ by hand.
fn on_wall(damped: bool) -> (Chain, &'static str) {
    let k = [[1.8, -0.8, 0.0], [-0.8, 2.0, -1.2], [0.0, -1.2, 1.6]];
    let gamma = [1.0, 1.5, 0.75];
    let r = 0.9;
    let mut chain = Chain {
        n: 3,
        gamma,
        c: [[0.0; 3]; 3],
        k,
        w: [0.0, 1.0, 0.0],
        p: [1.0, 0.0, 0.0],
        s: 0.0,
        mu: 1.0,
        r,
        beta: 0.35,
    };
    if !damped {
        return (
            chain,
            "struct Wall { masses: { a: 2, b: 3, c: 1.5 },
             springs: { base - a: 50, a - b: 40, b - c: 60, c - wall: 20 },
             contact: b - wall, excitation: a }",
        );
    }
    // C = aM + bK with a = 0.4/s, b = 0.03 s and ω = r√(k₁/m₁) = 5r rad/s:
    // C̄ = ωC/k₁ = ω(a m₁Γ/k₁ + bK̄).
    let omega = 5.0 * r;
    for i in 0..3 {
        for j in 0..3 {
            let mass = if i == j {
                0.4 * 2.0 / 50.0 * gamma[i]
            } else {
                0.0
            };
            chain.c[i][j] = omega * (mass + 0.03 * k[i][j]);
        }
    }
    chain.mu = 1.5;
    chain.beta = 0.2;
    (
        chain,
        "struct Wall { masses: { a: 2, b: 3, c: 1.5 },
         springs: { base - a: 50, a - b: 40, b - c: 60, c - wall: 20 },
         contact: b - wall, excitation: a, damping: rayleigh(0.4, 0.03), stiction: 1.5 }",
    )
}

/// The second mass rubs on the moving base; kg 0.8, 2; N/m 100, 150 and 30 to the base as well.
fn on_base(damped: bool) -> (Chain, &'static str, &'static [&'static str]) {
    if !damped {
        let chain = Chain {
            n: 2,
            gamma: [1.0, 2.5, 1.0],
            c: [[0.0; 3]; 3],
            k: [[2.5, -1.5, 0.0], [-1.5, 1.8, 0.0], [0.0; 3]],
            w: [0.0, 1.0, 0.0],
            p: [1.0, 0.3, 0.0],
            s: 1.0,
            mu: 1.3,
            r: 0.7,
            beta: 0.5,
        };
        return (
            chain,
            "struct Moving { masses: { low: 0.8, up: 2 },
             springs: { base - low: 100, low - up: 150, up - base: 30 },
             contact: up - base, excitation: base, stiction: 1.3 }",
            &["low", "up"],
        );
    }
    // One mode: C̄ = 2ζr, on the absolute velocity.
    let (zeta, r) = (0.12, 1.3);
    let mut c = [[0.0; 3]; 3];
    c[0][0] = 2.0 * zeta * r;
    let chain = Chain {
        n: 1,
        gamma: [1.0; 3],
        c,
        k: [[1.0, 0.0, 0.0], [0.0; 3], [0.0; 3]],
        w: [1.0, 0.0, 0.0],
        p: [1.0, 0.0, 0.0],
        s: 1.0,
        mu: 1.1,
        r,
        beta: 0.6,
    };
    (
        chain,
        "struct Moving { masses: { only: 7 }, springs: { base - only: 250 },
         contact: base - only, excitation: base, damping: modal(0.12), stiction: 1.1 }",
        &["only"],
    )
}

/// Two masses rub on each other; kg 1, 2; N/m 10, 15; the contact is written later mass first.
fn on_each_other(damped: bool) -> (Chain, &'static str) {
    let gamma = [1.0, 2.0, 1.0];
    let k = [[2.5, -1.5, 0.0], [-1.5, 1.5, 0.0], [0.0; 3]];
    let r = 1.4;
    let mut chain = Chain {
        n: 2,
        gamma,
        c: [[0.0; 3]; 3],
        k,
        w: [-1.0, 1.0, 0.0],
        p: [1.0, 0.0, 0.0],
        s: 0.0,
        mu: 1.25,
        r,
        beta: 0.3,
    };
    if !damped {
        return (
            chain,
            "struct Pair { masses: { a: 1, b: 2 }, springs: { base - a: 10, a - b: 15 },
             contact: b - a, excitation: a, stiction: 1.25 }",
        );
    }
    // Modal damping by hand: det(K̄ − λΓ) = 2λ² − 6.5λ + 1.5 = 0, and φ ∝ (1.5, 2.5 − λ).
    for (zeta, sign) in [(0.08, -1.0), (0.03, 1.0)] {
        let lambda = (6.5 + sign * (6.5f64 * 6.5 - 12.0).sqrt()) / 4.0;
        let shape = [1.5, 2.5 - lambda];
        let norm = shape[0] * shape[0] * gamma[0] + shape[1] * shape[1] * gamma[1];
        for i in 0..2 {
            for j in 0..2 {
                let weight = gamma[i] * shape[i] * gamma[j] * shape[j] / norm;
                chain.c[i][j] += 2.0 * zeta * r * lambda.sqrt() * weight;
            }
        }
    }
    (
        chain,
        "struct Pair { masses: { a: 1, b: 2 }, springs: { base - a: 10, a - b: 15 },
         contact: b - a, excitation: a, damping: modal[0.08, 0.03], stiction: 1.25 }",
    )
}

#[test]
fn wall_undamped() {
    let (chain, text) = on_wall(false);
    compare(&chain, false, text, &["a", "b", "c"]);
}

#[test]
fn wall_damped() {
    let (chain, text) = on_wall(true);
    compare(&chain, true, text, &["a", "b", "c"]);
}

#[test]
fn base_undamped() {
    let (chain, text, names) = on_base(false);
    compare(&chain, false, text, names);
}

#[test]
fn base_damped() {
    let (chain, text, names) = on_base(true);
    compare(&chain, true, text, names);
}

#[test]
fn masses_undamped() {
    let (chain, text) = on_each_other(false);
    compare(&chain, false, text, &["a", "b"]);
}

#[test]
fn masses_damped() {
    let (chain, text) = on_each_other(true);
    compare(&chain, true, text, &["a", "b"]);
}

/// The motion that reverses at τ = 0 and τ = π and nowhere looks at z̄′ in between: friction is +β
/// for half a period whether that is physical or not.  Start of the half period and its phase, by
/// Newton's method on y(π) = −y(0), z̄′(0) = 0.
fn formal(chain: &Chain) -> (f64, State) {
    let m = 2 * chain.n;
    let place = |i: usize| if i < chain.n { i } else { 3 + i - chain.n };
    let residual = |t: f64, y: &State| -> Vec<f64> {
        let (mut end, h) = (*y, PI / STEPS as f64);
        for step in 0..STEPS {
            end = chain.step(t + step as f64 * h, &end, h, Contact::Slides(-1.0));
        }
        let mut out: Vec<f64> = (0..m).map(|i| end[place(i)] + y[place(i)]).collect();
        out.push(chain.relative_velocity(t, y));
        out
    };
    let height = |t: f64| chain.relative(t, &chain.frictionless(t));
    let mut t = (0..400)
        .map(|i| f64::from(i) * PI / 200.0)
        .max_by(|a, b| height(*a).total_cmp(&height(*b)))
        .unwrap();
    let mut y = chain.frictionless(t);
    for _ in 0..30 {
        let now = residual(t, &y);
        if now.iter().all(|value| value.abs() < 1e-12) {
            break;
        }
        let mut rows: Vec<Vec<f64>> = now.iter().map(|_| vec![0.0; m + 2]).collect();
        for j in 0..=m {
            let step = 1e-5;
            let moved = |by: f64| {
                let (mut t, mut y) = (t, y);
                if j < m {
                    y[place(j)] += by
                } else {
                    t += by
                }
                residual(t, &y)
            };
            for (row, (more, less)) in rows.iter_mut().zip(moved(step).iter().zip(moved(-step))) {
                row[j] = (more - less) / (2.0 * step);
            }
        }
        for (row, value) in rows.iter_mut().zip(&now) {
            row[m + 1] = -value;
        }
        let change = solve(rows);
        // Damped: from the frictionless motion the first step may be far.
        let scale = 0.3 / change[m].abs().max(0.3);
        for j in 0..m {
            y[place(j)] += scale * change[j];
        }
        t += scale * change[m];
    }
    let left = residual(t, &y)
        .iter()
        .fold(0.0, |most: f64, value| most.max(value.abs()));
    assert!(left < 1e-10, "no formal motion: {left:e}");
    (t, y)
}

/// Whether the formal motion is one that Coulomb's law allows.
#[derive(Debug, PartialEq)]
enum Verdict {
    Continuous,
    /// z̄′ changes sign within the half period.
    Turns,
    /// Static friction holds the contact at the reversal.
    Holds,
}

fn verdict(chain: &Chain) -> Verdict {
    let (t, start) = formal(chain);
    // It comes to rest from +, so static friction of −μβ is what the load has to exceed.
    if -chain.holding_force(t, &start) <= chain.mu * chain.beta {
        return Verdict::Holds;
    }
    let (mut y, h) = (start, PI / STEPS as f64);
    for step in 0..STEPS - 1 {
        y = chain.step(t + step as f64 * h, &y, h, Contact::Slides(-1.0));
        if chain.relative_velocity(t + (step + 1) as f64 * h, &y) >= 0.0 {
            return Verdict::Turns;
        }
    }
    Verdict::Continuous
}

/// β_lim is where the formal motion ceases to be possible, and for the reason given.
fn check_boundary(mut chain: Chain, text: &str, beyond: Verdict) {
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let at = system.at(chain.r).unwrap();
    let limit = at.continuous_limit();
    assert!(limit < at.sliding_limit(), "{text}");
    // S decides where leaving it out changes the answer.
    let by_search = limit < at.continuous_limit_without_search() * (1.0 - 1e-3);
    assert_eq!(by_search, beyond == Verdict::Turns, "{text}");
    // The closer pair is limited by the grid on which z̄′ is looked at, not by the integration.
    for factor in [0.5, 0.98, 1.0 - 1e-5] {
        chain.beta = factor * limit;
        assert_eq!(
            verdict(&chain),
            Verdict::Continuous,
            "{factor} of {limit}: {text}"
        );
    }
    for factor in [1.0 + 1e-5, 1.02] {
        chain.beta = factor * limit;
        assert_eq!(verdict(&chain), beyond, "{factor} of {limit}: {text}");
    }
}

#[test]
fn velocity_constraint_is_the_boundary() {
    let single = |zeta: f64, r: f64| {
        let mut c = [[0.0; 3]; 3];
        c[0][0] = 2.0 * zeta * r;
        Chain {
            n: 1,
            gamma: [1.0; 3],
            c,
            k: [[1.0, 0.0, 0.0], [0.0; 3], [0.0; 3]],
            w: [1.0, 0.0, 0.0],
            p: [1.0, 0.0, 0.0],
            s: 0.0,
            mu: 1.0,
            r,
            beta: 0.0,
        }
    };
    for r in [0.35, 0.22] {
        check_boundary(
            single(0.0, r),
            "struct One { masses: { a: 4 }, springs: { base - a: 9 }, contact: a - wall, excitation: a }",
            Verdict::Turns,
        );
        check_boundary(
            single(0.02, r),
            "struct One { masses: { a: 4 }, springs: { base - a: 9 }, contact: a - wall, excitation: a,
             damping: modal(0.02) }",
            Verdict::Turns,
        );
    }
    // The modes together, where the sum of their own maxima is not the maximum of the sum.
    let (mut chain, text) = on_wall(false);
    chain.r = 0.35;
    check_boundary(chain, text, Verdict::Turns);
}

#[test]
fn break_away_is_the_boundary() {
    let (chain, text) = on_wall(true);
    check_boundary(chain, text, Verdict::Holds);
    let (chain, text, _) = on_base(false);
    check_boundary(chain, text, Verdict::Holds);
    let (chain, text, _) = on_base(true);
    check_boundary(chain, text, Verdict::Holds);
    let (chain, text) = on_each_other(true);
    check_boundary(chain, text, Verdict::Holds);
}

/// Complex amplitudes with the contact held, and the largest holding force, by integration.
fn check_stuck(chain: &Chain, text: &str, names: &[&str]) {
    let system: System = text
        .parse()
        .unwrap_or_else(|error| panic!("{error}\n{text}"));
    let at = system.at(chain.r).unwrap();
    let limit = at.sliding_limit();
    let stuck = at.stuck().unwrap();
    // Held where z̄ = 0, from rest.
    let mut y = [0.0; 6];
    for (y, w) in y.iter_mut().zip(&chain.w) {
        *y = chain.s * w;
    }
    let h = PI / STEPS as f64;
    let mut sums = vec![(0.0, 0.0); chain.n];
    let (mut force, mut before) = (0.0f64, y);
    let cycles = 160;
    for cycle in 0..cycles {
        before = y;
        for step in 0..2 * STEPS {
            let t = step as f64 * h;
            if cycle + 1 == cycles {
                // Over a whole period of a smooth function equal weights are exact.
                for (k, sum) in sums.iter_mut().enumerate() {
                    sum.0 += y[k] * t.cos() / STEPS as f64;
                    sum.1 -= y[k] * t.sin() / STEPS as f64;
                }
                force = force.max(chain.holding_force(t, &y).abs());
            }
            y = chain.step(t, &y, h, Contact::Holds);
        }
    }
    let drift = (0..6).fold(0.0, |most: f64, i| most.max((y[i] - before[i]).abs()));
    assert!(drift < 1e-11, "not steady yet: {drift:e}");
    for (name, (re, im)) in names.iter().zip(sums) {
        let amplitude = stuck.mass(name).unwrap();
        let error = (amplitude.re - re).hypot(amplitude.im - im);
        assert!(
            error < TOLERANCE * 10.0,
            "stuck {name}: {amplitude:?} against {re} + {im}i"
        );
    }
    // The largest of 4000 samples of a sinusoid is short of its amplitude by 3.1e-7 of it at most.
    let error = force / chain.mu / limit - 1.0;
    assert!(
        error < TOLERANCE && error > -4e-7,
        "sliding limit {limit}, force {force}"
    );
    assert!(force > chain.mu * 0.999 * limit && force < chain.mu * 1.001 * limit);
}

#[test]
fn stuck_response_and_sliding_limit() {
    let (chain, text) = on_wall(true);
    check_stuck(&chain, text, &["a", "b", "c"]);
    let (chain, text, names) = on_base(true);
    check_stuck(&chain, text, names);
    let (chain, text) = on_each_other(true);
    check_stuck(&chain, text, &["a", "b"]);
}

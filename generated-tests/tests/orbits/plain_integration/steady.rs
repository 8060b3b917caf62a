//! Time integration from reversal to reversal, and the steady motion that it reaches.

use crate::plain_integration::equations::{Chain, Contact, STEPS, State, solve};
use std::f64::consts::PI;

/// One step of an integration.
#[derive(Clone, Copy)]
pub struct Piece {
    pub t: f64,
    pub y: State,
    pub h: f64,
    pub contact: Contact,
}

/// A reversal of the contact's velocity.
#[derive(Clone, Copy, Debug)]
pub struct Reversal {
    pub t: f64,
    pub y: State,
    /// Direction of sliding before the reversal: 1 or −1.
    pub from: f64,
}

/// Integrates from the time t over `span` with the contact sliding all the time. Returns an error if the contact
/// would stop, or if it reverses more than twice in a period.
pub fn integrate(
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
        // Bisection finds the instant of the reversal to the last bits, because z̄′ changes its sign only once within
        // the short step.
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

/// The steady motion over one period, as integration steps, and its maximum of z̄. The period starts in the middle of
/// a slide in the direction of −z̄.
pub struct Steady {
    pub pieces: Vec<Piece>,
    pub top: Reversal,
}

pub fn distance(chain: &Chain, a: &State, b: &State) -> f64 {
    (0..chain.n).fold(0.0, |most: f64, i| {
        most.max((a[i] + b[i]).abs())
            .max((a[3 + i] + b[3 + i]).abs())
    })
}

/// Returns the steady motion of a scene. For an undamped scene Newton's method finds it as a fixed point of the map
/// y ↦ −y(τ + π). For a damped scene the integration continues until the transient has died out.
pub fn steady(chain: &Chain, damped: bool) -> Steady {
    // A quarter of a period after the maximum of z̄ of the response without friction, the contact slides fast.
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
        // The states after successive half periods alternate in sign. With the sign changed, each half period starts
        // like the first half period.
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

pub fn wrapped(angle: f64) -> f64 {
    angle - 2.0 * PI * (angle / (2.0 * PI)).round()
}

impl Steady {
    /// Returns x̄_k or x̄_k′ at an instant t of the excitation's time.
    pub fn at(&self, chain: &Chain, t: f64, k: usize) -> f64 {
        let first = self.pieces[0].t;
        let t = first + (t - first).rem_euclid(2.0 * PI);
        let piece = self.pieces.iter().rev().find(|piece| piece.t <= t).unwrap();
        chain.step(piece.t, &piece.y, t - piece.t, piece.contact)[k]
    }

    /// Returns the largest |x̄_k|, and the lag of this maximum behind the excitation.
    pub fn amplitude(&self, chain: &Chain, k: usize) -> (f64, f64) {
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
            // The two half periods mirror each other. A negative extreme stands for a positive one half a period later.
            if value.abs() > best.0 {
                best = (
                    value.abs(),
                    piece.t + low + if value < 0.0 { PI } else { 0.0 },
                );
            }
        }
        best
    }

    /// Returns real and imaginary part of the harmonic X_n of mass k, by Simpson's rule on every step.
    pub fn harmonic(&self, chain: &Chain, k: usize, n: u32) -> (f64, f64) {
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

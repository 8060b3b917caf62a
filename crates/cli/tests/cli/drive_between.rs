//! Compares `frictiongen drive` with an integration of the equation of motion between the samples of a record.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "a test may fail"
)]

use crate::common::{column, output};
use std::{fs, process};

/// Time between two samples in s, and the number of integration steps in this time.
const DT: f64 = 0.01;
const PARTS: u32 = 100;
/// Mass in kg, spring in N/m and dashpot in N·s/m to the base, kinetic friction in N, and ratio of static to kinetic.
const MASS: f64 = 0.2;
const SPRING: f64 = 2.0;
const DASHPOT: f64 = 0.1;
const FRICTION: f64 = 0.4;
const STICTION: f64 = 1.5;

/// Displacement, velocity and acceleration of the base at the time `s` in a step. `cubic` has the coefficients of its
/// displacement.
fn moved([a, b, c, d]: [f64; 4], s: f64) -> [f64; 3] {
    let place = a + s * (b + s * (c + s * d));
    [
        place,
        b + s * (2.0 * c + 3.0 * s * d),
        2.0 * c + 6.0 * s * d,
    ]
}

/// A block on a spring and a dashpot, with a contact that is rigid or elastic.
#[derive(Clone, Copy)]
struct Block {
    /// 1 if the second side of the contact is the base, and 0 if it is the wall.
    share: f64,
    stiffness: Option<f64>,
    motion: [f64; 2],
    /// Direction of sliding, or 0 while the contact sticks.
    side: f64,
    /// Place of the slider relative to the second side, while the contact sticks.
    place: f64,
}

impl Block {
    /// Returns the force that the contact has or, if it is rigid and sticks, needs to stay at rest.
    fn force(&self, base: [f64; 3]) -> f64 {
        let [x, v] = self.motion;
        let [y, rate, acceleration] = base;
        match self.stiffness {
            _ if self.side != 0.0 => self.side * FRICTION,
            Some(stiffness) => stiffness * (x - self.share * y - self.place),
            None => SPRING * (y - x) + DASHPOT * (rate - v) - MASS * self.share * acceleration,
        }
    }

    fn sliding(&self, [_, rate, _]: [f64; 3]) -> f64 {
        self.motion[1] - self.share * rate
    }

    /// Returns a number that is negative after the end of sticking or sliding.
    fn margin(&self, base: [f64; 3]) -> f64 {
        if self.side == 0.0 {
            STICTION * FRICTION - self.force(base).abs()
        } else {
            self.side * self.sliding(base)
        }
    }

    /// Integrates from the time `s` over the time `h` (Runge and Kutta, order 4).
    fn after(mut self, cubic: [f64; 4], s: f64, h: f64) -> Self {
        let [y, rate, _] = moved(cubic, s + h);
        if self.side == 0.0 && self.stiffness.is_none() {
            self.motion = [self.place + self.share * y, self.share * rate];
            return self;
        }
        let slope = |t: f64, by: [f64; 2], length: f64| {
            let (base, [x, v]) = (moved(cubic, s + t), self.motion);
            let [x, v] = [x + length * by[0], v + length * by[1]];
            let now = Self {
                motion: [x, v],
                ..self
            };
            let pull = SPRING * (base[0] - x) + DASHPOT * (base[1] - v) - now.force(base);
            [v, pull / MASS]
        };
        let first = slope(0.0, [0.0; 2], 0.0);
        let second = slope(0.5 * h, first, 0.5 * h);
        let third = slope(0.5 * h, second, 0.5 * h);
        let last = slope(h, third, h);
        for index in 0..2 {
            let sum = first[index] + 2.0 * (second[index] + third[index]) + last[index];
            self.motion[index] += h / 6.0 * sum;
        }
        self
    }

    /// Decides what the contact does after sticking or sliding has ended.
    fn decide(&mut self, base: [f64; 3]) {
        let (was, x) = (self.side, self.motion[0]);
        self.side = 0.0;
        let force = self.force(base);
        if self.stiffness.is_none() && 1e-9 < self.sliding(base).abs() {
            self.side = self.sliding(base).signum();
        } else if was == 0.0 {
            self.side = force.signum();
        } else if let Some(stiffness) = self.stiffness {
            self.place = x - self.share * base[0] - was * FRICTION / stiffness;
        } else if STICTION * FRICTION <= force.abs() {
            self.side = force.signum();
        } else {
            self.place = x - self.share * base[0];
        }
    }

    /// Follows one step of the record, during which the base moves along `cubic`.
    fn step(&mut self, cubic: [f64; 4]) {
        let start = moved(cubic, 0.0);
        // The velocity of the base may jump at a sample.
        let leaves =
            self.side == 0.0 && self.stiffness.is_none() && 1e-9 < self.sliding(start).abs();
        if leaves || self.margin(start) < -1e-9 {
            self.decide(start);
        }
        for part in 0..PARTS {
            let h = DT / f64::from(PARTS);
            let (mut s, end) = (h * f64::from(part), h * f64::from(part + 1));
            for _ in 0..8 {
                if 0.0 <= self.after(cubic, s, end - s).margin(moved(cubic, end)) {
                    break;
                }
                let (mut low, mut high) = (0.0, end - s);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    let holds = self
                        .after(cubic, s, middle)
                        .margin(moved(cubic, s + middle));
                    *(if 0.0 <= holds { &mut low } else { &mut high }) = middle;
                }
                *self = self.after(cubic, s, low);
                s += low;
                self.decide(moved(cubic, s));
            }
            *self = self.after(cubic, s, end - s);
        }
    }
}

/// Returns the motion of the base in every step, as the docs of `drive` define it, and its velocity at the start.
fn between(unit: &str, samples: &[f64]) -> (Vec<[f64; 4]>, f64) {
    let pairs = samples.windows(2);
    let (mut place, mut rate) = (0.0, if unit == "m_s" { samples[0] } else { 0.0 });
    let start = rate;
    let cubics = pairs.map(|pair| {
        let (value, rise) = (pair[0], (pair[1] - pair[0]) / DT);
        let cubic = match unit {
            "m" => [place, rise, 0.0, 0.0],
            "m_s" => [place, value, rise / 2.0, 0.0],
            _ => [place, rate, value / 2.0, rise / 6.0],
        };
        [place, rate, _] = moved(cubic, DT);
        cubic
    });
    (cubics.collect(), start)
}

/// Drives a block by records of displacement, velocity and acceleration, with both solvers. The contact is rigid or
/// elastic, to the wall or to the moving base.
#[test]
fn moves_between_samples_as_the_record_says() {
    let jump = |sample: u32| f64::from(u8::from(100 <= sample));
    let rough =
        |sample: u32| 0.3 * f64::from(sample * sample % 7) * f64::from(u8::from(sample % 40 < 20));
    let swing = |sample: u32| (0.06 * f64::from(sample)).cos();
    let (mut largest, mut compared, mut events) = (0.0_f64, 0, 0.0);
    for (unit, of) in [
        ("m", &jump as &dyn Fn(u32) -> f64),
        ("m", &|sample| 0.05 * rough(sample)),
        ("m_s", &swing),
        ("m_s", &jump),
        ("m_s2", &|sample| 9.0 * swing(sample) + rough(sample)),
    ] {
        let samples: Vec<f64> = (0..250).map(of).collect();
        let lines = samples.iter().enumerate();
        let lines: String = lines
            .map(|(k, value)| format!("{},{value}\n", DT * k as f64))
            .collect();
        let path = std::env::temp_dir().join(format!("frictiongen-between-{}.csv", process::id()));
        fs::write(&path, format!("time_s,base_{unit}\n{lines}")).unwrap();
        let (steps, start) = between(unit, &samples);
        for (share, side) in [(0.0, "wall"), (1.0, "base")] {
            for stiffness in [None, Some(5.0)] {
                let mut block = Block {
                    share,
                    stiffness,
                    motion: [0.0, start],
                    side: 0.0,
                    place: 0.0,
                };
                if stiffness.is_none() && block.sliding([0.0, start, 0.0]) != 0.0 {
                    block.side = 1.0;
                }
                let mut motions = vec![block.motion];
                for cubic in &steps {
                    block.step(*cubic);
                    motions.push(block.motion);
                }
                let head =
                    "struct Block { masses: { m: 0.2 }, springs: { base - m: 2 }, excitation: base";
                let elastic = |lead: &str| {
                    stiffness.map_or(String::new(), |k| format!("{lead}stiffness: {k}"))
                };
                for scene in [
                    // A damping matrix 0.5M relative to the base is the dashpot.
                    format!(
                        "{head}, contact: m - {side}{}, stiction: {STICTION},
                        damping: rayleigh(0.5, 0), damping_from: base, provide: [stepper] }}",
                        elastic(", ")
                    ),
                    format!(
                        "{head}, contacts: {{ pad: m - {side} {{ stiction: {STICTION} {} }} }},
                        dampers: {{ base - m: {DASHPOT} }} }}",
                        elastic(", ")
                    ),
                ] {
                    let friction = FRICTION.to_string();
                    let asked = [
                        "drive",
                        "-",
                        path.to_str().unwrap(),
                        "--of",
                        "m",
                        "--csv",
                        "--friction",
                    ];
                    let csv = output(&scene, &[&asked[..], &[&friction]].concat());
                    let found = column(&csv, "m.displacement_m")
                        .into_iter()
                        .zip(column(&csv, "m.velocity_m_s"));
                    let size = motions
                        .iter()
                        .fold(0.0_f64, |most, [x, v]| most.max(x.abs()).max(v.abs()));
                    for (sample, ((x, v), expected)) in found.zip(&motions).enumerate() {
                        let apart = (x - expected[0]).abs().max((v - expected[1]).abs()) / size;
                        // The integration has an error of about (ωh)⁴, 1e-14, and of 1e-13 in the instants of events.
                        assert!(
                            apart < 1e-9,
                            "{unit}, {scene}, sample {sample}: {x} {v} for {expected:?}"
                        );
                        largest = largest.max(apart);
                        compared += 1;
                    }
                    events += column(&csv, "events").into_iter().sum::<f64>();
                    if samples[99] == 0.0 && samples[100] == 1.0 {
                        // Nothing moves before the sample after which the base moves.
                        let still = |name: &str| {
                            column(&csv, name)[..100].iter().all(|value| *value == 0.0)
                        };
                        assert!(
                            still("m.displacement_m") && still("m.velocity_m_s") && still("events")
                        );
                    }
                }
            }
        }
        fs::remove_file(path).unwrap();
    }
    println!("{compared} samples, {events} events, largest difference {largest:.1e}");
    assert!(100.0 < events);
}

//! Compares steppers of several contacts on a moving base with four references: the same chain in coordinates
//! relative to the base, a plain integrator, formulas, and the run-time system bit by bit.

use frictiongen::study::joined::JoinedInput;
use frictiongen::{OutOfDomain, System, friction_system};
use fuzzing::Random;

friction_system! {
    pub struct Shaken {
        masses: { lower: 2.0, upper: 1.5 },
        springs: { base - lower: 900.0, lower - upper: 700.0 },
        contacts: {
            brace: base - lower { stiffness: 2000.0 },
            pads: lower - upper { stiction: 1.2 },
            guide: base - upper { share: 0.5 },
        },
        dampers: { base - lower: 3.0, lower - upper: 2.0 },
        excitation: base,
        provide: [stepper],
    }
}

friction_system! {
    // The chain of `Shaken`, on a base at rest and under forces on its masses.
    pub struct Pushed {
        masses: { lower: 2.0, upper: 1.5 },
        springs: { base - lower: 900.0, lower - upper: 700.0 },
        contacts: {
            brace: base - lower { stiffness: 2000.0 },
            pads: lower - upper { stiction: 1.2 },
            guide: base - upper { share: 0.5 },
        },
        dampers: { base - lower: 3.0, lower - upper: 2.0 },
        excitation: lower,
        force: { upper },
        provide: [stepper],
    }
}

friction_system! {
    pub struct Belt {
        masses: { block: 2.0, rider: 1.0 },
        contacts: { floor: base - block, spring: base - rider { stiffness: 50.0 } },
        excitation: base,
        input: hold,
        provide: [stepper],
    }
}

/// A base whose acceleration changes linearly between random samples. Its displacement and velocity at each step are
/// exact.
struct Record {
    random: Random,
    dt: f64,
    acceleration: f64,
    base: [f64; 2],
}

impl Record {
    fn new(seed: u64, dt: f64) -> Self {
        Self {
            random: Random(seed),
            dt,
            acceleration: 0.0,
            base: [0.0; 2],
        }
    }

    fn advance(&mut self, step: usize) {
        let before = self.acceleration;
        if step % 40 == 39 {
            self.acceleration = self.random.between(-25.0, 25.0);
        }
        let ([y, v], after, dt) = (self.base, self.acceleration, self.dt);
        self.base = [
            y + dt * (v + dt * (2.0 * before + after) / 6.0),
            v + dt * (before + after) / 2.0,
        ];
    }
}

/// Compares a moving base with its effect in coordinates relative to the base, a force −mÿ on each mass. If these
/// forces are linear over a step, the displacement of the base is a cubic.
#[test]
fn a_moving_base_is_a_force_on_each_mass() {
    let dt = 2e-3;
    let mut record = Record::new(5, dt);
    let mut shaken = Shaken::stepper(dt).expect("a stepper");
    let mut pushed = Pushed::stepper(dt).expect("a stepper");
    let (mut worst, mut size, mut events) = (0.0_f64, 0.0_f64, [0, 0]);
    for step in 0..3000 {
        record.advance(step);
        let [displacement, velocity] = record.base;
        let friction = ShakenFriction {
            brace: 9.0,
            pads: 6.0,
            guide: 4.0,
        };
        let input = ShakenInput {
            displacement,
            velocity,
            friction,
        };
        events[0] += shaken.advance(input).expect("a step").events;
        let friction = PushedFriction {
            brace: 9.0,
            pads: 6.0,
            guide: 4.0,
        };
        let input = PushedInput {
            force: -2.0 * record.acceleration,
            upper: -1.5 * record.acceleration,
            friction,
        };
        events[1] += pushed.advance(input).expect("a step").events;
        for (mass, expected) in [
            (shaken.lower(), pushed.lower()),
            (shaken.upper(), pushed.upper()),
        ] {
            let place = mass.displacement() - displacement;
            worst = worst.max((place - expected.displacement()).abs());
            size = size.max(expected.displacement().abs());
        }
        let (guide, expected) = (shaken.guide(), pushed.guide());
        assert_eq!(guide.is_sticking(), expected.is_sticking(), "{step}");
        if guide.is_sticking() {
            assert_eq!(guide.velocity(), 0.0, "{step}");
        }
        let brace = pushed.brace().is_sticking();
        assert_eq!(shaken.brace().is_sticking(), brace, "{step}");
        assert!(
            (shaken.brace().force() - pushed.brace().force()).abs() < 1e-8,
            "{step}"
        );
    }
    println!(
        "{:.1e} of the largest displacement, {events:?} events",
        worst / size
    );
    assert_eq!(events[0], events[1]);
    assert!(events[0] > 100, "{events:?}");
    // The base moves several metres away, a hundred times the deformation. Each step rounds this distance by a
    // relative 1e-16.
    assert!(worst < 1e-10 * size, "{worst} {size}");
}

/// Compares emitted steppers on a moving base, which use tables, with the run-time system, which follows power series.
#[test]
fn emitted_steppers_follow_the_system() {
    let text = "struct Shaken {
        masses: { lower: 2.0, upper: 1.5 },
        springs: { base - lower: 900.0, lower - upper: 700.0 },
        contacts: { brace: base - lower { stiffness: 2000.0 }, pads: lower - upper { stiction: 1.2 },
            guide: base - upper { share: 0.5 } },
        dampers: { base - lower: 3.0, lower - upper: 2.0 },
        excitation: base, provide: [stepper],
    }";
    let system: System = text.parse().expect("a valid scene");
    let joined = system.joined().expect("answers");
    let dt = 5e-3;
    let mut record = Record::new(8, dt);
    let mut emitted = Shaken::stepper(dt).expect("a stepper");
    let mut run = joined.stepper(dt).expect("a stepper");
    let (mut events, mut worst) = (0, 0.0_f64);
    for step in 0..1000 {
        record.advance(step);
        let [displacement, velocity] = record.base;
        let friction = ShakenFriction {
            brace: 12.0,
            pads: 5.0,
            guide: if step % 300 < 250 { 3.0 } else { 0.0 },
        };
        let input = ShakenInput {
            displacement,
            velocity,
            friction,
        };
        let count = emitted.advance(input).expect("a step").events;
        let sampled = JoinedInput {
            base: record.base,
            frictions: &[("brace", 12.0), ("pads", 5.0), ("guide", friction.guide)],
            ..JoinedInput::default()
        };
        assert_eq!(count as usize, run.advance(sampled).expect("a step"));
        events += count;
        let upper = (emitted.upper().displacement(), emitted.upper().velocity());
        let expected = run.mass("upper").expect("a mass");
        worst = worst.max((upper.0 - expected.0).abs());
        worst = worst.max((upper.1 - expected.1).abs());
        let guide = run.contact_named("guide").expect("a contact");
        worst = worst.max((emitted.guide().force() - guide.force).abs());
    }
    assert!(events > 50, "{events}");
    // Velocities and forces are of the size 1 to 10. Each step adds some rounding errors of 1e-16.
    assert!(worst < 1e-11, "{worst:e}");
}

/// A plain integrator of the same laws in small steps. The force of the brace follows its spring up to the friction
/// level. The friction of pads and guide opposes the present velocity.
struct Plain {
    x: [f64; 2],
    v: [f64; 2],
    brace: f64,
}

impl Plain {
    /// Returns the forces on both masses, without the friction of pads and guide.
    fn forces(&self, [y, w]: [f64; 2]) -> [f64; 2] {
        let low = 900.0 * (self.x[0] - y) + 3.0 * (self.v[0] - w) + self.brace;
        let high = 700.0 * (self.x[1] - self.x[0]) + 2.0 * (self.v[1] - self.v[0]);
        [high - low, -high]
    }

    /// Takes a small step.
    fn advance(&mut self, h: f64, base: [f64; 2], levels: [f64; 3]) {
        let [lower, upper] = self.forces(base);
        let pads = levels[1] * (self.v[1] - self.v[0]).signum();
        let guide = levels[2] * (self.v[1] - base[1]).signum();
        self.v[0] += h * (lower + pads) / 2.0;
        self.v[1] += h * (upper - pads - guide) / 1.5;
        self.x[0] += h * self.v[0];
        self.x[1] += h * self.v[1];
        let slid = self.brace + h * 2000.0 * (self.v[0] - base[1]);
        self.brace = slid.clamp(-levels[0], levels[0]);
    }
}

/// Compares a stepper with a plain integrator. At a contact that sticks, the integrator's velocity chatters with an
/// amplitude of the step times the acceleration. Its motion therefore has an error of the order of its step.
#[test]
fn a_plain_integrator_agrees() {
    let (dt, parts) = (2e-3, 400_u32);
    let mut shaken = Shaken::stepper(dt).expect("a stepper");
    let mut plain = Plain {
        x: [0.0; 2],
        v: [0.0; 2],
        brace: 0.0,
    };
    // No contact has static friction above the kinetic friction, because the chattering integrator has no static
    // friction.
    let base = |t: f64| [0.02 * (1.0 - (20.0 * t).cos()), 0.4 * (20.0 * t).sin()];
    let friction = ShakenFriction {
        brace: 9.0,
        pads: 0.0,
        guide: 1.5,
    };
    let begun = shaken.begin(ShakenInput {
        friction,
        ..ShakenInput::default()
    });
    begun.expect("the input at the start");
    let (mut worst, mut size, mut events) = (0.0_f64, 0.0_f64, 0);
    for step in 0..400_u32 {
        let [displacement, velocity] = base(f64::from(step + 1) * dt);
        let input = ShakenInput {
            displacement,
            velocity,
            friction,
        };
        events += shaken.advance(input).expect("a step").events;
        for part in 1..=parts {
            let time = (f64::from(step) + f64::from(part) / f64::from(parts)) * dt;
            plain.advance(dt / f64::from(parts), base(time), [9.0, 0.0, 1.5]);
        }
        let differs = (shaken.lower().displacement() - plain.x[0]).abs();
        worst = worst.max(differs.max((shaken.upper().displacement() - plain.x[1]).abs()));
        size = size.max(plain.x[1].abs());
    }
    println!(
        "{:.1e} of the largest displacement, {events} events",
        worst / size
    );
    assert!(events > 10, "{events}");
    // The integrator is symplectic Euler with steps of 5 µs over 0.8 s, at about 30 rad/s. Its error is 30·5e-6/2 =
    // 8e-5 of the motion, plus 8e-5 of the motion for each event.
    assert!(worst < 1e-3 * size, "{worst} {size}");
}

/// Checks a belt whose velocity jumps at the start. The block slides for the time mv/F, then it travels with the
/// belt.
#[test]
fn a_belt_that_starts_at_once() {
    let dt = 0.01;
    let mut belt = Belt::stepper(dt).expect("a stepper");
    let friction = BeltFriction {
        floor: 4.0,
        spring: 0.0,
    };
    let mut events = 0;
    for step in 0..100_u32 {
        let input = BeltInput {
            displacement: 0.9 * f64::from(step) * dt,
            velocity: 0.9,
            friction,
        };
        events += belt.advance(input).expect("a step").events;
        let time = f64::from(step + 1) * dt;
        // 4 N accelerate 2 kg to 0.9 m/s in 0.45 s.
        let (speed, place) = if time < 0.45 {
            (2.0 * time, time * time)
        } else {
            (0.9, 0.2025 + 0.9 * (time - 0.45))
        };
        assert!((belt.block().velocity() - speed).abs() < 1e-12, "{time}");
        assert!(
            (belt.block().displacement() - place).abs() < 1e-12,
            "{time}"
        );
        // At 0.45 s rounding decides in which step the block stops.
        let sticks = belt.floor().is_sticking();
        assert!(
            (time - 0.45).abs() < 1e-9 || sticks == (time > 0.45),
            "{time}"
        );
    }
    assert!(events <= 2, "{events}");
    assert_eq!(belt.floor().velocity(), 0.0);
}

/// Checks a base that jumps by d. If the spring contact holds, the rider vibrates about d. If the contact slips
/// immediately, its force starts at its friction level, not at kd.
#[test]
fn a_base_that_jumps() {
    let (dt, jump) = (0.02_f64, 0.1);
    let rate = 50.0_f64.sqrt();
    for (level, amplitude) in [(100.0, jump), (2.0, 2.0 / 50.0)] {
        let mut belt = Belt::stepper(dt).expect("a stepper");
        let friction = BeltFriction {
            floor: 0.0,
            spring: level,
        };
        // While the friction level of a contact is 0, the jump has no effect on it.
        let input = BeltInput {
            friction,
            ..BeltInput::default()
        };
        belt.advance(input).expect("a step");
        for step in 1..=20_u32 {
            let input = BeltInput {
                displacement: jump,
                velocity: 0.0,
                friction,
            };
            belt.advance(input).expect("a step");
            let time = f64::from(step) * dt;
            let place = amplitude * (1.0 - (rate * time).cos());
            let differs = (belt.rider().displacement() - place).abs();
            assert!(differs < 1e-13, "{level} {time}: {differs}");
        }
    }
}

#[test]
fn bad_inputs_change_nothing() {
    let mut step = Shaken::stepper(1e-3).expect("a stepper");
    let good = ShakenInput {
        velocity: 0.1,
        ..ShakenInput::default()
    };
    step.advance(good).expect("a step");
    let before = format!("{step:?}");
    for displacement in [f64::NAN, f64::INFINITY] {
        let bad = ShakenInput {
            displacement,
            ..good
        };
        let refused = step.advance(bad);
        assert!(
            matches!(refused, Err(OutOfDomain::BaseMotion(_))),
            "{refused:?}"
        );
        assert_eq!(format!("{step:?}"), before);
    }
}

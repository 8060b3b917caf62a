//! Tests of the stepper: tables against power series, friction that changes, free chains, and the bound on events.

#![allow(clippy::indexing_slicing, reason = "a test may fail")]

use super::{Layout, Sample, Stepped, Stepper};
use crate::Float;
use crate::errors::OutOfDomain;
use crate::joints::heap::Heap;
use crate::joints::tangent_tests::{between, chain};
use crate::joints::{Contact, Curve, Model, Wave};
use crate::stepper::Input;
use fuzzing::Random;
use smallvec::smallvec;

pub(super) type Desk<S> = Stepper<S, Heap, Vec<S>>;

/// Returns a stepper with tables, or one that follows power series only.
pub(super) fn stepper<S: Float>(
    model: &Model<S, Heap>,
    (dt, input, on_base): (f64, Input, bool),
    with_tables: bool,
) -> Desk<S> {
    let pace = (S::constant(dt), input, on_base);
    let slow = Stepper::new(model.clone(), pace, Vec::new()).expect("a stepper");
    if !with_tables {
        return slow;
    }
    let entries = Layout::of(model, &slow.pace).entries();
    let tables = vec![S::constant(0.0); entries];
    Stepper::new(model.clone(), pace, tables).expect("a stepper")
}

/// Takes a step under a force on the last mass, and a friction force of the last contact.
fn step<S: Float>(stepper: &mut Desk<S>, force: f64, friction: f64) -> Stepped {
    let taken = stepper.advance(Sample {
        base: [S::constant(0.0); 2],
        forces: &[S::constant(force)],
        frictions: &[S::constant(friction)],
    });
    taken.expect("a step")
}

impl<S: Float> Desk<S> {
    /// Returns true if tables alone can take the next step.
    pub(super) fn leaps(mut self, sample: &Sample<'_, S>) -> bool {
        let led = match self.pace.input {
            Input::Hold => self.hold(sample),
            Input::Linear => self.lead(sample),
        };
        led.is_ok() && (0..self.pace.parts).all(|part| self.leap(part))
    }
}

#[test]
fn tables_give_the_motion_of_the_power_series() {
    let mut random = Random(11);
    let (mut leaps, mut steps, mut events, mut worst) = (0, 0, 0, 0.0_f64);
    for scene in 0..200 {
        let model = chain(&mut random, 1.0);
        let on_base = scene % 2 == 0;
        let dt = model.stretch * between(&mut random, 0.05, 2.2);
        let input = if scene % 3 == 0 {
            Input::Hold
        } else {
            Input::Linear
        };
        let mut both = [true, false].map(|tables| stepper(&model, (dt, input, on_base), tables));
        let mut frictions = vec![0.3; model.contacts.len()];
        for step in 0..200 {
            if step % 25 == 0 {
                for friction in &mut frictions {
                    *friction = between(&mut random, -0.2, 1.0).max(0.0);
                }
            }
            let phase = 0.7 * dt * f64::from(step);
            let sample = Sample {
                base: if on_base {
                    [phase.sin(), 0.7 * phase.cos()]
                } else {
                    [0.0; 2]
                },
                forces: &[(1.3 * phase).cos()],
                frictions: &frictions,
            };
            leaps += u32::from(both[0].clone().leaps(&sample));
            steps += 1;
            let [one, other] = both
                .each_mut()
                .map(|stepper| stepper.advance(sample).expect("a step"));
            events += one.events;
            assert_eq!(one, other, "scene {scene}, step {step}");
            assert!(!one.exceeded, "scene {scene}, step {step}");
            for mass in 0..model.masses.len() {
                let [a, b] = both.each_ref().map(|stepper| stepper.mass(mass));
                worst = worst.max((a.displacement() - b.displacement()).abs());
                worst = worst.max((a.velocity() - b.velocity()).abs());
            }
        }
        let [a, b] = both.each_ref().map(|stepper| stepper.work());
        let size = a.load.abs() + a.friction + a.damping;
        for (a, b) in [
            (a.load, b.load),
            (a.friction, b.friction),
            (a.damping, b.damping),
        ] {
            worst = worst.max((a - b).abs() / size);
        }
    }
    println!("{leaps} of {steps} steps by tables, {events} events: {worst:.1e}");
    assert!(leaps > 6 * steps / 10, "{leaps}");
    assert!(events > 3000, "{events}");
    // Displacements and velocities are of the size 1. Rounding errors of 1e-16 grow where a motion is sensitive to its
    // state.
    assert!(worst < 1e-10, "{worst}");
}

/// Returns masses of 1 in a row, which springs connect to each other and a contact connects to the wall.
fn row<S: Float>(springs: &[f64], stiction: f64, stiffness: Option<f64>) -> Model<S, Heap> {
    let masses = springs.len() + 1;
    let links = springs.iter().enumerate();
    Model {
        size: Heap {
            masses,
            contacts: 1,
            loads: 1,
        },
        masses: vec![S::constant(1.0); masses].into(),
        springs: links
            .map(|(mass, k)| (mass + 1, mass, S::constant(*k)))
            .collect(),
        dashpots: [].into(),
        damping: [].into(),
        damping_from_base: false,
        contacts: smallvec![Contact {
            plus: masses - 1,
            minus: masses,
            level: Wave::zero(),
            stiction: S::constant(stiction),
            stiffness: stiffness.map(S::constant),
            speed: S::constant(0.0),
            stop: None,
        }],
        law: Vec::new(),
        loads: smallvec![(masses - 1, Wave::zero())],
        base: Curve::zero(),
        stretch: S::constant(0.0),
    }
}

#[test]
fn friction_is_linear_between_samples_or_held() {
    // A force of 2 moves the mass 1 for 2 s. The friction force t gives x(2) = 4 − 8/6. Held over steps of 0.5 s, it is
    // 0, 0.5, 1 and 1.5 in turn, and the sum over the steps is x(2) = 2.75 + 0.375·… of the closed form below.
    let begin = |stepper: &mut Desk<f64>| {
        let begun = stepper.begin(Sample {
            base: [0.0; 2],
            forces: &[2.0],
            frictions: &[0.0],
        });
        begun.expect("the input at the start");
    };
    for with_tables in [true, false] {
        let mut linear = stepper(
            &row(&[], 1.0, None),
            (0.5, Input::Linear, false),
            with_tables,
        );
        begin(&mut linear);
        for friction in [0.5, 1.0, 1.5, 2.0] {
            step(&mut linear, 2.0, friction);
        }
        assert!((linear.mass(0).displacement() - 8.0 / 3.0).abs() < 1e-14);
        let mut held = stepper(&row(&[], 1.0, None), (0.5, Input::Hold, false), with_tables);
        let (mut place, mut speed) = (0.0_f64, 0.0_f64);
        for friction in [0.0, 0.5, 1.0, 1.5] {
            step(&mut held, 2.0, friction);
            place += 0.5 * speed + 0.125 * (2.0 - friction);
            speed += 0.5 * (2.0 - friction);
        }
        let held: f64 = held.mass(0).displacement();
        assert!((held - place).abs() < 1e-14);
    }
}

#[test]
fn elastic_contacts_follow_a_friction_that_changes() {
    // A linear change is the limit of a staircase. Its error falls with the square of the duration of a stair.
    let model = row(&[3.0], 1.0, Some(7.0));
    let mut linear = stepper(&model, (0.2, Input::Linear, false), true);
    let stairs = 4000;
    let mut held = stepper(&model, (0.2 / f64::from(stairs), Input::Hold, false), true);
    let (mut before, mut worst) = ((0.0, 0.0), 0.0_f64);
    for index in 0..60 {
        let time = 0.2 * f64::from(index + 1);
        let after = (1.5 * (1.1 * time).sin(), 0.6 + 0.5 * (2.3 * time).sin());
        step(&mut linear, after.0, after.1);
        for stair in 0..stairs {
            let part = (f64::from(stair) + 0.5) / f64::from(stairs);
            let at = |from: f64, to: f64| from + part * (to - from);
            step(&mut held, at(before.0, after.0), at(before.1, after.1));
        }
        before = after;
        for mass in 0..2 {
            let [a, b] =
                [&linear, &held].map(|stepper: &Desk<f64>| stepper.mass(mass).displacement());
            worst = worst.max((a - b).abs());
        }
        let [a, b] = [&linear, &held].map(|stepper: &Desk<f64>| stepper.contact(0).force());
        worst = worst.max((a - b).abs());
    }
    println!("{worst:.1e}");
    assert!(worst < 1e-4, "{worst}");
}

#[test]
fn free_chains_in_single_precision_keep_their_digits_far_away() {
    // Two masses under a load of 4 until they are at x = 500, and then under 7 sin 3t for 18 s.
    let drift = |displacement: f64| {
        let model = (
            row::<f32>(&[9000.0], 1.3, None),
            row::<f64>(&[9000.0], 1.3, None),
        );
        let mut single = stepper(&model.0, (1e-3, Input::Linear, false), true);
        let mut double = stepper(&model.1, (1e-3, Input::Linear, false), true);
        let mut events = [0; 2];
        let mut both = |force: f64, friction: f64| {
            events[0] += step(&mut single, force, friction).events;
            events[1] += step(&mut double, force, friction).events;
            let [a, b] = [
                f64::from(single.mass(1).displacement()),
                double.mass(1).displacement(),
            ];
            (b, (a - b).abs())
        };
        while both(8.0, 4.0).0 < displacement {}
        let mut last = 0.0;
        for index in 1..=18_000 {
            last = both(7.0 * (3e-3 * f64::from(index)).sin(), 4.0).1;
        }
        (last, events)
    };
    // At 6 m/s each of 4000 steps rounds the velocity by up to 2.4e-7, at 45 m/s each of 30 000 by 2e-6. The errors have
    // different signs, and most cancel.
    for (far, most) in [(10.0, 1e-4), (500.0, 5e-3)] {
        let (drift, events) = drift(far);
        println!("{far}: {drift:.1e}, {events:?}");
        assert_eq!(events[0], events[1]);
        assert!(drift < most, "{far}: {drift}");
    }
}

#[test]
fn undamped_chains_in_single_precision_keep_their_energy() {
    // The second chain is held by a spring, and the third by an elastic contact that sticks.
    let free = row::<f32>(&[900.0, 500.0, 700.0], 1.0, Some(400.0));
    let mut held = free.clone();
    held.springs = held
        .springs
        .iter()
        .copied()
        .chain([(0, 4, 300.0)])
        .collect();
    for (model, friction) in [(&free, 0.0), (&held, 0.0), (&free, 1e3)] {
        for angle in [0.12, 0.4, 1.2] {
            let mut stepper = stepper(model, (angle / 50.0, Input::Linear, false), true);
            step(&mut stepper, 0.0, friction);
            let speeds = [0.3, -0.5, 0.7, -0.5];
            stepper.motion.state.v.copy_from_slice(&speeds);
            let start = energy(&stepper);
            for _ in 0..300_000 {
                step(&mut stepper, 0.0, friction);
            }
            let grown = energy(&stepper) / start - 1.0;
            println!("{angle}: {grown:.1e}");
            // Rounding errors of 6e-8 in each step add up like a random walk.
            assert!(grown.abs() < 5e-4, "{angle}: {grown}");
        }
    }
}

/// Returns the energy of a stepper in double precision.
fn energy(stepper: &Desk<f32>) -> f64 {
    let (model, state) = (stepper.motion.model(), stepper.motion.state());
    let kinetic = state.v.iter().map(|v| f64::from(*v).powi(2));
    let x = |mass: usize| state.x.get(mass).map_or(0.0, |x| f64::from(*x));
    let springs = model.springs.iter();
    let springs = springs.map(|(a, b, k)| f64::from(*k) * (x(*a) - x(*b)).powi(2));
    let force = f64::from(state.forces[0]);
    kinetic.chain(springs).sum::<f64>() + force * force / 400.0
}

/// Takes 200 steps of a random input, and returns the displacement of the last mass after each.
fn course(stepper: &mut Desk<f64>, random: &mut Random, budget: u8) -> Vec<f64> {
    stepper.set_event_budget(budget);
    let last = stepper.motion.model().wall() - 1;
    let course = (0..200).map(|_| {
        step(
            stepper,
            2.0 * random.signed(),
            0.5 * (1.0 + random.signed()),
        );
        stepper.mass(last).displacement()
    });
    course.collect()
}

#[test]
fn saved_states_and_images_continue_to_the_last_bit() {
    for stiffness in [None, Some(40.0)] {
        let model = row(&[3.0, 5.0], 1.2, stiffness);
        let mut first = stepper(&model, (0.3, Input::Linear, false), true);
        course(&mut first, &mut Random(3), 3);
        let saved = first.save();
        let mut image = vec![0; first.image_len()];
        first.write_image(&mut image);
        let expected = course(&mut first, &mut Random(4), 3);
        let mut others = [0, 1].map(|_| stepper(&model, (0.3, Input::Linear, false), true));
        others[0].restore(&saved).expect("the saved state");
        others[1].restore_image(&image).expect("the image");
        for other in &mut others {
            assert_eq!(other.steps(), 200);
            assert_eq!(course(other, &mut Random(4), 3), expected);
        }
        let mut slower = stepper(&model, (0.31, Input::Linear, false), true);
        assert_eq!(slower.restore(&saved), Err(OutOfDomain::Saved));
        assert_eq!(slower.restore_image(&image), Err(OutOfDomain::Saved));
        for byte in 0..image.len() {
            let mut damaged = image.clone();
            damaged[byte] ^= 1 << (byte % 8);
            let refused = slower.restore_image(&damaged);
            assert_eq!(refused, Err(OutOfDomain::ImageDamaged), "byte {byte}");
        }
    }
}

#[test]
fn an_image_keeps_the_acceleration_of_the_base() {
    // The contact sticks, so that its force is the inertia of the mass on the accelerated base.
    let mut model = row::<f64>(&[], 1.0, None);
    model.contacts[0].minus = model.base_node();
    let pace = (0.1, Input::Linear, true);
    let mut first = stepper(&model, pace, true);
    let sample = |base| Sample {
        base,
        forces: &[0.0],
        frictions: &[100.0],
    };
    first.advance(sample([0.01, 0.3])).expect("a step");
    let mut image = vec![0; first.image_len()];
    first.write_image(&mut image);
    let mut second = stepper(&model, pace, true);
    second.restore_image(&image).expect("the image");
    let force = first.contact(0).force();
    assert!(force.abs() > 1.0, "{force}");
    assert_eq!(second.contact(0), first.contact(0));
    for stepper in [&mut first, &mut second] {
        stepper.advance(sample([0.05, 0.2])).expect("a step");
    }
    assert_eq!(second.contact(0), first.contact(0));
    assert_eq!(second.mass(0), first.mass(0));
}

#[test]
fn an_error_leaves_the_stepper_unchanged() {
    let model = row(&[3.0, 5.0], 1.2, None);
    let mut stepper = stepper(&model, (0.3, Input::Linear, false), true);
    course(&mut stepper, &mut Random(5), 0);
    let mut before = vec![0; stepper.image_len()];
    stepper.write_image(&mut before);
    let still = |base| Sample {
        base,
        forces: &[1.0],
        frictions: &[1.0],
    };
    let force = Sample {
        forces: &[f64::NAN],
        ..still([0.0; 2])
    };
    let friction = Sample {
        frictions: &[-1.0],
        ..still([0.0; 2])
    };
    let missing = Sample {
        forces: &[],
        ..still([0.0; 2])
    };
    // Forces of this size accelerate the masses beyond the range of numbers.
    let enormous = Sample {
        forces: &[1e308],
        frictions: &[1e308],
        base: [0.0; 2],
    };
    for sample in [force, friction, missing, still([0.1, 0.0]), enormous] {
        let mut after = vec![0; stepper.image_len()];
        while stepper.advance(sample).is_ok() {
            stepper.write_image(&mut before);
        }
        stepper.write_image(&mut after);
        assert_eq!(before, after, "{sample:?}");
    }
}

#[test]
fn steps_beyond_the_budget_never_gain_energy() {
    let mut random = Random(8);
    let mut exceeded = 0;
    for _ in 0..200 {
        let springs = [
            between(&mut random, 1.0, 50.0),
            between(&mut random, 1.0, 50.0),
        ];
        let model = row::<f64>(&springs, 1.0, None);
        let mut stepper = stepper(&model, (0.4, Input::Hold, false), true);
        stepper.set_event_budget(1);
        for speed in stepper.motion.state.v.as_mut() {
            *speed = random.signed();
        }
        stepper.restart_work();
        let mut energy: f64 = stepper.energies().iter().sum();
        for _ in 0..60 {
            step(&mut stepper, 0.0, 0.2);
            let now: f64 = stepper.energies().iter().sum();
            assert!(now <= energy + 1e-14, "{energy} {now}");
            energy = now;
        }
        exceeded += stepper.exceeded();
    }
    println!("{exceeded} steps beyond the budget");
    assert!(exceeded > 20, "{exceeded}");
}

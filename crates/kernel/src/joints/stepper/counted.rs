//! Tests of the cost of a step: counts the operations of a stepper, and compares their number with the bounds.

use super::tests::{Desk, stepper};
use super::{Sample, Stepped};
use crate::joints::heap::Heap;
use crate::joints::tangent_tests::{between, chain};
use crate::joints::{Contact, Curve, Model, Wave};
use crate::stepper::Input;
use crate::{Float, Scalar};
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};
use fuzzing::Random;
use std::cell::Cell;

thread_local! {
    /// Number of operations so far.
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

/// A number that counts the sums, products, quotients, roots and comparisons in which it takes part.
#[derive(Clone, Copy, Debug)]
struct Counted(f32);

fn count<T>(result: T) -> T {
    COUNT.set(COUNT.get() + 1);
    result
}

macro_rules! operators {
    ($($operator:ident $call:ident),*) => {$(
        impl $operator for Counted {
            type Output = Self;

            fn $call(self, other: Self) -> Self {
                count(Self($operator::$call(self.0, other.0)))
            }
        }
    )*};
}

operators! { Add add, Sub sub, Mul mul, Div div }

impl Neg for Counted {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl PartialEq for Counted {
    fn eq(&self, other: &Self) -> bool {
        count(self.0 == other.0)
    }
}

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        count(self.0.partial_cmp(&other.0))
    }
}

impl Scalar for Counted {
    type Condition = bool;

    fn constant(value: f64) -> Self {
        Self(Scalar::constant(value))
    }
    fn pi() -> Self {
        Self(Scalar::pi())
    }
    fn inverse_pi() -> Self {
        Self(Scalar::inverse_pi())
    }
    fn lt(self, other: Self) -> bool {
        count(self.0 < other.0)
    }
    fn is_zero(self) -> bool {
        count(self.0 == 0.0)
    }
    fn select(condition: bool, yes: Self, no: Self) -> Self {
        if condition { yes } else { no }
    }
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    fn sqrt(self) -> Self {
        count(Self(self.0.sqrt()))
    }
    fn max(self, other: Self) -> Self {
        count(Self(Scalar::max(self.0, other.0)))
    }
    fn min(self, other: Self) -> Self {
        count(Self(Scalar::min(self.0, other.0)))
    }
    fn copysign(self, sign: Self) -> Self {
        Self(self.0.copysign(sign.0))
    }
    fn exp(self) -> Self {
        Self(Scalar::exp(self.0))
    }
    fn exp_m1(self) -> Self {
        Self(Scalar::exp_m1(self.0))
    }
    fn atan2(self, x: Self) -> Self {
        Self(Scalar::atan2(self.0, x.0))
    }
    fn sin_cos_pi(self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos_pi();
        (Self(sin), Self(cos))
    }
    fn sin_cos_pi_minus(self, d: Self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos_pi_minus(d.0);
        (Self(sin), Self(cos))
    }
    fn one_minus_sinc_pi(self) -> Self {
        Self(self.0.one_minus_sinc_pi())
    }
    fn scaled_sinh_defect(self) -> Self {
        Self(self.0.scaled_sinh_defect())
    }
}

impl Float for Counted {
    const EPSILON: f64 = <f32 as Float>::EPSILON;

    fn whole(number: usize) -> Self {
        Self(Float::whole(number))
    }
    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }
    fn inverse_ratio_range() -> (Self, Self) {
        let (low, high) = f32::inverse_ratio_range();
        (Self(low), Self(high))
    }
    fn floor(self) -> Self {
        Self(Float::floor(self.0))
    }
}

/// Returns a chain whose numbers count operations.
fn counted(model: &Model<f64, Heap>, law: &[[f64; 2]]) -> Model<Counted, Heap> {
    let number = Counted::constant;
    let link = |(plus, minus, value): &(usize, usize, f64)| (*plus, *minus, number(*value));
    Model {
        size: model.size,
        masses: model.masses.iter().copied().map(number).collect(),
        springs: model.springs.iter().map(link).collect(),
        dashpots: model.dashpots.iter().map(link).collect(),
        damping: model.damping.iter().copied().map(number).collect(),
        damping_from_base: model.damping_from_base,
        contacts: model
            .contacts
            .iter()
            .map(|own| Contact {
                plus: own.plus,
                minus: own.minus,
                level: Wave::zero(),
                stiction: number(own.stiction),
                stiffness: own.stiffness.map(number),
                speed: number(own.speed),
                stop: None,
            })
            .collect(),
        law: law.iter().map(|point| point.map(number)).collect(),
        loads: model
            .loads
            .iter()
            .map(|(mass, _)| (*mass, Wave::zero()))
            .collect(),
        base: Curve::zero(),
        stretch: number(model.stretch),
    }
}

/// Takes a step. Returns its number of operations.
fn operations(desk: &mut Desk<Counted>, sample: Sample<'_, Counted>) -> (u64, Stepped) {
    COUNT.set(0);
    let stepped = desk.advance(sample).expect("a step");
    (COUNT.get(), stepped)
}

#[test]
fn no_step_has_more_operations_than_its_cost() {
    let mut random = Random(17);
    let (mut nearest, mut leapt, mut events, mut exceeded) = ([0.0_f64; 4], 0.0_f64, 0, 0);
    for scene in 0..240 {
        let model = chain(&mut random, 1.0);
        let law = [[0.0, 1.0], [0.3, 0.8], [1.0, 0.7]];
        let law = if scene % 8 == 7 { &law[..] } else { &[] };
        let on_base = scene % 2 == 0;
        let input = if scene % 3 == 0 {
            Input::Hold
        } else {
            Input::Linear
        };
        let dt = model.stretch * between(&mut random, 0.05, 2.2);
        let mut desk = stepper(&counted(&model, law), (dt, input, on_base), law.is_empty());
        let budget = scene % 4;
        desk.set_event_budget(budget);
        let cost = desk.cost();
        let mut frictions = vec![Counted(0.3); model.contacts.len()];
        for step in 0..120 {
            let changes = step % 10 == 0;
            for friction in frictions.iter_mut().filter(|_| changes) {
                *friction = Counted::constant(between(&mut random, -0.2, 1.0).max(0.0));
            }
            let size = if step % 40 < 20 { 1.0 } else { 30.0 };
            let mut draw = || Counted::constant(size * random.signed());
            let sample = Sample {
                base: if on_base {
                    [draw(), draw()]
                } else {
                    [Counted(0.0); 2]
                },
                forces: &[draw()],
                frictions: &frictions,
            };
            let leaps = !changes && desk.clone().leaps(&sample);
            let (count, stepped) = operations(&mut desk, sample);
            events += stepped.events;
            exceeded += u32::from(stepped.exceeded);
            let share = count as f64 / cost.most as f64;
            assert!(
                share <= 1.0,
                "scene {scene}, step {step}: {count} of {}",
                cost.most
            );
            let of_budget = &mut nearest[usize::from(budget)];
            *of_budget = of_budget.max(share);
            if leaps {
                let share = count as f64 / cost.tables as f64;
                assert!(
                    share <= 1.0,
                    "scene {scene}, step {step}: {count} of {}",
                    cost.tables
                );
                leapt = leapt.max(share);
            }
        }
    }
    println!("{events} events, {exceeded} steps exceeded; by tables {leapt:.2}, any {nearest:.4?}");
    assert!(events > 10_000 && exceeded > 1000, "{events} {exceeded}");
    // A bound of little use would be far above all counts.
    assert!(leapt > 0.4 && nearest[1] > 0.05, "{leapt} {nearest:?}");
}

//! Compares the derivatives of a stepper with central differences between steppers without derivatives.
#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "a test may fail"
)]

use crate::study::parameter::quantities;
use crate::study::scene::{Damping, Scene};
use crate::study::sensitivity::{Quantity, Sensitive};
use crate::study::{System, SystemInput};
use frictiongen_kernel::number::dd::Dd;

/// Four scenes: two masses on a moving base, a force that is constant over each step, an elastic contact, and a
/// friction law.
const SCENES: [&str; 4] = [
    "struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall, excitation: base, damping: modal[0.01, 0.012], stiction: 1.2,
        provide: [stepper],
    }",
    "struct Held {
        masses: { lower: 1.0, upper: 0.5 },
        springs: { wall - lower: 900.0, lower - upper: 700.0 },
        contact: lower - upper, excitation: lower, damping: rayleigh(0.3, 1e-4), stiction: 1.1,
        input: hold, provide: [stepper],
    }",
    "struct Elastic {
        masses: { lower: 1.0, upper: 0.5 },
        springs: { base - lower: 900.0, lower - upper: 700.0 },
        contact: lower - base, excitation: base, damping: modal[0.02, 0.025], stiffness: 4000, stiction: 1.3,
        provide: [stepper],
    }",
    "struct Law {
        masses: { block: 2.0 },
        springs: { base - block: 800.0 },
        contact: block - wall, excitation: block, damping: modal(0.02), stiction: 1.2,
        friction: stribeck(0.05: 0.9, 0.2: 0.8), provide: [stepper],
    }",
];

/// The variable of a derivative. It is a quantity of the scene, the friction force, or a factor on the load.
#[derive(Clone, Copy, Debug)]
enum Along {
    Quantity(Quantity),
    Friction,
    Load,
}

/// Random numbers between −1 and 1, by xorshift (Marsaglia 2003).
struct Random(u64);

impl Random {
    fn signed(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 40) as f64 / 8_388_608.0 - 1.0
    }
}

/// Results of a run: displacements, velocities, contact force and dissipated energy, and then the numbers of events and
/// steps.
type Results<S> = (Vec<S>, u32, u32);

macro_rules! run {
    ($system:expr, $dt:expr, $on_base:expr, $number:expr, $friction:expr, $load:expr) => {{
        let mut stepper = $system.stepper($dt).unwrap();
        let (mut random, mut events, mut steps) = (Random(88_172_645_463_325_252), 0, 0);
        while events < EVENTS && steps < STEPS {
            steps += 1;
            let (first, second) = (random.signed(), random.signed());
            let input = if $on_base {
                SystemInput::base($load * $number(2e-3 * first), $load * $number(0.3 * second))
            } else {
                SystemInput::force($load * $number(2.5 * first))
            };
            events += stepper.advance(input.friction($friction)).unwrap().events;
        }
        let masses = stepper.system.scene().masses.len();
        let mut all = Vec::new();
        for index in 0..masses {
            let now = stepper.mass_at(index);
            all.extend([now.displacement(), now.velocity()]);
        }
        all.extend([stepper.contact().force(), stepper.work().friction]);
        assert!(!stepper.grazed(), "a random motion grazes an event");
        (all, events, steps)
    }};
}

/// Number of events after which a run ends. The run also ends after STEPS steps.
const EVENTS: u32 = 100;
const STEPS: u32 = 2000;
const DT: f64 = 0.02;
const FRICTION: f64 = 0.5;

/// Runs a stepper with derivatives with respect to one variable.
fn carried(system: &System, along: Along) -> Results<Sensitive> {
    let varied = match along {
        Along::Quantity(quantity) => system.along(quantity).unwrap(),
        _ => system.unvaried(),
    };
    let variable = |is: bool, value: f64| {
        if is {
            Sensitive::variable(value.into())
        } else {
            Sensitive::fixed(value.into())
        }
    };
    let friction = variable(matches!(along, Along::Friction), FRICTION);
    let load = variable(matches!(along, Along::Load), 1.0);
    let on_base = system.steps().on_base;
    run!(
        varied,
        DT,
        on_base,
        |value: f64| Sensitive::fixed(value.into()),
        friction,
        load
    )
}

/// Runs a stepper without derivatives, in double-double numbers. The variable `along` is multiplied by `factor` before
/// the run.
fn moved(system: &System, along: Along, factor: f64) -> Results<Dd> {
    let mut scene = system.scene().clone();
    let (mut friction, mut load) = (FRICTION, 1.0);
    match along {
        Along::Quantity(quantity) => *number(&mut scene, quantity) *= factor,
        Along::Friction => friction *= factor,
        Along::Load => load *= factor,
    }
    let on_base = system.steps().on_base;
    let system = System::<Dd>::try_from(scene).unwrap();
    run!(
        system,
        Dd::from(DT),
        on_base,
        Dd::from,
        Dd::from(friction),
        Dd::from(load)
    )
}

fn number(scene: &mut Scene, quantity: Quantity) -> &mut f64 {
    match quantity {
        Quantity::Mass(mass) => &mut scene.masses[mass].value,
        Quantity::Stiffness(spring) => &mut scene.springs[spring].stiffness,
        Quantity::Stiction => &mut scene.stiction,
        Quantity::ContactStiffness => scene.stiffness.as_mut().unwrap(),
        Quantity::DampingRatio(mode) => match &mut scene.damping {
            Damping::Modal(ratios) => &mut ratios[mode],
            Damping::Uniform(ratio) => ratio,
            other => panic!("{other:?}"),
        },
        Quantity::MassDamping | Quantity::StiffnessDamping => match &mut scene.damping {
            Damping::Rayleigh { mass, stiffness } => {
                if quantity == Quantity::MassDamping {
                    mass
                } else {
                    stiffness
                }
            }
            other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    }
}

/// Compares derivatives with differences in double-double numbers, whose rounding errors are negligible. The tolerance
/// covers the error of the differences. This error is of second order in the relative step of 1e-7.
#[test]
fn steps_carry_derivatives() {
    let mut compared = 0;
    for text in SCENES {
        let system: System = text.parse().unwrap();
        let name = &system.scene().name;
        let quantities = quantities(system.scene()).into_iter().map(Along::Quantity);
        for along in quantities.chain([Along::Friction, Along::Load]) {
            let (found, events, steps) = carried(&system, along);
            assert!(EVENTS <= events, "{name}: only {events} events");
            let value = match along {
                Along::Friction => FRICTION,
                Along::Load => 1.0,
                Along::Quantity(quantity) => *number(&mut system.scene().clone(), quantity),
            };
            let h = 1e-7;
            let [low, high] = [1.0 - h, 1.0 + h].map(|factor| moved(&system, along, factor));
            assert_eq!(
                [low.1, high.1, low.2, high.2],
                [events, events, steps, steps],
                "{name} {along:?} grazes an event"
            );
            let pairs = low.0.iter().zip(&high.0);
            let differences = pairs.map(|(low, high)| (*high - *low).to_f64() / (2.0 * h * value));
            let differences: Vec<f64> = differences.collect();
            let largest = differences
                .iter()
                .fold(0.0_f64, |most, value| most.max(value.abs()));
            assert!(0.0 < largest, "{name} {along:?} changes nothing");
            for (found, expected) in found.iter().zip(&differences) {
                let slope = found.slope.to_f64();
                let room = 1e-6 * expected.abs() + 1e-12 * largest;
                assert!(
                    (slope - expected).abs() <= room,
                    "{name} {along:?}: {slope:e}, difference {expected:e}"
                );
                compared += 1;
            }
        }
    }
    println!("{compared} derivatives after 100 events and more");
    assert_eq!(compared, COMPARED);
}

/// Number of compared derivatives. The four scenes have 7, 7, 8 and 4 quantities. Friction and load add two variables
/// to each scene. The scenes have 6, 6, 6 and 4 results.
const COMPARED: u32 = 9 * 6 + 9 * 6 + 10 * 6 + 6 * 4;

/// A scene whose upper mass sticks while the lower mass oscillates under a constant force P. The force in the contact
/// is P(1 − cos ωt)/2, with its maximum P at ωt = π. If μF is just below P, the force reaches μF slowly.
const SLOW: &str = "struct Slow {
    masses: { lower: 1.0, upper: 0.5 },
    springs: { base - lower: 700.0, lower - upper: 700.0 },
    contact: upper - wall, excitation: lower, stiction: 1.25,
    input: hold, provide: [stepper],
}";

/// Returns the derivative of the upper mass's displacement with respect to P at ωt = 3π/2. The second result is true if
/// the stepper reports a graze. P is 1.25 N, and μF is `share` times P.
fn slowly(share: f64) -> (f64, bool) {
    let system: System = SLOW.parse().unwrap();
    let unvaried = system.unvaried();
    let dt = 1.5 * std::f64::consts::PI / 1400.0_f64.sqrt() / 64.0;
    let mut stepper = unvaried.stepper(dt).unwrap();
    let mut events = 0;
    for _ in 0..64 {
        let input = SystemInput::force(Sensitive::variable(1.25.into()));
        let input = input.friction(Sensitive::fixed(share.into()));
        events += stepper.advance(input).unwrap().events;
    }
    assert_eq!(events > 0, share < 1.0, "{share}");
    let grazes = stepper.check_derivatives().is_err();
    assert_eq!(grazes, stepper.grazed());
    (stepper.mass_at(1).displacement().slope.to_f64(), grazes)
}

/// Compares the derivative of a slow break-away with its formula. The derivative of the break-away's instant with
/// respect to P is −tan(ωt/2)/(ωP). Its relative error is δ/(2(1 − share)), where δ is the rounding error of the input
/// divided by μF. The stepper permits a relative error of 1e-6. For δ the stepper assumes more than this rounding
/// error, because it adds up the absolute values of the terms in the force. The test therefore leaves a factor of 30
/// on both sides of 1 − share = 1e-10.
#[test]
fn a_slow_break_away_is_a_graze() {
    for (gap, expected) in [
        (0.2, false),
        (1e-2, false),
        (1e-5, false),
        (3e-9, false),
        (3e-12, true),
        (1e-15, true),
    ] {
        let (slope, grazes) = slowly(1.0 - gap);
        assert_eq!(grazes, expected, "{gap:e}: derivative {slope:e}");
    }
    // If μF exceeds the maximum of the force, there is no event, and the mass stays at rest.
    assert_eq!(slowly(1.0 + 1e-9), (0.0, false));
}

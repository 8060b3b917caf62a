//! Creates a stepper of a scene in any scalar, with forces on every mass or on some masses.

use frictiongen_kernel::Plain;
use frictiongen_kernel::number::dd::Dd;
use frictiongen_kernel::stepper::{
    Channel, HeldLoad, HeldStep, Input, ModeStep, Pace, Sample, StepScene, StepTables, Stepped,
    Stepper, Store, StoreMut, StoreRef, Units, View, fill,
};
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{Excitation, Scene};
use frictiongen_model::transient::Transient;

/// Number of coefficients of an input over a step, for a cubic.
const D: usize = 4;

/// Tables of a stepper, stored in vectors.
#[derive(Clone, Debug)]
pub struct Lists<S> {
    pace: Pace<S>,
    modes: Vec<ModeStep<S, D>>,
    held: Vec<HeldStep<S, D>>,
    loads: Vec<S>,
    held_loads: Vec<HeldLoad<S>>,
    channels: Vec<Channel<S>>,
}

impl<S: Copy> StepTables<S, D> for Lists<S> {
    fn view(&self) -> View<'_, S, D> {
        View {
            pace: self.pace,
            modes: &self.modes,
            held: &self.held,
            loads: &self.loads,
            held_loads: &self.held_loads,
            channels: &self.channels,
        }
    }
}

/// State of a stepper, stored in vectors.
#[derive(Clone, Debug)]
pub struct Numbers<S> {
    modes: Vec<[S; 2]>,
    held: Vec<[S; 2]>,
    scratch: Vec<[S; 2]>,
    drive: Vec<[S; D]>,
    last: Vec<S>,
}

impl<S> Store<S, D> for Numbers<S> {
    fn change(&mut self) -> StoreMut<'_, S, D> {
        StoreMut {
            modes: &mut self.modes,
            held: &mut self.held,
            scratch: &mut self.scratch,
            drive: &mut self.drive,
            last: &mut self.last,
        }
    }

    fn read(&self) -> StoreRef<'_, S> {
        StoreRef {
            modes: &self.modes,
            held: &self.held,
            last: &self.last,
        }
    }
}

/// Kind of input, and points of the friction law.
#[derive(Clone, Copy, Debug)]
pub struct Kind<'a> {
    pub input: Input,
    pub law: &'a [[f64; 2]],
}

/// Linear input and Coulomb's law.
pub const LINEAR: Kind<'static> = Kind {
    input: Input::Linear,
    law: &[],
};
/// Held input and Coulomb's law.
pub const HOLD: Kind<'static> = Kind {
    input: Input::Hold,
    law: &[],
};

/// A stepper whose scene lives as long as the program runs.
pub type Rig<S> = Stepper<'static, S, D, Lists<S>, Numbers<S>>;

/// Input of one step in the units of the scene, with a force on each mass.
#[derive(Clone, Debug)]
pub struct Load {
    pub base: [f64; 2],
    pub forces: Vec<f64>,
    pub friction: f64,
}

/// Returns the scene of a description.
pub fn scene(text: &str) -> Scene {
    let system: frictiongen::System = text
        .parse()
        .unwrap_or_else(|error| panic!("{text}: {error}"));
    system.scene().clone()
}

/// Returns a stepper of a scene at rest.
pub fn rig<S: Plain>(scene: &Scene, kind: Kind<'_>, dt: f64) -> Rig<S> {
    try_rig(scene, kind, dt).expect("a step")
}

/// Returns a stepper of a scene at rest, or the error if the step is refused.
pub fn try_rig<S: Plain>(
    scene: &Scene,
    kind: Kind<'_>,
    dt: f64,
) -> Result<Rig<S>, frictiongen::OutOfDomain> {
    let every: Vec<usize> = (0..scene.masses.len()).collect();
    loaded(scene, kind, dt, &every)
}

/// Returns a stepper of a scene at rest, with forces on the given masses only.
pub fn loaded<S: Plain>(
    scene: &Scene,
    kind: Kind<'_>,
    dt: f64,
    masses: &[usize],
) -> Result<Rig<S>, frictiongen::OutOfDomain> {
    let (all, n) = (parts::<S>(scene, kind, masses), scene.masses.len());
    let held = all.dynamics.held.len();
    let inputs = all.channels();
    let zero = S::constant(0.0);
    let mut lists = Lists {
        pace: Pace::zero(),
        modes: vec![ModeStep::zero(); n],
        held: vec![HeldStep::zero(); held],
        loads: vec![zero; n * inputs],
        held_loads: vec![HeldLoad::zero(); held * inputs],
        channels: vec![Channel::zero(); inputs],
    };
    lists.pace = fill(
        &all,
        S::constant(dt),
        (&mut lists.modes, &mut lists.held),
        (&mut lists.loads, &mut lists.held_loads, &mut lists.channels),
    )?;
    let numbers = Numbers {
        modes: vec![[zero; 2]; n],
        held: vec![[zero; 2]; held],
        scratch: vec![[zero; 2]; n],
        drive: vec![[zero; D]; inputs],
        last: vec![zero; inputs],
    };
    Stepper::new(all, lists, numbers, None)
}

fn parts<S: Plain>(scene: &Scene, kind: Kind<'_>, masses: &[usize]) -> StepScene<'static, S> {
    let to = |value: Dd| {
        let high = value.to_f64();
        S::constant(high) + S::constant((value - Dd::from(high)).to_f64())
    };
    let modal = Modal::of(scene);
    let transient = Box::leak(Box::new(Transient::of(scene, &modal, to)));
    let (k1, m1) = (scene.springs[0].stiffness, scene.masses[0].value);
    let law: Vec<[S; 2]> = kind
        .law
        .iter()
        .map(|point| point.map(S::constant))
        .collect();
    let support: f64 = super::plain::chain::Chain::of(scene, &[]).to_base.sum();
    StepScene {
        dynamics: transient.dynamics(),
        units: Units {
            stiffness: S::constant(k1),
            rate: (S::constant(k1) / S::constant(m1)).sqrt(),
            support: S::constant(support) / S::constant(k1),
        },
        on_base: scene.excitation == Excitation::Base,
        forces: Box::leak(masses.into()),
        input: kind.input,
        law: Box::leak(law.into_boxed_slice()),
    }
}

/// Advances a stepper by one step under a load.
pub fn advance<S: Plain>(rig: &mut Rig<S>, load: &Load) -> Stepped<S> {
    with(load, |sample| rig.advance(sample)).expect("a sound load")
}

/// Advances a stepper by one step, or returns the error if the load is refused.
pub fn try_advance<S: Plain>(
    rig: &mut Rig<S>,
    load: &Load,
) -> Result<Stepped<S>, frictiongen::OutOfDomain> {
    with(load, |sample| rig.advance(sample))
}

/// Gives a stepper the load at the start of the run.
pub fn begin<S: Plain>(rig: &mut Rig<S>, load: &Load) {
    with(load, |sample| rig.begin(sample)).expect("a sound load");
}

fn with<S: Plain, T>(load: &Load, then: impl FnOnce(Sample<'_, S>) -> T) -> T {
    let forces: Vec<S> = load
        .forces
        .iter()
        .map(|force| S::constant(*force))
        .collect();
    then(Sample {
        base: load.base.map(S::constant),
        forces: &forces,
        friction: S::constant(load.friction),
    })
}

//! Where a stepper stands.

use super::input::Input;
use super::run::Stepper;
use super::scene::StepScene;
use super::table::{Tables, View};
use crate::errors::OutOfDomain;
use crate::number::scalar::Float;
use crate::simulation::{Contact, Total};

/// The numbers of a stepper, to be changed.
#[derive(Debug)]
pub struct StoreMut<'s, S, const D: usize> {
    /// y and u of the modes; while the contact sticks, of those alone that it does not drive.
    pub modes: &'s mut [[S; 2]],
    /// y and u of the held modes, while the contact sticks.
    pub held: &'s mut [[S; 2]],
    /// Room for as many as there are modes.
    pub scratch: &'s mut [[S; 2]],
    /// The inputs over a part of a step.
    pub drive: &'s mut [[S; D]],
    /// The forces at the last sample.
    pub last: &'s mut [S],
}

impl<S: Float, const D: usize> StoreMut<'_, S, D> {
    /// Writes the state of the modes that the contact drives, from that of the held modes and from where the held contact
    /// is, and how fast.
    pub(super) fn release(&mut self, scene: &StepScene<'_, S>, receptance: S, lifted: (S, S)) {
        let held = self.held.iter().copied();
        let modes = self.modes.iter_mut().map(|[y, u]| (y, u));
        scene.dynamics.release(receptance, held, lifted, modes);
    }
}

/// The numbers of a stepper.
#[derive(Clone, Copy, Debug)]
pub struct StoreRef<'s, S> {
    /// y and u of the modes.
    pub modes: &'s [[S; 2]],
    /// y and u of the held modes.
    pub held: &'s [[S; 2]],
    /// The forces at the last sample.
    pub last: &'s [S],
}

/// What holds the numbers of a stepper: arrays, or vectors.
pub trait Store<S, const D: usize> {
    /// All of them, to be changed.
    fn change(&mut self) -> StoreMut<'_, S, D>;
    /// Those that say where it stands.
    fn read(&self) -> StoreRef<'_, S>;
}

/// The numbers of a stepper in arrays.
#[derive(Clone, Copy, Debug)]
pub struct FixedStore<S, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
{
    modes: [[S; 2]; MODES],
    held: [[S; 2]; HELD],
    scratch: [[S; 2]; MODES],
    drive: [[S; D]; INPUTS],
    last: [S; INPUTS],
}

impl<S: Float, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
    FixedStore<S, D, MODES, HELD, INPUTS>
{
    /// At rest.
    #[must_use]
    pub fn new() -> Self {
        let zero = S::constant(0.0);
        Self {
            modes: [[zero; 2]; MODES],
            held: [[zero; 2]; HELD],
            scratch: [[zero; 2]; MODES],
            drive: [[zero; D]; INPUTS],
            last: [zero; INPUTS],
        }
    }
}

impl<S: Float, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize> Default
    for FixedStore<S, D, MODES, HELD, INPUTS>
{
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Float, const D: usize, const MODES: usize, const HELD: usize, const INPUTS: usize>
    Store<S, D> for FixedStore<S, D, MODES, HELD, INPUTS>
{
    #[inline]
    fn change(&mut self) -> StoreMut<'_, S, D> {
        StoreMut {
            modes: &mut self.modes,
            held: &mut self.held,
            scratch: &mut self.scratch,
            drive: &mut self.drive,
            last: &mut self.last,
        }
    }

    #[inline]
    fn read(&self) -> StoreRef<'_, S> {
        StoreRef {
            modes: &self.modes,
            held: &self.held,
            last: &self.last,
        }
    }
}

/// What a stepper knows beyond the state of its oscillators.
#[derive(Clone, Copy, Debug)]
pub(super) struct Status<S> {
    /// What the contact does.
    pub contact: Contact,
    /// Nothing is known of the contact yet: its velocity and the force in it will tell.
    pub unknown: bool,
    /// It was about to leave and could not: what rounding says of its grip does not count.
    pub wedged: bool,
    /// While it sticks: where, relative to what it rubs on.
    pub place: S,
    /// Which line of the friction law holds.
    pub line: usize,
    /// Displacement and velocity of the base at the end of the last step.
    pub base: [S; 2],
    /// F and μ, F over k₁.
    pub friction: S,
    pub stiction: S,
    pub steps: u64,
    /// In how many of them the bound on events was met.
    pub exceeded: u64,
    /// The force in the contact at the end of the last step, over k₁, if it sticks or is unknown.
    pub holding: S,
    /// The work of the load and that taken by friction, over k₁, and the energy at the start.
    pub load: Total<S>,
    pub dissipated: Total<S>,
    pub energy: S,
    pub pull: S,
    /// The sizes of what the contact's velocity in a state at the start was summed from: none after the first step.
    pub given: S,
}

impl<S: Float> Status<S> {
    pub(super) fn new(stiction: S) -> Self {
        let zero = S::constant(0.0);
        Self {
            contact: Contact::Stuck,
            unknown: true,
            wedged: false,
            place: zero,
            line: 0,
            base: [zero; 2],
            friction: zero,
            stiction,
            steps: 0,
            exceeded: 0,
            holding: zero,
            load: Total::zero(),
            dissipated: Total::zero(),
            energy: zero,
            pull: zero,
            given: zero,
        }
    }
}

/// A stepper's state, apart from its tables: what [`Stepper::save`](super::Stepper::save) gives.
#[derive(Clone, Copy, Debug)]
pub struct Saved<S, V> {
    pub(super) status: Status<S>,
    pub(super) store: V,
    /// [`Stepper::mark`](super::Stepper::mark) of the stepper that it is of.
    mark: u64,
}

impl<S: Float, const D: usize, T: Tables<S, D>, V: Store<S, D>> Stepper<'_, S, D, T, V> {
    /// Where it stands: everything that a run goes on from.
    #[must_use]
    pub fn save(&self) -> Saved<S, V>
    where
        V: Clone,
    {
        Saved {
            status: self.status,
            store: self.store.clone(),
            mark: self.mark(),
        }
    }

    /// Goes back to where it stood: the same steps lead to the same bits.
    ///
    /// # Errors
    /// [`OutOfDomain`] ("saved") for the state of a stepper of another scene or step, as their hash tells.
    pub fn restore(&mut self, saved: &Saved<S, V>) -> Result<(), OutOfDomain>
    where
        V: Clone,
    {
        let size = |store: &V| {
            let store = store.read();
            (store.modes.len(), store.held.len(), store.last.len())
        };
        if size(&self.store) != size(&saved.store) || self.mark() != saved.mark {
            return Err(OutOfDomain { argument: "saved" });
        }
        self.status = saved.status;
        self.store = saved.store.clone();
        Ok(())
    }

    /// A hash of what the state means: the scene with its units and loads, and the step.
    fn mark(&self) -> u64 {
        let View {
            pace,
            modes,
            held,
            loads,
            ..
        } = self.tables.view();
        let (scene, units) = (&self.scene, &self.scene.units);
        let mut hash = Hash::new();
        hash.count(usize::from(scene.on_base));
        hash.count(usize::from(scene.input == Input::Linear));
        hash.number(units.stiffness).number(units.rate);
        hash.number(units.support).number(pace.step);
        hash.number(scene.dynamics.chain.inverse_mass);
        for mass in scene.forces {
            hash.count(*mass);
        }
        for [speed, level] in scene.law {
            hash.number(*speed).number(*level);
        }
        for mode in modes {
            hash.number(mode.angle).number(mode.zeta);
            hash.number(mode.contact);
        }
        for mode in held {
            hash.number(mode.angle).number(mode.force);
        }
        for load in loads {
            hash.number(*load);
        }
        hash.0
    }
}

/// A hash of numbers: FNV-1a over words of 64 bits, folded.
struct Hash(u64);

impl Hash {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn word(&mut self, word: u64) -> &mut Self {
        let mixed = (self.0 ^ word).wrapping_mul(0x0100_0000_01b3);
        // The product carries upwards alone.
        self.0 = mixed ^ (mixed >> 32);
        self
    }

    fn number<S: Float>(&mut self, number: S) -> &mut Self {
        self.word(number.bits())
    }

    fn count(&mut self, count: usize) -> &mut Self {
        self.word(u64::try_from(count).unwrap_or(u64::MAX))
    }
}

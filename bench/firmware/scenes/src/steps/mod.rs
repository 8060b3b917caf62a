//! Scenes for measurements of the real-time stepper: the loads of their steppers, and the trait [`Machine`] for all
//! steppers.

pub mod images;
pub mod machines;
pub mod script;
pub mod several;

pub use frictiongen::kernel::stepper::Cost;

/// Result of one step of a stepper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// True if the contact sticks at the end of the step.
    pub sticks: bool,
    /// Number of events in the step, such as stops of the contact.
    pub events: u32,
    /// True if the step had more events than the stepper follows.
    pub exceeded: bool,
}

/// A stepper of a scene, in the scene's scalar.
pub trait Machine: Sized {
    /// Scalar of the scene.
    type Scalar: Copy;
    /// Name of the stepper in printed tables.
    const NAME: &'static str;
    /// True if the load is a motion of the base, and false if it is a force.
    const ON_BASE: bool;
    /// True if a processor without double precision computes the numbers of this stepper in software.
    const SOFTWARE: bool = core::mem::size_of::<Self::Scalar>() == 8;
    /// Creates a stepper at rest.
    fn start() -> Option<Self>;
    /// Advances the stepper by one step with a load and a friction force. If [`ON_BASE`](Self::ON_BASE) is true, the
    /// load is displacement and velocity of the base, and otherwise a force and zero.
    fn advance(&mut self, load: [Self::Scalar; 2], friction: Self::Scalar) -> Option<Outcome>;
    /// Returns the upper bound on the cost of a step, or `None` if the stepper counts no operations.
    fn cost(&self) -> Option<Cost> {
        None
    }
    /// Sets the largest number of events that a step follows, the event budget. Returns `None` if the stepper has no
    /// budget.
    fn set_budget(&mut self, _events: u8) -> Option<()> {
        None
    }
    /// Creates a stepper at rest that borrows its constant tables. Returns `None` if the stepper has no tables.
    fn start_declared() -> Option<()> {
        None
    }
    /// Reads the masses, with one call for each mass.
    fn read_each(&self);
    /// Reads all masses in one call, or returns `None` if the stepper has no call that reads all masses.
    fn read_all(&self) -> Option<()> {
        None
    }
    /// Size in memory in bytes of a stepper that borrows its constant tables, or `None` if the stepper has no tables.
    const DECLARED: Option<usize> = None;
    /// Largest number of instructions for one floating-point operation of the stepper's cost.
    const INSTRUCTIONS: u64 = Cost::INSTRUCTIONS;
    /// Size of the stepper in memory in bytes, including its constant tables.
    const SIZE: usize = core::mem::size_of::<Self>();
    /// Returns the bits of three numbers of the state: displacement and velocity of the last mass, and work of the
    /// load. With several contacts the third number is the force in the last contact.
    fn bits(&self) -> [u64; 3];
}

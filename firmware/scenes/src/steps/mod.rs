//! The real-time stepper: scenes, their loads, and a common interface of their steps.

pub mod images;
pub mod machines;
pub mod script;
pub mod two_contacts;

pub use frictiongen::kernel::stepper::Cost;

/// Result of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// `true` if the contact sticks at the end of the step.
    pub sticks: bool,
    /// Number of events in the step.
    pub events: u32,
    /// `true` if the step had more events than the stepper follows.
    pub exceeded: bool,
}

/// A stepper of a scene, in the scene's scalar.
pub trait Machine: Sized {
    /// Scalar of the scene.
    type Scalar: Copy;
    /// Name in the tables of figures.
    const NAME: &'static str;
    /// `true` if the load is a motion of the base.
    const ON_BASE: bool;
    /// `true` if a processor without double precision computes the scalar's sums in software.
    const SOFTWARE: bool = core::mem::size_of::<Self::Scalar>() == 8;
    /// Creates a stepper at rest.
    fn start() -> Option<Self>;
    /// Advances by one step with a load and a friction force. The load is a force, or displacement and velocity of the
    /// base.
    fn advance(&mut self, load: [Self::Scalar; 2], friction: Self::Scalar) -> Option<Outcome>;
    /// Returns the upper bound on the cost of a step, or `None` if the stepper counts no operations.
    fn cost(&self) -> Option<Cost> {
        None
    }
    /// Sets the event budget. Returns `None` if the stepper has no budget.
    fn set_budget(&mut self, _events: u8) -> Option<()> {
        None
    }
    /// Creates a stepper at rest that borrows its constant tables. Returns `None` if the stepper has no tables.
    fn start_declared() -> Option<()> {
        None
    }
    /// Reads the masses one by one.
    fn read_each(&self);
    /// Reads all masses in one call. Returns `None` if the stepper has no such call.
    fn read_all(&self) -> Option<()> {
        None
    }
    /// Size in memory in bytes of a stepper that borrows its constant tables, or `None` if the stepper has no tables.
    const DECLARED: Option<usize> = None;
    /// Size in memory in bytes, including the tables.
    const SIZE: usize = core::mem::size_of::<Self>();
    /// Returns the bits of displacement and velocity of the last mass, and of the work of the load. For several contacts
    /// the third number is the force in the last one.
    fn bits(&self) -> [u64; 3];
}

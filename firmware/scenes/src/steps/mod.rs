//! The real-time stepper: scenes, what is played to them, and what a step is called as.

pub mod machines;
pub mod script;

pub use frictiongen::kernel::stepper::Cost;

/// What a step has led to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Whether the contact sticks at its end.
    pub sticks: bool,
    /// How many events there were.
    pub events: u32,
    /// Whether there were more than are followed.
    pub exceeded: bool,
}

/// A stepper of some scene, in the scene's scalar.
pub trait Machine: Sized {
    /// The scalar.
    type Scalar: Copy;
    /// What the tables of figures call it.
    const NAME: &'static str;
    /// Whether the load is the base's motion.
    const ON_BASE: bool;
    /// Whether a processor without double precision has no instruction for its sums.
    const SOFTWARE: bool = core::mem::size_of::<Self::Scalar>() == 8;
    /// At rest.
    fn start() -> Option<Self>;
    /// A step: under a force, or to a displacement and a velocity of the base; and the friction force.
    fn advance(&mut self, load: [Self::Scalar; 2], friction: Self::Scalar) -> Option<Outcome>;
    /// What a step costs at most.
    fn cost(&self) -> Cost;
    /// Its size in memory, its tables included, in bytes.
    const SIZE: usize = core::mem::size_of::<Self>();
    /// The bits of displacement and velocity of the last mass, and of the load's work.
    fn bits(&self) -> [u64; 3];
}

//! The item of a scene that causes an error.

/// The item of a scene that causes an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Path {
    /// The scene as a whole.
    Scene,
    /// The list of masses as a whole.
    Masses,
    /// The value of a mass.
    Mass(usize),
    /// The name of a mass.
    MassName(usize),
    /// The list of springs as a whole.
    Springs,
    /// The stiffness of a spring.
    Spring(usize),
    /// The first node of a spring.
    SpringFrom(usize),
    /// The second node of a spring.
    SpringTo(usize),
    /// The contact as a whole.
    Contact,
    /// The first side of the contact.
    ContactFrom,
    /// The second side of the contact.
    ContactTo,
    /// The excitation of the scene.
    Excitation,
    /// The damping as a whole, or one of its numbers.
    Damping(Option<usize>),
    /// The ratio μ of static to kinetic friction.
    Stiction,
    /// The list of items to provide, or one of its items.
    Provide(Option<usize>),
    /// The declared accuracy.
    Accuracy,
    /// The range of the declared accuracy.
    Range,
    /// The declared range of the frequency ratio.
    RangeOfRatio,
    /// The declared range of the friction ratio.
    RangeOfFriction,
    /// The declared side of the exact limits.
    Side,
    /// The number of bytes in place of an accuracy.
    Budget,
    /// The behaviour outside the range.
    Beyond,
    /// Time that the macro may spend on a proof.
    Proof,
    /// The friction law as a whole, or one of its numbers: speed and level of each point in turn.
    Friction(Option<usize>),
    /// The step of the stepper.
    Step,
    /// The behaviour of the stepper's input between samples.
    Input,
    /// The list of masses that the stepper may load, or one of them.
    Force(Option<usize>),
}

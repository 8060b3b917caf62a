//! Paths to the items of a scene. A path says which item causes an error.

/// An item of a scene that causes an error. Indices of masses and springs count from 0 in the order of the description.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Path {
    /// The scene as a whole.
    Scene,
    /// The list of masses as a whole.
    Masses,
    /// The value of the mass with this index.
    Mass(usize),
    /// The name of the mass with this index.
    MassName(usize),
    /// The list of springs as a whole.
    Springs,
    /// The stiffness of the spring with this index.
    Spring(usize),
    /// The first end of the spring with this index.
    SpringFrom(usize),
    /// The second end of the spring with this index.
    SpringTo(usize),
    /// The contact as a whole.
    Contact,
    /// The side of the contact that the description writes first.
    ContactFrom,
    /// The side of the contact that the description writes second.
    ContactTo,
    /// The excitation of the scene.
    Excitation,
    /// The damping as a whole (`None`), or the damping number with this index.
    Damping(Option<usize>),
    /// The velocities on which the damping acts.
    DampingFrom,
    /// The ratio μ of static to kinetic friction.
    Stiction,
    /// The stiffness of an elastic contact.
    Stiffness,
    /// The list `provide` as a whole (`None`), or the item with this index.
    Provide(Option<usize>),
    /// The accuracy that the scene declares.
    Accuracy,
    /// The range of r and β of the declared accuracy, as a whole.
    Range,
    /// The declared range of the frequency ratio r.
    RangeOfRatio,
    /// The declared range of the friction ratio β.
    RangeOfFriction,
    /// The side of the exact limits on which the limits from tables may lie.
    Side,
    /// The largest size of the tables in bytes, in place of an accuracy.
    Budget,
    /// The behaviour of the emitted code outside the declared range.
    Beyond,
    /// Time that the macro may spend on a proof of the tables.
    Proof,
    /// The friction law as a whole (`None`), or the number with this index. The numbers are the speed and the level of
    /// each point in turn.
    Friction(Option<usize>),
    /// The fixed step of the stepper.
    Step,
    /// The course of the stepper's input between two samples.
    Input,
    /// The name of the contact with this index in `contacts`.
    JointName(usize),
    /// The side of the contact with this index that the description writes first.
    JointFrom(usize),
    /// The side of the contact with this index that the description writes second.
    JointTo(usize),
    /// The stiffness of the contact with this index.
    JointStiffness(usize),
    /// The ratio μ of the contact with this index.
    JointStiction(usize),
    /// The share of the contact with this index.
    JointShare(usize),
    /// The speed of the second side of the contact with this index.
    JointSpeed(usize),
    /// The coefficient of the dashpot with this index.
    Damper(usize),
    /// The first end of the dashpot with this index.
    DamperFrom(usize),
    /// The second end of the dashpot with this index.
    DamperTo(usize),
    /// The name of the stop with this index.
    StopName(usize),
    /// The side of the stop with this index that the description writes first.
    StopFrom(usize),
    /// The side of the stop with this index that the description writes second.
    StopTo(usize),
    /// The gap of the stop with this index.
    StopGap(usize),
    /// The stiffness of the stop with this index.
    StopStiffness(usize),
    /// The damping of the stop with this index.
    StopDamping(usize),
    /// The coefficient of restitution of the stop with this index.
    StopRestitution(usize),
    /// The value of the constant force with this index.
    Constant(usize),
    /// The mass on which the constant force with this index acts.
    ConstantMass(usize),
    /// The list of masses on which a force may act in the stepper. `None` means the whole list, and a number is the
    /// index of one entry.
    Force(Option<usize>),
}

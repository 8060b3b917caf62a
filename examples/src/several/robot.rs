//! Computes a robot joint with friction in gear and seal, as a controller would do it. The torque of the motor is
//! constant in each step.

use frictiongen::friction_system;
use std::error::Error;

friction_system!("scenes/robot.friction");

/// Kinetic friction torque of the gear, in N·m.
pub const GEAR: f64 = 20.0;
/// Kinetic friction torque of the seal, in N·m.
pub const SEAL: f64 = 2.0;
/// Ratio of static to kinetic friction of the gear, as in the description.
pub const GEAR_STICTION: f64 = 1.5;
/// Ratio of static to kinetic friction of the seal, as in the description.
pub const SEAL_STICTION: f64 = 1.2;
/// Constant torque on the load in N·m: 0.3 of the static friction torque of the gear.
pub const LOAD: f64 = 0.3 * GEAR_STICTION * GEAR;

/// State of the joint after a step.
#[derive(Clone, Copy, Debug)]
pub struct Now {
    /// Number of steps since the start.
    pub step: u64,
    /// Torque of the motor during the step, in N·m.
    pub torque: f64,
    /// Angle of the motor at the end of the step, in rad.
    pub angle: f64,
    /// Speeds of the motor and of the load at the end of the step, in rad/s.
    pub speeds: [f64; 2],
    /// Friction torques of the gear and of the seal, in N·m.
    pub frictions: [f64; 2],
    /// For the gear and for the seal, true if it sticks.
    pub sticks: [bool; 2],
    /// Number of events in the step.
    pub events: u32,
}

/// The motion of the joint: a hold, in which the motor has no torque, and then a move.
#[derive(Clone, Debug)]
pub struct Course {
    /// State of the joint at the end of the hold. The motor has no torque, and the load has its constant torque.
    pub held: Now,
    /// Largest absolute value of the motor's angle in rad and of its speed in rad/s, during the hold.
    pub creep: f64,
    /// State of the joint after every step of the move.
    pub moved: Vec<Now>,
}

/// Returns the torque of the motor in N·m at a time in s after the hold. It rises by 10 N·m a second for 4 s, and is
/// −60 N·m afterwards.
#[must_use]
pub fn torque(time: f64) -> f64 {
    if time < 4.0 { 10.0 * time } else { -60.0 }
}

/// Holds the joint without motor torque for `hold` steps, and then moves it forth and back.
///
/// # Errors
/// Errors of the solver.
pub fn course(hold: u64) -> Result<Course, Box<dyn Error>> {
    let mut joint = Robot::stepper(Robot::STEP)?;
    let input = |torque| RobotInput {
        force: torque,
        load: LOAD,
        friction: RobotFriction {
            gear: GEAR,
            seal: SEAL,
        },
    };
    let mut creep = 0.0_f64;
    let mut count = 0;
    let mut advance = |torque: f64| -> Result<Now, Box<dyn Error>> {
        let events = joint.advance(input(torque))?.events;
        count += 1;
        let (gear, seal) = (joint.gear(), joint.seal());
        Ok(Now {
            step: count,
            torque,
            angle: joint.motor().displacement(),
            speeds: [joint.motor().velocity(), joint.load().velocity()],
            frictions: [gear.force(), seal.force()],
            sticks: [gear.is_sticking(), seal.is_sticking()],
            events,
        })
    };
    let mut held = advance(0.0)?;
    for _ in 1..hold {
        creep = creep.max(held.angle.abs()).max(held.speeds[0].abs());
        held = advance(0.0)?;
    }
    creep = creep.max(held.angle.abs()).max(held.speeds[0].abs());
    let mut moved = Vec::new();
    for step in 0..4600_u32 {
        moved.push(advance(torque(f64::from(step) * Robot::STEP))?);
    }
    Ok(Course { held, creep, moved })
}

/// Returns a text about the motion of the joint.
///
/// # Errors
/// Same errors as [`course`].
pub fn report(hold: u64) -> Result<String, Box<dyn Error>> {
    let course = course(hold)?;
    let grip = GEAR_STICTION * GEAR;
    let mut lines = vec![
        "Robot joint".to_owned(),
        format!(
            "  {hold} steps with {LOAD} N·m on the load: the motor moves by {} rad; friction torques {:.3} N·m in the gear, {:.3} N·m \
             in the seal",
            course.creep, course.held.frictions[0], course.held.frictions[1]
        ),
    ];
    let mut before = course.held;
    for now in &course.moved {
        let does = match (before.sticks[0], now.sticks[0]) {
            (true, false) => "breaks away",
            (false, true) => "sticks",
            (false, false) if before.speeds[0] * now.speeds[0] < 0.0 => "reverses",
            _ => "",
        };
        if !does.is_empty() {
            lines.push(format!(
                "  step {}: the gear {does} at a motor torque of {:.2} N·m (static friction torque of the gear {grip} N·m)",
                now.step, now.torque
            ));
        }
        before = *now;
    }
    lines.push(format!(
        "  at the end: {:.6} rad, {:.6} rad/s",
        before.angle, before.speeds[0]
    ));
    Ok(lines.join("\n"))
}

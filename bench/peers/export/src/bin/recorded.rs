//! Runs a stepper under random inputs, and prints inputs and results as CSV, with the names of an FMU's variables.
//!
//! Arguments: the scene (`shaken`, `pushed` or `held`), and the number of steps. `scripts/export` repeats the run.

use export_peer::Random;

frictiongen::friction_system!("shaken.friction");
frictiongen::friction_system!("pushed.friction");
frictiongen::friction_system!("held.friction");

/// Runs the stepper of one scene from an initial state. Each input comes with its name in the FMU, its field in Rust
/// and its scale.
macro_rules! run {
    (
        $scene:ident, $input:ident, $steps:expr, $real:ty,
        [$($name:literal: $field:ident * $scale:expr),*], [$($mass:ident),*]
    ) => {{
        let mut names: Vec<String> = vec![$($name.to_owned(),)* "friction".to_owned()];
        $(names.extend(["displacement", "velocity"].map(|what| format!("{}.{what}", stringify!($mass))));)*
        names.extend(["displacement", "velocity", "force"].map(|what| format!("contact.{what}")));
        names.extend(["load", "friction", "damping", "stored"].map(|what| format!("work.{what}")));
        names.extend(["sticks", "direction", "events", "exceeded", "last_event_time"].map(|what| format!("contact.{what}")));
        println!("{}", names.join(","));
        let mut random = Random::new();
        let mut input = || $input {
            $($field: (random.signed() * $scale) as $real,)*
            friction: (4.0 + 4.0 * random.signed()) as $real,
        };
        let start = [$(stringify!($mass)),*].map(|mass| 1e-3 * mass.len() as $real);
        let mut stepper = $scene::stepper_from($scene::STEP, (&start, &start))?;
        let mut now = input();
        let mut last_event = 0.0;
        for step in 0..=$steps {
            // A simulation begins with the inputs of its first step.
            let events = match step {
                0 => {
                    stepper.begin(now)?;
                    0
                }
                _ => stepper.advance(now)?.events,
            };
            if let Some(since) = stepper.last_event() {
                last_event = (step - 1) as f64 * f64::from($scene::STEP) + f64::from(since);
            }
            let (contact, work) = (stepper.contact(), stepper.work());
            let mut values = vec![$(f64::from(now.$field),)* f64::from(now.friction)];
            $(values.extend([f64::from(stepper.$mass().displacement()), f64::from(stepper.$mass().velocity())]);)*
            values.extend([contact.displacement(), contact.velocity(), contact.force()].map(f64::from));
            values.extend([work.load, work.friction, work.damping, work.stored].map(f64::from));
            let direction = match contact.contact() {
                Contact::Stuck => 0,
                Contact::Forward => 1,
                Contact::Backward => -1,
            };
            let mut texts: Vec<String> = values.iter().map(|value| format!("{value:?}")).collect();
            texts.push(u8::from(contact.is_sticking()).to_string());
            texts.extend([direction.to_string(), events.to_string(), stepper.exceeded().to_string()]);
            texts.push(format!("{last_event:?}"));
            println!("{}", texts.join(","));
            if step > 0 {
                now = input();
            }
        }
    }};
}

use frictiongen::answer::Contact;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let scene = arguments
        .next()
        .ok_or("give a scene and a number of steps")?;
    let steps: u64 = arguments.next().ok_or("give a number of steps")?.parse()?;
    match scene.as_str() {
        "shaken" => run!(
            Shaken, ShakenInput, steps, f64,
            ["base.displacement": displacement * 2e-6, "base.velocity": velocity * 2e-3], [lower, upper]
        ),
        "pushed" => run!(
            Pushed, PushedInput, steps, f32,
            ["first.force": force * 16.0, "double.force": double * 16.0], [first, double, third]
        ),
        "held" => run!(Held, HeldInput, steps, f64, ["block.force": force * 16.0], [block]),
        _ => return Err("the scene is `shaken`, `pushed` or `held`".into()),
    }
    Ok(())
}

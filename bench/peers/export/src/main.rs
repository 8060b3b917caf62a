//! Runs steppers under random inputs, and prints a hash of all bits of their results.
//!
//! Arguments: the scene (`shaken` or `pushed`), and the number of steps. `random.c` makes the same run in C.

use export_peer::Random;

frictiongen::friction_system!("shaken.friction");
frictiongen::friction_system!("pushed.friction");

/// FNV-1a hash with 64 bits.
struct Hash(u64);

impl Hash {
    fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

/// Runs the stepper of one scene. `input` makes an input from three random numbers, and `masses` names the masses.
macro_rules! run {
    ($scene:ident, $dt:expr, $steps:expr, |$random:ident| $input:expr, [$($mass:ident),*]) => {{
        let mut random = Random::new();
        let mut hash = Hash(0xcbf2_9ce4_8422_2325);
        let (mut stepper, mut stuck, mut events) = ($scene::stepper($dt)?, 0_u64, 0_u64);
        for _ in 0..$steps {
            let $random = [random.signed(), random.signed(), random.signed()];
            let stepped = stepper.advance($input)?;
            hash.bytes(&stepped.force.to_ne_bytes());
            events += u64::from(stepped.events);
            stuck += u64::from(stepper.contact().is_sticking());
            $(
                let mass = stepper.$mass();
                hash.bytes(&mass.displacement().to_ne_bytes());
                hash.bytes(&mass.velocity().to_ne_bytes());
            )*
        }
        let at = $scene::at(0.5)?;
        let start = [$(stringify!($mass)),*].map(|_| 0.25);
        let (orbit, other) = (at.orbit(0.125)?, at.orbit_from(0.125, (&start, &start))?);
        for multiplier in orbit.multipliers() {
            hash.bytes(&multiplier.re.to_ne_bytes());
            hash.bytes(&multiplier.im.to_ne_bytes());
        }
        for orbit in [orbit, other] {
            hash.bytes(&orbit.stuck_fraction().to_ne_bytes());
            hash.bytes(&(orbit.stops() as u32).to_ne_bytes());
        }
        println!("{:016x} {events} {stuck} {}", hash.0, stepper.exceeded());
    }};
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let scene = arguments
        .next()
        .ok_or("give a scene and a number of steps")?;
    let steps: u64 = arguments.next().ok_or("give a number of steps")?.parse()?;
    match scene.as_str() {
        "shaken" => run!(
            Shaken,
            1e-3,
            steps,
            |random| ShakenInput {
                displacement: random[0] * 2e-6,
                velocity: random[1] * 2e-3,
                friction: 4.0 + 4.0 * random[2],
            },
            [lower, upper]
        ),
        "pushed" => run!(
            Pushed,
            1.0 / 512.0,
            steps,
            |random| PushedInput {
                force: random[0] as f32 * 16.0,
                double: random[1] as f32 * 16.0,
                friction: 4.0 + 4.0 * random[2] as f32,
            },
            [first, double, third]
        ),
        _ => return Err("the scene is `shaken` or `pushed`".into()),
    }
    Ok(())
}

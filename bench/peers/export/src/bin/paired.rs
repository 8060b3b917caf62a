//! Runs a stepper with two contacts under random inputs. Prints inputs and results as CSV, with the names of an FMU's
//! variables, or their bits.
//!
//! Arguments: the number of steps, and `bits` for the bits. `scripts/export` repeats the run in C and in an FMU.

use export_peer::Random;

frictiongen::friction_system!("pair.friction");

const NAMES: &str = "lower.force,upper.force,brace.friction,pads.friction,lower.displacement,lower.velocity,\
    upper.displacement,upper.velocity,brace.displacement,brace.velocity,brace.force,pads.displacement,pads.velocity,\
    pads.force,work.load,work.friction,work.damping,work.stored,contacts.events,contacts.exceeded";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let steps: u64 = arguments.next().ok_or("give a number of steps")?.parse()?;
    let has_bits = arguments.next().is_some();
    if !has_bits {
        println!("{NAMES}");
    }
    let mut random = Random::new();
    let mut stepper = Pair::stepper(Pair::STEP)?;
    for _ in 0..steps {
        let [force, upper] = [0, 1].map(|_| 16.0 * random.signed());
        let [brace, pads] = [0, 1].map(|_| 4.0 + 4.0 * random.signed());
        let friction = PairFriction { brace, pads };
        let stepped = stepper.advance(PairInput {
            force,
            upper,
            friction,
        })?;
        let (masses, work) = ([stepper.lower(), stepper.upper()], stepper.work());
        let contacts = [stepper.brace(), stepper.pads()];
        let mut values = vec![force, upper, brace, pads];
        values.extend(
            masses
                .iter()
                .flat_map(|mass| [mass.displacement(), mass.velocity()]),
        );
        values.extend(
            contacts
                .iter()
                .flat_map(|now| [now.displacement(), now.velocity(), now.force()]),
        );
        values.extend([work.load, work.friction, work.damping, work.stored]);
        values.extend([f64::from(stepped.events), stepper.exceeded() as f64]);
        let texts = values.iter().map(|value| match has_bits {
            true => format!("{:016x}", value.to_bits()),
            false => format!("{value:?}"),
        });
        println!("{}", texts.collect::<Vec<_>>().join(","));
    }
    Ok(())
}

//! Runs a stepper with two contacts under random inputs. Prints inputs and results as CSV, with the names of an FMU's
//! variables, or their bits.
//!
//! Arguments: the number of steps, and `bits` for the bits. `scripts/export` repeats the run in C and in an FMU.

frictiongen::friction_system!("pair.friction");

/// Random numbers from a xorshift generator (Marsaglia 2003). The number in it is the state.
struct Random(u64);

impl Random {
    /// Returns a number between -1 and 1 with 24 bits.
    fn signed(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 40) as f64 / 8_388_608.0 - 1.0
    }
}

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
    let mut random = Random(88_172_645_463_325_252);
    let mut stepper = Pair::stepper(Pair::STEP)?;
    for _ in 0..steps {
        let [force, upper] = [0, 1].map(|_| 16.0 * random.signed());
        let [brace, pads] = [0, 1].map(|_| 4.0 + 4.0 * random.signed());
        let friction = PairFriction { brace, pads };
        let stepped = stepper.advance(PairInput { force, upper, friction })?;
        let (masses, work) = ([stepper.lower(), stepper.upper()], stepper.work());
        let contacts = [stepper.brace(), stepper.pads()];
        let mut values = vec![force, upper, brace, pads];
        values.extend(masses.iter().flat_map(|mass| [mass.displacement(), mass.velocity()]));
        values.extend(contacts.iter().flat_map(|now| [now.displacement(), now.velocity(), now.force()]));
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

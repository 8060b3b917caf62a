//! Runs steppers on the emulated processor. Prints their final states, and the instructions and the stack of their
//! steps.
#![no_std]
#![no_main]

use bench::{stack, timer};
use core::hint::black_box;
use core::panic::PanicInfo;
use cortex_m::peripheral::{Peripherals, SYST};
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use scenes::steps::machines::{Visitor, visit};
use scenes::steps::script::{FRICTION, STEPS, Song, Tone, Weather, played};
use scenes::steps::{Cost, Machine, Outcome};

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}

/// Number of bytes below the stack pointer that are painted to measure the stack of a step. No step needs as many.
const STACK: usize = 16384;

/// Needs of a group of steps: fewest and most instructions, and most bytes of stack.
#[derive(Clone, Copy)]
struct Needs {
    least: u64,
    most: u64,
    stack: usize,
}

impl Needs {
    const NONE: Self = Self {
        least: u64::MAX,
        most: 0,
        stack: 0,
    };

    fn add(&mut self, instructions: u64, stack: usize) {
        self.least = self.least.min(instructions);
        self.most = self.most.max(instructions);
        self.stack = self.stack.max(stack);
    }
}

/// Needs of the steps of a run, grouped by what happened in each step.
struct Kinds {
    sliding: Needs,
    sticking: Needs,
    quiet: Needs,
    one: Needs,
    all: Needs,
    sum: u64,
    exceeded: u32,
    events: u32,
}

/// Measures all steps of a machine under one kind of load. If `budget` is not 0, a step follows at most this number
/// of events.
fn measured<M: Machine>(timer: &mut SYST, weather: Weather, budget: u8) -> Option<Kinds>
where
    M::Scalar: Tone,
{
    let (mut machine, mut song) = (M::start()?, Song::new());
    if budget != 0 {
        machine.set_budget(budget)?;
    }
    let empty = timer::ticks(timer, || ());
    let mut kinds = Kinds {
        sliding: Needs::NONE,
        sticking: Needs::NONE,
        quiet: Needs::NONE,
        one: Needs::NONE,
        all: Needs::NONE,
        sum: 0,
        exceeded: 0,
        events: 0,
    };
    for _ in 0..STEPS {
        let load = black_box(song.next(M::ON_BASE, weather));
        let friction = black_box(M::Scalar::of(FRICTION));
        let mut outcome = None;
        let mut ticks = 0;
        let stack = stack::depth_within(STACK, || {
            ticks = timer::ticks(timer, || outcome = machine.advance(load, friction));
        });
        let Outcome {
            sticks,
            events,
            exceeded,
        } = outcome?;
        let count = ((ticks - empty) * timer::INSTRUCTIONS + timer::TICKS / 2) / timer::TICKS;
        match (events, sticks) {
            (0, false) => kinds.sliding.add(count, stack),
            (0, true) => kinds.sticking.add(count, stack),
            (1, _) => kinds.one.add(count, stack),
            _ => {}
        }
        if events == 0 {
            kinds.quiet.add(count, stack);
        }
        kinds.all.add(count, stack);
        kinds.sum += count;
        kinds.exceeded += u32::from(exceeded);
        kinds.events = kinds.events.max(events);
    }
    Some(kinds)
}

/// Measures the most expensive step over all loads, with each event budget. Compares it with the stepper's upper
/// bound on its cost.
fn budgets<M: Machine>(timer: &mut SYST)
where
    M::Scalar: Tone,
{
    for budget in [0, 1, 2, 4] {
        let mut all = Needs::NONE;
        let (mut exceeded, mut most) = (0, 0);
        for weather in [Weather::Song, Weather::Storm, Weather::Breeze] {
            let Some(kinds) = measured::<M>(timer, weather, budget) else {
                return;
            };
            all.add(kinds.all.most, kinds.all.stack);
            exceeded += kinds.exceeded;
            most = most.max(kinds.events);
        }
        hprintln!(
            "cost|{}|budget {}: worst|{}|{}",
            M::NAME,
            budget,
            all.most,
            all.stack
        );
        let Some(mut machine) = M::start() else {
            return;
        };
        machine.set_budget(budget);
        let Some(cost) = machine.cost().filter(|_| !M::SOFTWARE) else {
            continue;
        };
        let bound = M::INSTRUCTIONS * cost.most + Cost::FIXED;
        hprintln!("cost|{}|budget {}: bound|{}|0", M::NAME, budget, bound);
        hprintln!(
            "# {}, budget {}: {} steps exceeded, up to {} events",
            M::NAME,
            budget,
            exceeded,
            most
        );
        if bound < all.most {
            hprintln!("over: {}, budget {}", M::NAME, budget);
        }
    }
}

/// Measures the creation of a stepper, and the calls that read its masses while the contact sticks.
fn beside<M: Machine>(timer: &mut SYST)
where
    M::Scalar: Tone,
{
    let empty = timer::ticks(timer, || ());
    let mut told = |what: &str, size: usize, call: &mut dyn FnMut()| {
        let ticks = timer::ticks(timer, call);
        let count = ((ticks - empty) * timer::INSTRUCTIONS + timer::TICKS / 2) / timer::TICKS;
        hprintln!("cost|{}|{}|{}|{}", M::NAME, what, count, size);
    };
    told("stepper with its tables", M::SIZE, &mut || {
        black_box(&M::start());
    });
    if let Some(size) = M::DECLARED {
        told("stepper with constant tables", size, &mut || {
            M::start_declared();
        });
    }
    // Under a small load the contact sticks. Reading this state takes more instructions than reading a sliding state.
    let Some(mut machine) = M::start() else {
        return;
    };
    for _ in 0..4 {
        machine.advance([M::Scalar::of(0.0); 2], M::Scalar::of(FRICTION));
    }
    told("reading the masses one by one", 0, &mut || {
        machine.read_each()
    });
    if machine.read_all().is_some() {
        told("reading all masses at once", 0, &mut || {
            machine.read_all();
        });
    }
}

struct Bench<'t>(&'t mut SYST);

impl Visitor for Bench<'_> {
    fn visit<M: Machine>(&mut self)
    where
        M::Scalar: Tone,
    {
        let (Some(song), Some(storm)) = (
            measured::<M>(self.0, Weather::Song, 0),
            measured::<M>(self.0, Weather::Storm, 0),
        ) else {
            hprintln!("{}: an error", M::NAME);
            return;
        };
        let quiet = song.quiet.most.max(storm.quiet.most);
        let one = song.one.most.max(storm.one.most);
        let stack = song.all.stack.max(storm.all.stack);
        let least = song.sticking.least.min(storm.sticking.least);
        for (what, count, stack) in [
            (
                "sliding, by the tables",
                song.sliding.least,
                song.sliding.stack,
            ),
            ("sticking, by the tables", least, song.sticking.stack),
            ("mean of a song", song.sum / STEPS as u64, song.all.stack),
            ("worst without event", quiet, stack),
            ("worst with one event", one, stack),
            (
                "worst of a song and a storm",
                song.all.most.max(storm.all.most),
                stack,
            ),
        ] {
            if count != u64::MAX {
                hprintln!("cost|{}|step: {}|{}|{}", M::NAME, what, count, stack);
            }
        }
        budgets::<M>(self.0);
        beside::<M>(self.0);
        hprintln!(
            "# {}: {} of {} steps exceeded",
            M::NAME,
            storm.exceeded,
            STEPS
        );
        let Some(cost) = M::start().and_then(|machine| machine.cost()) else {
            return;
        };
        let tables = song
            .sliding
            .least
            .max(if least == u64::MAX { 0 } else { least });
        for (what, measured, operations) in [
            ("by the tables", tables, cost.tables),
            ("one event", one, cost.one_event),
            ("any", song.all.most.max(storm.all.most), cost.most),
        ] {
            hprintln!(
                "# {}, {}: {} instructions, {} operations",
                M::NAME,
                what,
                measured,
                operations
            );
            if !M::SOFTWARE && M::INSTRUCTIONS * operations + Cost::FIXED < measured {
                hprintln!("over: {}, {}", M::NAME, what);
            }
        }
    }
}

#[entry]
fn main() -> ! {
    if let Some(mut peripherals) = Peripherals::take() {
        let timer = &mut peripherals.SYST;
        timer::set_up(timer);
        visit(&mut Ends);
        visit(&mut Bench(timer));
    }
    loop {
        debug::exit(debug::EXIT_SUCCESS);
    }
}

/// Prints the final state of each machine that it visits.
struct Ends;

impl Visitor for Ends {
    fn visit<M: Machine>(&mut self)
    where
        M::Scalar: Tone,
    {
        for (weather, name) in [(Weather::Song, "song"), (Weather::Storm, "storm")] {
            let [place, velocity, work] = played::<M>(weather).unwrap_or_default();
            hprintln!(
                "{} of {}: {:016x} {:016x} {:016x}",
                name,
                M::NAME,
                place,
                velocity,
                work
            );
        }
    }
}

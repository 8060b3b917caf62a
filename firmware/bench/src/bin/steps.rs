//! Steppers on the emulated processor: where they end, and the instructions and the stack of their steps.
#![no_std]
#![no_main]

use bench::{stack, timer};
use core::hint::black_box;
use core::panic::PanicInfo;
use cortex_m::peripheral::{Peripherals, SYST};
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use scenes::steps::machines::*;
use scenes::steps::script::{FRICTION, STEPS, Song, Tone};
use scenes::steps::{Machine, Outcome};

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}

/// The instructions of some steps.
#[derive(Clone, Copy)]
struct Steps {
    count: u64,
    least: u64,
    most: u64,
    sum: u64,
    deepest: usize,
}

impl Steps {
    const NONE: Self = Self {
        count: 0,
        least: u64::MAX,
        most: 0,
        sum: 0,
        deepest: 0,
    };

    fn add(&mut self, instructions: u64, depth: usize) {
        self.count += 1;
        self.least = self.least.min(instructions);
        self.most = self.most.max(instructions);
        self.sum += instructions;
        self.deepest = self.deepest.max(depth);
    }

    fn print(&self, scene: &str, what: &str) {
        if self.count == 0 {
            return;
        }
        for (which, figure) in [
            ("least", self.least),
            ("mean", self.sum / self.count),
            ("worst", self.most),
        ] {
            hprintln!(
                "step|{}|{}, the {} of {}|{}|{}",
                scene,
                what,
                which,
                self.count,
                figure,
                self.deepest
            );
        }
    }
}

/// All steps of a song, by what happened in them.
fn measure<M: Machine>(timer: &mut SYST, on_base: bool, storm: bool)
where
    M::Scalar: Tone,
{
    let (Some(mut machine), mut song) = (M::start(), Song::new()) else {
        return;
    };
    let empty = timer::ticks(timer, || ());
    let mut kinds = [Steps::NONE; 5];
    for _ in 0..STEPS {
        let load = if storm { song.storm(on_base) } else { song.next(on_base) };
        let load = black_box(load);
        let friction = black_box(M::Scalar::of(FRICTION));
        let mut outcome = None;
        let mut ticks = 0;
        let depth = stack::depth(|| {
            ticks = timer::ticks(timer, || outcome = machine.advance(load, friction));
        });
        let count = ((ticks - empty) * timer::INSTRUCTIONS + timer::TICKS / 2) / timer::TICKS;
        let Some(Outcome { sticks, events, exceeded }) = outcome else {
            hprintln!("{}: an error", M::NAME);
            debug::exit(debug::EXIT_FAILURE);
            return;
        };
        let kind = match (events, sticks) {
            _ if exceeded => 4,
            (0, false) => 0,
            (0, true) => 1,
            (1, _) => 2,
            _ => 3,
        };
        kinds[kind].add(count, depth);
    }
    let names = ["sliding", "sticking", "one event", "more events", "more events than are followed"];
    for (kind, name) in kinds.iter().zip(names) {
        kind.print(M::NAME, name);
    }
    for bits in machine.bits() {
        hprintln!("end|{}|{:016x}", M::NAME, bits);
    }
}

#[entry]
fn main() -> ! {
    if let Some(mut peripherals) = Peripherals::take() {
        let timer = &mut peripherals.SYST;
        timer::set_up(timer);
        for storm in [false, true] {
            if storm {
                hprintln!("storm");
            }
            measure::<one_force::Run>(timer, false, storm);
            measure::<one_base::Run>(timer, true, storm);
            measure::<two_force::Run>(timer, false, storm);
            measure::<two_base::Run>(timer, true, storm);
            measure::<five_force::Run>(timer, false, storm);
            measure::<five_base::Run>(timer, true, storm);
            measure::<ten_force::Run>(timer, false, storm);
            measure::<ten_base::Run>(timer, true, storm);
            measure::<one_force_double::Run>(timer, false, storm);
            measure::<one_base_double::Run>(timer, true, storm);
            measure::<two_force_double::Run>(timer, false, storm);
            measure::<two_base_double::Run>(timer, true, storm);
        }
    }
    loop {
        debug::exit(debug::EXIT_SUCCESS);
    }
}

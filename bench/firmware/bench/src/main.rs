//! Makes every call on the emulated processor. Prints its values, its instructions and its stack.
#![no_std]
#![no_main]

use bench::{stack, timer};
use core::hint::black_box;
use core::panic::PanicInfo;
use cortex_m::peripheral::{Peripherals, SYST};
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use scenes::calls::{Call, DOUBLE, INPUTS, INPUTS_SINGLE, Input, SINGLE, tabled_five_limits};

const FEW: u64 = 4;
const MANY: u64 = 20;

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {
        debug::exit(debug::EXIT_FAILURE);
    }
}

fn ticks<S: Copy>(timer: &mut SYST, call: &Call<S>, input: &Input<S>, times: u64) -> u64 {
    let run = black_box(call.run);
    timer::ticks(timer, || {
        for _ in 0..times {
            black_box(run(black_box(input)));
        }
    })
}

/// A call that takes more ticks of the timer than this number is measured once. Shorter calls are repeated.
const LONG: u64 = 10_000_000;

/// Returns the number of instructions of a call, including those of the loop around it.
fn instructions<S: Copy>(timer: &mut SYST, call: &Call<S>, input: &Input<S>) -> u64 {
    let once = ticks(timer, call, input, 1);
    if LONG < once {
        return once * timer::INSTRUCTIONS / timer::TICKS;
    }
    let few = ticks(timer, call, input, FEW);
    let many = ticks(timer, call, input, MANY);
    let denominator = timer::TICKS * (MANY - FEW);
    ((many - few) * timer::INSTRUCTIONS + denominator / 2) / denominator
}

#[entry]
fn main() -> ! {
    if let Some(mut peripherals) = Peripherals::take() {
        let timer = &mut peripherals.SYST;
        timer::set_up(timer);
        for (number, call) in SINGLE.iter().enumerate() {
            for (place, input) in INPUTS_SINGLE.iter().enumerate() {
                let [a, b] = (call.run)(black_box(input));
                let (a, b) = (a.to_bits(), b.to_bits());
                hprintln!("single {} {} {:08x} {:08x}", number, place, a, b);
            }
        }
        for (number, call) in DOUBLE.iter().enumerate() {
            for (place, input) in INPUTS.iter().enumerate() {
                let [a, b] = (call.run)(black_box(input));
                let (a, b) = (a.to_bits(), b.to_bits());
                hprintln!("double {} {} {:016x} {:016x}", number, place, a, b);
            }
        }
        for call in &SINGLE {
            cost(timer, call, &INPUTS_SINGLE);
        }
        for call in &DOUBLE {
            cost(timer, call, &INPUTS);
        }
        for call in SINGLE.iter().filter(|call| call.question == "limits") {
            if !call.is_tabled() {
                sweep(timer, call);
            }
        }
        cost(timer, &NOTHING, &INPUTS_SINGLE);
        for call in SINGLE.iter().filter(|call| call.is_tabled()) {
            sweep_tabled(timer, call);
        }
    }
    loop {
        debug::exit(debug::EXIT_SUCCESS);
    }
}

/// Prints the largest number of instructions and the largest stack of a call over all inputs.
fn cost<S: Copy>(timer: &mut SYST, call: &Call<S>, inputs: &[Input<S>]) {
    let (mut slowest, mut deepest) = (0, 0);
    for input in inputs {
        slowest = slowest.max(instructions(timer, call, input));
        deepest = deepest.max(stack::depth(|| {
            black_box((call.run)(black_box(input)));
        }));
    }
    hprintln!(
        "cost|{}|{}|{}|{}",
        call.scene,
        call.question,
        slowest,
        deepest
    );
}

/// A call that does nothing. Its measurement is the overhead of all measurements.
const NOTHING: Call<f32> = Call {
    scene: "none",
    question: "a call that returns what it is given",
    run: nothing,
};

#[inline(never)]
fn nothing(input: &Input<f32>) -> [f32; 2] {
    [input.r, input.beta]
}

/// Number of frequency ratios in a sweep.
const FREQUENCIES: u32 = 1000;
/// Sweep of exact limits over the frequency ratio r, from 0.05 to 5: the first r, and the ratio of each r to the
/// previous r.
const EXACT: (f32, f32) = (0.05, 1.004_615_8);
/// Sweep of tables over the frequency ratio r, from 0.2 to 2.5 and just inside their range: the first r, and the ratio
/// of each r to the previous r.
const TABLED: (f32, f32) = (0.2001, 1.002_53);

/// Measures a call over a sweep of frequency ratios. Returns the smallest and the largest number of instructions and
/// stack in bytes. `beta` gives the friction ratio at each frequency ratio.
fn swept(
    timer: &mut SYST,
    call: &Call<f32>,
    (first, ratio): (f32, f32),
    beta: impl Fn(&Input<f32>) -> f32,
) -> [(u64, usize); 2] {
    let (mut least, mut most) = ((u64::MAX, usize::MAX), (0, 0));
    let mut input = Input {
        r: first,
        beta: 0.0,
        tau: 0.0,
    };
    for _ in 0..FREQUENCIES {
        input.beta = beta(&input);
        let count = instructions(timer, call, &input);
        let depth = stack::depth(|| {
            black_box((call.run)(black_box(&input)));
        });
        least = (count.min(least.0), depth.min(least.1));
        most = (count.max(most.0), depth.max(most.1));
        input.r *= ratio;
    }
    [least, most]
}

fn print_swept(call: &Call<f32>, which: &str, (count, depth): (u64, usize)) {
    hprintln!(
        "cost|{}|{}, the {} of {} frequencies|{}|{}",
        call.scene,
        call.question,
        which,
        FREQUENCIES,
        count,
        depth
    );
}

/// Measures a call for exact limits over a sweep. Next to resonances and their subharmonics, its search takes longer
/// than elsewhere.
fn sweep(timer: &mut SYST, call: &Call<f32>) {
    let [_, most] = swept(timer, call, EXACT, |_| 0.0);
    print_swept(call, "worst", most);
}

/// Measures a call that reads tables over a sweep. The call takes equally long at every frequency. The friction ratio
/// is half the smaller limit of the five masses, so that their motion is continuous.
fn sweep_tabled(timer: &mut SYST, call: &Call<f32>) {
    let [least, most] = swept(timer, call, TABLED, |input| {
        let [continuous, sliding] = tabled_five_limits(input);
        0.5 * continuous.min(sliding)
    });
    print_swept(call, "least", least);
    print_swept(call, "worst", most);
}

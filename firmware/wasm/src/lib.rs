//! Every call for a wasm host, by number: 32 or 64 bits of one of its two values.
#![no_std]

use scenes::calls::{DOUBLE, INPUTS, INPUTS_SINGLE, SINGLE};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    core::arch::wasm32::unreachable()
}

/// How many calls there are in single precision.
#[unsafe(no_mangle)]
pub extern "C" fn single_count() -> usize {
    SINGLE.len()
}

/// How many calls there are in double precision.
#[unsafe(no_mangle)]
pub extern "C" fn double_count() -> usize {
    DOUBLE.len()
}

/// How many inputs each call has.
#[unsafe(no_mangle)]
pub extern "C" fn input_count() -> usize {
    INPUTS.len()
}

/// The bits of value `which` of a call in single precision.
#[unsafe(no_mangle)]
pub extern "C" fn single(call: usize, input: usize, which: usize) -> u32 {
    let (Some(call), Some(input)) = (SINGLE.get(call), INPUTS_SINGLE.get(input)) else {
        return 0;
    };
    let values = (call.run)(input);
    values.get(which).map_or(0, |value| value.to_bits())
}

/// The bits of value `which` of a call in double precision.
#[unsafe(no_mangle)]
pub extern "C" fn double(call: usize, input: usize, which: usize) -> u64 {
    let (Some(call), Some(input)) = (DOUBLE.get(call), INPUTS.get(input)) else {
        return 0;
    };
    let values = (call.run)(input);
    values.get(which).map_or(0, |value| value.to_bits())
}

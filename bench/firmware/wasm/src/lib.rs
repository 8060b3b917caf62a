//! Makes the calls by their index for a wasm host. Each function returns the bits of one of the two values of a call.
#![no_std]

use scenes::calls::{DOUBLE, INPUTS, INPUTS_SINGLE, SINGLE};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    core::arch::wasm32::unreachable()
}

/// Returns the number of calls in single precision.
#[unsafe(no_mangle)]
pub extern "C" fn single_count() -> usize {
    SINGLE.len()
}

/// Returns the number of calls in double precision.
#[unsafe(no_mangle)]
pub extern "C" fn double_count() -> usize {
    DOUBLE.len()
}

/// Returns the number of inputs of each call.
#[unsafe(no_mangle)]
pub extern "C" fn input_count() -> usize {
    INPUTS.len()
}

/// Returns the bits of one value of a call in single precision. `call` and `input` are indices, and `which` is 0 or
/// 1.
#[unsafe(no_mangle)]
pub extern "C" fn single(call: usize, input: usize, which: usize) -> u32 {
    let (Some(call), Some(input)) = (SINGLE.get(call), INPUTS_SINGLE.get(input)) else {
        return 0;
    };
    let values = (call.run)(input);
    values.get(which).map_or(0, |value| value.to_bits())
}

/// Returns the bits of one value of a call in double precision. `call` and `input` are indices, and `which` is 0 or
/// 1.
#[unsafe(no_mangle)]
pub extern "C" fn double(call: usize, input: usize, which: usize) -> u64 {
    let (Some(call), Some(input)) = (DOUBLE.get(call), INPUTS.get(input)) else {
        return 0;
    };
    let values = (call.run)(input);
    values.get(which).map_or(0, |value| value.to_bits())
}

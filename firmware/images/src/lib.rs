//! Images that contain only a few calls, to measure their size and what they link.
#![no_std]

/// A program that runs the given calls. Its panic handler calls a function that does not exist. The image therefore
/// links only if no panic can be reached.
#[macro_export]
macro_rules! image {
    ($($call:ident $inputs:ident),*) => {
        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo) -> ! {
            unsafe extern "C" {
                fn a_panic_can_be_reached() -> !;
            }
            // SAFETY: the call is never linked.
            unsafe { a_panic_can_be_reached() }
        }

        #[cortex_m_rt::entry]
        fn main() -> ! {
            loop {
                $(core::hint::black_box(scenes::calls::$call(core::hint::black_box(
                    &scenes::calls::$inputs[0],
                )));)*
            }
        }
    };
}

/// A program that steps a machine from rest under the given input. It links only if no panic can be reached, as
/// `image!` does.
#[macro_export]
macro_rules! stepping {
    ($machine:ident) => {
        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo) -> ! {
            unsafe extern "C" {
                fn a_panic_can_be_reached() -> !;
            }
            // SAFETY: the call is never linked.
            unsafe { a_panic_can_be_reached() }
        }

        #[cortex_m_rt::entry]
        fn main() -> ! {
            use core::hint::black_box;
            use scenes::steps::machines::$machine::{advance, start, time};
            let mut machine = start();
            loop {
                if let Some(machine) = &mut machine {
                    black_box(advance(machine, black_box([10.0, 0.0]), black_box(3.0)));
                    black_box(time(machine));
                }
            }
        }
    };
}

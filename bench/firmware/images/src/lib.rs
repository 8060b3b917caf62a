//! Defines small programs with a few calls each. They show the size of an image, and which code it contains.
#![no_std]

/// Defines a program that makes the given calls. Its panic handler calls a function that does not exist. If any call
/// could panic, the linker would therefore fail.
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

/// Defines a program that advances a machine from rest under the given input. The linker fails if any step could panic,
/// as it does with [`image!`].
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

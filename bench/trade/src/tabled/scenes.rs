//! The chains in double precision, emitted with tables over the frequency ratios from 0.2 to 2.5.

use crate::methods::{Fill, each, limits};
use frictiongen::{FrictionSystem, LimitsAt};

/// Emits every chain with tables of each accuracy, and lists the chains.
macro_rules! tabled {
    ($($orbit:ident struct $name:ident $masses:literal $watched:literal $body:tt $provide:tt)*) => {
        mod undamped {
            tabled!(@accuracies [none]; $($name $body)*);
        }
        mod damped {
            tabled!(@accuracies [modal(0.02)]; $($name $body)*);
        }

        /// Returns the emitted tables of the scene with this name: those of both limits, each with the number n of
        /// its accuracy 10⁻ⁿ, and that of the contact's amplitude to 1e-4.
        pub fn emitted(name: &str, damped: bool) -> Option<(Vec<(u8, Fill<f64>)>, Fill<f64>)> {
            $(
                if name == stringify!($name) {
                    return Some(if damped {
                        tabled!(@fills damped $name)
                    } else {
                        tabled!(@fills undamped $name)
                    });
                }
            )*
            None
        }
    };
    (@accuracies $damping:tt; $($name:ident $body:tt)*) => {
        pub mod e2 {
            $(tabled!(@emit $name, 1e-2, [limits], $damping, $body);)*
        }
        pub mod e3 {
            $(tabled!(@emit $name, 1e-3, [limits], $damping, $body);)*
        }
        pub mod e4 {
            $(tabled!(@emit $name, 1e-4, [limits], $damping, $body);)*
        }
        pub mod e6 {
            $(tabled!(@emit $name, 1e-6, [limits], $damping, $body);)*
        }
        pub mod e9 {
            $(tabled!(@emit $name, 1e-9, [limits], $damping, $body);)*
        }
        pub mod motion {
            $(tabled!(@emit $name, 1e-4, [limits, motion], $damping, $body);)*
        }
    };
    (@emit $name:ident, $accuracy:literal, $provide:tt, [$($damping:tt)*], { $($body:tt)* }) => {
        ::frictiongen::friction_system! {
            /// One of the scenes.
            pub struct $name {
                $($body)* provide: $provide, damping: $($damping)*,
                accuracy: $accuracy, range: { r: 0.2..2.5 },
            }
        }
    };
    (@fills $damping:ident $name:ident) => {
        (
            vec![
                (2, both($damping::e2::$name)),
                (3, both($damping::e3::$name)),
                (4, both($damping::e4::$name)),
                (6, both($damping::e6::$name)),
                (9, both($damping::e9::$name)),
            ],
            contact(|r, beta| {
                Some($damping::motion::$name::at(r).ok()?.motion(beta).ok()?.contact().amplitude())
            }),
        )
    };
}

chains!(tabled);

/// Creates the function that computes both limits of a system.
pub fn both<F>(system: F) -> Fill<f64>
where
    F: FrictionSystem<Scalar = f64> + 'static,
{
    Box::new(move |_, points, out| limits(&system, points, out, |at| at.continuous_limit()))
}

/// Creates the function that computes the amplitude of the contact at each point (r, β).
fn contact(amplitude: impl Fn(f64, f64) -> Option<f64> + 'static) -> Fill<f64> {
    Box::new(move |_, points, out| {
        each(points, out, |[r, beta]| Some([amplitude(r, beta)?; 2]));
    })
}

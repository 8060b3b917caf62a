//! Tests of motion in time: the real-time stepper, and friction laws that depend on the speed.

/// Emits scenes, and keeps their texts: `system` parses the text of a scene by its name.
macro_rules! scenes {
    ($(struct $name:ident { $($body:tt)* })*) => {
        $(frictiongen::friction_system! { pub struct $name { $($body)* } })*
        fn system(name: &str) -> frictiongen::System {
            let text = match name {
                $(stringify!($name) => stringify!(struct $name { $($body)* }),)*
                _ => panic!("no scene {name}"),
            };
            text.parse().expect("a valid scene")
        }
    };
}

mod from_base;
mod images;
mod joined;
mod joined_base;
mod joined_orbits;
mod periodic;
mod step_readings;
mod stepper;
mod stops;
mod stribeck;

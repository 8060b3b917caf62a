//! Runs formulas of the thesis that are written by hand in C: `c/thesis.c`.

use super::Modal;
use crate::methods::{Fill, Method, Pair};

type Function = unsafe extern "C" fn(*const f64, usize, *const Pair<f64>, *mut Pair<f64>);

macro_rules! functions {
    ($($masses:literal: $limits:ident $limits_damped:ident $without:ident $without_damped:ident
       $amplitude:ident $amplitude_damped:ident;)*) => {
        unsafe extern "C" {
            $(
            fn $limits(s: *const f64, n: usize, p: *const Pair<f64>, out: *mut Pair<f64>);
            fn $limits_damped(s: *const f64, n: usize, p: *const Pair<f64>, out: *mut Pair<f64>);
            fn $without(s: *const f64, n: usize, p: *const Pair<f64>, out: *mut Pair<f64>);
            fn $without_damped(s: *const f64, n: usize, p: *const Pair<f64>, out: *mut Pair<f64>);
            fn $amplitude(s: *const f64, n: usize, p: *const Pair<f64>, out: *mut Pair<f64>);
            fn $amplitude_damped(s: *const f64, n: usize, p: *const Pair<f64>, out: *mut Pair<f64>);)*
        }

        fn function(masses: usize, damped: bool, method: Method) -> Option<Function> {
            Some(match (masses, damped, method) {
                $(($masses, false, Method::Limits) => $limits,
                ($masses, true, Method::Limits) => $limits_damped,
                ($masses, false, Method::WithoutSearch) => $without,
                ($masses, true, Method::WithoutSearch) => $without_damped,
                ($masses, false, Method::Amplitude) => $amplitude,
                ($masses, true, Method::Amplitude) => $amplitude_damped,)*
                _ => return None,
            })
        }
    };
}

functions! {
    1: limits_undamped_1 limits_damped_1 limits_without_search_undamped_1
       limits_without_search_damped_1 amplitude_undamped_1 amplitude_damped_1;
    2: limits_undamped_2 limits_damped_2 limits_without_search_undamped_2
       limits_without_search_damped_2 amplitude_undamped_2 amplitude_damped_2;
    5: limits_undamped_5 limits_damped_5 limits_without_search_undamped_5
       limits_without_search_damped_5 amplitude_undamped_5 amplitude_damped_5;
    10: limits_undamped_10 limits_damped_10 limits_without_search_undamped_10
       limits_without_search_damped_10 amplitude_undamped_10 amplitude_damped_10;
}

/// Quantities that the C functions compute.
pub const METHODS: [Method; 3] = [Method::Limits, Method::WithoutSearch, Method::Amplitude];

/// Creates the function that computes the quantities with the C functions.
pub fn filler(modal: &Modal) -> Fill<f64> {
    // The numbers follow the order of the members of `Thesis` in C.
    let mut data = Vec::new();
    for part in [
        &modal.root,
        &modal.load,
        &modal.friction,
        &modal.far_load,
        &modal.far_friction,
        &modal.share,
    ] {
        data.extend(part);
    }
    data.extend([modal.base, 1.0, modal.inverse_mass, modal.zeta]);
    let (masses, damped) = (modal.root.len(), modal.zeta > 0.0);
    Box::new(move |method, points, out| {
        let count = points.len().min(out.len());
        if let Some(function) = function(masses, damped, method) {
            // SAFETY: `data` holds a whole `Thesis` of this number of masses (6 arrays of as many
            // doubles, then 4), and both slices hold `count` pairs.
            unsafe { function(data.as_ptr(), count, points.as_ptr(), out.as_mut_ptr()) }
        }
    })
}

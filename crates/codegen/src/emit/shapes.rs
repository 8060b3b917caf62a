//! Emits mode shapes in the kernel's order: the components of the first mass in all modes, then of the second mass, and
//! so on. If `MODE_SHAPES` has the same numbers, the emitted code reads them from `MODE_SHAPES`.

use super::emission::{Emission, rounded};
use proc_macro2::{Literal, TokenStream};

/// Emits `[mass][mode]` from a list of numbers in the kernel's order.
pub(super) fn by_masses(emission: &Emission<'_>, shapes: &[f64]) -> TokenStream {
    let masses = emission.scene.masses.len();
    let modes = shapes.len() / masses.max(1);
    let places: Option<Vec<usize>> = (0..modes)
        .map(|mode| place(emission, shapes.iter().skip(mode).step_by(modes)))
        .collect();
    match places {
        Some(places) if places.iter().copied().eq(0..masses) => {
            code!(transposed(&Self::MODE_SHAPES))
        }
        Some(places) => {
            let places = places.into_iter().map(Literal::usize_unsuffixed);
            code!(transposed(&[#(Self::MODE_SHAPES[#places]),*]))
        }
        // For modes of equal frequency, the solver uses combinations of which the contact drives only one.
        // `MODE_SHAPES` therefore has other numbers.
        None => {
            let masses = shapes.chunks(modes.max(1));
            let masses = masses.map(|shape| emission.list(shape.iter().copied()));
            code!([#(#masses),*])
        }
    }
}

/// Returns the index in `MODE_SHAPES` of the mode that has exactly these components.
fn place<'a>(emission: &Emission<'_>, shape: impl Iterator<Item = &'a f64>) -> Option<usize> {
    let shape: Vec<u64> = shape.map(|component| component.to_bits()).collect();
    emission.modal.shapes.iter().position(|known| {
        let known = known.iter();
        let known = known.map(|component| rounded(*component, emission.precision).to_bits());
        known.eq(shape.iter().copied())
    })
}

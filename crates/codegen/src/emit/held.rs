//! Emits the tables and functions that compute the stuck responses of a scene with a declared accuracy. A stuck
//! response is the amplitude of a mass while the contact is stuck.

use super::checksum;
use super::emission::{Checked, Emission, EmittedCode};
use super::names::TypeNames;
use super::table::{counted, factors, quotient_over};
use crate::lower::SceneTables;
use frictiongen_kernel::Float;
use frictiongen_kernel::emitted::check::{self, Listed};
use frictiongen_kernel::table::Root;
use frictiongen_model::table::{Held, HeldForm, Tables};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::format_ident;

/// Emits the stuck responses as constants, each a product of factors, and the functions that evaluate the products.
/// Emits nothing for a scene without a declared accuracy.
pub(super) fn emit(emission: &Emission<'_>) -> EmittedCode {
    match &emission.description.tables {
        None => EmittedCode::default(),
        Some(SceneTables::Double(tables)) => tabled(emission, tables),
        Some(SceneTables::Single(tables)) => tabled(emission, tables),
    }
}

fn tabled<S: Float + Listed<S>>(emission: &Emission<'_>, tables: &Tables<S>) -> EmittedCode {
    let Emission {
        scalar,
        names: TypeNames { name, stuck, .. },
        ..
    } = emission;
    let Some(held) = &tables.held else {
        let items = code! {
            /// The exact formulas answer: as products their zeros cannot be told apart, their roundings are more than half
            /// the accuracy, or they take more than a quarter of a budget of bytes.
            impl TabledStuck for #name {
                type Sticking = #stuck;
            }
        };
        return EmittedCode {
            items,
            ..EmittedCode::default()
        };
    };
    let poles = Poles::of(held);
    let mut tables = poles.constants(emission);
    let mut constant = |name: &Ident, about: &str, form: &HeldForm<S>| {
        let response = poles.response(emission, form);
        let checksum = checksum::about(&response);
        tables.extend(code! {
            #[doc = #about]
            #[doc = #checksum]
            const #name: HeldResponse<'static, #scalar> = #response;
        });
    };
    let mut amplitudes = Vec::new();
    let mut names = Vec::new();
    for (form, (number, mass)) in held.masses.iter().zip((1..).zip(&emission.scene.masses)) {
        let name = format_ident!("STUCK_{}", number);
        let about = format!(" Stuck response of mass `{}` over r.", mass.name);
        constant(&name, &about, form);
        names.push(name.clone());
        let mass = Literal::usize_unsuffixed(number - 1);
        amplitudes.push(code!(#mass => Some(Self::#name.value(r))));
    }
    let force = format_ident!("STUCK_FORCE");
    names.push(force.clone());
    constant(
        &force,
        " V/H over r, the force that holds the contact.",
        &held.force,
    );
    let forms = held.masses.iter().chain([&held.force]);
    let forms = forms.zip(names).map(|(form, name)| {
        let sum = check::sum::<S>(&form.response());
        Checked::of_sum(&name.to_string(), code!(&Self::#name), sum)
    });
    let resonant = Checked::of_sum(
        "stuck_resonances",
        code!(&Self.stuck_resonances()),
        check::sum::<S>(&held.resonances.as_slice()),
    );
    let constants = forms.chain([resonant]).collect();
    let resonances = emission.list(held.resonances.iter().map(|own| own.to_f64()));
    let (stuck_about, force_about) = (stuck_about(held), force_about(held));
    let items = code! {
        impl TabledStuck for #name {
            type Sticking = #stuck;

            #[inline]
            fn holds_stuck(&self) -> bool {
                true
            }

            #[inline]
            fn stuck_resonances(&self) -> &[#scalar] {
                &#resonances
            }

            #(#[doc = #stuck_about])*
            #[inline]
            fn tabled_stuck(&self, mass: usize, r: #scalar) -> Option<Complex<#scalar>> {
                match mass {
                    #(#amplitudes,)*
                    _ => None,
                }
            }

            #(#[doc = #force_about])*
            #[inline]
            fn tabled_holding_force(&self, r: #scalar) -> Option<Complex<#scalar>> {
                Some(Self::#force.value(r))
            }
        }
    };
    EmittedCode {
        items,
        tables,
        constants,
        ..EmittedCode::default()
    }
}

/// Distinct sets of poles among the stuck responses of the masses. Each set becomes one emitted constant.
struct Poles<'a, S> {
    sets: Vec<&'a HeldForm<S>>,
}

impl<'a, S: Float> Poles<'a, S> {
    fn of(held: &'a Held<S>) -> Self {
        Self {
            sets: held.pole_sets(),
        }
    }

    fn name(place: usize) -> Ident {
        if place == 0 {
            format_ident!("STUCK_POLES")
        } else {
            format_ident!("STUCK_POLES_{}", place + 1)
        }
    }

    fn constants(&self, emission: &Emission<'_>) -> TokenStream {
        let scalar = &emission.scalar;
        let constants = self.sets.iter().enumerate().map(|(place, form)| {
            let name = Self::name(place);
            let (of, poles, count) = match form {
                HeldForm::Damped { denominator, .. } => {
                    (code!(Root), roots(emission, denominator), denominator.len())
                }
                HeldForm::Undamped(product) => {
                    let poles = factors(emission, &product.denominator);
                    (code!(Factor), poles, product.denominator.len())
                }
                HeldForm::Fixed(_) => return TokenStream::new(),
            };
            let about = match (place, form) {
                (0, HeldForm::Damped { .. }) => {
                    " Poles of the responses while the contact is stuck, factors of s = ir: `Pair` is off − (r − at − rest)(r + at) + i·rate·r, `Real` rate + ir."
                }
                (0, _) => {
                    " Poles of the responses while the contact is stuck: `Zero` is (r − at − rest)(r + at)."
                }
                _ => " The same of a mass that has others.",
            };
            let count = Literal::usize_unsuffixed(count);
            let checksum = checksum::about(&poles);
            code! {
                #[doc = #about]
                #[doc = #checksum]
                const #name: [#of<#scalar>; #count] = #poles;
            }
        });
        constants.collect()
    }

    fn response(&self, emission: &Emission<'_>, form: &HeldForm<S>) -> TokenStream {
        let place = self.sets.iter().position(|set| set.shares_poles(form));
        let poles = Self::name(place.unwrap_or_default());
        let poles = code!(&Self::#poles);
        match form {
            HeldForm::Fixed(amplitude) => {
                let amplitude = emission.literal(amplitude.to_f64());
                code!(HeldResponse::Fixed(#amplitude))
            }
            HeldForm::Undamped(product) => {
                let quotient = quotient_over(emission, product, &poles);
                code!(HeldResponse::Undamped(#quotient))
            }
            HeldForm::Damped {
                gain, numerator, ..
            } => {
                let gain = emission.literal(gain.to_f64());
                let numerator = roots(emission, numerator);
                code!(HeldResponse::Damped(Transfer {
                    gain: #gain,
                    numerator: &#numerator,
                    denominator: #poles,
                }))
            }
        }
    }
}

fn roots<S: Float>(emission: &Emission<'_>, roots: &[Root<S>]) -> TokenStream {
    let number = |value: S| emission.literal(value.to_f64());
    let roots = roots.iter().map(|root| match *root {
        Root::Pair {
            at,
            rest,
            off,
            rate,
        } => {
            let (at, rest) = (number(at), number(rest));
            let (off, rate) = (number(off), number(rate));
            code!(Root::Pair { at: #at, rest: #rest, off: #off, rate: #rate })
        }
        Root::Real { rate } => {
            let rate = number(rate);
            code!(Root::Real { rate: #rate })
        }
    });
    code!([#(#roots),*])
}

fn stuck_about<S: Float>(held: &Held<S>) -> Vec<String> {
    let (plain, divisions) = held.most_operations();
    vec![
        " x̄* = V_k − H_kV/H (6.11, 6.27, 6.33) of each mass, as a product over its zeros and poles.".to_owned(),
        String::new(),
        format!(" {}", held.told()),
        String::new(),
        format!(
            " Operations: at most {plain} additions and multiplications, {}; all masses and the force hold {} bytes.",
            counted(divisions, "division"),
            held.bytes(),
        ),
    ]
}

fn force_about<S: Float>(held: &Held<S>) -> Vec<String> {
    let (plain, divisions) = held.force.operations();
    vec![
        " V/H, the force that holds the contact, as a product over its zeros and poles.  The check above includes it.".to_owned(),
        String::new(),
        format!(
            " Operations: {plain} additions and multiplications, {}.",
            counted(divisions, "division")
        ),
    ]
}

//! Emits the stepper, the simulation, the steady states and the stuck state of a scene with several contacts or
//! dashpots. Each emitted type wraps a type of the kernel, and has a method for each mass and each contact.

mod at;
mod declared;
mod simulation;
mod stepper;

use super::about::{origin, scene_struct};
use super::emission::rounded;
use super::names::TypeNames;
use super::units::scene_hash;
use crate::Description;
use crate::graph::literal::{literal, scalar};
use frictiongen_kernel::joints::{Layout, table_sizes};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::joined::{at_rest, damping_matrix, is_turned, numbered};
use frictiongen_model::modal::Modal;
use frictiongen_model::scene::{
    Damping, Excitation, NamedContact, NamedStop, Node, Precision, Provide, Scene,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::format_ident;

/// Data of a scene with several contacts or dashpots, from which the generator emits its items.
struct JointsEmission<'a> {
    description: &'a Description,
    names: TypeNames,
    /// Name of the type of the friction forces.
    friction: Ident,
    contacts: Vec<NamedContact>,
    contact_names: Vec<Ident>,
    stop_names: Vec<Ident>,
    /// The masses on which a force acts, each with the name of its field in the input. If a force drives the scene,
    /// the excited mass is the first.
    loads: Vec<(usize, Ident)>,
    scalar: TokenStream,
    /// The type argument that fixes the lengths of all arrays.
    size: TokenStream,
    /// Numbers of coordinates and rows in the stepper's tables, or `None` for a stepper without tables.
    steps: Option<Layout>,
    /// Path of the kernel's module for scenes with several contacts.
    engine: TokenStream,
}

impl<'a> JointsEmission<'a> {
    fn of(description: &'a Description) -> Self {
        let scene = &description.scene;
        let facade = &description.facade;
        let name = &description.name;
        let contacts = scene.named_contacts();
        let named = |name: &str| Ident::new(name, description.name.span());
        let contact_names = contacts
            .iter()
            .map(|contact| named(&contact.name))
            .collect();
        let stops = scene.joints.stops.iter();
        let mut loads = Vec::new();
        if let Excitation::Force(mass) = scene.excitation {
            loads.push((mass, named("force")));
        }
        let others = scene.stepping.forces.iter();
        loads.extend(others.filter_map(|mass| {
            let name = description.mass_names.get(*mass)?;
            Some((*mass, name.clone()))
        }));
        let engine = code!(#facade::kernel::joints);
        let steps = step_layout(scene, loads.len());
        let sizes = sizes(scene, loads.len());
        let sizes = sizes.into_iter().map(Literal::usize_unsuffixed);
        let precision = scalar(scene.precision);
        let mut friction = format_ident!("{}Friction", name);
        friction.set_span(name.span());
        Self {
            description,
            names: TypeNames::of(name),
            friction,
            contacts,
            contact_names,
            stop_names: stops.map(|stop| named(&stop.name)).collect(),
            loads,
            scalar: code!(::core::primitive::#precision),
            size: code!(#engine::Fixed<#(#sizes),*>),
            steps,
            engine,
        }
    }

    /// Returns the number of contacts and stops.
    fn contact_count(&self) -> usize {
        self.contacts.len() + self.stop_names.len()
    }

    fn number(&self, value: f64) -> TokenStream {
        literal(value, self.description.scene.precision)
    }

    fn provides(&self, what: &Provide) -> bool {
        self.description.scene.provide.contains(what)
    }

    /// Returns true if the scene provides the stuck state or steady states, which belong to one frequency.
    fn provides_at(&self) -> bool {
        self.provides(&Provide::Stuck) || self.provides(&Provide::Orbit)
    }

    /// Returns true if the scene provides a method that takes the ratios r and β. The methods of a stepper do not take
    /// ratios.
    fn provides_ratios(&self) -> bool {
        self.provides(&Provide::Simulation) || self.provides_at()
    }

    /// Returns the numbers of the two nodes of a spring, dashpot or contact. The node whose motion counts as positive
    /// comes first.
    fn ends(&self, from: Node, to: Node) -> [Literal; 2] {
        let masses = self.description.scene.masses.len();
        let (plus, minus) = numbered(masses, from, to).unwrap_or_default();
        [plus, minus].map(Literal::usize_unsuffixed)
    }

    fn link(&self, from: Node, to: Node, value: f64) -> TokenStream {
        let [plus, minus] = self.ends(from, to);
        let value = self.number(value);
        code!((#plus, #minus, #value))
    }

    /// Emits a `Wave` that has the value `value` at any time.
    fn constant(&self, value: f64) -> TokenStream {
        let (engine, value, zero) = (&self.engine, self.number(value), self.number(0.0));
        code!(#engine::Wave {
            constant: #value,
            slope: #zero,
            amplitude: #zero,
            omega: #zero,
            phase: #zero,
        })
    }

    /// Emits a number that may be missing, as an `Option`.
    fn optional(&self, value: Option<f64>) -> TokenStream {
        match value.map(|value| self.number(value)) {
            None => code!(::core::option::Option::None),
            Some(value) => code!(::core::option::Option::Some(#value)),
        }
    }

    /// Emits a stop as a contact without a friction force.
    fn stop(&self, own: &NamedStop) -> TokenStream {
        let engine = &self.engine;
        let [plus, minus] = self.ends(own.sides.from, own.sides.to);
        let (level, zero, one) = (self.constant(0.0), self.number(0.0), self.number(1.0));
        let (stiffness, damping, restitution) = own.law.impact.numbers();
        let stiffness = self.optional(stiffness);
        let masses = self.description.scene.masses.len();
        let side = self.number(if is_turned(masses, own.sides) {
            -1.0
        } else {
            1.0
        });
        let [gap, damping, restitution] =
            [own.law.gap, damping, restitution].map(|value| self.number(value));
        code!(#engine::Contact {
            plus: #plus,
            minus: #minus,
            level: #level,
            stiction: #one,
            stiffness: #stiffness,
            speed: #zero,
            stop: ::core::option::Option::Some(#engine::Stop {
                side: #side,
                gap: #gap,
                damping: #damping,
                restitution: #restitution,
            }),
        })
    }

    /// Emits the constants of the chain. The kinetic friction force of each contact is its share of the common
    /// friction force.
    fn chain(&self, modal: &Modal) -> TokenStream {
        let (engine, size, scalar) = (&self.engine, &self.size, &self.scalar);
        let fields = self.chain_fields(modal, |contact| contact.law.share, 1.0);
        code! {
            /// The chain. Node numbers are those of the masses, then the wall, then the base. The level of each contact
            /// is its share. The start of a motion sets the stretch.
            const CHAIN: #engine::Model<#scalar, #size> = #fields;
        }
    }

    /// Emits the constants of the chain as an expression. `level` returns the kinetic friction force of a contact.
    fn chain_fields(
        &self,
        modal: &Modal,
        level: impl Fn(&NamedContact) -> f64,
        stretch: f64,
    ) -> TokenStream {
        let (scene, engine) = (&self.description.scene, &self.engine);
        let masses = scene.masses.iter().map(|mass| self.number(mass.value));
        let springs = scene.springs.iter();
        let springs = springs.map(|spring| self.link(spring.from, spring.to, spring.stiffness));
        let dashpots = scene.joints.dampers.iter();
        let dashpots = dashpots.map(|part| self.link(part.from, part.to, part.coefficient));
        let damping = damping_matrix(scene, modal).into_iter().flatten();
        let damping = damping.map(|entry| self.number(entry));
        let from_base = scene.is_damped_from_base();
        let masses_count = scene.masses.len();
        let contacts = self.contacts.iter().map(|contact| {
            let [plus, minus] = self.ends(contact.sides.from, contact.sides.to);
            let (level, stiction) = (
                self.constant(level(contact)),
                self.number(contact.law.stiction),
            );
            let speed = match is_turned(masses_count, contact.sides) {
                true if contact.law.speed != 0.0 => -contact.law.speed,
                _ => contact.law.speed,
            };
            let speed = self.number(speed);
            let stiffness = self.optional(contact.law.stiffness);
            code!(#engine::Contact {
                plus: #plus,
                minus: #minus,
                level: #level,
                stiction: #stiction,
                stiffness: #stiffness,
                speed: #speed,
                stop: ::core::option::Option::None,
            })
        });
        let rest = self.constant(0.0);
        let loads = self.loads.iter().map(|(mass, _)| {
            let mass = Literal::usize_unsuffixed(*mass);
            code!((#mass, #rest))
        });
        let stops = scene.joints.stops.iter().map(|own| self.stop(own));
        let constant = scene.joints.constant.iter().map(|own| {
            let mass = Literal::usize_unsuffixed(own.mass);
            let (force, zero) = (self.number(own.force), self.number(0.0));
            code!((#mass, #engine::Wave {
                constant: #zero,
                slope: #zero,
                amplitude: #force,
                omega: #zero,
                phase: #zero,
            }))
        });
        let (zero, stretch) = (self.number(0.0), self.number(stretch));
        let law = scene.friction.points().iter().map(|[speed, level]| {
            let (speed, level) = (self.number(*speed), self.number(*level));
            code!([#speed, #level])
        });
        code! {
            #engine::Model {
                size: #engine::Fixed,
                masses: &[#(#masses),*],
                springs: &[#(#springs),*],
                dashpots: &[#(#dashpots),*],
                damping: &[#(#damping),*],
                damping_from_base: #from_base,
                contacts: [#(#contacts,)* #(#stops),*],
                law: [#(#law),*],
                loads: [#(#loads,)* #(#constant),*],
                base: #engine::Curve {
                    wave: #rest,
                    square: #zero,
                    cube: #zero,
                },
                stretch: #stretch,
            }
        }
    }

    /// Emits the constants that convert the ratios r and β to the units of the description.
    fn reference(&self, modal: &Modal) -> TokenStream {
        let (scene, engine, scalar) = (&self.description.scene, &self.engine, &self.scalar);
        let round = |value: Dd| self.number(rounded(value, scene.precision));
        let rate = round(modal.reference);
        let stiffness = round(Dd::from(scene.first_stiffness()));
        let on_base = scene.excitation == Excitation::Base;
        code! {
            /// √(k₁/m₁), k₁, and the kind of the load.
            const REFERENCE: #engine::Reference<#scalar> = #engine::Reference {
                rate: #rate,
                stiffness: #stiffness,
                on_base: #on_base,
            };
        }
    }

    /// Returns the number of entries in the stepper's tables.
    fn entries(&self) -> Literal {
        Literal::usize_unsuffixed(self.steps.map_or(0, |layout| layout.entries()))
    }

    /// Emits the kernel's type of a stepper whose tables have the type `tables`.
    fn stepper_type(&self, tables: &TokenStream) -> TokenStream {
        let (engine, scalar, size) = (&self.engine, &self.scalar, &self.size);
        code!(#engine::Stepper<#scalar, #size, #tables>)
    }

    /// Emits the methods that return the present motion of one mass or one contact. Each method has the name of its
    /// mass or contact.
    fn methods(&self, when: &str) -> TokenStream {
        let (engine, scalar) = (&self.engine, &self.scalar);
        self.named(
            [
                &format!("Displacement and velocity of mass `{{}}` {when}."),
                &format!("Motion and force of contact `{{}}` {when}."),
            ],
            [
                &code!(#engine::MassState<#scalar>),
                &code!(#engine::ContactState<#scalar>),
            ],
        )
    }

    /// Emits a method for each mass and for each contact. `about` has two documentation texts, for the method of a
    /// mass and for the method of a contact. The texts contain `{}` in place of the name. `of` has the result types
    /// of these two kinds of methods.
    fn named(&self, about: [&str; 2], of: [&TokenStream; 2]) -> TokenStream {
        let method = |about: &str, name: &Ident, call: TokenStream, of: &TokenStream| {
            let about = format!(" {}", about.replace("{}", &name.to_string()));
            code! {
                #[doc = #about]
                #[must_use]
                pub fn #name(&self) -> #of {
                    self.0.#call
                }
            }
        };
        let [about_mass, about_contact] = about;
        let [of_mass, of_contact] = of;
        let masses = self.description.mass_names.iter().enumerate();
        let masses = masses.map(|(index, name)| {
            let index = Literal::usize_unsuffixed(index);
            method(about_mass, name, code!(mass(#index)), of_mass)
        });
        let stops = self.stop_names.iter();
        let contacts = self.contact_names.iter().chain(stops).enumerate();
        let contacts = contacts.map(|(index, name)| {
            let index = Literal::usize_unsuffixed(index);
            method(about_contact, name, code!(contact(#index)), of_contact)
        });
        masses.chain(contacts).collect()
    }
}

/// Returns the numbers of coordinates and rows in the tables of a stepper on whose masses `loads` forces act. Returns
/// `None` for a stepper without tables.
pub(crate) fn step_layout(scene: &Scene, loads: usize) -> Option<Layout> {
    let counts = (scene.masses.len(), scene.named_contacts().len(), loads);
    let on_base = scene.excitation == Excitation::Base;
    let shears = scene.precision == Precision::F32;
    let damped = !matches!(scene.damping, Damping::None) || !scene.joints.dampers.is_empty();
    let layout = Layout::new(
        counts,
        scene.stepping.input.into(),
        [on_base, shears, damped],
    );
    let has_tables = scene.provides(&Provide::Stepper)
        && scene.friction.points().is_empty()
        && scene.has_linear_states()
        && layout.entries() > 0;
    has_tables.then_some(layout)
}

/// Largest number of tables that the search for a steady state keeps. A table belongs to one set of sticking contacts.
const MAX_TABLES: usize = 4;

/// Returns the arguments of the kernel's type that fixes the lengths of all arrays.
pub(crate) fn sizes(scene: &Scene, loads: usize) -> Vec<usize> {
    let joints = &scene.joints;
    let masses = scene.masses.len();
    let contacts = scene.named_contacts().len() + joints.stops.len();
    let loads_of_input = loads;
    let loads = loads + joints.constant.len();
    let belts = joints.contacts.iter();
    let belts = belts.filter(|contact| contact.law.speed != 0.0);
    let parts = joints.stops.len() + joints.constant.len() + belts.count();
    let unknowns = if scene.provides(&Provide::Orbit) {
        2 * masses + contacts
    } else if scene.provides(&Provide::Stuck) {
        2 * masses
    } else {
        0
    };
    let points = scene.friction.points().len();
    let layout = step_layout(scene, loads_of_input);
    let row = layout.map_or(0, |layout| layout.coordinates());
    let step = layout.map_or(0, |layout| layout.properties());
    let mut sizes = vec![masses, masses + 2, contacts, loads];
    sizes.extend([unknowns, unknowns * unknowns, points, row, parts, step]);
    if scene.provides(&Provide::Orbit) && points == 0 && parts == joints.constant.len() {
        let waves = loads + usize::from(scene.excitation == Excitation::Base);
        let counts = [masses, contacts, waves];
        sizes.extend(match scene.precision {
            Precision::F32 => table_sizes::<f32>(counts),
            Precision::F64 => table_sizes::<f64>(counts),
        });
        sizes.push(MAX_TABLES.min(1 << contacts.min(8)));
    }
    // The last arguments are 0 by default.
    while sizes.len() > 4 && sizes.last() == Some(&0) {
        sizes.pop();
    }
    sizes
}

/// Emits the code of a scene with several contacts or dashpots. Returns the types for the user's module, and the
/// hidden items.
pub(super) fn emit(description: &Description) -> (TokenStream, TokenStream) {
    let emission = JointsEmission::of(description);
    let scene = &description.scene;
    let modal = at_rest(scene, Modal::of(scene));
    let name = &emission.names.name;
    let chain = emission.chain(&modal);
    let mut types = scene_type(&emission);
    let hash = scene_hash(scene);
    let mut items = code!(impl #name { #hash #chain });
    if emission.provides(&Provide::Stepper) {
        let (own, more) = stepper::emit(&emission, &modal);
        types.extend(own);
        items.extend(more);
    }
    if emission.provides_ratios() {
        let reference = emission.reference(&modal);
        items.extend(code!(impl #name { #reference }));
    }
    if emission.provides(&Provide::Simulation) {
        let (own, more) = simulation::emit(&emission);
        types.extend(own);
        items.extend(more);
    }
    if emission.provides_at() {
        let (own, more) = at::emit(&emission);
        types.extend(own);
        items.extend(more);
    }
    (types, items)
}

/// Emits the scene's type with its documentation.
fn scene_type(emission: &JointsEmission<'_>) -> TokenStream {
    let description = emission.description;
    let TypeNames {
        at,
        stuck,
        orbit,
        stepper,
        input,
        simulation,
        ..
    } = &emission.names;
    let mut lines = origin(description);
    if emission.provides(&Provide::Stepper) {
        lines.push(format!(
            "* `stepper(dt)` returns [`{stepper}`], the motion by steps under any [`{input}`]"
        ));
    }
    if emission.provides(&Provide::Simulation) {
        lines.push(format!(
            "* `{}` returns [`{simulation}`], the motion in time under a harmonic load",
            simulation::start(&description.scene)
        ));
    }
    if emission.provides_at() {
        lines.push(format!(
            "* `at(r)` returns [`{at}`], the scene at one frequency"
        ));
    }
    if emission.provides(&Provide::Stuck) {
        lines.push(format!(
            "* `at(r)?.stuck()` returns [`{stuck}`], the state in which no contact slides"
        ));
    }
    if emission.provides(&Provide::Orbit) {
        lines.push(format!(
            "* `at(r)?.orbit(beta)` returns [`{orbit}`], the steady state"
        ));
    }
    scene_struct(description, lines)
}

/// Emits a type that wraps a type of the kernel.
fn wrapper(emission: &JointsEmission<'_>, name: &Ident, target: &str, about: &str) -> TokenStream {
    let JointsEmission {
        scalar,
        size,
        engine,
        ..
    } = emission;
    let target = format_ident!("{target}");
    wrapper_of(
        emission,
        name,
        &code!(#engine::#target<#scalar, #size>),
        about,
    )
}

/// Emits a type that wraps the type `target`.
fn wrapper_of(
    emission: &JointsEmission<'_>,
    name: &Ident,
    target: &TokenStream,
    about: &str,
) -> TokenStream {
    let visibility = &emission.description.visibility;
    code! {
        #[doc = #about]
        #[allow(deprecated, non_camel_case_types)]
        #[::core::prelude::v1::derive(::core::clone::Clone, ::core::fmt::Debug)]
        #visibility struct #name(#target);
    }
}

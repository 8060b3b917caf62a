//! Defines `Emission`, the data that all emitted items share, and `EmittedCode`, the code that one file of this folder
//! emits.

use super::names::{TypeNames, local};
use crate::Description;
use crate::graph::Graph;
use crate::graph::literal::{literal, scalar};
use frictiongen_kernel::emitted::check::{self, Listed};
use frictiongen_kernel::number::dd::Dd;
use frictiongen_model::modal::Modal;
use frictiongen_model::reduced::Reduced;
use frictiongen_model::scene::{CONTACT, Precision, Provide, Scene};
use proc_macro2::{Ident, TokenStream, TokenTree};

/// From this number of modes on, the emitted code calls functions of the kernel that add up a motion over the modes.
/// With fewer modes, each mass has its own straight-line code.
const SUMS_FROM: usize = 3;

/// From this number of modes on, the emitted code for one frequency ratio loops over an array of modes. For fewer
/// modes it is straight-line code, which is faster but grows with the number of modes.
const PASSES_FROM: usize = 17;

/// Data of a scene from which the generator emits the items of the scene.
pub(super) struct Emission<'a> {
    pub description: &'a Description,
    pub scene: &'a Scene,
    pub modal: Modal,
    /// The modes that the load or the contact drives. Their numbers are rounded from double-double to the scene's
    /// precision, and stored as `f64`.
    pub reduced: Reduced<f64>,
    pub precision: Precision,
    /// The scalar type, `f64` or `f32`.
    pub scalar: TokenStream,
    pub names: TypeNames,
    pub facade: &'a TokenStream,
}

/// Groups of methods that the scene's `provide` lists.
pub(super) struct Wanted<'a> {
    pub motion: Option<Vec<(usize, &'a Ident)>>,
    pub stuck: bool,
    pub simulation: bool,
    pub orbit: bool,
    pub stepper: bool,
    pub self_check: bool,
}

impl Wanted<'_> {
    /// Returns true if the scene provides a method that returns the motion of one mass at one frequency. A method for
    /// one mass needs the mode shapes.
    pub fn shapes(&self) -> bool {
        let moves = |masses: &Vec<(usize, &Ident)>| !masses.is_empty();
        self.stuck || self.motion.as_ref().is_some_and(moves)
    }
}

impl<'a> Emission<'a> {
    pub fn of(description: &'a Description) -> Self {
        let scene = &description.scene;
        let modal = Modal::of(scene);
        let precision = scene.precision;
        let reduced = modal.reduced(|value| rounded(value, precision));
        let scalar = scalar(precision);
        Self {
            description,
            scene,
            modal,
            reduced,
            precision,
            scalar,
            names: TypeNames::of(&description.name),
            facade: &description.facade,
        }
    }

    pub fn modes(&self) -> usize {
        self.reduced.modes.len()
    }

    /// Returns the names `mode_1`, `mode_2`, … of the modes at a frequency.
    pub fn mode_names(&self) -> Vec<Ident> {
        self.numbered("mode")
    }

    /// Returns the names `constants_1`, `constants_2`, … of the modes' constants.
    pub fn constant_names(&self) -> Vec<Ident> {
        self.numbered("constants")
    }

    fn numbered(&self, name: &str) -> Vec<Ident> {
        let modes = 1..=self.modes();
        modes.map(|mode| local(&format!("{name}_{mode}"))).collect()
    }

    /// Emits the `let` statement that binds `constants_1`, `constants_2`, … to the constants of the modes. The
    /// statement binds only names that occur in `body`.
    pub fn constants(&self, body: &TokenStream) -> TokenStream {
        bound(&self.constant_names(), body, &code!(&Self::MODES))
    }

    /// Emits the statements that bind the inputs of a motion's formulas. The inputs are 1/r, the sums V, H, U, G and
    /// H_c of the contact, the modes at a frequency and their constants. The statements bind only names that occur in
    /// `body`.
    pub fn inputs(&self, body: &TokenStream) -> TokenStream {
        let mut inputs = TokenStream::new();
        if mentions(body, "inverse_r") {
            inputs.extend(code!(let inverse_r = at.inverse_ratio();));
        }
        if mentions(body, "contact") {
            inputs.extend(code!(let contact = at.contact_sums();));
        }
        inputs.extend(self.constants(body));
        inputs.extend(bound(&self.mode_names(), body, &code!(at.modes())));
        inputs
    }

    /// Emits the `let` statement that binds `shape_1`, `shape_2`, … to the components of a mass in the mode shapes.
    /// The statement binds only names that occur in `body`.
    pub fn shape(&self, body: &TokenStream) -> TokenStream {
        let names = self.numbered("shape");
        let source = code!(*Self::SHAPES.get(mass)?);
        bound(&names, body, &source)
    }

    /// Returns an empty graph that records formulas of `modes` modes in the scene's precision.
    pub fn graph(&self, modes: usize) -> Graph {
        Graph::new(modes).in_precision(self.precision)
    }

    /// Returns true if the emitted code for one frequency ratio loops over the array of modes. If false, this code is
    /// straight-line code.
    pub fn in_passes(&self) -> bool {
        self.modes() >= PASSES_FROM
    }

    /// Returns true if the emitted code calls the kernel's functions that add up the motion of a mass from all modes.
    pub fn in_sums(&self) -> bool {
        self.modes() >= SUMS_FROM
    }

    /// Returns true if the scene declares an accuracy and has tables.
    pub fn is_tabled(&self) -> bool {
        self.description.tables.is_some()
    }

    pub fn damped(&self) -> bool {
        self.reduced.chain.damped
    }

    /// Returns true if this mass moves exactly as the contact does, because it slides on a support at rest.
    pub fn moves_as_contact(&self, mass: usize) -> bool {
        self.reduced.chain.on_moving_base.is_none() && self.reduced.rubbing == Some(mass)
    }

    /// Returns true if the load acts on the mass that slides on a support. V, the response of the contact to the load,
    /// then equals H, its response to a force in the contact.
    pub(super) fn loads_contact(&self) -> bool {
        let Reduced { chain, modes, .. } = &self.reduced;
        self.reduced.quadratures.is_empty() && chain.loads_contact(modes)
    }

    /// Returns true if the contact is elastic.
    pub fn is_elastic(&self) -> bool {
        self.scene.stiffness.is_some()
    }

    /// Returns the last type argument of a kernel type in the user's module, with a comma before it. The argument
    /// selects the force law of an elastic contact. A rigid contact has no argument.
    pub fn law_in_types(&self) -> Option<TokenStream> {
        let Self { facade, scalar, .. } = self;
        self.is_elastic()
            .then(|| code!(, #facade::kernel::motion::ElasticChain<::core::primitive::#scalar>))
    }

    /// Returns the last type argument of a kernel type in the hidden block, with a comma before it. The argument
    /// selects the force law of an elastic contact. A rigid contact has no argument.
    pub fn law(&self) -> Option<TokenStream> {
        let scalar = &self.scalar;
        self.is_elastic().then(|| code!(, ElasticChain<#scalar>))
    }

    /// Returns the additional argument of the macro `wraps!` for a type with an elastic contact. A rigid contact has no
    /// additional argument.
    pub fn law_word(&self) -> Option<TokenStream> {
        self.is_elastic().then(|| code!(elastic))
    }

    pub fn literal(&self, value: f64) -> TokenStream {
        literal(value, self.precision)
    }

    pub fn list(&self, values: impl IntoIterator<Item = f64>) -> TokenStream {
        let values = values.into_iter().map(|value| self.literal(value));
        code!([#(#values),*])
    }

    /// Returns the name of the contact, if the method of the kernel does not have this name.
    pub fn contact_name(&self) -> Option<Ident> {
        let name = self.scene.contact_name.as_str();
        (name != CONTACT).then(|| Ident::new(name, self.description.name.span()))
    }

    /// Emits a method with the name of the contact, if this name is not `contact`. The method returns the result of
    /// type `of` that the kernel's method `call` returns.
    pub fn contact_method(&self, call: &TokenStream, of: &TokenStream) -> Option<TokenStream> {
        let name = self.contact_name()?;
        let about = format!(" The contact `{name}`, as `{call}` returns it.");
        Some(code! {
            #[doc = #about]
            #[must_use]
            pub fn #name(&self) -> #of {
                self.0.#call()
            }
        })
    }

    pub fn wanted(&self) -> Wanted<'_> {
        let mut wanted = Wanted {
            motion: None,
            stuck: false,
            simulation: false,
            orbit: false,
            stepper: false,
            self_check: false,
        };
        let all = || {
            self.description
                .mass_names
                .iter()
                .enumerate()
                .collect::<Vec<_>>()
        };
        for item in &self.scene.provide {
            match item {
                Provide::Limits => {}
                Provide::Motion(None) => wanted.motion = Some(all()),
                Provide::Motion(Some(masses)) => {
                    let named = all()
                        .into_iter()
                        .filter(|(index, _)| masses.contains(index));
                    let known = wanted.motion.take().unwrap_or_default();
                    let mut merged: Vec<_> = known.into_iter().chain(named).collect();
                    merged.sort_by_key(|(index, _)| *index);
                    merged.dedup_by_key(|(index, _)| *index);
                    wanted.motion = Some(merged);
                }
                Provide::Stuck => wanted.stuck = true,
                Provide::Orbit => wanted.orbit = true,
                Provide::Simulation => wanted.simulation = true,
                Provide::Stepper => wanted.stepper = true,
                Provide::SelfCheck => wanted.self_check = true,
            }
        }
        wanted
    }
}

/// Emits `let [a, _, c] = source;`, where `_` replaces each name that does not occur in `body`. Emits nothing if no
/// name occurs in `body`.
fn bound(names: &[Ident], body: &TokenStream, source: &TokenStream) -> TokenStream {
    let mentioned: Vec<bool> = names
        .iter()
        .map(|name| mentions(body, &name.to_string()))
        .collect();
    if !mentioned.contains(&true) {
        return TokenStream::new();
    }
    let names = names.iter().zip(mentioned).map(
        |(name, mentioned)| {
            if mentioned { code!(#name) } else { code!(_) }
        },
    );
    code!(let [#(#names),*] = #source;)
}

/// Returns true if a name occurs in the tokens, other than as the name of a field.
pub(super) fn mentions(tokens: &TokenStream, name: &str) -> bool {
    let mut field = false;
    tokens.clone().into_iter().any(|token| {
        let after_point = std::mem::replace(
            &mut field,
            matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '.'),
        );
        match &token {
            TokenTree::Ident(ident) => !after_point && ident == name,
            TokenTree::Group(group) => mentions(&group.stream(), name),
            _ => false,
        }
    })
}

/// Rounds a double-double number once to the scene's scalar type, and returns the result as `f64`.
pub(super) fn rounded(value: Dd, precision: Precision) -> f64 {
    match precision {
        Precision::F64 => value.hi,
        Precision::F32 => f64::from(frictiongen_model::rounded::<f32>(value)),
    }
}

/// Returns the checksum that the emitted code computes for a constant that consists of `numbers`.
pub(super) fn sum(numbers: &(impl Listed<f64> + ?Sized)) -> u32 {
    check::sum::<f64>(numbers)
}

/// Returns the checksum of double-double numbers, each rounded once to the given precision.
pub(super) fn sum_of_rounded(numbers: &impl Listed<Dd>, precision: Precision) -> u32 {
    let mut sum = 0;
    numbers.list(&mut |number| {
        sum = check::with(sum, rounded(number, precision));
    });
    sum
}

/// Emitted code of one file of this folder, divided by the place in the output to which it belongs.
#[derive(Default)]
pub(super) struct EmittedCode {
    /// The emitted types, which are in the user's module.
    pub types: TokenStream,
    /// Items in the single `impl` of the scene's type.
    pub associated: TokenStream,
    /// Hidden items outside the `impl` of the scene's type.
    pub items: TokenStream,
    /// Tables of numbers, as associated constants, in a block separate from the code.
    pub tables: TokenStream,
    /// The emitted constants that the self-check compares with checksums.
    pub constants: Vec<Checked>,
}

/// Constants of the emitted code, with the checksum that the self-check expects.
pub(super) struct Checked {
    /// Name of the constants in the message of a failed self-check.
    pub name: String,
    /// Expression for a reference to the constants in the emitted code.
    pub numbers: TokenStream,
    pub sum: u32,
}

impl Checked {
    /// Returns the entry for constants with the given values. `numbers` is the expression for a reference to the
    /// constants in the emitted code.
    pub fn new(name: &str, numbers: TokenStream, values: &impl Listed<f64>) -> Self {
        Self::of_sum(name, numbers, sum(values))
    }

    /// Returns the entry for constants with a given checksum. `numbers` is the expression for a reference to the
    /// constants in the emitted code.
    pub fn of_sum(name: &str, numbers: TokenStream, sum: u32) -> Self {
        Self {
            name: name.to_owned(),
            numbers,
            sum,
        }
    }
}

impl EmittedCode {
    pub fn join(&mut self, other: Self) {
        self.types.extend(other.types);
        self.associated.extend(other.associated);
        self.items.extend(other.items);
        self.tables.extend(other.tables);
        self.constants.extend(other.constants);
    }
}

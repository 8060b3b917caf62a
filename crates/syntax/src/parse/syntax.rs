//! The syntax tree: the words of a description with their positions. The parser has not yet resolved the names in the
//! tree.

use frictiongen_model::scene::{Beyond, DampingFrom, Precision, Proving, Side, StepInput};

use super::number::Number;
use super::reader::{List, Name};
use super::token::Token;
use crate::diagnostics::TokenPosition;

/// A doc comment or an attribute before the struct.
#[derive(Clone, Debug)]
pub enum Attribute {
    /// A doc comment in a text.
    Doc {
        /// The text of the comment.
        text: String,
        /// The position of the doc comment.
        place: TokenPosition,
    },
    /// An attribute of the struct. The parser checks only its name and its outer form.
    Other {
        /// The group in square brackets.
        group: Token,
        /// The position of the attribute's `#`.
        place: TokenPosition,
    },
}

/// The visibility of the struct.
#[derive(Clone, Debug)]
pub enum Visibility {
    /// No visibility is written.
    Inherited,
    /// `pub`, at this position.
    Public(TokenPosition),
    /// `pub(path)` or `pub(in path)`.
    Restricted {
        /// The position of `pub`.
        place: TokenPosition,
        /// The position of the bracket after `pub`.
        bracket: TokenPosition,
        /// True if `in` is written.
        is_in: bool,
        /// The path in the brackets after `pub`.
        path: RustPath,
    },
}

/// The value of a description's field, which may be missing or unreadable.
#[derive(Default)]
pub(crate) enum Slot<T> {
    /// The description does not have the field.
    #[default]
    Missing,
    /// The description has the field, but the parser could not read it, and has already reported the errors.
    Broken,
    /// The description has the field, with this value.
    Given(T),
}

impl<T> Slot<T> {
    pub(crate) fn given(&self) -> Option<&T> {
        match self {
            Self::Given(value) => Some(value),
            Self::Missing | Self::Broken => None,
        }
    }

    /// Returns false if the description has the field but the parser could not read it.
    pub(crate) fn is_read(&self) -> bool {
        !matches!(self, Self::Broken)
    }

    pub(crate) fn is_missing(&self) -> bool {
        matches!(self, Self::Missing)
    }
}

/// A list of entries, with the position of its bracket.
pub(crate) struct Placed<T> {
    pub(crate) list: List<T>,
    pub(crate) place: TokenPosition,
}

pub(crate) struct MassEntry {
    pub(crate) name: Name,
    pub(crate) value: Number,
}

pub(crate) struct SpringEntry {
    pub(crate) from: Name,
    pub(crate) to: Name,
    pub(crate) stiffness: Number,
}

pub(crate) struct ContactEntry {
    pub(crate) from: Name,
    pub(crate) to: Name,
    /// The contact with the properties in its braces. `None` if it has no braces.
    pub(crate) named: Option<JointEntry>,
}

/// A contact in the field `contacts` of a description.
pub(crate) struct JointEntry {
    pub(crate) name: Name,
    pub(crate) from: Name,
    pub(crate) to: Name,
    pub(crate) stiffness: Option<Number>,
    pub(crate) stiction: Option<Number>,
    pub(crate) share: Option<Number>,
    pub(crate) speed: Option<Number>,
    /// True if the parser could read all properties in the braces of the contact.
    pub(crate) complete: bool,
}

/// A stop in the field `stops` of a description.
pub(crate) struct StopEntry {
    pub(crate) name: Name,
    pub(crate) from: Name,
    pub(crate) to: Name,
    pub(crate) gap: Option<Number>,
    pub(crate) stiffness: Option<Number>,
    pub(crate) damping: Option<Number>,
    pub(crate) restitution: Option<Number>,
    /// True if the parser could read all properties in the braces of the stop.
    pub(crate) complete: bool,
}

pub(crate) struct DampingEntry {
    /// Position of the word that names the kind of damping.
    pub(crate) place: TokenPosition,
    pub(crate) kind: DampingKind,
}

pub(crate) enum DampingKind {
    None,
    Uniform(Number),
    Modal(Vec<Number>),
    Rayleigh(Number, Number),
}

pub(crate) struct ProvideEntry {
    pub(crate) place: TokenPosition,
    pub(crate) kind: ProvideKind,
}

pub(crate) enum ProvideKind {
    Limits,
    /// The motions of the listed masses. `None` selects all masses.
    Motion(Option<List<Name>>),
    Stuck,
    Orbit,
    Simulation,
    Stepper,
    SelfCheck,
}

pub(crate) enum AccuracyEntry {
    Exact,
    Relative(Number),
}

/// A range of two numbers as written: `a..b`.
#[derive(Clone, Copy)]
pub(crate) struct RangeSyntax {
    pub(crate) low: Number,
    pub(crate) high: Number,
}

/// The declared ranges of r and β, as written.
pub(crate) struct RangeEntry {
    pub(crate) place: TokenPosition,
    pub(crate) ratio: Option<RangeSyntax>,
    pub(crate) friction: Option<RangeSyntax>,
}

pub(crate) struct FrictionEntry {
    /// Position of the word that names the friction law.
    pub(crate) place: TokenPosition,
    pub(crate) law: LawEntry,
}

pub(crate) enum LawEntry {
    Coulomb,
    /// The points of the friction law. Each has a speed and a level of the kinetic friction.
    Stribeck(Vec<[Number; 2]>),
    /// An exponential decay: the friction at rest over F, the speed of the decay, and the accuracy if it is given.
    Decaying(Vec<Number>),
}

/// One of the words that a field allows, as the description chooses it, with its position.
pub(crate) struct Choice<T> {
    pub(crate) value: T,
    pub(crate) place: TokenPosition,
}

/// A path of Rust, as written in a description.
#[derive(Clone, Debug)]
pub struct RustPath {
    /// The words of the path. If `::` precedes a word, the word comes with the position of the `::`.
    pub segments: Vec<(Option<TokenPosition>, Name)>,
}

/// The syntax tree of a whole description, as far as the parser could read the description.
pub struct Syntax {
    /// The doc comments and attributes before the struct.
    pub attributes: Vec<Attribute>,
    /// The visibility of the struct.
    pub visibility: Visibility,
    /// The name of the struct. `None` if the written name cannot be used.
    pub name: Option<Name>,
    /// Position for the error of a missing field: the name of the struct, or the start of the struct if the
    /// description has no usable name.
    pub(crate) place: TokenPosition,
    /// True if the description has braces with fields.
    pub(crate) has_body: bool,
    pub(crate) fields: Fields,
}

impl Syntax {
    /// Returns the path of the facade crate, if the description gives one.
    #[must_use]
    pub fn facade(&self) -> Option<&RustPath> {
        self.fields.facade.given()
    }

    /// Returns true if the description has the field `excitation`. Otherwise sets it to a mass of the first contact.
    pub(crate) fn fill_excitation(&mut self) -> bool {
        let fields = &mut self.fields;
        if !fields.excitation.is_missing() {
            return true;
        }
        let contacts = fields.contacts.given();
        let joint = contacts.and_then(|contacts| contacts.list.entries.first());
        let joint = joint.map(|joint| [&joint.from, &joint.to]);
        let contact = fields.contact.given().map(|entry| [&entry.from, &entry.to]);
        let mut sides = contact.or(joint).into_iter().flatten();
        let mass = sides.find(|side| !["base", "wall"].contains(&side.text.as_str()));
        if let Some(mass) = mass.cloned() {
            fields.excitation = Slot::Given(mass);
        }
        false
    }

    /// Returns the names of the masses that the parser could read, in the order of the text.
    pub fn mass_names(&self) -> impl Iterator<Item = &Name> {
        let masses = self.fields.masses.given();
        let entries = masses.map_or(&[][..], |masses| &masses.list.entries);
        entries.iter().map(|entry| &entry.name)
    }
}

impl Fields {
    /// Moves a `contact` that has braces to the list `contacts`. The fields `stiffness` and `stiction` of the description
    /// become its properties. A number that stands both in the braces and in a field stays in both, and a contact beside
    /// the field `contacts` stays where it is. The lowering reports these errors.
    pub(crate) fn list_contact(&mut self) {
        if !self.contacts.is_missing() {
            return;
        }
        let Slot::Given(entry) = &mut self.contact else {
            return;
        };
        let place = entry.from.place;
        if let Some(mut named) = entry.named.take() {
            let fields = [&mut self.stiffness, &mut self.stiction];
            let own = [&mut named.stiffness, &mut named.stiction];
            for (own, field) in own.into_iter().zip(fields) {
                if let (None, Slot::Given(number)) = (&own, &*field) {
                    *own = Some(*number);
                    *field = Slot::Missing;
                }
            }
            let entries = vec![named];
            let list = List {
                entries,
                complete: true,
            };
            self.contacts = Slot::Given(Placed { list, place });
            self.contact = Slot::Missing;
        }
    }

    /// Returns true if the description has a field of a scene with several contacts, dashpots, stops or constant
    /// forces, even with errors. A chain with such a field needs no spring.
    pub(crate) fn may_lack_springs(&self) -> bool {
        !(self.contacts.is_missing()
            && self.dampers.is_missing()
            && self.stops.is_missing()
            && self.constant.is_missing())
    }
}

#[derive(Default)]
pub(crate) struct Fields {
    pub(crate) masses: Slot<Placed<MassEntry>>,
    pub(crate) springs: Slot<Placed<SpringEntry>>,
    pub(crate) contact: Slot<ContactEntry>,
    pub(crate) contacts: Slot<Placed<JointEntry>>,
    pub(crate) dampers: Slot<Placed<SpringEntry>>,
    pub(crate) stops: Slot<Placed<StopEntry>>,
    pub(crate) constant: Slot<Placed<MassEntry>>,
    pub(crate) excitation: Slot<Name>,
    pub(crate) damping: Slot<DampingEntry>,
    pub(crate) damping_from: Slot<Choice<DampingFrom>>,
    pub(crate) stiction: Slot<Number>,
    pub(crate) stiffness: Slot<Number>,
    pub(crate) scalar: Slot<Precision>,
    pub(crate) provide: Slot<Placed<ProvideEntry>>,
    pub(crate) accuracy: Slot<AccuracyEntry>,
    pub(crate) range: Slot<RangeEntry>,
    pub(crate) side: Slot<Choice<Side>>,
    pub(crate) budget: Slot<Number>,
    pub(crate) beyond: Slot<Choice<Beyond>>,
    pub(crate) proof: Slot<Choice<Proving>>,
    pub(crate) friction: Slot<FrictionEntry>,
    pub(crate) step: Slot<Number>,
    pub(crate) input: Slot<Choice<StepInput>>,
    pub(crate) force: Slot<Placed<Name>>,
    pub(crate) facade: Slot<RustPath>,
}

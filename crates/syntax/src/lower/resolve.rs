//! Resolves names to masses, and checks the scene as far as the parser could read it.

use std::collections::{HashMap, HashSet};

use frictiongen_model::scene::{CONTACT, ContactSides, Excitation, Mass, Node, Scene, Spring};
use frictiongen_model::validate::{Checks, Path, validate_known};

use super::Located;
use super::places::Places;
use crate::diagnostics::{Problems, Reported};
use crate::parse::suggest;
use crate::parse::syntax::{Fields, SpringEntry, Syntax};
use crate::parse::{Name, Number};

/// Returns the scene of a description, and reports all errors that the names and values cause.
pub(super) fn resolve<'s>(
    syntax: &'s Syntax,
    checks: Checks,
    problems: &mut Problems,
) -> Located<'s> {
    let fields = &syntax.fields;
    report_missing(syntax, problems);
    let names = Names::new(fields);
    let mut lowering = Lowering {
        names,
        problems,
        checks,
        unread: HashSet::new(),
    };
    let masses = lowering.masses(fields);
    let (springs, spring_entries) = lowering.springs(fields);
    let joints = lowering.joints(fields);
    let contact = match joints.joints.contacts.first() {
        Some(first) => first.sides,
        None => lowering.contact(fields),
    };
    let excitation = lowering.excitation(fields);
    let damping = lowering.damping(fields);
    let damping_from = fields.damping_from.given().map(|choice| choice.value);
    let stiction = match fields.stiction.given() {
        Some(number) => lowering.number(*number, Path::Stiction),
        None => 1.0,
    };
    let stiffness = fields.stiffness.given().copied();
    let stiffness = stiffness.map(|number| lowering.number(number, Path::Stiffness));
    let (provide, provide_entries) = lowering.provide(fields);
    let declared = lowering.declared(fields);
    let (friction, law) = lowering.friction(fields, &joints.contacts);
    let (stepping, force_entries) = lowering.stepping(fields);
    let mut scene = Scene {
        name: syntax
            .name
            .as_ref()
            .map(|name| name.text.clone())
            .unwrap_or_default(),
        masses,
        springs,
        contact,
        contact_name: CONTACT.to_owned(),
        excitation,
        damping,
        damping_from: damping_from.unwrap_or_default(),
        stiction,
        stiffness,
        precision: fields.scalar.given().copied().unwrap_or_default(),
        provide: Vec::new(),
        declared,
        friction,
        stepping,
        joints: joints.joints,
    };
    if let Some(law) = &law
        && (fields.contact.given().is_some() || fields.contacts.given().is_some())
    {
        scene.raise_rigid(law.rest);
    }
    // The code cannot decide whether springs hold a mass if it could not read them all.
    let checks = &lowering.checks;
    if checks.masses && checks.springs && checks.excitation && checks.joints {
        scene.unite();
    }
    scene.provide = provide.unwrap_or_else(|| scene.default_provide());
    let Lowering {
        problems,
        checks,
        unread,
        ..
    } = lowering;
    let places = Places {
        syntax,
        springs: spring_entries,
        contacts: joints.contacts,
        dampers: joints.dampers,
        stops: joints.stops,
        constant: joints.constant,
        provide: provide_entries,
        force: force_entries,
    };
    if let Err(errors) = validate_known(&scene, &checks) {
        for error in errors {
            // The parser has already reported every number that it could not read. The scene has NaN instead of such a
            // number, and needs no second error.
            if !unread.contains(&error.path()) {
                problems.report(places.of(error.path()), error.to_string());
            }
        }
    }
    Located { scene, places, law }
}

fn report_missing(syntax: &Syntax, problems: &mut Problems) {
    let fields = &syntax.fields;
    let name = syntax
        .name
        .as_ref()
        .map_or("the scene".to_owned(), |name| format!("`{}`", name.text));
    // The error message advises the user with the name of a mass of the scene, if a mass exists.
    let entries = fields
        .masses
        .given()
        .map_or(&[][..], |masses| &masses.list.entries);
    let mass = entries
        .first()
        .map_or("m1", |entry| entry.name.text.as_str());
    // Only with a field for several contacts, dashpots, stops or constant forces may a chain have no springs.
    let free = fields.contact.given().map_or(String::new(), |one| {
        let (from, to) = (&one.from.text, &one.to.text);
        format!("; for masses that nothing holds, write the contact as `contacts: {{ contact: {from} - {to} }}`")
    });
    for (is_missing, what, example) in [
        (
            fields.masses.is_missing(),
            "masses",
            "masses: { m1: 1.0 }".to_owned(),
        ),
        (
            fields.springs.is_missing() && !fields.may_lack_springs(),
            "springs",
            format!("springs: {{ base - {mass}: 1.0 }}"),
        ),
        (
            fields.contact.is_missing() && fields.contacts.is_missing(),
            "contact",
            format!("contact: {mass} - wall"),
        ),
        (
            fields.excitation.is_missing(),
            "excitation",
            format!("excitation: {mass}"),
        ),
    ] {
        if is_missing {
            let more = if what == "springs" { &free } else { "" };
            problems.report(
                syntax.place,
                format!("{name} lacks the field `{what}`; write, for example, `{example},`{more}"),
            );
        }
    }
}

/// The masses of a scene by name. If two masses have the same name, the name refers to the first of the two masses.
struct Names<'s> {
    index: HashMap<&'s str, usize>,
    order: Vec<&'s str>,
    complete: bool,
}

impl<'s> Names<'s> {
    fn new(fields: &'s Fields) -> Self {
        let Some(masses) = fields.masses.given() else {
            return Self {
                index: HashMap::new(),
                order: Vec::new(),
                complete: false,
            };
        };
        let mut index = HashMap::new();
        let mut order = Vec::new();
        for (place, entry) in masses.list.entries.iter().enumerate() {
            let name = entry.name.text.as_str();
            index.entry(name).or_insert_with(|| {
                order.push(name);
                place
            });
        }
        // A description without masses gets one error in total, not an error for each name in it.
        let complete = masses.list.complete && !order.is_empty();
        Self {
            index,
            order,
            complete,
        }
    }
}

/// The state of a conversion from a syntax tree to a scene.
pub(super) struct Lowering<'s, 'p> {
    names: Names<'s>,
    pub(super) problems: &'p mut Problems,
    pub(super) checks: Checks,
    /// Paths of the numbers in the scene that the parser could not read.
    unread: HashSet<Path>,
}

impl<'s> Lowering<'s, '_> {
    /// Returns the value of a number. If the parser could not read the number, it has already reported the error. The
    /// function then returns NaN and stores the path of the number.
    pub(super) fn number(&mut self, number: Number, path: Path) -> f64 {
        number.value.unwrap_or_else(|| {
            self.unread.insert(path);
            f64::NAN
        })
    }

    /// Returns the index of the mass with this name. Without such a mass, returns an error. Its message may suggest
    /// one of `supports`: the words (`base`, `wall`) that the field accepts instead of a mass.
    pub(super) fn mass(&mut self, name: &Name, supports: &[&str]) -> Result<usize, Reported> {
        let text = name.text.as_str();
        if let Some(&index) = self.names.index.get(text) {
            return Ok(index);
        }
        // The name may belong to a mass that the parser could not read, so the function reports no error.
        if !self.names.complete {
            return Err(Reported);
        }
        let grounded = ["ground", "earth", "fixed", "floor", "support"].contains(&text);
        let hint = if self.problems.are_many() {
            String::new()
        } else if grounded && supports.contains(&"wall") {
            "; write `wall` for a support that never moves, or `base` for one that moves with the excitation".to_owned()
        } else if grounded && supports.contains(&"base") {
            "; write `base` for a base motion, or the name of a mass for a force on it".to_owned()
        } else {
            let candidates = self
                .names
                .order
                .iter()
                .copied()
                .chain(supports.iter().copied());
            suggest::hint(text, candidates, || {
                let shown: Vec<_> = self.names.order.iter().take(8).copied().collect();
                let more = if self.names.order.len() > shown.len() {
                    ", …"
                } else {
                    ""
                };
                format!("the masses are {}{more}", shown.join(", "))
            })
        };
        Err(self
            .problems
            .report(name.place, format!("there is no mass `{text}`{hint}")))
    }

    pub(super) fn node(&mut self, name: &Name) -> Result<Node, Reported> {
        match name.text.as_str() {
            "base" => Ok(Node::Base),
            "wall" => Ok(Node::Wall),
            _ => self.mass(name, &["base", "wall"]).map(Node::Mass),
        }
    }

    fn masses(&mut self, fields: &Fields) -> Vec<Mass> {
        self.checks.masses = fields
            .masses
            .given()
            .is_some_and(|masses| masses.list.complete);
        let entries = fields
            .masses
            .given()
            .map_or(&[][..], |masses| &masses.list.entries);
        entries
            .iter()
            .enumerate()
            .map(|(index, entry)| Mass {
                name: entry.name.text.clone(),
                value: self.number(entry.value, Path::Mass(index)),
            })
            .collect()
    }

    /// Returns the springs whose two nodes exist, and the entry of each spring in the description.
    fn springs(&mut self, fields: &'s Fields) -> (Vec<Spring>, Vec<&'s SpringEntry>) {
        let (mut springs, mut entries) = (Vec::new(), Vec::new());
        let Some(written) = fields.springs.given() else {
            self.checks.springs = fields.may_lack_springs() && fields.springs.is_missing();
            return (springs, entries);
        };
        self.checks.springs = written.list.complete;
        for entry in &written.list.entries {
            // The code looks up both nodes before it returns an error, so that it reports errors in both nodes.
            let (from, to) = (self.node(&entry.from), self.node(&entry.to));
            let (Ok(from), Ok(to)) = (from, to) else {
                self.checks.springs = false;
                continue;
            };
            let stiffness = self.number(entry.stiffness, Path::Spring(springs.len()));
            springs.push(Spring {
                from,
                to,
                stiffness,
            });
            entries.push(entry);
        }
        (springs, entries)
    }

    fn contact(&mut self, fields: &Fields) -> ContactSides {
        let nodes = fields
            .contact
            .given()
            .map(|entry| (self.node(&entry.from), self.node(&entry.to)));
        if let Some((Ok(from), Ok(to))) = nodes {
            ContactSides { from, to }
        } else {
            self.checks.contact = false;
            ContactSides {
                from: Node::Mass(0),
                to: Node::Wall,
            }
        }
    }

    fn excitation(&mut self, fields: &Fields) -> Excitation {
        let excitation =
            fields.excitation.given().map(|name| {
                match name.text.as_str() {
            "base" => Ok(Excitation::Base),
            "wall" => Err(self.problems.report(
                name.place,
                "a wall never moves; write `base` for a base motion, or a mass for a force on it",
            )),
            _ => self.mass(name, &["base"]).map(Excitation::Force),
        }
            });
        if let Some(Ok(excitation)) = excitation {
            excitation
        } else {
            self.checks.excitation = false;
            Excitation::Base
        }
    }
}

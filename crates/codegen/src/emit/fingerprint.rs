//! Hash of a scene. Emitted code contains the hash, so that a reader can identify the scene from which the code comes.

use frictiongen_model::scene::{
    Accuracy, Beyond, CONTACT, ContactSides, Damping, DampingFrom, Declared, Excitation,
    FrictionLaw, Impact, Joints, Mass, Node, Precision, Provide, Proving, Range, Scene, Side,
    Spring, StepInput, StepperOptions,
};

/// Returns the FNV-1a hash of all fields of a scene. Texts that differ only in layout have the same
/// hash.
pub(crate) fn fingerprint(scene: &Scene) -> u64 {
    // The pattern names every field. A new field therefore causes a compiler error here.
    let Scene {
        name,
        masses,
        springs,
        contact: ContactSides { from, to },
        contact_name,
        excitation,
        damping,
        damping_from,
        stiction,
        stiffness,
        precision,
        provide,
        declared,
        friction,
        stepping,
        joints,
    } = scene;
    let mut hash = Fnv::new();
    hash.text(name);
    hash.list(masses, |hash, Mass { name, value }| {
        hash.text(name);
        hash.number(*value);
    });
    hash.list(springs, |hash, spring| {
        let Spring {
            from,
            to,
            stiffness,
        } = spring;
        hash.node(*from);
        hash.node(*to);
        hash.number(*stiffness);
    });
    hash.node(*from);
    hash.node(*to);
    match excitation {
        Excitation::Force(mass) => hash.variant(0).index(*mass),
        Excitation::Base => hash.unit(1),
    }
    hash.damping(damping);
    hash.number(*stiction);
    hash.unit(match precision {
        Precision::F64 => 0,
        Precision::F32 => 1,
    });
    hash.list(provide, Fnv::provide);
    hash.declared(declared);
    match friction {
        FrictionLaw::Coulomb => hash.unit(0),
        FrictionLaw::Stribeck(points) => {
            hash.variant(1)
                .list(points, |hash, point| hash.numbers(point));
        }
    }
    hash.stepping(stepping);
    // Only scenes with damping relative to the base, with an elastic contact, with a name of the contact or with joints
    // hash the fields below.
    // All other scenes keep the hash that they had before these fields existed.
    if *damping_from == DampingFrom::Base {
        hash.unit(1);
    }
    if let Some(stiffness) = stiffness {
        hash.number(*stiffness);
    }
    if contact_name != CONTACT {
        hash.text(contact_name);
    }
    if !joints.is_empty() {
        hash.joints(joints);
    }
    hash.0
}

/// The state of an FNV-1a hash with 64 bits.
struct Fnv(u64);

impl Fnv {
    fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// Hashes the number of an enum variant with fields. The caller then hashes these fields.
    fn variant(&mut self, variant: u8) -> &mut Self {
        self.unit(variant);
        self
    }

    /// Hashes the number of an enum variant without fields.
    fn unit(&mut self, variant: u8) {
        self.bytes(&[variant]);
    }

    fn index(&mut self, index: usize) {
        self.bytes(&(index as u64).to_le_bytes());
    }

    fn number(&mut self, number: f64) {
        self.bytes(&number.to_bits().to_le_bytes());
    }

    fn numbers(&mut self, numbers: &[f64]) {
        self.list(numbers, |hash, number| hash.number(*number));
    }

    fn text(&mut self, text: &str) {
        self.index(text.len());
        self.bytes(text.as_bytes());
    }

    /// Hashes the length of a list, then its entries, so that neighbouring lists cannot be confused.
    fn list<T>(&mut self, list: &[T], mut entry: impl FnMut(&mut Self, &T)) {
        self.index(list.len());
        for one in list {
            entry(self, one);
        }
    }

    fn joints(&mut self, joints: &Joints) {
        let Joints {
            contacts,
            dampers,
            stops,
            constant,
        } = joints;
        self.list(contacts, |hash, contact| {
            hash.text(&contact.name);
            hash.node(contact.sides.from);
            hash.node(contact.sides.to);
            // The hash treats a rigid contact as one of infinite stiffness.
            hash.number(contact.law.stiffness.unwrap_or(f64::INFINITY));
            hash.numbers(&[contact.law.stiction, contact.law.share]);
        });
        self.list(dampers, |hash, damper| {
            hash.node(damper.from);
            hash.node(damper.to);
            hash.number(damper.coefficient);
        });
        // Scenes without belts, stops and constant forces keep the hash that they had before these existed.
        if contacts.iter().any(|contact| contact.law.speed != 0.0) {
            self.variant(0)
                .list(contacts, |hash, contact| hash.number(contact.law.speed));
        }
        if !stops.is_empty() {
            self.variant(1).list(stops, |hash, stop| {
                hash.text(&stop.name);
                hash.node(stop.sides.from);
                hash.node(stop.sides.to);
                hash.number(stop.law.gap);
                match stop.law.impact {
                    Impact::Spring { stiffness, damping } => {
                        hash.variant(0).numbers(&[stiffness, damping]);
                    }
                    Impact::Restitution(ratio) => hash.variant(1).number(ratio),
                }
            });
        }
        if !constant.is_empty() {
            self.variant(2).list(constant, |hash, load| {
                hash.index(load.mass);
                hash.number(load.force);
            });
        }
    }

    fn node(&mut self, node: Node) {
        match node {
            Node::Mass(mass) => self.variant(0).index(mass),
            Node::Base => self.unit(1),
            Node::Wall => self.unit(2),
        }
    }

    fn damping(&mut self, damping: &Damping) {
        match damping {
            Damping::None => self.unit(0),
            Damping::Uniform(ratio) => self.variant(1).number(*ratio),
            Damping::Modal(ratios) => self.variant(2).numbers(ratios),
            Damping::Rayleigh { mass, stiffness } => {
                self.variant(3).numbers(&[*mass, *stiffness]);
            }
        }
    }

    fn provide(&mut self, item: &Provide) {
        match item {
            Provide::Limits => self.unit(0),
            Provide::Motion(None) => self.unit(1),
            Provide::Motion(Some(masses)) => self.variant(2).masses(masses),
            Provide::Stuck => self.unit(3),
            Provide::Orbit => self.unit(4),
            Provide::Simulation => self.unit(5),
            Provide::Stepper => self.unit(6),
            Provide::SelfCheck => self.unit(7),
        }
    }

    fn masses(&mut self, masses: &[usize]) {
        self.list(masses, |hash, mass| hash.index(*mass));
    }

    fn declared(&mut self, declared: &Declared) {
        let Declared {
            accuracy,
            range,
            side,
            budget,
            beyond,
            proof,
        } = declared;
        match accuracy {
            Accuracy::Exact => self.unit(0),
            Accuracy::Relative(error) => self.variant(1).number(*error),
        }
        self.list(range.as_slice(), |hash, Range { r, beta }| {
            hash.numbers(&[r.0, r.1, beta.0, beta.1]);
        });
        self.unit(match side {
            Side::Near => 0,
            Side::Safe => 1,
        });
        self.numbers(budget.as_slice());
        self.unit(match beyond {
            Beyond::Error => 0,
            Beyond::Exact => 1,
        });
        self.unit(match proof {
            Proving::Quick => 0,
            Proving::Whole => 1,
        });
    }

    fn stepping(&mut self, stepping: &StepperOptions) {
        let StepperOptions {
            step,
            input,
            forces,
        } = stepping;
        self.numbers(step.as_slice());
        self.unit(match input {
            StepInput::Hold => 0,
            StepInput::Linear => 1,
        });
        self.masses(forces);
    }
}

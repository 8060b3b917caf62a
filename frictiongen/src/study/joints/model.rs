//! Checks a chain and numbers its nodes.

use super::{Chain, EndStop, Heap, Joint, JointError, MAX_CONTACTS, MAX_MASSES, Model, Wave};
use frictiongen_kernel::joints::{Contact, Link, Short, Stop};
use frictiongen_model::scene::{ContactSides, Node};

impl Chain {
    /// Checks the chain and numbers its nodes for the solver.
    ///
    /// # Errors
    ///
    /// [`JointError`] for an invalid chain.
    pub fn model(&self) -> Result<Model, JointError> {
        let count = self.masses.len();
        if !(1..=MAX_MASSES).contains(&count) || self.contacts.len() > MAX_CONTACTS {
            return Err(JointError::Size);
        }
        check_numbers(self)?;
        let links = |links: &[(Node, Node, f64)], what| {
            let numbered = links.iter().map(|&(from, to, value)| {
                ends(count, (from, to), what).map(|(plus, minus)| (plus, minus, value))
            });
            numbered.collect::<Result<Vec<Link<f64>>, JointError>>()
        };
        let contacts = self.contacts.iter().map(|joint| numbered(count, joint));
        let stops = self.stops.iter().map(|stop| stop_of(count, stop));
        let constant = self.constant.iter();
        // A constant force is a harmonic one of the frequency 0.
        let constant = constant.map(|&(mass, force)| (mass, Wave::harmonic(force, 0.0)));
        let loads: Short<(usize, Wave)> = self.loads.iter().copied().chain(constant).collect();
        if loads.iter().any(|&(mass, _)| mass >= count) {
            return Err(JointError::Ends("a load"));
        }
        let mut model = Model {
            size: Heap {
                masses: count,
                contacts: self.contacts.len() + self.stops.len(),
                loads: loads.len(),
            },
            masses: self.masses.as_slice().into(),
            springs: links(&self.springs, "a spring")?.into(),
            dashpots: links(&self.dashpots, "a dashpot")?.into(),
            damping: self.damping_by_rows().into(),
            damping_from_base: self.damping_from_base,
            contacts: contacts.chain(stops).collect::<Result<_, JointError>>()?,
            law: self.law.clone(),
            loads,
            base: self.base.into(),
            stretch: 0.0,
        };
        check_redundant(&model)?;
        model.set_stretch();
        Ok(model)
    }

    /// Divides all lengths and speeds of the chain, and the constant forces, by a length.
    pub(crate) fn scale(&mut self, length: f64) {
        for [speed, _] in &mut self.law {
            *speed /= length;
        }
        for contact in &mut self.contacts {
            contact.speed /= length;
        }
        for stop in &mut self.stops {
            stop.law.gap /= length;
        }
        for (_, force) in &mut self.constant {
            *force /= length;
        }
    }

    /// Returns the damping matrix row by row. Each row has one entry for each mass.
    fn damping_by_rows(&self) -> Vec<f64> {
        let rows = self.damping.iter().flat_map(|row| {
            let entry = |column| row.get(column).copied().unwrap_or(0.0);
            (0..self.masses.len()).map(entry)
        });
        rows.collect()
    }
}

/// Converts a contact of the chain to a contact between numbered nodes.
fn numbered(masses: usize, joint: &Joint) -> Result<Contact<f64>, JointError> {
    let (plus, minus) = ends(masses, joint.ends, "a contact")?;
    Ok(Contact {
        plus,
        minus,
        level: joint.level,
        stiction: joint.stiction,
        stiffness: joint.stiffness,
        speed: if is_turned(masses, joint.ends) {
            -joint.speed
        } else {
            joint.speed
        },
        stop: None,
    })
}

/// Returns true if the second of two ends counts as positive.
fn is_turned(masses: usize, (from, to): (Node, Node)) -> bool {
    frictiongen_model::joined::is_turned(masses, ContactSides { from, to })
}

/// Converts a stop of the chain to a stop between numbered nodes.
fn stop_of(masses: usize, own: &EndStop) -> Result<Contact<f64>, JointError> {
    let (plus, minus) = ends(masses, own.ends, "a stop")?;
    let (stiffness, damping, restitution) = own.law.impact.numbers();
    let side = if is_turned(masses, own.ends) {
        -1.0
    } else {
        1.0
    };
    Ok(Contact {
        plus,
        minus,
        level: Wave::zero(),
        stiction: 1.0,
        stiffness,
        speed: 0.0,
        stop: Some(Stop {
            side,
            gap: own.law.gap,
            damping,
            restitution,
        }),
    })
}

/// Returns an error if rigid contacts form a closed loop. The check treats the wall and the base as one node.
fn check_redundant(model: &Model) -> Result<(), JointError> {
    let ground = |node: usize| node.min(model.wall());
    let mut tree: Vec<(usize, usize, usize)> = Vec::new();
    for (index, contact) in model.contacts.iter().enumerate() {
        if !contact.is_rigid() || contact.stop.is_some() {
            continue;
        }
        let (from, to) = (ground(contact.plus), ground(contact.minus));
        if let Some(mut loop_) = path(&tree, from, to) {
            loop_.push(index);
            loop_.sort_unstable();
            return Err(JointError::Redundant(loop_));
        }
        tree.push((from, to, index));
    }
    Ok(())
}

/// Returns the numbers of two nodes. The displacement of the first returned node has a positive sign in the relative
/// displacement, and that of the second has a negative sign.
fn ends(
    masses: usize,
    (from, to): (Node, Node),
    what: &'static str,
) -> Result<(usize, usize), JointError> {
    frictiongen_model::joined::numbered(masses, from, to).ok_or(JointError::Ends(what))
}

/// Returns an error if a number of the chain is invalid.
fn check_numbers(chain: &Chain) -> Result<(), JointError> {
    let positive = |value: f64| value > 0.0 && value.is_finite();
    let checks = [
        (chain.masses.iter().all(|&m| positive(m)), "a mass"),
        (
            chain.springs.iter().all(|spring| positive(spring.2)),
            "a stiffness of a spring",
        ),
        (
            chain.dashpots.iter().all(|dashpot| positive(dashpot.2)),
            "a coefficient of a dashpot",
        ),
        (
            chain.damping.iter().flatten().all(|c| c.is_finite())
                && chain.damping.len() <= chain.masses.len(),
            "an entry of the damping matrix",
        ),
        (
            chain.loads.iter().all(|(_, load)| load.is_finite()) && chain.base.is_finite(),
            "a load",
        ),
        (
            chain.contacts.iter().all(level_fits),
            "the level of a contact",
        ),
        (law_fits(&chain.law), "a point of the friction law"),
        (
            chain
                .contacts
                .iter()
                .all(|c| c.stiction >= 1.0 && c.stiction.is_finite()),
            "the stiction of a contact",
        ),
        (
            chain
                .contacts
                .iter()
                .all(|c| c.stiffness.is_none_or(positive)),
            "the stiffness of a contact",
        ),
    ];
    match checks.iter().find(|(fits, _)| !fits) {
        Some((_, what)) => Err(JointError::Number(what)),
        None => Ok(()),
    }
}

/// Returns true if the points (v, φ) of a friction law are valid. The speeds v must be above 0 and ascend, and the
/// factors φ must not be negative.
fn law_fits(points: &[[f64; 2]]) -> bool {
    let speeds = points.iter().map(|[speed, _]| *speed);
    let ascends = std::iter::once(0.0).chain(speeds.clone()).zip(speeds);
    ascends.into_iter().all(|(a, b)| a < b && b.is_finite())
        && points
            .iter()
            .all(|[_, level]| *level >= 0.0 && level.is_finite())
}

/// Returns true if the friction force of a contact is valid.
fn level_fits(joint: &Joint) -> bool {
    let contact = Contact {
        plus: 0,
        minus: 0,
        level: joint.level,
        stiction: joint.stiction,
        stiffness: joint.stiffness,
        speed: 0.0,
        stop: None,
    };
    contact.fits(&joint.level)
}

/// Returns the contacts on the path between two nodes of a graph without loops, or `None` if no path connects them.
/// `tree` lists the edges of the graph, which are contacts.
fn path(tree: &[(usize, usize, usize)], from: usize, to: usize) -> Option<Vec<usize>> {
    let mut ways = vec![(from, Vec::<usize>::new())];
    while let Some((node, way)) = ways.pop() {
        if node == to {
            return Some(way);
        }
        for &(a, b, contact) in tree {
            let next = match node {
                node if node == a => b,
                node if node == b => a,
                _ => continue,
            };
            if !way.contains(&contact) {
                ways.push((next, way.iter().copied().chain([contact]).collect()));
            }
        }
    }
    None
}

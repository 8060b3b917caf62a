//! Names of motions: `roof`, `roof-base`, `roof-first`, `spring(first-roof)`, `shear`, `contact`.

use super::error::UnknownMotion;
use super::quantity::MotionQuantity;
use super::system::System;
use crate::Of;
use frictiongen_kernel::Float;
use frictiongen_model::scene::Node;

impl<S: Float> System<S> {
    /// Returns the motion with this name.
    ///
    /// | name | motion |
    /// |---|---|
    /// | `roof` | displacement of the mass `roof` |
    /// | `contact`, or the name of the contact in `contacts` | relative motion in the contact |
    /// | `roof-base` | displacement of `roof` relative to the base |
    /// | `roof-first` | displacement of `roof` relative to `first`, for example the drift of a storey |
    /// | `spring(first-roof)` | force in the spring between `first` and `roof` |
    /// | `shear` | base shear: the sum of the forces in all springs between a mass and the base |
    ///
    /// A force is divided by P (by k₁Y for base motion).
    ///
    /// ```
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let frame: System = "struct Frame {
    ///     masses: { first: 2000, roof: 2000 },
    ///     springs: { base - first: 1.5e6, first - roof: 1.5e6 },
    ///     contact: base - first,
    ///     excitation: base,
    ///     damping: modal(0.01),
    /// }"
    /// .parse()?;
    /// assert_eq!(frame.motion_named("roof-first")?, Of::Relative(1, 0));
    /// let response = frame.at(0.5)?.response(0.4)?;
    /// let drift = response.swing(frame.motion_named("roof-first")?).ok_or("no drift")?;
    /// let force = response.swing(frame.motion_named("spring(first-roof)")?).ok_or("no force")?;
    /// // Both springs are as stiff as k₁, so force over P is displacement over P/k₁.
    /// assert!((drift.amplitude - force.amplitude).abs() < 1e-14);
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// [`UnknownMotion`] if no motion of the scene has this name. The error says what to write instead.
    pub fn motion_named(&self, name: &str) -> Result<Of, UnknownMotion> {
        let name = name.trim();
        if let Ok(index) = self.mass_index(name) {
            return Ok(Of::Mass(index));
        }
        if let Some(of) = self.contact_of_name(name) {
            return Ok(of);
        }
        if name == "shear" {
            return self.shear();
        }
        if let Some((function, inside)) = name.split_once('(') {
            let inside = inside.strip_suffix(')');
            let inside = inside.filter(|inside| !inside.contains(['(', ')']));
            let inside = inside.ok_or_else(|| UnknownMotion::Brackets(name.to_owned()))?;
            return match function.trim() {
                "spring" => self.spring_named(inside),
                other => Err(UnknownMotion::Function(other.to_owned())),
            };
        }
        let Some((of, to)) = name.split_once('-') else {
            return Err(self.unknown(name).into());
        };
        let (of, to) = (of.trim(), to.trim());
        if of == "base" {
            self.mass_index(to)?;
            return Err(UnknownMotion::BaseFirst(to.to_owned()));
        }
        let mass = self.mass_index(of)?;
        if to == "base" {
            return Ok(Of::FromBase(mass));
        }
        let reference = self.mass_index(to)?;
        if mass == reference {
            return Err(UnknownMotion::Itself(of.to_owned()));
        }
        Ok(Of::Relative(mass, reference))
    }

    /// Reads a name, and returns the motion and the quantity of this motion that the name means.
    ///
    /// | name | quantity |
    /// |---|---|
    /// | `vel(roof)` | largest velocity of the motion `roof` |
    /// | `accel(roof)` | largest acceleration of the motion `roof` |
    /// | `slip(contact)` | largest relative displacement in the contact |
    /// | `force(contact)` | largest force in the contact |
    /// | `energy(contact)` | energy that the contact dissipates in a cycle |
    /// | `zeta_eq` | equivalent viscous damping ratio ([`MotionQuantity::Damping`]), with the energy of all springs |
    /// | `zeta_eq(first-roof)` | equivalent viscous damping ratio, with the energy of one spring |
    /// | any other name | displacement or force, as in [`motion_named`](Self::motion_named) |
    ///
    /// ```
    /// use frictiongen::study::response::MotionQuantity;
    /// use frictiongen::{Of, System};
    ///
    /// # fn main() -> Result<(), Box<dyn std::error::Error>> {
    /// let frame: System = "struct Frame {
    ///     masses: { first: 2000, roof: 2000 },
    ///     springs: { base - first: 1.5e6, first - roof: 1.5e6 },
    ///     contact: base - first,
    ///     excitation: base,
    ///     damping: modal(0.01),
    /// }"
    /// .parse()?;
    /// assert_eq!(frame.quantity_named("accel(roof)")?, (Of::Mass(1), MotionQuantity::Acceleration));
    /// assert_eq!(frame.quantity_named("vel(roof-base)")?, (Of::FromBase(1), MotionQuantity::Velocity));
    /// # Ok(())
    /// # }
    /// ```
    ///
    /// # Errors
    /// Same errors as [`motion_named`](Self::motion_named). [`UnknownMotion::Rate`] for the velocity or the
    /// acceleration of a force. [`UnknownMotion::Slip`] if the brackets of `slip`, `force` or `energy` do not contain
    /// the contact.
    pub fn quantity_named(&self, name: &str) -> Result<(Of, MotionQuantity), UnknownMotion> {
        let name = name.trim();
        if let Some(of) = self.damping_named(name)? {
            return Ok((of, MotionQuantity::Damping));
        }
        let functions = [
            ("slip(", MotionQuantity::Displacement),
            ("vel(", MotionQuantity::Velocity),
            ("accel(", MotionQuantity::Acceleration),
            ("force(", MotionQuantity::Force),
            ("energy(", MotionQuantity::Energy),
        ];
        for (function, size) in functions {
            let Some(inside) = name.strip_prefix(function) else {
                continue;
            };
            let inside = inside.strip_suffix(')');
            let inside = inside.ok_or_else(|| UnknownMotion::Brackets(name.to_owned()))?;
            let of = self.motion_named(inside)?;
            if of.is_force()
                && matches!(
                    size,
                    MotionQuantity::Velocity | MotionQuantity::Acceleration
                )
            {
                return Err(UnknownMotion::Rate(inside.trim().to_owned()));
            }
            let of_contact = matches!(
                size,
                MotionQuantity::Displacement | MotionQuantity::Force | MotionQuantity::Energy
            );
            if of_contact && !matches!(of, Of::Contact | Of::ContactAt(_)) {
                let function = function.trim_end_matches('(').to_owned();
                return Err(UnknownMotion::Slip(
                    function,
                    inside.trim().to_owned(),
                    self.scene.names_of_contacts(),
                ));
            }
            return Ok((of, size));
        }
        Ok((self.motion_named(name)?, MotionQuantity::Displacement))
    }

    /// Returns the name of a motion, in the form that [`motion_named`](Self::motion_named) reads. A question mark
    /// replaces the name of a mass or spring that the scene does not have.
    #[must_use]
    pub fn name_of_motion(&self, of: Of) -> String {
        let mass = |index: usize| self.scene.node_name(Node::Mass(index));
        match of {
            Of::Contact => self.scene.contact_name.clone(),
            Of::ContactAt(index) => {
                let names = self.scene.names_of_contacts();
                names.into_iter().nth(index).unwrap_or("?".to_owned())
            }
            Of::Mass(index) => mass(index).to_owned(),
            Of::Relative(of, to) => format!("{}-{}", mass(of), mass(to)),
            Of::FromBase(index) => format!("{}-base", mass(index)),
            Of::Spring(index) => match self.scene.springs.get(index) {
                Some(spring) => format!(
                    "spring({}-{})",
                    self.scene.node_name(spring.from),
                    self.scene.node_name(spring.to)
                ),
                None => "spring(?)".to_owned(),
            },
            Of::Shear => "shear".to_owned(),
        }
    }

    /// Reads the name of an equivalent damping ratio, and returns the springs of this ratio: all springs for `zeta_eq`,
    /// or one spring for `zeta_eq(a-b)`. Returns `None` if the name means another quantity.
    fn damping_named(&self, name: &str) -> Result<Option<Of>, UnknownMotion> {
        let Some(inside) = name.strip_prefix("zeta_eq") else {
            return Ok(None);
        };
        if inside.is_empty() {
            return Ok(self.mass_index(name).is_err().then_some(Of::Contact));
        }
        let Some(inside) = inside.trim_start().strip_prefix('(') else {
            return Ok(None);
        };
        let spring = inside.strip_suffix(')').map(str::trim);
        let spring = spring.ok_or_else(|| UnknownMotion::Brackets(name.to_owned()))?;
        if let Some(of) = self.contact_of_name(spring) {
            return Ok(Some(of));
        }
        self.spring_named(spring).map(Some)
    }

    /// Returns the contact or stop with this name, if there is one.
    fn contact_of_name(&self, name: &str) -> Option<Of> {
        let mut names = self.scene.names_of_contacts().into_iter();
        let index = names.position(|known| known == name)?;
        Some(if self.scene.is_joined() {
            Of::ContactAt(index)
        } else {
            Of::Contact
        })
    }

    fn shear(&self) -> Result<Of, UnknownMotion> {
        let mut springs = self.scene.springs.iter();
        let at_base = springs.any(|spring| [spring.from, spring.to].contains(&Node::Base));
        at_base.then_some(Of::Shear).ok_or(UnknownMotion::NoShear)
    }

    fn spring_named(&self, name: &str) -> Result<Of, UnknownMotion> {
        let ends = name.split_once('-').map(|(a, b)| [a.trim(), b.trim()]);
        let found = ends.and_then(|[a, b]| {
            self.scene.springs.iter().position(|spring| {
                let own = [spring.from, spring.to].map(|node| self.scene.node_name(node));
                own == [a, b] || own == [b, a]
            })
        });
        found.map(Of::Spring).ok_or_else(|| {
            let springs = 0..self.scene.springs.len();
            let known = springs.map(|index| self.name_of_motion(Of::Spring(index)));
            UnknownMotion::Spring(name.trim().to_owned(), known.collect())
        })
    }
}

//! Sketches of mechanical systems: masses in a row, springs, the friction contact, the excitation.

use crate::label::Label;

/// An element to which a spring or the contact is attached: a mass, the base or the wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum End {
    /// A mass, by its index from 0.
    Mass(usize),
    /// The base to the left of the masses. It may move.
    Base,
    /// The ground, which never moves. A sketch shows it as the floor, or as a wall to the right of the masses.
    Wall,
}

/// A spring or a dashpot between two elements of a sketch.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spring {
    /// The two elements that the spring joins, in any order.
    pub between: (End, End),
    /// Label next to the spring.
    pub label: Label,
}

/// The friction contact of a sketch, between two elements.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SketchContact {
    /// The two elements that rub on each other, in any order.
    pub between: (End, End),
    /// Label next to the contact.
    pub label: Label,
}

/// Type of a contact that a sketch draws above the row of masses.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SliderType {
    /// A rigid friction contact.
    Rigid,
    /// A friction contact in series with a spring.
    Elastic,
    /// A stop with a gap, which acts if its two sides approach each other.
    Stop,
    /// A stop with a gap, which acts if its two sides move apart.
    PullingStop,
}

/// A friction contact or a stop of a system with several contacts. A sketch draws it above the row of masses.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Slider {
    /// The two elements that touch each other, in any order.
    pub between: (End, End),
    /// Label above the contact.
    pub label: Label,
    /// Type of the contact.
    pub slider_type: SliderType,
    /// Direction in which the second surface of the contact moves: 1 to the right, −1 to the left, 0 at rest.
    pub direction: i8,
}

/// A constant force on a mass. A sketch draws it as an arrow below the mass.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ConstantArrow {
    /// Index of the loaded mass, from 0.
    pub mass: usize,
    /// Label below the arrow.
    pub label: Label,
    /// True if the force acts in the negative direction, to the left.
    pub is_negative: bool,
}

/// The excitation in a sketch: none, a force on a mass, or the motion of the base.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum Excitation {
    /// The sketch shows no excitation.
    #[default]
    None,
    /// A force on a mass, drawn as an arrow.
    Force {
        /// Index of the loaded mass, from 0.
        mass: usize,
        /// Label next to the arrow of the force.
        label: Label,
    },
    /// The motion of the base, drawn as an arrow.
    Base {
        /// Label next to the arrow of the base's motion.
        label: Label,
    },
}

/// A mechanical system as a sketch. The sketch shows a chain of up to [`Sketch::MOST`] masses, or up to
/// [`Sketch::MOST_WITH_VALUES`] masses with values. It does not show longer chains, and it leaves out a spring to a
/// mass that does not exist.
///
/// ```
/// use frictiongen_plot::{End, Excitation, Sketch, SketchContact, Spring};
/// let sketch = Sketch {
///     masses: vec!["*m*_1".into(), "*m*_2".into()],
///     values: Vec::new(),
///     springs: vec![
///         Spring { between: (End::Base, End::Mass(0)), label: "*k*_1".into() },
///         Spring { between: (End::Mass(0), End::Mass(1)), label: "*k*_2".into() },
///     ],
///     dashpots: Vec::new(),
///     sliders: Vec::new(),
///     constant: Vec::new(),
///     contact: Some(SketchContact { between: (End::Mass(1), End::Wall), label: "*F*".into() }),
///     excitation: Excitation::Base { label: "*y*(*t*)".into() },
/// };
/// assert!(sketch.svg().is_some());
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sketch {
    /// The names of the masses, from left to right.
    pub masses: Vec<Label>,
    /// Texts under the names of the masses, such as 3.27 kg. The list may be empty. The masses of a sketch with
    /// values are wide enough for these texts.
    pub values: Vec<Label>,
    /// The springs between masses, base and wall.
    pub springs: Vec<Spring>,
    /// Dashpots parallel to the springs.
    pub dashpots: Vec<Spring>,
    /// The contacts and stops of a system with several contacts.
    pub sliders: Vec<Slider>,
    /// Constant forces on masses.
    pub constant: Vec<ConstantArrow>,
    /// The friction contact of a system with a single contact, below the row of masses. `None` for a system without
    /// contact, or with several contacts.
    pub contact: Option<SketchContact>,
    /// The excitation: none, a force on a mass, or the motion of the base.
    pub excitation: Excitation,
}

impl Sketch {
    /// Largest number of masses in a sketch without values.
    pub const MOST: usize = 6;

    /// Largest number of masses in a sketch with values.
    pub const MOST_WITH_VALUES: usize = 16;
}

#[cfg(test)]
mod tests {
    use super::{
        ConstantArrow, End, Excitation, Sketch, SketchContact, Slider, SliderType, Spring,
    };
    use crate::drawing::ALONE;

    fn chain(count: usize) -> Sketch {
        let ends = |index: usize| match index {
            0 => (End::Base, End::Mass(0)),
            _ => (End::Mass(index - 1), End::Mass(index)),
        };
        Sketch {
            masses: (1..=count).map(|i| format!("*m*_{i}").into()).collect(),
            values: Vec::new(),
            springs: (0..count)
                .map(|i| Spring {
                    between: ends(i),
                    label: format!("*k*_{}", i + 1).into(),
                })
                .collect(),
            dashpots: Vec::new(),
            sliders: Vec::new(),
            constant: Vec::new(),
            contact: None,
            excitation: Excitation::None,
        }
    }

    #[test]
    fn draws_up_to_six_masses() {
        for count in 1..=6 {
            let svg = chain(count).svg().unwrap();
            assert_eq!(svg.matches(">m</tspan>").count(), count);
            assert_eq!(svg.matches(">k</tspan>").count(), count);
            assert!(!svg.contains("NaN"));
        }
        assert_eq!(chain(0).svg(), None);
        assert_eq!(chain(7).svg(), None);
    }

    #[test]
    fn values_take_the_room_that_they_need() {
        let mut sketch = chain(7);
        sketch.values = vec!["3.27 kg".into(); 7];
        let (width, _) = sketch.size(ALONE).unwrap();
        assert!(sketch.svg().unwrap().matches(">3.27 kg<").count() == 7);
        sketch.values = vec!["327000.25 kg".into(); 7];
        let (wider, _) = sketch.size(ALONE).unwrap();
        assert!(width < wider);
        sketch.springs[3].label = "1190.25 N/m and more".into();
        assert!(wider < sketch.size(ALONE).unwrap().0);
        let mut long = chain(Sketch::MOST_WITH_VALUES + 1);
        long.values = vec!["1 kg".into()];
        assert_eq!(long.svg(), None);
    }

    #[test]
    fn leaves_out_what_ends_nowhere() {
        let mut sketch = chain(2);
        let plain = sketch.svg();
        for between in [
            (End::Mass(2), End::Mass(0)),
            (End::Mass(1), End::Mass(1)),
            (End::Base, End::Wall),
        ] {
            sketch.springs.push(Spring {
                between,
                label: "no".into(),
            });
            sketch.contact = Some(SketchContact {
                between,
                label: "no".into(),
            });
        }
        sketch.excitation = Excitation::Force {
            mass: 9,
            label: "no".into(),
        };
        assert_eq!(sketch.svg(), plain);
    }

    #[test]
    fn dashpots_stand_above() {
        let mut sketch = chain(1);
        let (width, height) = sketch.size(ALONE).unwrap();
        sketch.dashpots.push(Spring {
            between: (End::Base, End::Mass(0)),
            label: "*c*".into(),
        });
        let (same, higher) = sketch.size(ALONE).unwrap();
        assert!(same == width && height < higher);
        assert!(sketch.svg().unwrap().contains(">c</tspan>"));
    }

    #[test]
    fn several_contacts_stand_above() {
        let mut sketch = chain(2);
        let (width, height) = sketch.size(ALONE).unwrap();
        let types = [SliderType::Elastic, SliderType::Rigid];
        for (index, slider_type) in types.into_iter().enumerate() {
            sketch.sliders.push(Slider {
                between: (End::Mass(0), End::Mass(1)),
                label: format!("slider {index}").into(),
                slider_type,
                direction: 0,
            });
            let (same, higher) = sketch.size(ALONE).unwrap();
            // Two contacts between the same masses are drawn at different levels, so the sketch becomes higher but not
            // wider.
            assert!(same == width && height + 34.0 * (index as f64) < higher);
        }
        sketch.sliders.push(Slider {
            between: (End::Mass(1), End::Wall),
            label: "pads".into(),
            slider_type: SliderType::Rigid,
            direction: 0,
        });
        assert!(width < sketch.size(ALONE).unwrap().0);
        let svg = sketch.svg().unwrap();
        for label in ["slider 0", "slider 1", "pads"] {
            assert!(svg.contains(&format!(">{label}<")), "{label}: {svg}");
        }
    }

    /// Each of a belt, a stop and a constant force adds strokes to the sketch, and has its label in it.
    #[test]
    fn belts_stops_and_constant_forces_are_drawn() {
        let strokes = |sketch: &Sketch| sketch.svg().unwrap().matches("<path").count();
        let with = |slider_type, direction| {
            let mut sketch = chain(2);
            sketch.sliders.push(Slider {
                between: (End::Mass(1), End::Wall),
                label: "pads".into(),
                slider_type,
                direction,
            });
            assert!(sketch.svg().unwrap().contains(">pads<"));
            strokes(&sketch)
        };
        for slider_type in [SliderType::Rigid, SliderType::Elastic] {
            let [at_rest, right, left] = [0, 1, -1].map(|direction| with(slider_type, direction));
            assert!(at_rest < right && right == left);
        }
        for slider_type in [SliderType::Stop, SliderType::PullingStop] {
            assert!(strokes(&chain(2)) < with(slider_type, 0));
        }
        let mut sketch = chain(2);
        let (plain, (width, height)) = (strokes(&sketch), sketch.size(ALONE).unwrap());
        for (mass, is_negative) in [(0, false), (1, true), (2, false)] {
            sketch.constant.push(ConstantArrow {
                mass,
                label: format!("{mass} N").into(),
                is_negative,
            });
        }
        let svg = sketch.svg().unwrap();
        assert!(svg.contains(">0 N<") && svg.contains(">1 N<") && !svg.contains(">2 N<"));
        assert_eq!(strokes(&sketch), plain + 4);
        let (same, higher) = sketch.size(ALONE).unwrap();
        assert!(same == width && height < higher);
    }

    #[test]
    fn far_springs_and_contacts_take_room() {
        let mut sketch = chain(3);
        let (width, height) = sketch.size(ALONE).unwrap();
        sketch.springs.push(Spring {
            between: (End::Mass(0), End::Mass(2)),
            label: "a".into(),
        });
        let (same, higher) = sketch.size(ALONE).unwrap();
        assert!(same == width && height < higher);
        sketch.springs.push(Spring {
            between: (End::Wall, End::Mass(1)),
            label: "b".into(),
        });
        let (wider, highest) = sketch.size(ALONE).unwrap();
        assert!(width < wider && higher < highest);
        for between in [
            (End::Mass(0), End::Wall),
            (End::Mass(2), End::Base),
            (End::Mass(2), End::Mass(0)),
        ] {
            sketch.contact = Some(SketchContact {
                between,
                label: "*F*".into(),
            });
            assert!(highest < sketch.size(ALONE).unwrap().1, "{between:?}");
            assert!(sketch.svg().unwrap().contains(">F</tspan>"));
        }
    }
}

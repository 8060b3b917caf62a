//! Sketches of a scene.

use crate::{
    ConstantArrow, End, Excitation, Label, Sketch, SketchContact, Slider, SliderType, Spring,
};
use frictiongen::study::scene::{self, Node, Scene};

/// Returns the sketch of a scene whose excitation is a recording. The masses have the names of the scene. The label of
/// the excitation is *y*(*t*) or *f*(*t*) instead of a cosine.
#[must_use]
pub fn sketch_under_record(scene: &Scene) -> Sketch {
    let mut sketch = sketch(scene, true);
    match &mut sketch.excitation {
        Excitation::Force { label, .. } => *label = "*f*(*t*)".into(),
        Excitation::Base { label } => *label = "*y*(*t*)".into(),
        Excitation::None => {}
    }
    sketch
}

/// Returns the sketch of a scene without a load. The masses have the names of the scene.
#[must_use]
pub fn sketch_without_load(scene: &Scene) -> Sketch {
    Sketch {
        excitation: Excitation::None,
        ..sketch(scene, true)
    }
}

/// Returns the sketch of a scene. If `own_names` is true, the masses have the names of the scene. Otherwise they have
/// the symbols of the theory, such as *m*₁. Springs are numbered in the order of the scene description.
#[must_use]
pub fn sketch(scene: &Scene, own_names: bool) -> Sketch {
    let end = |node: Node| match node {
        Node::Mass(index) => End::Mass(index),
        Node::Base => End::Base,
        Node::Wall => End::Wall,
    };
    let single = scene.masses.len() == 1;
    let masses = scene.masses.iter().enumerate().map(|(index, mass)| {
        if own_names {
            Label::verbatim(&mass.name)
        } else if single {
            "*m*".into()
        } else {
            Label::from(format!("*m*_{}", index + 1))
        }
    });
    let springs = scene
        .springs
        .iter()
        .enumerate()
        .map(|(index, spring)| Spring {
            between: (end(spring.from), end(spring.to)),
            label: if scene.springs.len() == 1 {
                "*k*".into()
            } else {
                Label::from(format!("*k*_{}", index + 1))
            },
        });
    let dampers = scene.joints.dampers.iter().enumerate();
    let dashpots = dampers.map(|(index, damper)| Spring {
        between: (end(damper.from), end(damper.to)),
        label: if scene.joints.dampers.len() == 1 {
            "*c*".into()
        } else {
            Label::from(format!("*c*_{}", index + 1))
        },
    });
    let is_joined = scene.is_joined();
    let contacts = scene.named_contacts().into_iter().filter(|_| is_joined);
    let sliders = contacts.map(|contact| Slider {
        between: (end(contact.sides.from), end(contact.sides.to)),
        label: Label::verbatim(&contact.name),
        slider_type: match contact.law.stiffness {
            None => SliderType::Rigid,
            Some(_) => SliderType::Elastic,
        },
        direction: match contact.law.speed {
            0.0 => 0,
            speed if speed < 0.0 => -1,
            _ => 1,
        },
    });
    // Order of the elements in the sketch, from left to right.
    let place = |node: Node| match node {
        Node::Base => 0,
        Node::Mass(index) => index + 1,
        Node::Wall => usize::MAX,
    };
    let stops = scene.joints.stops.iter().map(|stop| Slider {
        between: (end(stop.sides.from), end(stop.sides.to)),
        label: Label::verbatim(&stop.name),
        slider_type: if place(stop.sides.from) < place(stop.sides.to) {
            SliderType::Stop
        } else {
            SliderType::PullingStop
        },
        direction: 0,
    });
    let constant = scene.joints.constant.iter().map(|own| ConstantArrow {
        mass: own.mass,
        label: Label::verbatim(&format!("{} N", own.force.abs())),
        is_negative: own.force < 0.0,
    });
    Sketch {
        masses: masses.collect(),
        values: Vec::new(),
        springs: springs.collect(),
        dashpots: dashpots.collect(),
        sliders: sliders.chain(stops).collect(),
        constant: constant.collect(),
        contact: (!is_joined).then(|| SketchContact {
            between: (end(scene.contact.from), end(scene.contact.to)),
            label: match scene.contact_name.as_str() {
                scene::CONTACT => "*F*".into(),
                name => Label::verbatim(name),
            },
        }),
        excitation: match scene.excitation {
            scene::Excitation::Force(mass) => Excitation::Force {
                mass,
                label: "*P* cos *ωt*".into(),
            },
            scene::Excitation::Base => Excitation::Base {
                label: "*Y* cos *ωt*".into(),
            },
        },
    }
}

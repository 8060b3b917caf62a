//! Draws figures with sketches of chains.

use frictiongen_plot::{End, Excitation, Figure, Sketch, SketchContact, Spring};

/// Returns the figure with sketches of all kinds of contact and excitation.
pub fn systems() -> Figure {
    let mut sketch = two_masses();
    sketch.masses = (1..=6).map(|i| format!("*m*_{i}").into()).collect();
    let ends = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (0, 2), (2, 5)];
    sketch.springs = vec![Spring {
        between: (End::Base, End::Mass(0)),
        label: "*k*_1".into(),
    }];
    sketch
        .springs
        .extend(ends.iter().enumerate().map(|(i, (a, b))| Spring {
            between: (End::Mass(*a), End::Mass(*b)),
            label: format!("*k*_{}", i + 2).into(),
        }));
    sketch.springs.push(Spring {
        between: (End::Mass(4), End::Wall),
        label: "*k*_9".into(),
    });
    sketch.springs.push(Spring {
        between: (End::Mass(5), End::Wall),
        label: "*k*_{10}".into(),
    });
    sketch.springs.push(Spring {
        between: (End::Base, End::Mass(2)),
        label: "*k*_{11}".into(),
    });
    sketch.contact = Some(SketchContact {
        between: (End::Mass(1), End::Mass(3)),
        label: "*F*".into(),
    });
    sketch.excitation = Excitation::Force {
        mass: 2,
        label: "*P* cos *ωt*".into(),
    };
    Figure::new("", "a chain of six masses", 1, Vec::new()).with_sketch(sketch)
}

pub fn two_masses() -> Sketch {
    Sketch {
        masses: vec!["*m*_1".into(), "*m*_2".into()],
        values: Vec::new(),
        springs: vec![
            Spring {
                between: (End::Base, End::Mass(0)),
                label: "*k*_1".into(),
            },
            Spring {
                between: (End::Mass(0), End::Mass(1)),
                label: "*k*_2".into(),
            },
        ],
        dashpots: Vec::new(),
        sliders: Vec::new(),
        contact: Some(SketchContact {
            between: (End::Mass(0), End::Wall),
            label: "*F*".into(),
        }),
        excitation: Excitation::Force {
            mass: 0,
            label: "*P* cos *ωt*".into(),
        },
    }
}

pub fn base_driven() -> Sketch {
    Sketch {
        masses: vec!["*m*_1".into(), "*m*_2".into()],
        values: Vec::new(),
        springs: vec![
            Spring {
                between: (End::Base, End::Mass(0)),
                label: "*k*_1".into(),
            },
            Spring {
                between: (End::Mass(0), End::Mass(1)),
                label: "*k*_2".into(),
            },
            Spring {
                between: (End::Mass(0), End::Wall),
                label: "*k*_3".into(),
            },
        ],
        dashpots: Vec::new(),
        sliders: Vec::new(),
        contact: Some(SketchContact {
            between: (End::Mass(1), End::Base),
            label: "*F*".into(),
        }),
        excitation: Excitation::Base {
            label: "*y*(*t*)".into(),
        },
    }
}

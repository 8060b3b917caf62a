//! A sheet with everything that a figure can hold, in the folder of the first argument: `cargo run --example sampler`.
//! It is written for a page and for a telephone, as SVG and, with the feature `png`, as PNG.

use frictiongen_plot::{
    Across, Anchor, Axis, Cells, Colour, Contact, End, Excitation, Figure, Fill, Guide, Inset, Key,
    Line, Marker, Markers, Note, Panel, Point, Raster, Region, Sketch, Spring, Stroke,
};
use std::error::Error;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os()
        .nth(1)
        .map_or_else(std::env::temp_dir, PathBuf::from);
    std::fs::create_dir_all(&folder)?;
    for (name, figure) in [
        ("responses", responses()),
        ("maps", maps()),
        ("times", times()),
        ("systems", systems()),
    ] {
        write(&folder, name, &figure)?;
        write(&folder, &format!("{name}-narrow"), &figure.narrow())?;
    }
    println!("{}", folder.display());
    Ok(())
}

#[cfg(feature = "png")]
fn write(folder: &Path, name: &str, figure: &Figure) -> Result<(), Box<dyn Error>> {
    std::fs::write(folder.join(format!("{name}.png")), figure.png(2.0)?)?;
    std::fs::write(folder.join(format!("{name}.svg")), figure.svg())?;
    Ok(())
}

#[cfg(not(feature = "png"))]
fn write(folder: &Path, name: &str, figure: &Figure) -> Result<(), Box<dyn Error>> {
    std::fs::write(folder.join(format!("{name}.svg")), figure.svg())?;
    Ok(())
}

/// Points of a curve.
fn curve(from: f64, to: f64, count: u32, function: impl Fn(f64) -> f64) -> Vec<Point> {
    (0..=count)
        .map(|i| from + (to - from) * f64::from(i) / f64::from(count))
        .map(|x| (x, function(x)))
        .collect()
}

/// The amplitude and the lag of a damped mass.
fn damped(r: f64, zeta: f64) -> (f64, f64) {
    let (real, imaginary) = (1.0 - r * r, 2.0 * zeta * r);
    (
        1.0 / real.hypot(imaginary),
        imaginary.atan2(real).to_degrees(),
    )
}

fn regimes() -> [Key; 4] {
    [
        Key::stroke("continuous", Stroke::Solid),
        Key::stroke("stick-slip", Stroke::DashDot),
        Key::stroke("stuck", Stroke::Dotted),
        Key::marker("simulation", Marker::Circle),
    ]
}

/// Curves with markers, an inset, degrees.
fn responses() -> Figure {
    let x = || Axis::new("frequency ratio *r*_1", 0.0, 2.5);
    let mut amplitude = Panel::new(
        "**(a)** amplitude of *m*_1",
        x(),
        Axis::new("*X̄*_1", 0.0, 5.0),
    );
    let mut lag = Panel::new(
        "**(b)** lag of *m*_1",
        x(),
        Axis::new("*φ*_1, degrees", 0.0, 180.0).degrees(),
    );
    let mut detail = Panel::new("", Axis::new("", 0.9, 1.1), Axis::new("", 2.0, 6.0));
    for (index, zeta) in [0.02, 0.1, 0.2, 0.4].into_iter().enumerate() {
        let colour = Colour::Series(index);
        let name = format!("*β* = {zeta}");
        let pieces = |read: &dyn Fn(f64) -> f64, stroke| match stroke {
            Stroke::DashDot => vec![curve(0.02, 0.4, 400, read)],
            Stroke::Dotted => vec![curve(1.9, 2.5, 400, read)],
            _ => vec![curve(0.4, 1.9, 4000, read)],
        };
        for stroke in [Stroke::Solid, Stroke::DashDot, Stroke::Dotted] {
            let high = |r: f64| damped(r, zeta).0;
            let late = |r: f64| damped(r, zeta).1;
            amplitude = amplitude.with(Line::new(
                name.clone(),
                colour,
                stroke,
                pieces(&high, stroke),
            ));
            lag = lag.with(Line::new(
                name.clone(),
                colour,
                stroke,
                pieces(&late, stroke),
            ));
            detail = detail.with(Line::new(
                name.clone(),
                colour,
                stroke,
                pieces(&high, stroke),
            ));
        }
        let places = curve(0.15, 2.4, 15, |r| r);
        let marks = places
            .iter()
            .map(|(r, _)| (*r, damped(*r, zeta).0))
            .collect();
        amplitude = amplitude.with(Markers::unnamed(colour, Marker::Circle, marks));
        let marks = places
            .iter()
            .map(|(r, _)| (*r, damped(*r, zeta).1))
            .collect();
        lag = lag.with(Markers::unnamed(colour, Marker::Circle, marks));
    }
    let limit = curve(0.0, 2.5, 500, |r| 2.2 / (1.0 + r * r));
    amplitude = amplitude
        .with(Line::new(
            "at *β*_lim",
            Colour::Black,
            Stroke::Dashed,
            vec![limit],
        ))
        .with(Note::new("*P*_1", (0.99, 2.75), Anchor::Middle))
        .with_inset(Inset {
            place: (0.62, 0.08, 0.34, 0.42),
            marked: true,
            panel: detail,
        });
    lag = lag
        .with(Guide::new(Across::Y(90.0)))
        .with(Guide::new(Across::X(1.0)));
    Figure::new("6.6", "two masses, contact and load on *m*_1", 2, vec![amplitude, lag])
        .with_sketch(two_masses())
        .with_keys(regimes())
        .with_caption(
            "*γ* = *m*_2/*m*_1 = 1, *κ* = *k*_2/*k*_1 = 1, *β* = *F*/*P*. The inset shows the resonance; where \
             *X̄*_1 ≈ 0 the lag is left out.",
        )
}

/// The names of the classes of a map.
const STOPS: [&str; 5] = ["no stop", "1 stop", "2 stops", "3 stops", "4 stops"];

/// Regions and maps.
fn maps() -> Figure {
    let x = || Axis::new("frequency ratio *r*", 0.0, 2.0);
    let lower = |r: f64| 0.8 * r * r / (0.3 + r * r);
    let upper = |r: f64| lower(r) + 0.25 + 0.3 * (-8.0 * (r - 1.0) * (r - 1.0)).exp();
    let places: Vec<f64> = curve(0.0, 2.0, 400, |r| r)
        .iter()
        .map(|point| point.0)
        .collect();
    let strip = |low: &dyn Fn(f64) -> f64, high: &dyn Fn(f64) -> f64| -> Vec<(f64, f64, f64)> {
        places.iter().map(|r| (*r, low(*r), high(*r))).collect()
    };
    let regions = Panel::new(
        "**(a)** regimes",
        x(),
        Axis::new("friction ratio *β*", 0.0, 1.5),
    )
    .with(
        Region::between("continuous", Fill::Class(0), &strip(&|_| 0.0, &lower))
            .named_at((1.3, 0.25)),
    )
    .with(
        Region::between("stick-slip", Fill::Class(1), &strip(&lower, &upper)).named_at((1.5, 0.8)),
    )
    .with(Region::between("stuck", Fill::Class(2), &strip(&upper, &|_| 1.6)).named_at((0.5, 1.2)))
    .with(Line::new(
        "*β*_lim",
        Colour::Black,
        Stroke::Solid,
        vec![curve(0.0, 2.0, 400, lower)],
    ))
    .with(Line::new(
        "*β*^*_lim",
        Colour::Black,
        Stroke::Dashed,
        vec![curve(0.0, 2.0, 400, upper)],
    ));
    let (columns, rows) = (120_usize, 90_usize);
    let cell = |index: usize| {
        let (column, row) = (index % columns, index / columns);
        (
            2.0 * (column as f64 + 0.5) / columns as f64,
            1.5 * (row as f64 + 0.5) / rows as f64,
        )
    };
    let stops = |index: usize| {
        let (r, beta) = cell(index);
        let count = (beta / (0.3 + 0.7 * r)) * 4.0;
        (beta < upper(r)).then_some((count as usize).min(4))
    };
    let classes = (0..5)
        .map(|i| {
            (
                STOPS.get(i).copied().unwrap_or_default().into(),
                Fill::Class(i),
            )
        })
        .collect();
    let cells = Cells::Classes {
        classes,
        cells: (0..columns * rows).map(stops).collect(),
    };
    let stopping = Panel::new(
        "**(b)** stops a cycle",
        x(),
        Axis::new("friction ratio *β*", 0.0, 1.5),
    )
    .with(Raster {
        x: (0.0, 2.0),
        y: (0.0, 1.5),
        columns,
        cells,
    })
    .with(Line::new(
        "*β*_lim",
        Colour::Black,
        Stroke::Solid,
        vec![curve(0.0, 2.0, 400, lower)],
    ));
    let value = |index: usize| {
        let (r, beta) = cell(index);
        damped(r, 0.05 + beta).0
    };
    let cells = Cells::Values {
        bar: Axis::log("*X̄*", 0.1, 10.0),
        cells: (0..columns * rows).map(value).collect(),
    };
    let heat = Panel::new(
        "**(c)** amplitude",
        x(),
        Axis::new("friction ratio *β*", 0.0, 1.5),
    )
    .with(Raster {
        x: (0.0, 2.0),
        y: (0.0, 1.5),
        columns,
        cells,
    });
    let decay = Panel::new(
        "**(d)** decay",
        Axis::log("*ζ*_1", 1e-4, 1.0),
        Axis::log("|*β* − *β*_lim|", 1e-9, 10.0),
    )
    .with(Line::new(
        "first order",
        Colour::Series(0),
        Stroke::Solid,
        vec![curve(1e-4, 1.0, 4000, |z| z)],
    ))
    .with(Line::new(
        "second order",
        Colour::Series(1),
        Stroke::Solid,
        vec![curve(1e-4, 1.0, 4000, |z| z * z)],
    ))
    .with(Markers::new(
        "measured",
        Colour::Series(3),
        Marker::Square,
        vec![(1e-3, 2e-3), (1e-2, 1e-2), (1e-1, 8e-2)],
    ))
    .with(Markers::new(
        "trials",
        Colour::Series(4),
        Marker::Cross,
        vec![(1e-3, 2e-6), (1e-2, 1e-4), (1e-1, 8e-3)],
    ))
    .with(Markers::new(
        "runs",
        Colour::Series(5),
        Marker::Triangle,
        vec![(2e-3, 2e-7), (2e-2, 2e-4)],
    ))
    .with(Markers::new(
        "points",
        Colour::Series(6),
        Marker::Dot,
        vec![(4e-3, 2e-7), (4e-2, 2e-4)],
    ))
    .with(Note::new("slope 1", (0.02, 0.2), Anchor::End));
    Figure::new(
        "3.12",
        "regimes and stops over frequency and friction",
        2,
        vec![regions, stopping, heat, decay],
    )
    .with_caption("Regions are named where they lie; 10^{−9} < |*β* − *β*_lim| ≤ 10.")
}

/// Multiples of π, jumps, values that are not finite.
fn times() -> Figure {
    let stuck = |tau: f64| (1.4 * tau.cos()).clamp(-1.0, 1.0);
    // A pole is not a line: a value that is not finite breaks it.
    let mut wild = curve(0.0, 0.5 * PI, 600, |tau| 0.4 * tau.tan());
    wild.push((0.5 * PI, f64::NAN));
    wild.extend(curve(0.501 * PI, 1.499 * PI, 600, |tau| 0.4 * tau.tan()));
    let last = curve(1.501 * PI, 2.0 * PI, 600, |tau| 0.4 * tau.tan());
    let panel = Panel::new(
        "",
        Axis::new("*τ*", 0.0, 2.0 * PI).in_pi(),
        Axis::fitted("*x̄*, *ȳ*", [-1.5, 1.5]),
    )
    .with(Line::new(
        "*x̄*_1(*τ*)",
        Colour::Series(0),
        Stroke::Solid,
        vec![curve(0.0, 2.0 * PI, 600, stuck)],
    ))
    .with(Line::new(
        "*ȳ*(*τ*)",
        Colour::Black,
        Stroke::Dashed,
        vec![curve(0.0, 2.0 * PI, 600, f64::cos)],
    ))
    .with(Line::new(
        "0.4 tan *τ*",
        Colour::Grey,
        Stroke::Thin,
        vec![wild, last],
    ));
    Figure::new(
        "4.12",
        "time response at *β* = 0.2, *r* = 0.6",
        1,
        vec![panel],
    )
    .with_keys([Key::fill("stuck", Fill::Class(2))])
    .with_sketch(base_driven())
}

/// Sketches of all kinds.
fn systems() -> Figure {
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
    sketch.contact = Some(Contact {
        between: (End::Mass(1), End::Mass(3)),
        label: "*F*".into(),
    });
    sketch.excitation = Excitation::Force {
        mass: 2,
        label: "*P* cos *ωt*".into(),
    };
    Figure::new("", "a chain of six masses", 1, Vec::new()).with_sketch(sketch)
}

fn two_masses() -> Sketch {
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
        contact: Some(Contact {
            between: (End::Mass(0), End::Wall),
            label: "*F*".into(),
        }),
        excitation: Excitation::Force {
            mass: 0,
            label: "*P* cos *ωt*".into(),
        },
    }
}

fn base_driven() -> Sketch {
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
        contact: Some(Contact {
            between: (End::Mass(1), End::Base),
            label: "*F*".into(),
        }),
        excitation: Excitation::Base {
            label: "*y*(*t*)".into(),
        },
    }
}

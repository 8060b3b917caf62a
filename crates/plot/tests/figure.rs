//! Tests whole figures: the content of the file, and that it is the same in every run.

use frictiongen_plot::{
    Across, Anchor, Axis, Cells, Colour, Figure, Fill, Guide, Inset, Key, Line, Marker, Markers,
    Note, Panel, Point, Raster, Region, Stroke,
};

/// Values that must not appear in any file.
const ODD: [f64; 7] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    1e-300,
    5e-324,
];

fn parabola() -> Vec<Point> {
    (0..=100)
        .map(|i| f64::from(i) * 0.02)
        .map(|x| (x, x * x))
        .collect()
}

/// Returns a small figure with one layer of each kind.
fn small() -> Figure {
    let inner = Panel::new("", Axis::new("", 0.9, 1.1), Axis::new("", 0.8, 1.2)).with(
        Line::unnamed(Colour::Series(0), Stroke::Solid, vec![parabola()]),
    );
    let cells = Cells::Classes {
        classes: vec![("class".into(), Fill::Class(1))],
        cells: vec![Some(0), None, Some(0), Some(0)],
    };
    let panel = Panel::new(
        "**(a)** title",
        Axis::new("*x*", 0.0, 2.0),
        Axis::new("*X̄*_1", 0.0, 4.0),
    )
    .with(Raster {
        x: (1.5, 2.0),
        y: (0.0, 1.0),
        columns: 2,
        cells,
    })
    .with(Region::new(
        "region",
        Fill::Class(0),
        vec![vec![(0.0, 3.0), (0.5, 3.0), (0.5, 5.0), (0.0, 5.0)]],
    ))
    .with(Line::new(
        "*x*^2",
        Colour::Series(0),
        Stroke::DashDot,
        vec![parabola()],
    ))
    .with(Markers::new(
        "marks",
        Colour::Series(1),
        Marker::Circle,
        vec![(1.0, 1.0), (9.0, 9.0)],
    ))
    .with(Guide::new(Across::Y(2.0)))
    .with(Note::new("here", (1.0, 3.0), Anchor::Middle))
    .with_inset(Inset {
        place: (0.1, 0.1, 0.3, 0.3),
        marked: true,
        panel: inner,
    });
    Figure::new("1", "small & simple", 1, vec![panel])
        .with_keys([Key::stroke("stick-slip", Stroke::DashDot)])
        .with_caption("*β*_lim = 1.")
}

/// Checks that the small figure equals its recorded picture. `UPDATE_FIGURES=1` renews the recording.
#[test]
fn the_small_figure_is_as_recorded() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/small.svg");
    if std::env::var_os("UPDATE_FIGURES").is_some() {
        std::fs::write(path, small().svg()).unwrap();
    }
    assert_eq!(small().svg(), std::fs::read_to_string(path).unwrap());
    assert_eq!(small().svg(), small().svg());
}

#[test]
fn it_says_what_it_shows() {
    let svg = small().svg();
    assert!(svg.contains("role=\"img\""));
    assert!(svg.contains("<title>Figure 1. small &amp; simple</title>"));
    assert!(svg.contains("<desc>(a) title: X̄1 over x. Drawn are: class; region; x2; marks; stick-slip. βlim = 1.</desc>"));
}

#[test]
fn a_name_stands_in_the_legend_once_and_only_if_it_is_seen() {
    let line = |name: &str, y: f64| {
        Line::new(
            name,
            Colour::Black,
            Stroke::Solid,
            vec![vec![(0.0, y), (1.0, y)]],
        )
    };
    let panel = Panel::new("", Axis::new("", 0.0, 1.0), Axis::new("", 0.0, 1.0))
        .with(line("seen", 0.5))
        .with(line("seen", 0.6))
        .with(line("beyond", 2.0))
        .with(line("nowhere", f64::NAN));
    let svg = Figure::new("", "", 2, vec![panel.clone(), panel]).svg();
    assert_eq!(svg.matches(">seen<").count(), 1);
    assert!(!svg.contains("beyond") && !svg.contains("nowhere"));
}

#[test]
fn what_is_not_finite_breaks_a_line() {
    let broken = vec![
        (0.0, 0.5),
        (0.2, 0.5),
        (0.4, f64::NAN),
        (0.6, 0.5),
        (0.8, 0.5),
    ];
    let panel = Panel::new("", Axis::new("", 0.0, 1.0), Axis::new("", 0.0, 1.0)).with(
        Line::unnamed(Colour::Rgb(1, 2, 3), Stroke::Solid, vec![broken]),
    );
    let svg = Figure::new("", "", 1, vec![panel]).svg();
    let path = svg.lines().find(|line| line.contains("#010203")).unwrap();
    assert_eq!(path.matches('M').count(), 2, "{path}");
}

#[test]
fn no_odd_value_reaches_a_file() {
    let points: Vec<Point> = ODD.into_iter().flat_map(|x| ODD.map(|y| (x, y))).collect();
    let mut drawn = 0;
    for low in ODD {
        for axis in [
            Axis::new("", low, 1.0),
            Axis::new("", low, 1.0).degrees(),
            Axis::log("", low, 1.0),
        ] {
            let cells = Cells::Values {
                bar: axis.clone(),
                cells: ODD.to_vec(),
            };
            let mut panel = Panel::new("", axis.clone(), axis)
                .with(Raster {
                    x: (low, 1.0),
                    y: (low, 1.0),
                    columns: 0,
                    cells,
                })
                .with(Region::new("r", Fill::Map(low), vec![points.clone()]).named_at((low, low)))
                .with(Line::new(
                    "l",
                    Colour::Black,
                    Stroke::Solid,
                    vec![points.clone(), Vec::new()],
                ))
                .with(Markers::new(
                    "m",
                    Colour::Black,
                    Marker::Cross,
                    points.clone(),
                ))
                .with(Guide::new(Across::X(low)))
                .with(Note::new("n", (low, low), Anchor::End));
            panel.height = Some(low);
            let inset = Inset {
                place: (low, 0.0, 0.5, 0.5),
                marked: true,
                panel: panel.clone(),
            };
            let svg = Figure::new("", "", 9, vec![panel.with_inset(inset)]).svg();
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{low}");
            drawn += 1;
        }
    }
    assert_eq!(drawn, 21);
    assert!(Figure::default().svg().ends_with("</svg>\n"));
}

#[test]
fn a_smooth_curve_is_drawn_between_the_pixels() {
    let svg = small().svg();
    let curve = svg
        .lines()
        .find(|line| line.contains("stroke-dasharray=\"8"))
        .unwrap();
    assert!(curve.matches('.').count() > 40, "{curve}");
}

#[cfg(feature = "png")]
#[test]
fn the_png_has_the_size_and_the_pixels_that_are_recorded() {
    let png = small().png(2.0).unwrap();
    assert_eq!(png, small().png(2.0).unwrap());
    let pixels = resvg::tiny_skia::Pixmap::decode_png(&png).unwrap();
    let svg = small().svg();
    let size = |name: &str| -> u32 {
        let (_, after) = svg.split_once(&format!("{name}=\"")).unwrap();
        after.split_once('"').unwrap().0.parse().unwrap()
    };
    assert_eq!(
        (pixels.width(), pixels.height()),
        (2 * size("width"), 2 * size("height"))
    );
    let inked = pixels
        .pixels()
        .iter()
        .filter(|pixel| pixel.red() < 128)
        .count();
    assert!((10_000..200_000).contains(&inked), "{inked}");
    // FNV-1a hash of all pixels, which is the same on every host.
    let hash = pixels
        .data()
        .iter()
        .fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
            (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3)
        });
    assert_eq!(hash, 0x0b2b_cccc_e7f3_04cf, "{hash:#018x}");
}

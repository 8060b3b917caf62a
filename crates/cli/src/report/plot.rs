//! A picture of the report with the data of its curves. The page uses these data to show the values under the pointer.

use super::words::rounded;
use frictiongen_plot::{Colour, Figure, Label, Layer, Page, PanelFrame, Scale, Stroke};
use maud::{Markup, PreEscaped, html};
use serde_json::{Value as Json, json};

/// Largest distance between a curve and the straight lines through its data points. The distance is the first number
/// times the local value of the curve, plus the second number times the curve's largest value.
const STRAYS: [f64; 2] = [5e-4, 2e-5];

/// A curve of a panel, in the units of the panel's axes.
pub struct PlotCurve {
    name: String,
    colour: Colour,
    /// Pieces of the curve, each group with its regime. The regime is `None` if the strokes do not show regimes.
    runs: Vec<(Option<&'static str>, Pieces)>,
}

/// The points of each piece of a curve. Straight lines join the points of a piece, but not two pieces.
type Pieces = Vec<Vec<(f64, f64)>>;

impl PlotCurve {
    /// Creates a curve from the layers that draw it in a figure. If `by_regime` is true, the stroke of a layer
    /// determines the regime of its pieces.
    pub fn of(name: &Label, colour: Colour, layers: &[Layer], by_regime: bool) -> Self {
        let lines = layers.iter().filter_map(|layer| match layer {
            Layer::Line(line) => Some(line),
            _ => None,
        });
        let regime = |stroke: Stroke| match stroke {
            Stroke::Solid => "continuous",
            Stroke::DashDot => "stick-slip",
            _ => "stuck",
        };
        let runs = lines.map(|line| {
            let regime = by_regime.then(|| regime(line.stroke));
            (regime, line.pieces.clone())
        });
        Self {
            name: name.plain(),
            colour,
            runs: runs.collect(),
        }
    }

    fn data(&self) -> Json {
        let mut runs: Vec<Json> = Vec::new();
        let all = self.runs.iter().flat_map(|(_, pieces)| pieces).flatten();
        let most = all.fold(0.0_f64, |most, point| most.max(point.1.abs()));
        for (regime, pieces) in &self.runs {
            for piece in pieces.iter().filter(|piece| !piece.is_empty()) {
                let piece = thinned(piece, most);
                let list = |read: fn(&(f64, f64)) -> f64| -> Vec<f64> {
                    piece.iter().map(|point| rounded(read(point))).collect()
                };
                runs.push(json!({
                    "regime": regime,
                    "x": list(|point| point.0),
                    "y": list(|point| point.1),
                }));
            }
        }
        json!({ "name": self.name, "colour": self.colour.to_string(), "runs": runs })
    }
}

/// Removes the points of a curve piece that a picture does not need. Straight lines through the remaining points stay
/// close to the curve. A curve that ends at a pole or at the bound of the range has many such points.
fn thinned(piece: &[(f64, f64)], most: f64) -> Vec<(f64, f64)> {
    let [relative, absolute] = STRAYS;
    let mut kept = vec![false; piece.len()];
    for end in [0, piece.len().saturating_sub(1)] {
        if let Some(kept) = kept.get_mut(end) {
            *kept = true;
        }
    }
    let mut open = vec![(0, piece.len().saturating_sub(1))];
    while let Some((low, high)) = open.pop() {
        let (Some(a), Some(b)) = (piece.get(low), piece.get(high)) else {
            continue;
        };
        let inner = piece.iter().enumerate().take(high).skip(low + 1);
        let strays = inner.map(|(index, (x, y))| {
            let width = b.0 - a.0;
            let share = if 0.0 < width { (x - a.0) / width } else { 0.5 };
            let off = (y - (a.1 + share * (b.1 - a.1))).abs();
            (
                index,
                off / (relative * y.abs() + absolute * most + f64::MIN_POSITIVE),
            )
        });
        if let Some((index, off)) = strays.max_by(|a, b| a.1.total_cmp(&b.1))
            && 1.0 < off
        {
            if let Some(kept) = kept.get_mut(index) {
                *kept = true;
            }
            open.extend([(low, index), (index, high)]);
        }
    }
    let both = piece.iter().zip(kept);
    both.filter(|(_, kept)| *kept)
        .map(|(point, _)| *point)
        .collect()
}

/// A picture of the report, with the data of the curves in each of its panels.
pub struct Plot {
    /// Identifier of the picture in the page and in the data.
    pub id: String,
    /// Title of the picture.
    pub title: String,
    svg: String,
    data: Json,
}

/// Name and unit of the quantity on a panel's vertical axis.
pub struct Axes<'a> {
    /// Name of the quantity on a panel's vertical axis.
    pub quantity: &'a str,
    /// Unit of the quantity on a panel's vertical axis. It may be empty.
    pub unit: &'a str,
}

/// Name and unit of the quantity on the horizontal axis.
pub struct HorizontalAxis<'a> {
    /// Name of the quantity on the horizontal axis.
    pub name: &'a str,
    /// Unit of the quantity on the horizontal axis. It may be empty.
    pub unit: &'a str,
}

impl Plot {
    /// Creates a picture from a figure, with the width of a telephone screen. `curves` contains the curves of each
    /// panel, and `more` further data.
    pub fn new(
        id: &str,
        title: &str,
        figure: Figure,
        across: &HorizontalAxis<'_>,
        curves: &[(Axes<'_>, Vec<PlotCurve>)],
        more: Json,
    ) -> Self {
        let figure = Figure {
            page: Page::Narrow,
            ..figure
        };
        let (svg, frames) = figure.svg_with_frames();
        let panels = figure.panels.iter().zip(frames).zip(curves);
        let panels = panels.map(|((panel, frame), (axes, series))| {
            let mut data = placed(&frame);
            if let Json::Object(fields) = &mut data {
                fields.insert("quantity".to_owned(), axes.quantity.into());
                fields.insert("unit".to_owned(), axes.unit.into());
                fields.insert("log".to_owned(), (panel.y.scale == Scale::Log).into());
                fields.insert(
                    "series".to_owned(),
                    series.iter().map(PlotCurve::data).collect(),
                );
            }
            data
        });
        let data = json!({
            "id": id,
            "title": title,
            "x": across.name,
            "x_unit": across.unit,
            "panels": panels.collect::<Vec<_>>(),
            "more": more,
        });
        Self {
            id: id.to_owned(),
            title: title.to_owned(),
            svg,
            data,
        }
    }

    /// Returns the picture as HTML.
    pub fn html(&self) -> Markup {
        html! {
            figure.plot data-plot=(self.id) aria-label=(self.title) {
                // The crate frictiongen-plot has made this SVG text, and has escaped every word of the user in it.
                div.paper { (PreEscaped(&self.svg)) }
            }
        }
    }

    /// Returns the data of the picture as JSON.
    pub fn data(&self) -> &Json {
        &self.data
    }
}

/// Returns the position of a panel's frame in the units of the picture, and the values of the axes at the sides of the
/// frame.
fn placed(frame: &PanelFrame) -> Json {
    json!({
        "left": rounded(frame.left),
        "top": rounded(frame.top),
        "width": rounded(frame.width),
        "height": rounded(frame.height),
        "x_ends": [frame.x.0, frame.x.1],
        "y_ends": [frame.y.0, frame.y.1],
    })
}

#[cfg(test)]
mod tests {
    use super::thinned;

    #[test]
    fn thinned_lines_keep_to_the_curve() {
        let curve: Vec<(f64, f64)> = (0..=4000)
            .map(|i| f64::from(i) * 1e-3)
            .map(|x| (x, 1.0 / (0.01 + (x - 1.5) * (x - 1.5))))
            .collect();
        let few = thinned(&curve, 100.0);
        assert!(few.len() < 400, "{}", few.len());
        for (x, y) in &curve {
            let after = few.iter().position(|point| x <= &point.0).unwrap();
            let (a, b) = (few[after.saturating_sub(1)], few[after]);
            let share = if a.0 < b.0 {
                (x - a.0) / (b.0 - a.0)
            } else {
                0.0
            };
            let line = a.1 + share * (b.1 - a.1);
            assert!(
                (line - y).abs() <= 5e-4 * y + 2e-3 + 1e-12,
                "{x}: {line} {y}"
            );
        }
        assert_eq!(thinned(&[(1.0, 2.0)], 2.0), [(1.0, 2.0)]);
        assert!(thinned(&[], 0.0).is_empty());
    }
}

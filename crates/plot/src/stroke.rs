//! Strokes and markers.

/// The stroke of a line. Each regime has its own stroke.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Stroke {
    /// Solid line, for continuous motion.
    #[default]
    Solid,
    /// Dashes and dots, for stick-slip motion.
    DashDot,
    /// Dotted line, for stuck motion.
    Dotted,
    /// Dashed line, for limits.
    Dashed,
    /// Thin solid line, for comparison.
    Thin,
}

/// The shape of a marker, which shows a separate point.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Marker {
    /// An open circle.
    Circle,
    /// A filled dot.
    Dot,
    /// An open square.
    Square,
    /// An open triangle.
    Triangle,
    /// A cross.
    Cross,
}

impl Stroke {
    /// Returns the width of a stroke in pixels, and its dash pattern as SVG text.
    pub(crate) fn look(self) -> (f64, &'static str) {
        match self {
            Self::Solid => (1.6, ""),
            Self::DashDot => (1.6, "8 3 1.8 3"),
            Self::Dotted => (1.8, "1.8 2.8"),
            Self::Dashed => (1.4, "5.5 3.2"),
            Self::Thin => (0.9, ""),
        }
    }
}

//! Tables of the results of a design study. Each kind of result has a table with rows, and columns with units.
//!
//! The command prints these tables as text, CSV and JSON, and the report contains them. In Python their columns become
//! arrays. One line of code adds a column to a table.
//!
//! ```
//! use frictiongen::study::columns::{CurveTable, FrequencyUnit, FrictionSetting, Measure, MovingPart, Setting};
//! use frictiongen::study::{System, curve::{CurveRequest, CurveStart}};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let system: System = "struct Block {
//!     masses: { block: 2.0 },
//!     springs: { base - block: 50.0 },
//!     contact: block - wall,
//!     excitation: block,
//! }"
//! .parse()?;
//! let parts = [MovingPart::contact(&system)];
//! let setting = Setting {
//!     system: &system,
//!     measure: Measure::groups(&system),
//!     frequency: FrequencyUnit::Ratio,
//!     frequencies: &[],
//!     frictions: &[0.5],
//!     forces: false,
//!     parts: &parts,
//! };
//! let table = CurveTable { setting, starts: false, rates: false, orders: &[] };
//! let request = CurveRequest::new(0.4, 0.6, &[parts[0].of]);
//! let curves = system.curves(&request, &[(0.5, CurveStart::Rest)])?;
//! let friction = FrictionSetting::of_ratio(0.5, None);
//! let rows = table.rows(friction, &curves[0]);
//! let columns = table.columns();
//! let keys: Vec<String> = columns.iter().map(|column| column.key()).collect();
//! assert_eq!(keys[..3], ["beta", "r", "piece"]);
//! assert_eq!(columns[1].read(&rows[0]), 0.4.into());
//! # Ok(())
//! # }
//! ```

mod branch;
mod builder;
mod cell;
mod column;
#[cfg(feature = "desk")]
mod curve;
mod features;
#[cfg(feature = "desk")]
mod history;
mod joined;
mod joined_limits;
mod joined_sensitivity;
mod joined_time;
mod limits;
#[cfg(feature = "desk")]
mod map;
mod measure;

mod motion;
mod optimum;
mod periodic;
mod quantity;
mod sensitivity;
mod setting;
mod steady;

pub use branch::{Along, BranchEndRow, BranchPlace};
pub use builder::Columns;
pub use cell::Cell;
pub use column::{Column, ColumnAxis, ColumnKind, Head, Shown, TableRow};
#[cfg(feature = "desk")]
pub use curve::{CurveRow, CurveTable};
pub use features::{
    FeatureLine, FeatureLists, FeatureTable, FeatureVisitor, FeaturesAsked, Ground, words_of_set,
};
#[cfg(feature = "desk")]
pub use history::{EventRow, HarmonicRow, HistoryTable, SampleRow};
pub use joined::{JoinedRow, JoinedTable};
pub use joined_limits::JoinedLimitsRow;
pub use joined_sensitivity::{JoinedPart, JoinedSensitivityRow, JoinedSensitivityTable};
pub use joined_time::{JoinedEventRow, JoinedSample};
pub use limits::{LimitsAsked, LimitsRow, LimitsTable};
#[cfg(feature = "desk")]
pub use map::{BoundaryRow, MapLimitsRow, MapRow, MapTable};
pub use measure::{Measure, PhysicalQuantity};
pub use motion::{MotionColumns, MotionRow, PartMotion, motions};
pub use optimum::{OptimumLine, OptimumSensitivityRow, OptimumTable, PeakRow};
pub use periodic::{PeriodicRow, PeriodicSample, PeriodicTable};
pub use quantity::{base_load, bound, unbalance};
pub use sensitivity::{SensitivityRow, SensitivityTable};
pub use setting::{
    AtFrequency, AtFriction, Frequency, FrequencyUnit, FrictionSetting, MovingPart, Setting, spread,
};
pub use steady::{OrbitRow, OrbitTable, ResponseRow, ResponseTable};

//! Rows and columns of features: one line for each, and a list for each kind.

mod found;
mod lines;
mod lists;
mod sheet;
mod table;

pub use found::FeatureLists;
pub use lines::{FeatureLine, FeaturesAsked, Ground};
pub use lists::FeatureVisitor;
pub use table::FeatureTable;

//! Rows and columns of features: one line for each, and a list for each kind.

mod found;
mod lines;
mod lists;
mod sheet;

pub use found::FeatureLists;
pub use lines::{FeatureLine, FeatureTable, FeaturesAsked, Ground};
pub use lists::FeatureVisitor;

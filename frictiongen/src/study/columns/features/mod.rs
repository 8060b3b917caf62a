//! Rows and columns of features: a table with one line for each feature, and one list for each kind of feature.

mod found;
mod joined;
mod lines;
mod lists;
mod sheet;
mod table;

pub use found::FeatureLists;
pub use joined::words_of_set;
pub use lines::{FeatureLine, FeaturesAsked, Ground};
pub use lists::FeatureVisitor;
pub use table::FeatureTable;

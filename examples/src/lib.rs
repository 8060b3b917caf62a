//! What the programs share: scenes as things to sample, adaptive curves, figures as SVG with their
//! data as CSV, and the numbers that the thesis prints beside what they come out as.

pub mod album;
pub mod curve;
pub mod draw;
pub mod facts;
pub mod figure;
pub mod gallery;
pub mod panels;
pub mod scene;
pub mod scenes;
pub mod svg;
pub mod two_stops;

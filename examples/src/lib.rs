//! What the chapter programs share: scenes as things to sample, adaptive curves, figures as SVG with
//! their data as CSV.

pub mod album;
pub mod curve;
pub mod figure;
pub mod panels;
pub mod scene;
pub mod svg;

//! Backward errors of every answer: at the edges of the reference, and over random scenes.

mod extremes;
mod measure;
mod property;

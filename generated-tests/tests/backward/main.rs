//! Backward errors of every answer: at the edges of the reference, and over random scenes.

mod asked;
mod condition;
mod extremes;
mod measure;
mod property;

//! Backward errors of every answer: at the edges of the reference, and over random scenes.

mod asked;
mod condition;
mod displacement;
mod extremes;
mod instant;
mod matched;
mod measure;
mod property;
mod random;
mod seen;

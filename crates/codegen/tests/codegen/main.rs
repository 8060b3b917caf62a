//! Tests of the generator and of the language that it reads. One program, because each program links the generator.

mod counts;
mod fingerprint;
mod graph;
mod locals;
mod parse_forms;
mod parse_names;
mod parse_random;
mod parse_together;
mod step_facts;

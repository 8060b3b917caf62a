//! Tests the pages of the documentation, whose commands print what the pages show, and random arguments. Published
//! packages do not contain these tests, because they need pages and a crate of the repository.

#[path = "../cli/common/mod.rs"]
mod common;
mod contacts_page;
mod example_scenes;
mod fuzz;
mod guide_page;
mod start_page;
mod worked_page;

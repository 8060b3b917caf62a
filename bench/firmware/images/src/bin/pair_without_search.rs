//! 2DOF f32, `provide: [limits]`: both limits without the search.
#![no_std]
#![no_main]

images::image!(least_without_search INPUTS_SINGLE);

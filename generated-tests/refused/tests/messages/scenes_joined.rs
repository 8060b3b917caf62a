// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_780_stiffness_of_the_contact_is_negative {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: -5.0e4,
    provide: [orbit, simulation],
}
}
}

mod case_780_too_many_contacts {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { c0: upper - wall { stiffness: 1e3 }, c1: upper - wall { stiffness: 1e3 }, c2: upper - wall { stiffness: 1e3 }, c3: upper - wall { stiffness: 1e3 }, c4: upper - wall { stiffness: 1e3 }, c5: upper - wall { stiffness: 1e3 }, c6: upper - wall { stiffness: 1e3 }, c7: upper - wall { stiffness: 1e3 }, c8: upper - wall { stiffness: 1e3 }, c9: upper - wall { stiffness: 1e3 }, c10: upper - wall { stiffness: 1e3 }, c11: upper - wall { stiffness: 1e3 }, c12: upper - wall { stiffness: 1e3 }, c13: upper - wall { stiffness: 1e3 }, c14: upper - wall { stiffness: 1e3 }, c15: upper - wall { stiffness: 1e3 }, c16: upper - wall { stiffness: 1e3 } },
    excitation: base,
}
}
}

mod case_781_keyword_for_a_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { loop: upper - wall },
    excitation: base,
}
}
}

mod case_781_self_check_of_an_elastic_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 5.0e4,
    provide: [orbit, self_check],
}
}
}

mod case_782_budget_with_an_elastic_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 5.0e4,
    provide: [orbit],
    budget: 4096,
    range: { r: 0.2..2.0 },
}
}
}

mod case_782_reserved_word_for_a_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { contact: upper - wall },
    excitation: base,
}
}
}

mod case_783_raw_name_of_a_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { r#loop: upper - wall },
    excitation: base,
}
}
}

mod case_783_stiffness_of_the_contact_out_of_scale {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 1e61,
    provide: [orbit],
}
}
}

mod case_784_stiffness_of_the_contact_in_single_precision {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    stiffness: 1e12,
    scalar: f32,
    provide: [orbit],
}
}
}

mod case_784_two_contacts_of_one_name {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall, pads: base - lower },
    excitation: base,
}
}
}

mod case_785_contact_called_as_a_mass {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { upper: upper - wall },
    excitation: base,
}
}
}

mod case_786_two_rigid_contacts_of_one_pair {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { share: 0.6 }, more: wall - upper },
    excitation: base,
}
}
}

mod case_787_share_of_zero {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { share: 0 } },
    excitation: base,
}
}
}

mod case_788_stiffness_of_one_contact_is_negative {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { stiffness: -5e4 } },
    excitation: base,
}
}
}

mod case_789_rigid_contacts_that_close_a_loop {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { floor: base - lower, joint: lower - upper, pads: upper - wall },
    excitation: base,
}
}
}

mod case_790_dashpot_to_itself {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    dampers: { lower - lower: 12.0 },
    excitation: base,
}
}
}

mod case_791_dashpot_between_supports {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    dampers: { base - wall: 12.0 },
    excitation: base,
}
}
}

mod case_792_parallel_dashpots {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    dampers: { lower - upper: 12.0, upper - lower: 3.0 },
    excitation: base,
}
}
}

mod case_793_dashpot_of_zero {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    dampers: { lower - upper: 0 },
    excitation: base,
}
}
}

mod case_794_mass_that_nothing_touches {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25, loose: 1.0 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    excitation: base,
}
}
}

mod case_795_base_that_moves_no_mass {
frictiongen::friction_system! {
struct Frame {
    masses: { block: 1.0 },
    contacts: { pads: block - wall },
    excitation: base,
}
}
}

mod case_796_stiction_of_several_contacts {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    excitation: base,
    stiction: 1.2,
}
}
}

mod case_797_stribeck_with_elastic_contacts_only {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { stiffness: 5e3 } },
    excitation: base,
    friction: stribeck(0.1: 0.8),
    provide: [simulation],
}
}
}

mod case_7971_orbit_of_several_contacts_with_stribeck {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    excitation: base,
    friction: stribeck(0.1: 0.8),
    provide: [simulation, orbit],
}
}
}

mod case_798_tables_with_several_contacts {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    excitation: base,
    accuracy: 1e-4,
    range: { r: 0.2..2.5 },
}
}
}

mod case_799_macro_with_several_contacts {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    excitation: base,
}
}
}

mod case_7990_enormous_numbers_of_contacts {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: {
        pads: upper - wall { share: 1e70, stiction: 1e70 },
        brace: base - lower { stiffness: 1e70 },
    },
    dampers: { lower - upper: 1e70 },
    excitation: base,
}
}
}

mod case_7991_more_contacts_than_the_macro_emits {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: {
        pads: upper - wall,
        first: base - lower { stiffness: 100 },
        second: base - lower { stiffness: 200 },
        third: base - lower { stiffness: 300 },
        fourth: base - lower { stiffness: 400 },
    },
    excitation: base,
    provide: [simulation],
}
}
}

mod case_7992_limits_of_several_contacts {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    excitation: base,
    provide: [simulation, limits],
}
}
}

mod case_7994_simulation_without_springs {
frictiongen::friction_system! {
struct Drive {
    masses: { motor: 3.27, arm: 3.25 },
    contacts: { clutch: motor - arm },
    excitation: motor,
    provide: [simulation],
}
}
}

fn main() {}

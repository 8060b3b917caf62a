// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_401_masses_in_brackets {
frictiongen::friction_system! {
struct Frame {
    masses: [3.27, 3.25],
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_402_mass_without_a_name {
frictiongen::friction_system! {
struct Frame {
    masses: { (3.27), upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_403_decimal_comma {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3,27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_404_mass_without_a_colon {
frictiongen::friction_system! {
struct Frame {
    masses: { lower 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_405_springs_in_brackets {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: [1190.0, 1323.0],
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_406_spring_without_an_end {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base -: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_407_spring_without_a_hyphen {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base > lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_408_spring_with_an_arrow {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base -> lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_409_spring_without_a_colon {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower = 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_410_contact_without_a_hyphen {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_411_contact_with_an_arrow {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper -> wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_412_contact_without_a_side {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_413_excitation_by_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: 1.0,
    damping: modal[0.010, 0.012],
}
}
}

mod case_414_excited_wall {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: wall,
    damping: modal[0.010, 0.012],
}
}
}

mod case_415_misspelt_mass {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: uper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_416_unknown_mass {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: x - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_417_unknown_mass_of_many {
frictiongen::friction_system! {
struct Tower {
    masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0, m6: 1.0, m7: 1.0, m8: 1.0, m9: 1.0 },
    springs: { base - m1: 1.0, m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0, m5 - m6: 1.0, m6 - m7: 1.0, m7 - m8: 1.0, m8 - m9: 1.0 },
    contact: roof - wall,
    excitation: base,
}
}
}

mod case_418_ground {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - ground,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_419_list_of_contacts {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: [upper - wall, lower - wall],
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_420_second_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall, lower - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_421_spring_with_a_decimal_comma {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1,2e6, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_422_excited_ground {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: ground,
    damping: modal[0.010, 0.012],
}
}
}

mod case_423_contacts_in_brackets {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: [pads: upper - wall],
    excitation: base,
}
}
}

mod case_424_contact_without_a_name {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { upper - wall },
    excitation: base,
}
}
}

mod case_425_contact_named_by_a_number {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { 1: upper - wall },
    excitation: base,
}
}
}

mod case_426_no_contact_in_the_list {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: {},
    excitation: base,
}
}
}

mod case_427_contact_and_contacts {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    contacts: { brace: base - lower },
    excitation: base,
}
}
}

mod case_428_misspelt_property_of_a_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { shore: 0.5 } },
    excitation: base,
}
}
}

mod case_429_unknown_property_of_a_contact {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { force: 0.5 } },
    excitation: base,
}
}
}

mod case_430_property_of_a_contact_twice {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { share: 0.5, share: 0.6 } },
    excitation: base,
}
}
}

mod case_431_property_without_a_name {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { 0.5 } },
    excitation: base,
}
}
}

mod case_432_property_without_a_colon {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall { share 0.5 } },
    excitation: base,
}
}
}

mod case_433_contact_without_a_colon {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads upper - wall },
    excitation: base,
}
}
}

mod case_434_dashpots_in_brackets {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    dampers: [lower - upper: 12.0],
    excitation: base,
}
}
}

mod case_435_dashpot_without_a_colon {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    dampers: { lower - upper 12.0 },
    excitation: base,
}
}
}

mod case_436_dashpot_without_a_hyphen {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    dampers: { lower: 12.0 },
    excitation: base,
}
}
}

mod case_437_no_dashpot_in_the_list {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contacts: { pads: upper - wall },
    dampers: {},
    excitation: base,
}
}
}

fn main() {}

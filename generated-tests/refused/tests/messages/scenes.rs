// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_701_no_mass {
frictiongen::friction_system! {
struct Frame {
    masses: {},
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_702_too_many_masses {
frictiongen::friction_system! {
struct Tower {
    masses: {
        m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0, m6: 1.0, m7: 1.0, m8: 1.0,
        m9: 1.0, m10: 1.0, m11: 1.0, m12: 1.0, m13: 1.0, m14: 1.0, m15: 1.0, m16: 1.0,
        m17: 1.0, m18: 1.0, m19: 1.0, m20: 1.0, m21: 1.0, m22: 1.0, m23: 1.0, m24: 1.0,
        m25: 1.0, m26: 1.0, m27: 1.0, m28: 1.0, m29: 1.0, m30: 1.0, m31: 1.0, m32: 1.0,
        m33: 1.0, m34: 1.0, m35: 1.0, m36: 1.0, m37: 1.0, m38: 1.0, m39: 1.0, m40: 1.0,
        m41: 1.0, m42: 1.0, m43: 1.0, m44: 1.0, m45: 1.0, m46: 1.0, m47: 1.0, m48: 1.0,
        m49: 1.0, m50: 1.0, m51: 1.0, m52: 1.0, m53: 1.0, m54: 1.0, m55: 1.0, m56: 1.0,
        m57: 1.0, m58: 1.0, m59: 1.0, m60: 1.0, m61: 1.0, m62: 1.0, m63: 1.0, m64: 1.0,
        m65: 1.0,
    },
    springs: {
        base - m1: 1.0,
        m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0, m5 - m6: 1.0,
        m6 - m7: 1.0, m7 - m8: 1.0, m8 - m9: 1.0, m9 - m10: 1.0, m10 - m11: 1.0,
        m11 - m12: 1.0, m12 - m13: 1.0, m13 - m14: 1.0, m14 - m15: 1.0, m15 - m16: 1.0,
        m16 - m17: 1.0, m17 - m18: 1.0, m18 - m19: 1.0, m19 - m20: 1.0, m20 - m21: 1.0,
        m21 - m22: 1.0, m22 - m23: 1.0, m23 - m24: 1.0, m24 - m25: 1.0, m25 - m26: 1.0,
        m26 - m27: 1.0, m27 - m28: 1.0, m28 - m29: 1.0, m29 - m30: 1.0, m30 - m31: 1.0,
        m31 - m32: 1.0, m32 - m33: 1.0, m33 - m34: 1.0, m34 - m35: 1.0, m35 - m36: 1.0,
        m36 - m37: 1.0, m37 - m38: 1.0, m38 - m39: 1.0, m39 - m40: 1.0, m40 - m41: 1.0,
        m41 - m42: 1.0, m42 - m43: 1.0, m43 - m44: 1.0, m44 - m45: 1.0, m45 - m46: 1.0,
        m46 - m47: 1.0, m47 - m48: 1.0, m48 - m49: 1.0, m49 - m50: 1.0, m50 - m51: 1.0,
        m51 - m52: 1.0, m52 - m53: 1.0, m53 - m54: 1.0, m54 - m55: 1.0, m55 - m56: 1.0,
        m56 - m57: 1.0, m57 - m58: 1.0, m58 - m59: 1.0, m59 - m60: 1.0, m60 - m61: 1.0,
        m61 - m62: 1.0, m62 - m63: 1.0, m63 - m64: 1.0, m64 - m65: 1.0,
    },
    contact: m1 - wall,
    excitation: base,
}
}
}

mod case_703_raw_name {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, r#type: 3.25 },
    springs: { base - lower: 1190.0, lower - r#type: 1323.0 },
    contact: r#type - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_704_keyword_for_a_mass {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, box: 3.25 },
    springs: { base - lower: 1190.0, lower - box: 1323.0 },
    contact: box - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_705_reserved_word_for_a_mass {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, phase: 3.25 },
    springs: { base - lower: 1190.0, lower - phase: 1323.0 },
    contact: phase - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_706_not_a_name {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, ℘: 3.25 },
    springs: { base - lower: 1190.0, lower - ℘: 1323.0 },
    contact: ℘ - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_707_two_masses_of_one_name {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25, lower: 1.0 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: none,
}
}
}

mod case_709_mass_of_zero {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 0, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_710_out_of_scale {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 1e61, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_711_no_spring {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: {},
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_713_spring_to_itself {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 10.0, lower - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_714_spring_between_supports {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - wall: 10.0, base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_715_parallel_springs {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1000.0, upper - lower: 323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_716_stiffness_of_zero {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: -1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_717_mass_that_nothing_holds {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - wall: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_718_masses_that_nothing_holds {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_719_many_masses_that_nothing_holds {
frictiongen::friction_system! {
struct Tower {
    masses: { m1: 1.0, m2: 1.0, m3: 1.0, m4: 1.0, m5: 1.0, m6: 1.0, m7: 1.0, m8: 1.0, m9: 1.0, m10: 1.0 },
    springs: { m1 - m2: 1.0, m2 - m3: 1.0, m3 - m4: 1.0, m4 - m5: 1.0, m5 - m6: 1.0, m6 - m7: 1.0, m7 - m8: 1.0, m8 - m9: 1.0, m9 - m10: 1.0 },
    contact: m9 - wall,
    excitation: base,
}
}
}

mod case_720_contact_with_itself {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - upper,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_721_contact_between_supports {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: base - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_722_base_that_moves_nothing {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { wall - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_723_contact_that_a_force_never_reaches {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, wall - upper: 1323.0 },
    contact: upper - wall,
    excitation: lower,
    damping: modal[0.010, 0.012],
}
}
}

mod case_724_contact_that_the_base_never_reaches {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, wall - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

mod case_725_too_few_damping_ratios {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010],
}
}
}

mod case_726_negative_damping {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, -0.012],
}
}
}

mod case_727_negative_mass_factor {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: rayleigh(-0.1, 0.001),
}
}
}

mod case_728_negative_stiffness_factor {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: rayleigh(0.1, -0.001),
}
}
}

mod case_729_stiction_below_one {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: 3.27, upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
    stiction: 0.8,
}
}
}

fn main() {}

// From the cases in generated-tests/tests/messages; see generated-tests/tests/messages.rs.
#![allow(uncommon_codepoints)]

mod case_115_nested_too_deep {
frictiongen::friction_system! {
struct Frame {
    masses: { lower: (((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((((3.27))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))))), upper: 3.25 },
    springs: { base - lower: 1190.0, lower - upper: 1323.0 },
    contact: upper - wall,
    excitation: base,
    damping: modal[0.010, 0.012],
}
}
}

fn main() {}

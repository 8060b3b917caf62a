//! The chains that are measured. An entry begins with `orbit` if its steady states with stops are measured, otherwise
//! with `plain`. It continues with the name, the number of masses, the index of the observed mass, the description, and
//! what an exact scene provides.
//!
//! Masses and springs are equal, because `bench/peers/stepper.c` supports no others. The observed mass is the mass whose
//! amplitude is computed.

/// Passes the list of all chains to the macro `$then`.
macro_rules! chains {
    ($then:ident) => {
        $then! {
            orbit struct Wall1 1 0 {
                masses: { m1: 1 },
                springs: { base - m1: 1 },
                contact: m1 - wall,
                excitation: m1,
            } [limits, motion(m1), orbit]
            orbit struct Base1 1 0 {
                masses: { m1: 1 },
                springs: { base - m1: 1 },
                contact: m1 - base,
                excitation: base,
            } [limits, motion(m1), orbit]
            orbit struct Wall2 2 0 {
                masses: { m1: 1, m2: 1 },
                springs: { base - m1: 1, m1 - m2: 1 },
                contact: m2 - wall,
                excitation: m1,
            } [limits, motion(m1), orbit]
            plain struct Base2 2 1 {
                masses: { m1: 1, m2: 1 },
                springs: { base - m1: 1, m1 - m2: 1 },
                contact: m1 - base,
                excitation: base,
            } [limits, motion(m2)]
            plain struct Pair2 2 1 {
                masses: { m1: 1, m2: 1 },
                springs: { base - m1: 1, m1 - m2: 1 },
                contact: m1 - m2,
                excitation: m2,
            } [limits, motion(m2)]
            orbit struct Wall5 5 0 {
                masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
                springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
                contact: m5 - wall,
                excitation: m1,
            } [limits, motion(m1), orbit]
            plain struct Base5 5 4 {
                masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
                springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
                contact: m1 - base,
                excitation: base,
            } [limits, motion(m5)]
            plain struct Pair5 5 4 {
                masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1 },
                springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1 },
                contact: m1 - m2,
                excitation: m5,
            } [limits, motion(m5)]
            plain struct Wall10 10 0 {
                masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1 },
                springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 -
                    m7: 1, m7 - m8: 1, m8 - m9: 1, m9 - m10: 1 },
                contact: m10 - wall,
                excitation: m1,
            } [limits, motion(m1)]
            plain struct Base10 10 9 {
                masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1 },
                springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 -
                    m7: 1, m7 - m8: 1, m8 - m9: 1, m9 - m10: 1 },
                contact: m1 - base,
                excitation: base,
            } [limits, motion(m10)]
            plain struct Pair10 10 9 {
                masses: { m1: 1, m2: 1, m3: 1, m4: 1, m5: 1, m6: 1, m7: 1, m8: 1, m9: 1, m10: 1 },
                springs: { base - m1: 1, m1 - m2: 1, m2 - m3: 1, m3 - m4: 1, m4 - m5: 1, m5 - m6: 1, m6 -
                    m7: 1, m7 - m8: 1, m8 - m9: 1, m9 - m10: 1 },
                contact: m1 - m2,
                excitation: m10,
            } [limits, motion(m10)]
        }
    };
}

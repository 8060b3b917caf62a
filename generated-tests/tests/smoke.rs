use frictiongen::friction_system;
friction_system! {
    /// Two-storey shear frame; a brass disc rubs on the upper floor.
    pub struct Frame {
        masses: { lower: 3.27, upper: 3.25 },
        springs: { base - lower: 1190.0, lower - upper: 1323.0 },
        contact: upper - wall,
        excitation: base,
        damping: modal[0.010, 0.012],
        stiction: 1.2,
        provide: [limits, motion, stuck],
    }
}
friction_system! {
    struct Block { masses: { block: 1.0 }, springs: { base - block: 1.0 }, contact: block - wall, excitation: block }
}
friction_system! {
    struct Five { masses: { a: 1.0, b:1, c:1, d:1,e:1 }, springs: { base - a: 1.0, a-b:1,b-c:1,c-d:1,d-e:1 }, contact: a - wall, excitation: a, damping: modal(0.01), provide: [limits, motion, stuck], scalar: f32 }
}
#[test]
fn smoke() {
    let at = Frame::at(0.9).unwrap();
    println!("{} {}", at.continuous_limit(), at.sliding_limit());
    let m = at.motion(0.1).unwrap();
    println!(
        "{} {} {:?}",
        m.contact().amplitude(),
        m.lower().amplitude(),
        at.stuck().unwrap().lower()
    );
    let at = Block::at(0.9).unwrap();
    println!("{} {}", at.continuous_limit(), at.sliding_limit());
    println!("{}", at.motion(0.2).unwrap().block().displacement(1.0));
    let at = Five::at(0.9).unwrap();
    println!("{} {}", at.continuous_limit(), at.sliding_limit());
    println!(
        "{} {:?}",
        at.motion(0.1).unwrap().c().amplitude(),
        at.stuck().unwrap().c()
    );
}

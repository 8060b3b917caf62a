frictiongen::friction_system! {
    struct Bare {
        masses: { a: 1, b: 1 },
        springs: { base - a: 1, a - b: 1 },
        contact: b - wall,
        excitation: a,
        provide: [limits],
    }
}

frictiongen::friction_system! {
    struct One {
        masses: { a: 1, b: 1 },
        springs: { base - a: 1, a - b: 1 },
        contact: b - wall,
        excitation: a,
        provide: [motion(a)],
    }
}

frictiongen::friction_system! {
    struct Stepped {
        masses: { a: 1, b: 1 },
        springs: { base - a: 1, a - b: 1 },
        contact: b - wall,
        excitation: a,
        provide: [stepper],
    }
}

fn asked() -> Result<f64, frictiongen::Error> {
    let at = Bare::at(0.3)?;
    let state = (&[0.0, 0.0], &[0.0, 0.0]);
    let first = at.motion(0.4)?.a().amplitude();
    let second = at.orbit(0.4)?.a().amplitude();
    let third = at.orbit_from(0.4, state)?.a().amplitude();
    let fourth = at.stuck()?.a().re;
    let mut run = Bare::simulation(0.3, 0.4)?;
    let fifth = run.advance(0.1)?.length;
    let sixth = Bare::simulation_from(0.3, 0.4, state)?.a().displacement();
    let seventh = One::at(0.3)?.motion(0.01)?.b().amplitude();
    let eighth = Bare::stepper(0.1)?.a().displacement();
    let ninth = Bare::stepper_from(0.1, state)?.a().displacement();
    let tenth = Stepped::at(0.3)?.continuous_limit() + eighth + ninth;
    let _ = Bare::self_check();
    Ok(tenth + first + second + third + fourth + fifth + sixth + seventh)
}

fn main() {
    let _ = asked();
}

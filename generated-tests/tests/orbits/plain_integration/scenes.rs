//! The compared scenes, each as matrices written by hand and as a description.

use crate::plain_integration::equations::Chain;

/// Returns the matrices and the description of three masses of 2, 3 and 1.5 kg on springs of 50, 40, 60 and 20 N/m,
/// with a contact on the wall. The mass ratios γ and stiffness ratios κ are written by hand.
pub fn on_wall(damped: bool) -> (Chain, &'static str) {
    let k = [[1.8, -0.8, 0.0], [-0.8, 2.0, -1.2], [0.0, -1.2, 1.6]];
    let gamma = [1.0, 1.5, 0.75];
    let r = 0.9;
    let mut chain = Chain {
        n: 3,
        gamma,
        c: [[0.0; 3]; 3],
        k,
        w: [0.0, 1.0, 0.0],
        p: [1.0, 0.0, 0.0],
        s: 0.0,
        mu: 1.0,
        r,
        beta: 0.35,
    };
    if !damped {
        return (
            chain,
            "struct Wall { masses: { a: 2, b: 3, c: 1.5 },
             springs: { base - a: 50, a - b: 40, b - c: 60, c - wall: 20 },
             contact: b - wall, excitation: a }",
        );
    }
    // C = aM + bK with a = 0.4/s, b = 0.03 s and ω = r√(k₁/m₁) = 5r rad/s gives C̄ = ωC/k₁ = ω(a m₁Γ/k₁ + bK̄).
    let omega = 5.0 * r;
    for i in 0..3 {
        for j in 0..3 {
            let mass = if i == j {
                0.4 * 2.0 / 50.0 * gamma[i]
            } else {
                0.0
            };
            chain.c[i][j] = omega * (mass + 0.03 * k[i][j]);
        }
    }
    chain.mu = 1.5;
    chain.beta = 0.2;
    (
        chain,
        "struct Wall { masses: { a: 2, b: 3, c: 1.5 },
         springs: { base - a: 50, a - b: 40, b - c: 60, c - wall: 20 },
         contact: b - wall, excitation: a, damping: rayleigh(0.4, 0.03), stiction: 1.5 }",
    )
}

/// Returns the matrices and the description of a scene on the moving base, with the names of its masses. Undamped, it
/// has masses of 0.8 and 2 kg on springs of 100 and 150 N/m. The second mass rubs on the base, and a spring of 30 N/m
/// joins it to the base. Damped, it has one mass.
pub fn on_base(damped: bool) -> (Chain, &'static str, &'static [&'static str]) {
    if !damped {
        let chain = Chain {
            n: 2,
            gamma: [1.0, 2.5, 1.0],
            c: [[0.0; 3]; 3],
            k: [[2.5, -1.5, 0.0], [-1.5, 1.8, 0.0], [0.0; 3]],
            w: [0.0, 1.0, 0.0],
            p: [1.0, 0.3, 0.0],
            s: 1.0,
            mu: 1.3,
            r: 0.7,
            beta: 0.5,
        };
        return (
            chain,
            "struct Moving { masses: { low: 0.8, up: 2 },
             springs: { base - low: 100, low - up: 150, up - base: 30 },
             contact: up - base, excitation: base, stiction: 1.3 }",
            &["low", "up"],
        );
    }
    // The chain has one mode with C̄ = 2ζr, and its damper acts on the absolute velocity.
    let (zeta, r) = (0.12, 1.3);
    let mut c = [[0.0; 3]; 3];
    c[0][0] = 2.0 * zeta * r;
    let chain = Chain {
        n: 1,
        gamma: [1.0; 3],
        c,
        k: [[1.0, 0.0, 0.0], [0.0; 3], [0.0; 3]],
        w: [1.0, 0.0, 0.0],
        p: [1.0, 0.0, 0.0],
        s: 1.0,
        mu: 1.1,
        r,
        beta: 0.6,
    };
    (
        chain,
        "struct Moving { masses: { only: 7 }, springs: { base - only: 250 },
         contact: base - only, excitation: base, damping: modal(0.12), stiction: 1.1 }",
        &["only"],
    )
}

/// Returns the matrices and the description of two masses of 1 and 2 kg on springs of 10 and 15 N/m that rub on each
/// other. The description names the second mass of the contact first.
pub fn on_each_other(damped: bool) -> (Chain, &'static str) {
    let gamma = [1.0, 2.0, 1.0];
    let k = [[2.5, -1.5, 0.0], [-1.5, 1.5, 0.0], [0.0; 3]];
    let r = 1.4;
    let mut chain = Chain {
        n: 2,
        gamma,
        c: [[0.0; 3]; 3],
        k,
        w: [-1.0, 1.0, 0.0],
        p: [1.0, 0.0, 0.0],
        s: 0.0,
        mu: 1.25,
        r,
        beta: 0.3,
    };
    if !damped {
        return (
            chain,
            "struct Pair { masses: { a: 1, b: 2 }, springs: { base - a: 10, a - b: 15 },
             contact: b - a, excitation: a, stiction: 1.25 }",
        );
    }
    // Modal damping is computed by hand: det(K̄ − λΓ) = 2λ² − 6.5λ + 1.5 = 0, and φ ∝ (1.5, 2.5 − λ).
    for (zeta, sign) in [(0.08, -1.0), (0.03, 1.0)] {
        let lambda = (6.5 + sign * (6.5f64 * 6.5 - 12.0).sqrt()) / 4.0;
        let shape = [1.5, 2.5 - lambda];
        let norm = shape[0] * shape[0] * gamma[0] + shape[1] * shape[1] * gamma[1];
        for i in 0..2 {
            for j in 0..2 {
                let weight = gamma[i] * shape[i] * gamma[j] * shape[j] / norm;
                chain.c[i][j] += 2.0 * zeta * r * lambda.sqrt() * weight;
            }
        }
    }
    (
        chain,
        "struct Pair { masses: { a: 1, b: 2 }, springs: { base - a: 10, a - b: 15 },
         contact: b - a, excitation: a, damping: modal[0.08, 0.03], stiction: 1.25 }",
    )
}

//! Compares natural frequencies and mode shapes with two general eigensolvers.
//!
//! nalgebra and faer get the matrix Γ^−½ K̄ Γ^−½. The test builds it from the numbers that also form the text of the
//! scene. The coefficients lie within two decades. In a wider range the general solvers lose digits of the slow
//! modes, but not this project.

use frictiongen::study::System;
use std::fmt::Write as _;

/// Number that stands for the base of the chain in place of the index of a mass.
const BASE: usize = usize::MAX;
const WALL: usize = usize::MAX - 1;

struct Case {
    masses: &'static [f64],
    springs: &'static [(usize, usize, f64)],
}

/// The compared chains, trees and loops, with one, two or many supports.
const CASES: [Case; 7] = [
    // A shear frame.
    Case {
        masses: &[3.27, 3.25],
        springs: &[(BASE, 0, 1190.0), (0, 1, 1323.0)],
    },
    // Supported at both ends. The first mass and spring are neither the largest nor 1.
    Case {
        masses: &[0.4, 7.5, 2.2],
        springs: &[(BASE, 0, 35.0), (0, 1, 410.0), (1, 2, 96.0), (2, WALL, 8.5)],
    },
    // A ring of four masses, one of which is also joined to the wall.
    Case {
        masses: &[1.1, 2.3, 0.9, 4.7],
        springs: &[
            (0, WALL, 12.0),
            (0, 1, 7.0),
            (1, 2, 31.0),
            (2, 3, 5.5),
            (0, 3, 19.0),
        ],
    },
    // A star about the middle mass. Every arm also has a support.
    Case {
        masses: &[5.0, 1.3, 2.9, 0.7, 3.1],
        springs: &[
            (0, 1, 21.0),
            (2, 0, 3.0),
            (0, 3, 40.0),
            (4, 0, 11.0),
            (BASE, 1, 2.0),
            (WALL, 2, 17.0),
            (3, BASE, 60.0),
            (4, WALL, 0.9),
        ],
    },
    // A long chain with a free end, whose reference spring is not its first link.
    Case {
        masses: &[2.0, 1.5, 6.0, 1.0, 3.7, 4.0, 0.8],
        springs: &[
            (3, 2, 90.0),
            (BASE, 0, 150.0),
            (0, 1, 82.0),
            (1, 2, 170.0),
            (3, 4, 105.0),
            (4, 5, 310.0),
            (5, 6, 46.0),
        ],
    },
    // Four masses, each joined by a spring with every other mass, and one support: a full K̄.
    Case {
        masses: &[1.0, 1.7, 0.6, 2.4],
        springs: &[
            (BASE, 2, 1.0),
            (0, 1, 2.5),
            (0, 2, 0.4),
            (0, 3, 1.9),
            (1, 2, 3.3),
            (1, 3, 0.7),
            (2, 3, 5.1),
        ],
    },
    // A ladder of ten masses, supported by the base at one corner and by the wall at the other.
    Case {
        masses: &[1.0, 1.3, 0.7, 2.1, 5.2, 0.3, 1.9, 8.8, 3.4, 0.9],
        springs: &[
            (BASE, 0, 4.0),
            (0, 1, 9.0),
            (1, 2, 2.2),
            (2, 3, 14.0),
            (3, 4, 6.1),
            (5, 6, 0.8),
            (6, 7, 33.0),
            (7, 8, 5.0),
            (8, 9, 1.6),
            (0, 5, 3.0),
            (1, 6, 7.7),
            (2, 7, 0.5),
            (3, 8, 12.0),
            (4, 9, 2.9),
            (9, WALL, 20.0),
        ],
    },
];

impl Case {
    fn system(&self) -> System {
        let mut text = String::from("struct Case { masses: { ");
        for (i, mass) in self.masses.iter().enumerate() {
            write!(text, "m{i}: {mass:?}, ").unwrap();
        }
        text.push_str("}, springs: { ");
        let name = |node: usize| match node {
            BASE => String::from("base"),
            WALL => String::from("wall"),
            mass => format!("m{mass}"),
        };
        for (from, to, stiffness) in self.springs {
            write!(text, "{} - {}: {stiffness:?}, ", name(*from), name(*to)).unwrap();
        }
        text.push_str("}, contact: m0 - wall, excitation: m1 }");
        text.parse()
            .unwrap_or_else(|error| panic!("{error}\n{text}"))
    }

    /// Returns the non-dimensional stiffness matrix K̄ of the case, row by row.
    fn stiffness(&self) -> Vec<Vec<f64>> {
        let n = self.masses.len();
        let mut k = vec![vec![0.0; n]; n];
        for &(from, to, stiffness) in self.springs {
            let kappa = stiffness / self.springs[0].2;
            for node in [from, to] {
                if node < n {
                    k[node][node] += kappa;
                }
            }
            if from < n && to < n {
                k[from][to] -= kappa;
                k[to][from] -= kappa;
            }
        }
        k
    }

    fn gamma(&self) -> Vec<f64> {
        self.masses
            .iter()
            .map(|mass| mass / self.masses[0])
            .collect()
    }

    fn scaled(&self) -> Vec<Vec<f64>> {
        let (gamma, mut k) = (self.gamma(), self.stiffness());
        for (i, row) in k.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                *value /= (gamma[i] * gamma[j]).sqrt();
            }
        }
        k
    }
}

/// Eigenvalues in ascending order, each with its unit eigenvector.
type Pairs = Vec<(f64, Vec<f64>)>;

fn sorted(mut pairs: Pairs) -> Pairs {
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
    pairs
}

fn by_nalgebra(a: &[Vec<f64>]) -> Pairs {
    let n = a.len();
    let eigen = nalgebra::SymmetricEigen::new(nalgebra::DMatrix::from_fn(n, n, |i, j| a[i][j]));
    let column = |i| eigen.eigenvectors.column(i).iter().copied().collect();
    sorted((0..n).map(|i| (eigen.eigenvalues[i], column(i))).collect())
}

fn by_faer(a: &[Vec<f64>]) -> Pairs {
    let n = a.len();
    let matrix = faer::Mat::from_fn(n, n, |i, j| a[i][j]);
    let eigen = matrix.self_adjoint_eigen(faer::Side::Lower).unwrap();
    let (values, vectors) = (eigen.S().column_vector(), eigen.U());
    sorted(
        (0..n)
            .map(|i| (values[i], (0..n).map(|k| vectors[(k, i)]).collect()))
            .collect(),
    )
}

/// Compares all frequencies and all components of the mode shapes of a case. Returns the number of comparisons.
fn compare(case: &Case, label: &str, pairs: &Pairs) -> usize {
    let system = case.system();
    let gamma = case.gamma();
    let n = gamma.len();
    let shapes = system.mode_shapes();
    let reference = (case.springs[0].2 / case.masses[0]).sqrt();
    assert_eq!((system.resonances().len(), shapes.len()), (n, n));
    let largest = pairs[n - 1].0;
    assert_eq!(pairs.len(), n);
    let mut compared = 0;
    for (i, (lambda, vector)) in pairs.iter().enumerate() {
        // A backward stable solver shifts every eigenvalue by a few units of ε‖A‖. The frequency shifts by half of
        // that, over λ. 1e-12 is enough for all cases, whose λ spread over less than 10³.
        let backward = 4.0 * n as f64 * f64::EPSILON * largest;
        let tolerance = (0.5 * backward / lambda).max(1e-13);
        assert!(
            tolerance < 1e-12,
            "{label}: mode {i} is too slow for this comparison: {tolerance:e}"
        );
        let resonance = lambda.sqrt();
        let error = system.resonances()[i] / resonance - 1.0;
        assert!(
            error.abs() < tolerance,
            "{label}: resonance {i} {resonance} off by {error:e}"
        );
        let error = system.natural_frequencies()[i] / (resonance * reference) - 1.0;
        assert!(
            error.abs() < tolerance,
            "{label}: frequency {i} off by {error:e}"
        );

        // A vector turns by the same backward error over the gap of its eigenvalue. 1e-10 leaves two digits of margin.
        let gap = pairs
            .iter()
            .enumerate()
            .filter(|(j, _)| *j != i)
            .fold(f64::INFINITY, |gap, (_, pair)| {
                gap.min((pair.0 - lambda).abs())
            });
        assert!(backward / gap < 1e-11, "{label}: mode {i} is not separated");
        let shape: Vec<f64> = vector
            .iter()
            .zip(&gamma)
            .map(|(q, gamma)| q / gamma.sqrt())
            .collect();
        let along: f64 = (0..n).map(|k| shape[k] * gamma[k] * shapes[i][k]).sum();
        for k in 0..n {
            let error = shapes[i][k] - shape[k].copysign(shape[k] * along);
            assert!(
                error.abs() < 1e-10,
                "{label}: shape {i} of mass {k} off by {error:e}"
            );
            compared += 1;
        }
        compared += 2;
    }
    compared
}

/// Number of components of the mode shapes of all cases: the sum of N² with N masses each.
const COMPONENTS: usize = 2 * 2 + 3 * 3 + 4 * 4 + 5 * 5 + 7 * 7 + 4 * 4 + 10 * 10;
/// Number of comparisons: all components, and 35 frequencies, each as a ratio and in rad/s.
const COMPARED: usize = 2 * 35 + COMPONENTS;

fn agrees(with: &str, solve: fn(&[Vec<f64>]) -> Pairs) {
    let cases = CASES.iter().enumerate();
    let compared: usize = cases
        .map(|(index, case)| compare(case, &format!("case {index}"), &solve(&case.scaled())))
        .sum();
    println!("{with}: {compared} compared, none skipped");
    assert_eq!(compared, COMPARED);
}

#[test]
fn nalgebra_agrees() {
    agrees("nalgebra", by_nalgebra);
}

#[test]
fn faer_agrees() {
    agrees("faer", by_faer);
}

/// Checks K̄φ = λΓφ and φᵀΓφ = 1 for every mode, to a few roundings. No rounding of another solver affects this
/// check.
#[test]
fn modes_satisfy_their_equation() {
    let (mut residuals, mut products) = (0, 0);
    for (index, case) in CASES.iter().enumerate() {
        let (system, gamma, k) = (case.system(), case.gamma(), case.stiffness());
        let shapes = system.mode_shapes();
        for (i, shape) in shapes.iter().enumerate() {
            let lambda = system.resonances()[i] * system.resonances()[i];
            for (row, gamma) in k
                .iter()
                .zip(&gamma)
                .zip(shape)
                .map(|((row, gamma), phi)| (row, gamma * phi))
            {
                let size: f64 = row.iter().zip(shape).map(|(k, phi)| (k * phi).abs()).sum();
                let residual: f64 =
                    row.iter().zip(shape).map(|(k, phi)| k * phi).sum::<f64>() - lambda * gamma;
                // The entries of K̄ are rounded here, once per spring.
                let tolerance = 16.0 * f64::EPSILON * (size + lambda * gamma.abs());
                assert!(
                    residual.abs() <= tolerance,
                    "case {index}, mode {i}: {residual:e} > {tolerance:e}"
                );
                residuals += 1;
            }
            for (j, other) in shapes.iter().enumerate() {
                let product: f64 = (0..gamma.len())
                    .map(|m| shape[m] * gamma[m] * other[m])
                    .sum();
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!(
                    (product - expected).abs() < 1e-14,
                    "case {index}, modes {i} and {j}: {product}"
                );
                products += 1;
            }
        }
    }
    println!("{residuals} residuals and {products} products compared, none skipped");
    assert_eq!((residuals, products), (COMPONENTS, COMPONENTS));
}

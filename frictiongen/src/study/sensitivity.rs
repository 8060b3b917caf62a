//! Sensitivities: exact derivatives of every result with respect to a number of the scene description. To compute them,
//! the code evaluates the formulas with dual numbers.

pub use super::parameter::{OperatingPoint, Parameter, Slope};
pub use super::physical::{ParameterSensitivity, ResponseSensitivities};
pub use super::varied::{Sensitive, Varied};
pub use frictiongen_kernel::orbit::NoDerivative;
pub use frictiongen_model::sensitivity::Quantity;

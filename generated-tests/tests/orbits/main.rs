//! Tests steady states with stick-slip, their derivatives, and the backward error of every answer.

mod backward;
mod sensitivities;
mod stick_slip;

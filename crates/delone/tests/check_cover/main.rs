//! The verifier of covers: right ones pass, their numbers are right, and each way of being wrong is found and named.

mod cover;
mod judge;
mod random;
mod right;
mod special;
mod wrong;

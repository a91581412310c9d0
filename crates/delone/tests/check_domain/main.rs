//! The verifier of domains: right triangulations pass, and each way of being wrong is found and
//! named.

#[macro_use]
mod claim;
mod long;
mod random;
mod right;
mod wrong;

//! The verifier of domains: right triangulations pass, and each way of being wrong is found and
//! named.

#[macro_use]
mod claim;
mod long;
mod mesh;
mod quality;
mod random;
mod reached;
mod refined;
mod right;
mod wrong;

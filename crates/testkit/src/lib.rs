//! Oracles and data that only tests use.

pub mod claims;
pub mod corpus;
pub mod cover;
pub mod data;
pub mod domains;
pub mod fuzz;
pub mod generate;
pub mod naive;
pub mod refined;

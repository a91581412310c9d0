//! Oracles and data that only tests use.

pub mod corpus;

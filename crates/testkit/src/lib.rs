//! Oracles and data that only tests use.

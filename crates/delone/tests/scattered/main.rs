//! Triangulations made for data: what they promise, on every kind of data.

mod alone;
mod chapter;
mod claims;
mod cover;
mod edges;
mod properties;

//! Triangulations made for data: what they promise, on every kind of data.

mod cover;
mod edges;

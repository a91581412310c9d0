//! Weighted points: regular triangulation and power diagram.

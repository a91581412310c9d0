//! Nearest neighbours: the nearest vertex, the k nearest, and all within a radius.

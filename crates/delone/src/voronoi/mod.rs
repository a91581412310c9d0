//! The Voronoi diagram: cells, clipped to boxes and polygons, and Lloyd's relaxation.

//! Surfaces over a triangulation: interpolants, gradients, rasters and contour lines.

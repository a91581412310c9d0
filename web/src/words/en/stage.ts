// The stage.

export const stage = {
  label: "The stage: points, edges and triangles",
  fit: "Fit",
  zoomIn: "Zoom in",
  zoomOut: "Zoom out",
};

// The stage.

export const stage = {
  label: "The stage: points, edges and triangles",
  keys: "Arrow keys move the view, with Shift farther; plus and minus zoom, zero shows everything.",
  view: "View",
  fit: "Fit",
  zoomIn: "Zoom in",
  zoomOut: "Zoom out",
};

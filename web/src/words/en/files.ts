// Files: opening and saving.

export const files = {
  open: "Open a file …",
  save: "Save …",
  dropHere: "Drop files here to open them",
};

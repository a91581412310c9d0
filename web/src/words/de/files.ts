// Files: opening and saving.

import type { Words } from "..";

export const files: Words["files"] = {
  open: "Datei öffnen …",
  save: "Speichern …",
  dropHere: "Dateien hier ablegen, um sie zu öffnen",
};

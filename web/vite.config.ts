// How the page is built: everything relative, so that any folder of any static host will do.

import { defineConfig, type Plugin } from "vite";
import { guide } from "./guide/plugin.ts";
import { offline } from "./offline/plugin.ts";

/** What keeps `dist/` in the repository, and its content out: `delone-cli` looks at the folder when it is built. */
const keeper: Plugin = {
  name: "delone-keeper",
  generateBundle() {
    this.emitFile({ type: "asset", fileName: ".gitignore", source: "*\n!.gitignore\n" });
  },
};

export default defineConfig({
  base: "./",
  build: {
    target: "es2022",
    // Nothing inlined: the content security policy allows no data: scripts, and the module must stay a file.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  worker: { format: "es" },
  plugins: [guide(), offline(), keeper],
});

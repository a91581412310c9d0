// How the page is built: everything relative, so that any folder of any static host will do.

import { defineConfig } from "vite";
import { guide } from "./guide/plugin.ts";

export default defineConfig({
  base: "./",
  build: {
    target: "es2022",
    // The folder holds a committed .gitignore; whoever builds removes old files (`delone-web-build` does).
    emptyOutDir: false,
    // Nothing inlined: the content security policy allows no data: scripts, and the module must stay a file.
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
  },
  worker: { format: "es" },
  plugins: [guide()],
});

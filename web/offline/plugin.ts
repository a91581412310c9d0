// Writes the service worker of a build: `worker.js`, told which files there are to keep.

import { createHash } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import type { Plugin } from "vite";

const source = join(import.meta.dirname, "worker.js");

/** Makes the service worker part of the build. The guide is kept page by page, as it is read. */
export function offline(): Plugin {
  let publicDir = "";
  return {
    name: "delone-offline",
    apply: "build",
    enforce: "post",
    configResolved(config) {
      publicDir = config.publicDir;
    },
    generateBundle: {
      order: "post",
      handler(_, bundle) {
        const built = Object.values(bundle)
          .filter(({ fileName }) => !/^(guide\/|\.)/.test(fileName))
          .map((file) => [file.fileName, file.type === "chunk" ? file.code : file.source] as const);
        const beside = readdirSync(publicDir).map(
          (name) => [name, readFileSync(join(publicDir, name))] as const,
        );
        this.emitFile({ type: "asset", fileName: "sw.js", source: told([...built, ...beside]) });
      },
    },
  };
}

/** Returns the service worker that keeps these files; another one if any of them is another. */
function told(files: (readonly [name: string, content: string | Uint8Array])[]): string {
  const sorted = files.toSorted(([a], [b]) => (a < b ? -1 : 1));
  const hash = createHash("sha256");
  for (const [name, content] of sorted) hash.update(`${name}\n`).update(content);
  const kept = {
    version: hash.digest("hex").slice(0, 16),
    files: sorted.map(([name]) => (name === "index.html" ? "./" : name)),
  };
  return readFileSync(source, "utf8").replace('"__KEPT__"', JSON.stringify(kept));
}

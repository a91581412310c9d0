// The guide of the algorithms as pages beside the theatre: `docs/algorithms/*.md` become `guide/*.html`, with their
// pictures, when the page is built or served.

import { existsSync, readdirSync, readFileSync } from "node:fs";
import { basename, extname, join, resolve } from "node:path";
import type { Plugin } from "vite";
import { pageOf } from "./page.ts";

const docs = resolve(import.meta.dirname, "../../docs/algorithms");
const references = resolve(import.meta.dirname, "../../REFERENCES.md");
const style = join(import.meta.dirname, "guide.css");

const types: Record<string, string> = {
  ".html": "text/html; charset=utf-8",
  ".css": "text/css",
  ".png": "image/png",
  ".svg": "image/svg+xml",
};

/** Makes the pages of the guide part of the build. */
export function guide(): Plugin {
  return {
    name: "delone-guide",
    generateBundle() {
      for (const fileName of names()) {
        this.emitFile({ type: "asset", fileName: `guide/${fileName}`, source: contentOf(fileName)! });
      }
    },
    configureServer(server) {
      server.middlewares.use("/guide/", (request, response, next) => {
        const name = decodeURIComponent((request.url ?? "").slice(1).replace(/[?#].*$/, ""));
        const content = names().includes(name) ? contentOf(name) : undefined;
        if (content === undefined) return next();
        response.setHeader("Content-Type", types[extname(name)] ?? "application/octet-stream");
        response.end(content);
      });
    },
  };
}

/** Lists the files of the guide, as they are called below `guide/`. */
function names(): string[] {
  const pages = readdirSync(docs).filter((name) => name.endsWith(".md"));
  const pictures = readdirSync(join(docs, "pictures")).map((name) => `pictures/${name}`);
  return [...pages.map(htmlName), "references.html", "guide.css", ...pictures];
}

const htmlName = (markdown: string): string =>
  markdown === "README.md" ? "index.html" : markdown.replace(/\.md$/, ".html");

function contentOf(name: string): string | Uint8Array | undefined {
  if (name === "guide.css") return readFileSync(style);
  if (name === "references.html") return pageOf(readFileSync(references, "utf8"), null);
  if (name.startsWith("pictures/")) return readFileSync(join(docs, name));
  const page = basename(name, ".html");
  const file = join(docs, page === "index" ? "README.md" : `${page}.md`);
  if (!existsSync(file)) return undefined;
  const isAlgorithm = page !== "index" && page !== "log-format";
  return pageOf(readFileSync(file, "utf8"), isAlgorithm ? page : null);
}

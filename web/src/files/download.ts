// Files on their way to the visitor's machine.

import type { NamedBytes } from "../engine/protocol";

const types: Record<string, string> = {
  zip: "application/zip",
  png: "image/png",
  gif: "image/gif",
  svg: "image/svg+xml",
  html: "text/html",
  webm: "video/webm",
  mp4: "video/mp4",
};

/** Browsers that get several files at once keep the last alone. */
const PAUSE = 200;

/** Hands files to the browser, which keeps them. */
export async function download(files: NamedBytes[]): Promise<void> {
  for (const [i, { name, bytes }] of files.entries()) {
    if (i > 0) await new Promise((go) => setTimeout(go, PAUSE));
    const type = types[name.replace(/^.*\./, "")] ?? "application/octet-stream";
    const url = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>], { type }));
    const link = document.createElement("a");
    Object.assign(link, { href: url, download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(url), 60_000);
  }
}

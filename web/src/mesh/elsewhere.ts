// What the page has elsewhere, or will have: saving, and looking at a place.

import { mesher } from "../engine/client";
import type { NamedBytes } from "../engine/protocol";
import { drawingName } from "../state/drawing";
import { work } from "../state/job";

/** Saves the mesh. */
export async function saveMesh(extension: string): Promise<void> {
  const name = `${drawingName.peek()}.${extension}`;
  const files = await work(mesher, "save", (engine) => engine.meshes.save(name, {}));
  for (const file of files ?? []) hand(file);
}

/** Saves the report. */
export async function saveReport(headline: string): Promise<void> {
  const name = `${drawingName.peek()}.html`;
  const files = await work(mesher, "save", (engine) => engine.meshes.saveReport(name, headline));
  for (const file of files ?? []) hand(file);
}

function hand({ name, bytes }: NamedBytes): void {
  const url = URL.createObjectURL(new Blob([bytes as Uint8Array<ArrayBuffer>]));
  Object.assign(document.createElement("a"), { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}

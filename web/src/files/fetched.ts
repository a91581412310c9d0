// Files that the address names, from beside the page.

import type { NamedBytes, Source } from "../engine/protocol";
import { tell } from "../state/notices";
import { words } from "../words";
import { openNamed } from "./open";

/** From which names a drawing was fetched: enough to find it again. */
const origins = new WeakMap<Source, string[]>();

/** Returns the names from which a drawing was fetched, if it was. */
export const originOf = (source: Source): string[] | undefined => origins.get(source);

/** Fetches files from beside the page and opens them; returns whether that went well. */
export async function openFetched(names: string[], mine: object): Promise<boolean> {
  try {
    const files = await Promise.all(names.map(fetchNamed));
    return await openNamed(files, mine, (source) => origins.set(source, names));
  } catch (error) {
    tell(error);
    return false;
  }
}

async function fetchNamed(name: string): Promise<NamedBytes> {
  const say = words.peek().files;
  const path = name.split("/").map(encodeURIComponent).join("/");
  const url = new URL(path, new URL(".", location.href));
  if (url.origin !== location.origin) throw new Error(say.elsewhere(name));
  const answer = await fetch(url).catch(() => null);
  // Some servers give a page for whatever they do not have.
  const isPage = answer?.headers.get("content-type")?.startsWith("text/html");
  if (!answer?.ok || isPage) throw new Error(say.missing(name));
  return { name: name.replace(/^.*\//, ""), bytes: new Uint8Array(await answer.arrayBuffer()) };
}

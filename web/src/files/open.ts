// Opening files: chosen, dropped, pasted, or named in the address.

import { stage } from "../engine/client";
import type { DrawingData, Format, NamedBytes, Source } from "../engine/protocol";
import { drawing, giveUp, open, wish } from "../state/drawing";
import { notify, tell } from "../state/notices";
import { playLog } from "../state/play";
import { words } from "../words";
import { arrange } from "./arrange";
import { nameOfText } from "./text";

/** How much of a file is looked at to know what it is. */
const HEAD = 1 << 16;

/** Opens files of the visitor's machine. */
export async function openFiles(list: Iterable<File>): Promise<boolean> {
  const files = [...list];
  if (files.length === 0) return false;
  const mine = wish();
  try {
    const read = async (file: File) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) });
    return await openNamed(await Promise.all(files.map(read)), mine);
  } catch {
    const names = files.map(({ name }) => name).join(", ");
    notify("error", words.peek().files.unreadable(names));
    await giveUp(mine);
    return false;
  }
}

/** Opens text as a file of its format. */
export function openText(text: string): Promise<boolean> {
  return openNamed([{ name: nameOfText(text), bytes: new TextEncoder().encode(text) }]);
}

/** Opens files: a log is played, all else is drawn. Returns whether that went well; what is wrong is shown. */
export async function openNamed(
  all: NamedBytes[],
  mine = wish(),
  opened: (source: Source) => void = () => {},
): Promise<boolean> {
  const { files, left } = arrange(all);
  try {
    const [main] = files;
    if (main.bytes.length === 0) throw new Error(words.peek().files.empty(main.name));
    const head = { name: main.name, bytes: main.bytes.slice(0, HEAD) };
    const kind = await stage.insist((engine) => engine.drawings.kind(head));
    if (kind === "unknown") throw new Error(words.peek().files.unknown(main.name, await readable()));
    if (left.length > 0) notify("info", words.peek().files.leftOut(main.name, left.join(", ")));
    if (kind === "log") return await playLog(main);
    const source: Source = { kind: "files", files };
    opened(source);
    if (!(await open(source, mine))) return false;
    if (isEmpty(drawing.peek()!)) notify("info", words.peek().files.nothing(main.name));
    return true;
  } catch (error) {
    tell(error);
    await giveUp(mine);
    return false;
  }
}

const isEmpty = ({ points, holes, regions }: DrawingData): boolean =>
  points.length + holes.length + regions.length === 0;

/** Lists what can be opened, by extension. */
export async function readable(): Promise<string> {
  const formats: Format[] = await stage.insist((engine) => engine.drawings.formats());
  const names = formats.filter(({ reads }) => reads).flatMap(({ extensions }) => extensions);
  return [...new Set(names)].map((name) => `.${name}`).join(", ");
}

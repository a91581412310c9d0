// The table of all algorithms: its columns, its order, and how it is written for other programs.

import type { Entry } from "../state/compare";
import { testsOf } from "./racing";

/** The numbers of a row; null where there are none. */
export const columns = {
  tests: ({ measured }: Entry) => (measured ? testsOf(measured.tally) : null),
  steps: ({ measured }: Entry) => measured?.tally.steps ?? null,
  flips: ({ measured }: Entry) => measured?.tally.flips ?? null,
  orientationTests: ({ measured }: Entry) => measured?.tally.orientationTests ?? null,
  circleTests: ({ measured }: Entry) => measured?.tally.circleTests ?? null,
  trianglesCreated: ({ measured }: Entry) => measured?.tally.trianglesCreated ?? null,
  milliseconds: ({ measured }: Entry) => measured?.milliseconds ?? null,
} as const;

export type Column = keyof typeof columns;

export const columnNames = Object.keys(columns) as Column[];

/** What rows are sorted by: a column, or the title. */
export interface Order {
  by: Column | "title";
  isDown: boolean;
}

/** Sorts rows; those without numbers come last, equals stay as they are. */
export function sorted(entries: Entry[], { by, isDown }: Order): Entry[] {
  const sign = isDown ? -1 : 1;
  return entries.toSorted((a, b) => {
    if (by === "title") return sign * a.title.localeCompare(b.title);
    const [x, y] = [columns[by](a), columns[by](b)];
    if (x === null || y === null) return Number(x === null) - Number(y === null);
    return sign * (x - y);
  });
}

/** Writes rows as CSV, with a head: names and numbers as programs read them. */
export function toCsv(entries: Entry[]): string {
  const head = ["algorithm", ...columnNames, "hash", "error"];
  const rows = entries.map((entry) => [
    entry.name,
    ...columnNames.map((name) => columns[name](entry) ?? ""),
    entry.measured?.hash ?? "",
    entry.error,
  ]);
  return `${[head, ...rows].map((row) => row.map(cell).join(",")).join("\n")}\n`;
}

function cell(value: string | number): string {
  const text = String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

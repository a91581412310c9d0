import { expect, test } from "vitest";
import type { Tally } from "../engine/protocol";
import type { Entry } from "../state/compare";
import { columns, sorted, toCsv } from "./columns";

const entry = (name: string, steps: number | null, error = ""): Entry => ({
  name,
  title: name.toUpperCase(),
  measured:
    steps === null
      ? null
      : {
          algorithm: name,
          tally: { steps, orientationTests: 2, circleTests: 3, flips: 0, trianglesCreated: 1 } as Tally,
          hash: "ab",
          milliseconds: 0.5,
        },
  error,
});
const all = [entry("b", 3), entry("c", null, 'too "many", really'), entry("a", 5), entry("d", 3)];
const names = (entries: Entry[]) => entries.map(({ name }) => name).join("");

test("rows are sorted by any column, those without numbers last", () => {
  expect(names(sorted(all, { by: "steps", isDown: false }))).toBe("bdac");
  expect(names(sorted(all, { by: "steps", isDown: true }))).toBe("abdc");
  expect(names(sorted(all, { by: "title", isDown: false }))).toBe("abcd");
  expect(columns.tests(all[0])).toBe(5);
  expect(columns.tests(all[1])).toBeNull();
});

test("other programs can read the table", () => {
  expect(toCsv(all.slice(0, 2))).toBe(
    "algorithm,tests,steps,flips,orientationTests,circleTests,trianglesCreated,milliseconds,hash,error\n" +
      "b,5,3,0,2,3,1,0.5,ab,\n" +
      'c,,,,,,,,,"too ""many"", really"\n',
  );
});

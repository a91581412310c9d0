// Where the page keeps itself.

import { expect, test } from "vitest";
import { keepsItself } from "./offline";

test.each([
  ["https:", "example.org", true],
  ["http:", "localhost", true],
  ["http:", "127.0.0.1", false],
  ["http:", "example.org", false],
])("%s//%s: %s", (protocol, hostname, expected) => {
  expect(keepsItself({ protocol, hostname })).toBe(expected);
});

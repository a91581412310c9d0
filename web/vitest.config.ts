// Two kinds of tests: of pieces, beside them; and of the built page, in a real browser. And what takes its pictures.

import { defineConfig } from "vitest/config";

export default defineConfig({
  test: {
    projects: [
      {
        extends: "./vite.config.ts",
        test: { name: "unit", include: ["{src,guide,tests/module}/**/*.test.ts"] },
      },
      {
        test: {
          name: "browser",
          include: ["tests/browser/**/*.test.ts"],
          // One browser at a time: two cores, and figures of time that mean something.
          fileParallelism: false,
          // A hang shall end it, not a machine that has other things to do, too, and lets what takes seconds take minutes.
          testTimeout: 600_000,
          hookTimeout: 150_000,
          expect: { poll: { timeout: 120_000 } },
          // A browser on a busy machine. A net, no excuse: the reporter tells what was tried twice, and whoever sees a
          // test there mends it, or the page.
          retry: 1,
        },
      },
      {
        test: {
          name: "pictures",
          include: ["tests/pictures.ts"],
          fileParallelism: false,
          testTimeout: 60_000,
          hookTimeout: 60_000,
        },
      },
    ],
  },
});

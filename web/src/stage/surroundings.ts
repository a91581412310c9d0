// What the stage must notice of its surroundings: how fine the screen is, and whether the system is dark.

import { signal } from "@preact/signals";

/** How many pixels of the device a CSS pixel has: other screens and the browser's zoom change it. */
export const ratio = signal(devicePixelRatio);

const dark = matchMedia("(prefers-color-scheme: dark)");

/** Whether the system is dark. */
export const isDark = signal(dark.matches);

dark.addEventListener("change", () => {
  isDark.value = dark.matches;
});

/** Nobody tells of the ratio itself, only that it is another one than now. */
function watch(): void {
  ratio.value = devicePixelRatio;
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", watch, { once: true });
}
watch();

// Which dialog of files is open.

import { signal } from "@preact/signals";

export const dialog = signal<"save" | "paste" | null>(null);

// Which part of the panel is open.

import { signal } from "@preact/signals";

export const tabs = ["options", "quality", "triangle", "export"] as const;

export const tab = signal<(typeof tabs)[number]>("options");

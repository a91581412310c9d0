// The box of tools: which there are, and which is in hand.

import { computed } from "@preact/signals";
import { editBy } from "../../state/drawing";
import { type Tool, tool } from "../tool";
import { remove } from "./edits";
import { erase } from "./erase";
import { holes } from "./holes";
import { points } from "./points";
import { endLine, segments } from "./segments";
import { hovered } from "./under";

/** Names a tool; "view" moves the view, or does what the mode has clicks for. */
export const toolNames = ["view", "points", "segments", "holes", "erase"] as const;
export type ToolName = (typeof toolNames)[number];

/** The key that takes each tool in hand. */
export const toolKeys: Record<ToolName, string> = {
  view: "v",
  points: "p",
  segments: "s",
  holes: "h",
  erase: "e",
};

const drawing: Record<Exclude<ToolName, "view">, Tool> = { points, segments, holes, erase };

/** The tool in hand. */
export const inHand = computed<ToolName>(
  () => toolNames.find((name) => name !== "view" && drawing[name] === tool.value) ?? "view",
);

/** What the mode had in hand before somebody began to draw. */
let resting: Tool | null = null;

/** Takes a tool in hand. */
export function take(name: ToolName): void {
  endLine();
  if (inHand.peek() === "view") resting = tool.peek();
  tool.value = name === "view" ? resting : drawing[name];
}

/** Ends a line that is being drawn, or else lays the tool down; returns whether there was something to end. */
export function stop(): boolean {
  if (endLine()) return true;
  if (inHand.peek() === "view") return false;
  take("view");
  return true;
}

/** Removes what the pointer hovers over, if a tool that draws is in hand. */
export function removeHovered(): void {
  if (inHand.peek() === "view") return;
  void editBy(() => {
    const what = hovered.peek();
    return what ? [remove(what)] : [];
  });
}

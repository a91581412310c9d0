// Keys and clicks while meshes are made: Enter meshes, a click asks about a triangle, arrows go to its neighbours,
// Escape lets go of it.

import { useEffect } from "preact/hooks";
import { bind } from "../app/shortcuts";
import { clicked } from "../stage/tool";
import { jobs } from "../state/job";
import { build } from "../state/mesh";
import { chooseAt, chosen, close, goToward } from "./inspect";

const arrows: Record<string, readonly [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

bind("mesh", "Enter", "build");
for (const arrow of Object.keys(arrows)) bind("mesh", arrow, "neighbour");
bind("mesh", "Escape", "letGo");

/** Listens as long as the panel is there. */
export function useKeys(): void {
  useEffect(() => {
    const click = ({ x, y }: { x: number; y: number }) => void chooseAt(x, y);
    clicked.value = click;
    // Before those that work everywhere.
    document.addEventListener("keydown", press, { capture: true });
    return () => {
      if (clicked.peek() === click) clicked.value = null;
      document.removeEventListener("keydown", press, { capture: true });
    };
  }, []);
}

function press(event: KeyboardEvent): void {
  if (event.ctrlKey || event.metaKey || event.altKey || isTaken(event)) return;
  const action = actionOf(event.key);
  if (!action) return;
  event.preventDefault();
  event.stopPropagation();
  action();
}

function actionOf(key: string): (() => void) | undefined {
  if (key === "Enter") return () => void build();
  if (chosen.peek() === null) return undefined;
  // Work is stopped first.
  if (key === "Escape") return jobs.peek().length > 0 ? undefined : close;
  const arrow = arrows[key];
  return arrow && (() => goToward(arrow));
}

/** Tells whether the key means something where the focus is. */
function isTaken({ key, target }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest("dialog")) return true;
  if (key === "Escape") return false;
  if (key === "Enter") {
    const isElsewhere = target.matches("input, select") && !target.closest(".mesh");
    return isElsewhere || target.matches("button, summary, a, textarea, [role=button]");
  }
  return target.closest("input, select, textarea, [role=tablist], [role=application], [role=group]") !== null;
}

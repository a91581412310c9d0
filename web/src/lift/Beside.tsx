// The stage, and beside it the lifted scene if somebody wants to see it.

import type { ComponentChildren } from "preact";
import { mode } from "../state/mode";
import { isLifted } from "../state/see";
import { Lift } from "./Lift";
import "./lift.css";

export function Beside({ children }: { children: ComponentChildren }) {
  const isShown = isLifted.value && (mode.value === "play" || mode.value === "mesh");
  return (
    <div class={isShown ? "beside two" : "beside"}>
      {children}
      {isShown && <Lift />}
    </div>
  );
}

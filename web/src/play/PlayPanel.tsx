// Which algorithm is played, what it does just now, and what came of it.

import { AlgorithmChoice } from "./AlgorithmChoice";
import { Angles } from "./Angles";
import { Breakpoints } from "./Breakpoints";
import { Code } from "./Code";
import { Curves } from "./Curves";
import { Figures } from "./Figures";
import { Narration } from "./Narration";
import "./play.css";

export function PlayPanel() {
  return (
    <>
      <AlgorithmChoice />
      <Narration />
      <Code />
      <Breakpoints />
      <Curves />
      <Figures />
      <Angles />
    </>
  );
}

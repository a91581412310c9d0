// The page as a tool: what is asked of a mesh, what came of it, why it is so, and how to take it along.

import { drawing } from "../state/drawing";
import { build, mesh } from "../state/mesh";
import { words } from "../words";
import { Export } from "./Export";
import { useKeys } from "./keys";
import { Options } from "./Options";
import { Quality } from "./Quality";
import { Status } from "./Status";
import { Tabs } from "./Tabs";
import { Triangle } from "./Triangle";
import { tab, tabs } from "./tab";
import "./mesh.css";

const contents = { options: Options, quality: Quality, triangle: Triangle, export: Export };

export function MeshPanel() {
  useKeys();
  const say = words.value.mesh;
  const Content = contents[tab.value];
  return (
    <section aria-labelledby="mesh-heading" class="mesh">
      <header class="mesh-head">
        <h2 id="mesh-heading">{say.heading}</h2>
        <form
          onSubmit={(event) => {
            event.preventDefault();
            void build();
          }}
        >
          <button
            type="submit"
            class="mesh-build"
            data-key={say.buildHint}
            aria-keyshortcuts="Enter"
            disabled={!drawing.value}
          >
            {say.build}
          </button>
        </form>
        <Status />
      </header>
      <Tabs
        names={tabs}
        now={tab.value}
        labels={say.tabs}
        label={say.heading}
        onChange={(name) => {
          tab.value = name;
        }}
      >
        <Content key={mesh.value === null ? "none" : "some"} />
      </Tabs>
    </section>
  );
}

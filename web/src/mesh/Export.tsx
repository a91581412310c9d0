// How to take the mesh along: files, its hash, and the command that gives the same.

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { copy } from "../app/clipboard";
import { SaveIcon } from "../app/icons";
import { stage } from "../engine/client";
import type { Preset } from "../engine/protocol";
import { openSave } from "../files/dialogs";
import { drawing } from "../state/drawing";
import { asked, mesh } from "../state/mesh";
import { notify, tell } from "../state/notices";
import { words } from "../words";
import { commandOf } from "./command";

export function Export() {
  const say = words.value.mesh.export;
  const now = mesh.value;
  return (
    <>
      {now ? <Files isRefined={now.kind === "refine"} /> : <p class="quiet">{say.needsMesh}</p>}
      {now && (
        <section aria-labelledby="mesh-hash">
          <h3 id="mesh-hash">{say.hash}</h3>
          <Copyable text={now.hash} hint={say.hashHint} />
        </section>
      )}
      <Command />
    </>
  );
}

function Files({ isRefined }: { isRefined: boolean }) {
  const say = words.value.mesh.export;
  return (
    <section class="mesh-files">
      <button type="button" onClick={() => openSave("mesh")}>
        <SaveIcon /> {say.mesh}
      </button>
      {isRefined && (
        <>
          <button type="button" onClick={() => openSave("report")}>
            <SaveIcon /> {say.report}
          </button>
          <small class="quiet">{say.reportHint}</small>
        </>
      )}
    </section>
  );
}

function Command() {
  const say = words.value.mesh.export;
  const presets = useSignal<Preset[]>([]);
  useEffect(() => {
    stage
      .insist((engine) => engine.drawings.presets())
      .then((all) => {
        presets.value = all;
      }, tell);
  }, [presets]);
  const about = drawing.value?.about;
  if (!about || presets.value.length === 0) return null;
  const command = commandOf({
    ...asked.value,
    about,
    presets: presets.value,
    isLimited: mesh.value?.quality.outcome === "budgetExhausted",
  });
  return (
    <section aria-labelledby="mesh-command">
      <h3 id="mesh-command">{say.command}</h3>
      {command ? (
        <Copyable
          text={command.lines.join("\n")}
          hint={command.save === null ? "" : say.commandSave(command.save)}
        />
      ) : (
        <p class="quiet mesh-small">{say.noCommand}</p>
      )}
    </section>
  );
}

/** A text to be copied by a click. */
function Copyable({ text, hint }: { text: string; hint: string }) {
  const say = words.value.mesh.export;
  const copied = useSignal("");
  const code = useRef<HTMLElement>(null);
  const take = async () => {
    if (await copy(text, select)) copied.value = text;
  };
  // Where the browser does not let it into the clipboard, Ctrl+C does.
  const select = () => {
    getSelection()?.selectAllChildren(code.current!);
    notify("info", say.notCopied);
  };
  return (
    <div class="mesh-copy">
      <pre>
        <code ref={code}>{text}</code>
      </pre>
      <button type="button" onClick={() => void take()}>
        {say.copy}
      </button>
      <small class="quiet" aria-live="polite">
        {copied.value === text ? say.copied : hint}
      </small>
    </div>
  );
}

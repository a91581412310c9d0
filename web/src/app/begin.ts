// What happens once, when the page opens.

import { effect } from "@preact/signals";
import { stage } from "../engine/client";
import { wish } from "../state/drawing";
import { beginLink } from "../state/link";
import { tell } from "../state/notices";
import { algorithms } from "../state/play";
import { language, theme } from "../state/settings";
import { words } from "../words";
import { beOffline } from "./offline";
import { fail, lacking, readiness } from "./readiness";

/** Loads what the module knows, and shows the first drawing. */
export async function begin(): Promise<void> {
  effect(() => {
    document.documentElement.lang = language.value;
    document.documentElement.dataset.theme = theme.value;
    document.title = words.value.app.title;
  });
  const lack = lacking();
  if (lack) return fail(lack);
  // Before anybody can wish for something else.
  const first = wish();
  try {
    // Whoever wishes for one drawing after the other ends the worker that is asked, be it in its first moments.
    algorithms.value = await stage.insist((engine) => engine.players.algorithms());
  } catch (error) {
    return fail("start", error);
  }
  try {
    await beginLink(first);
  } catch (error) {
    tell(error);
  }
  readiness.value = "ready";
  beOffline();
}

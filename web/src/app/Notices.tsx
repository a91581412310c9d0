// What has gone wrong, over the stage, until it is dismissed.

import { boxOfMarks } from "../drawing/troubles";
import { lookAt } from "../stage/attention";
import { dismiss, notices } from "../state/notices";
import { words } from "../words";
import { CloseIcon } from "./icons";

export function Notices() {
  return (
    <div class="notices" aria-live="polite">
      {notices.value.map(({ id, tone, text, marks, action }) => (
        <div key={id} class={`notice ${tone}`} role={tone === "error" ? "alert" : undefined}>
          <span>{text}</span>
          {boxOfMarks(marks) && (
            <button type="button" onClick={() => lookAt(boxOfMarks(marks)!)}>
              {words.value.app.show}
            </button>
          )}
          {action && (
            <button type="button" onClick={action.run}>
              {words.value.app.actions[action.name]}
            </button>
          )}
          <button
            type="button"
            class="icon-button"
            aria-label={words.value.app.dismiss}
            onClick={() => dismiss(id)}
          >
            <CloseIcon />
          </button>
        </div>
      ))}
    </div>
  );
}

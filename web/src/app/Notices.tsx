// What has gone wrong, over the stage, until it is dismissed.

import { dismiss, notices } from "../state/notices";
import { words } from "../words";

export function Notices() {
  return (
    <div class="notices" aria-live="polite">
      {notices.value.map(({ id, tone, text }) => (
        <div key={id} class={`notice ${tone}`} role={tone === "error" ? "alert" : "status"}>
          <span>{text}</span>
          <button type="button" aria-label={words.value.app.dismiss} onClick={() => dismiss(id)}>
            ×
          </button>
        </div>
      ))}
    </div>
  );
}

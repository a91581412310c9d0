// Before the stage can show anything: that it is coming, or why it does not come and what to do.

import { words } from "../words";
import { readiness } from "./readiness";

export function Loading() {
  const say = words.value.app.loading;
  const now = readiness.value;
  if (now === "ready") return null;
  if (now === "loading") {
    return (
      <div class="loading" role="status">
        <span class="loading-bar" />
        <span>{say.now}</span>
      </div>
    );
  }
  return (
    <div class="failed" role="alert">
      <h2>{say.failed}</h2>
      <p>{say.reasons[now.reason]}</p>
      {now.told && (
        <p class="quiet">
          <code>{now.told}</code>
        </p>
      )}
      <button type="button" class="main" onClick={() => location.reload()}>
        {say.again}
      </button>
    </div>
  );
}

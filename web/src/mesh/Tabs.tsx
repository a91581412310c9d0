// Parts of a panel, one of which is open. Arrow keys go from tab to tab.

import type { ComponentChildren } from "preact";
import { useId } from "preact/hooks";

interface Props<T extends string> {
  names: readonly T[];
  now: T;
  labels: Record<T, string>;
  /** What the tabs are about. */
  label: string;
  onChange: (name: T) => void;
  children: ComponentChildren;
}

export function Tabs<T extends string>({ names, now, labels, label, onChange, children }: Props<T>) {
  const id = useId();
  const press = (event: KeyboardEvent) => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const next = names[(names.indexOf(now) + by + names.length) % names.length];
    onChange(next);
    document.getElementById(`${id}-${next}`)?.focus();
  };
  return (
    <>
      <div role="tablist" aria-label={label} class="mesh-tabs" onKeyDown={press}>
        {names.map((name) => (
          <button
            key={name}
            id={`${id}-${name}`}
            type="button"
            role="tab"
            aria-selected={name === now}
            aria-controls={`${id}-content`}
            tabIndex={name === now ? 0 : -1}
            onClick={() => onChange(name)}
          >
            {labels[name]}
          </button>
        ))}
      </div>
      <div role="tabpanel" id={`${id}-content`} aria-labelledby={`${id}-${now}`} class="mesh-content">
        {children}
      </div>
    </>
  );
}

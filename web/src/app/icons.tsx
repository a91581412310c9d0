// Icons: one shape each, in the colour of the text around them; always beside or under a label in words.

import type { ComponentChildren } from "preact";

function Icon({ children }: { children: ComponentChildren }) {
  return (
    <svg
      viewBox="0 0 24 24"
      width="20"
      height="20"
      fill="none"
      stroke="currentColor"
      stroke-width="2"
      stroke-linecap="round"
      stroke-linejoin="round"
      aria-hidden="true"
    >
      {children}
    </svg>
  );
}

/** A plus: more, nearer. */
export const PlusIcon = () => (
  <Icon>
    <path d="M12 5v14M5 12h14" />
  </Icon>
);

/** A minus: less, farther. */
export const MinusIcon = () => (
  <Icon>
    <path d="M5 12h14" />
  </Icon>
);

/** The corners of a frame: all of it. */
export const FitIcon = () => (
  <Icon>
    <path d="M4 9V4h5M15 4h5v5M20 15v5h-5M9 20H4v-5" />
  </Icon>
);

/** A filled shape, as players of films have them. */
const icon = (shape: string) => () => (
  <svg class="icon" viewBox="0 0 16 16" width="16" height="16" fill="currentColor" aria-hidden="true">
    <path d={shape} />
  </svg>
);

export const PlayIcon = icon("M4 2.2v11.6L13.5 8z");
export const BackwardsIcon = icon("M12 2.2v11.6L2.5 8z");
export const PauseIcon = icon("M3.5 2.5h3.2v11H3.5zM9.3 2.5h3.2v11H9.3z");
export const StepIcon = icon("M3 2.8v10.4L10 8zM11 2.8h2.2v10.4H11z");
export const StepBackIcon = icon("M13 2.8v10.4L6 8zM2.8 2.8H5v10.4H2.8z");
export const LastIcon = icon("M1.8 3v10L7.3 8zM7 3v10l5.5-5zM12.3 3h2v10h-2z");
export const FirstIcon = icon("M14.2 3v10L8.7 8zM9 3v10L3.5 8zM1.7 3h2v10h-2z");
export const NextIcon = icon("M5 2.2l1.6-1.4L13.4 8l-6.8 7.2L5 13.8 10.4 8z");
export const PreviousIcon = icon("M11 2.2L9.4.8 2.6 8l6.8 7.2 1.6-1.4L5.6 8z");
export const MoreIcon = icon(
  "M1.5 8a1.6 1.6 0 1 1 3.2 0 1.6 1.6 0 0 1-3.2 0zM6.4 8a1.6 1.6 0 1 1 3.2 0 1.6 1.6 0 0 1-3.2 0zM11.3 8a1.6 1.6 0 1 1 3.2 0 1.6 1.6 0 0 1-3.2 0z",
);
export const RestartIcon = icon("M8 2a6 6 0 1 1-5.7 4.1l1.9.6A4 4 0 1 0 8 4v2.6L3.8 3.2 8 0z");
export const DiceIcon = icon(
  "M3 1.5h10A1.5 1.5 0 0 1 14.5 3v10a1.5 1.5 0 0 1-1.5 1.5H3A1.5 1.5 0 0 1 1.5 13V3A1.5 1.5 0 0 1 3 1.5zM3 3v10h10V3zM4.2 5.4a1.2 1.2 0 1 1 2.4 0 1.2 1.2 0 0 1-2.4 0zM6.8 8a1.2 1.2 0 1 1 2.4 0 1.2 1.2 0 0 1-2.4 0zM9.4 10.6a1.2 1.2 0 1 1 2.4 0 1.2 1.2 0 0 1-2.4 0z",
);
export const RemoveIcon = icon(
  "M3.1 1.7L8 6.6l4.9-4.9 1.4 1.4L9.4 8l4.9 4.9-1.4 1.4L8 9.4l-4.9 4.9-1.4-1.4L6.6 8 1.7 3.1z",
);
export const CheckIcon = icon("M6.3 13.4L1.4 8.5l1.7-1.7 3.2 3.2 6.6-7 1.7 1.7z");

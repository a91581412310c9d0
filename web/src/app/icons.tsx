// Icons: one shape each, drawn with one pen on one grid, in the colour of the text around them; always beside or under a
// label in words.

import type { ComponentChildren } from "preact";

interface IconProps {
  children: ComponentChildren;
  /** Whether shapes are filled, as players of films have them. */
  isSolid?: boolean;
}

function Icon({ children, isSolid = false }: IconProps) {
  return (
    <svg
      class="icon"
      viewBox="0 0 24 24"
      width="20"
      height="20"
      fill={isSolid ? "currentColor" : "none"}
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

/** The mark of the page: two triangles and their edge. */
export const Logo = () => (
  <Icon>
    <path d="M3 20 10.5 4 21 13zM3 20l10-5 8-2M10.5 4 13 15" />
  </Icon>
);

/** Three lines: what is folded away. */
export const MenuIcon = () => (
  <Icon>
    <path d="M4 7h16M4 12h16M4 17h16" />
  </Icon>
);

/** A question mark. */
export const HelpIcon = () => (
  <Icon>
    <path d="M8.5 9a3.5 3.5 0 1 1 5.3 3c-1.2.7-1.8 1.3-1.8 2.5M12 18.5h.01" />
  </Icon>
);

/** An open book. */
export const GuideIcon = () => (
  <Icon>
    <path d="M12 6c-2-1.6-5-2-8-2v14c3 0 6 .4 8 2 2-1.6 5-2 8-2V4c-3 0-6 .4-8 2zM12 6v14" />
  </Icon>
);

/** A window with something at its left. */
export const LeftPanelIcon = () => (
  <Icon>
    <rect x="3" y="4" width="18" height="16" rx="2" />
    <path d="M9 4v16" />
  </Icon>
);

/** A window with something at its right. */
export const RightPanelIcon = () => (
  <Icon>
    <rect x="3" y="4" width="18" height="16" rx="2" />
    <path d="M15 4v16" />
  </Icon>
);

/** A cross: away with it. */
export const CloseIcon = () => (
  <Icon>
    <path d="M6 6l12 12M18 6L6 18" />
  </Icon>
);

/** A ring that is still empty. */
export const OpenStepIcon = () => (
  <Icon>
    <circle cx="12" cy="12" r="8" />
  </Icon>
);

/** A ring with a tick. */
export const DoneStepIcon = () => (
  <Icon>
    <circle cx="12" cy="12" r="9" fill="currentColor" stroke="none" />
    <path d="M8 12.3l2.8 2.8L16 9.5" stroke="var(--paper)" />
  </Icon>
);

/** A hand that moves the view: arrows to four sides. */
export const ViewIcon = () => (
  <Icon>
    <path d="M12 3v18M3 12h18M9 6l3-3 3 3M9 18l3 3 3-3M6 9l-3 3 3 3M18 9l3 3-3 3" />
  </Icon>
);

/** A point, and one that is added. */
export const PointsIcon = () => (
  <Icon>
    <circle cx="7" cy="16" r="3" fill="currentColor" />
    <path d="M17 4v8M13 8h8" />
  </Icon>
);

/** A segment between two points. */
export const SegmentsIcon = () => (
  <Icon>
    <path d="M7 17 17 7" />
    <circle cx="5" cy="19" r="2.5" />
    <circle cx="19" cy="5" r="2.5" />
  </Icon>
);

/** A cross in a ring. */
export const HolesIcon = () => (
  <Icon>
    <circle cx="12" cy="12" r="9" />
    <path d="m9 9 6 6M15 9l-6 6" />
  </Icon>
);

/** An eraser. */
export const EraseIcon = () => (
  <Icon>
    <path d="M8 20h12M5.5 17.5l-2-2a2 2 0 0 1 0-2.8l9-9a2 2 0 0 1 2.8 0l5 5a2 2 0 0 1 0 2.8L12.5 19.5H7.5zM9 7l8 8" />
  </Icon>
);

/** An arrow that turns back. */
export const UndoIcon = () => (
  <Icon>
    <path d="M4 9h10a6 6 0 0 1 0 12H9M8 5 4 9l4 4" />
  </Icon>
);

/** An arrow that turns forward. */
export const RedoIcon = () => (
  <Icon>
    <path d="M20 9H10a6 6 0 0 0 0 12h5M16 5l4 4-4 4" />
  </Icon>
);

/** A bin. */
export const ClearIcon = () => (
  <Icon>
    <path d="M4 7h16M9 7V4h6v3M6 7l1 14h10l1-14M10 11v6M14 11v6" />
  </Icon>
);

/** A sheet with a folded corner. */
export const EmptyIcon = () => (
  <Icon>
    <path d="M6 3h8l5 5v13H6zM14 3v5h5" />
  </Icon>
);

/** A die. */
export const DiceIcon = () => (
  <Icon>
    <rect x="4" y="4" width="16" height="16" rx="3" />
    <path d="M8.5 8.5h.01M15.5 8.5h.01M12 12h.01M8.5 15.5h.01M15.5 15.5h.01" />
  </Icon>
);

/** An open folder. */
export const OpenIcon = () => (
  <Icon>
    <path d="M3 19V5h6l2 3h8v3M3 19l3-8h16l-3 8z" />
  </Icon>
);

/** An arrow down into a tray. */
export const SaveIcon = () => (
  <Icon>
    <path d="M12 3v12M7 10l5 5 5-5M4 17v4h16v-4" />
  </Icon>
);

/** Two links of a chain. */
export const LinkIcon = () => (
  <Icon>
    <path d="M10 14a4 4 0 0 0 6 .5l3-3a4.2 4.2 0 0 0-6-6l-1.5 1.5M14 10a4 4 0 0 0-6-.5l-3 3a4.2 4.2 0 0 0 6 6l1.5-1.5" />
  </Icon>
);

/** A clipboard. */
export const PasteIcon = () => (
  <Icon>
    <path d="M9 4h6v3H9zM9 5H5v16h14V5h-4" />
  </Icon>
);

/** An arrow to what lies across. */
export const AcrossIcon = () => (
  <Icon>
    <path d="M4 12h15M13 6l6 6-6 6" />
  </Icon>
);

/** An arrowhead to the right: play. */
export const PlayIcon = () => (
  <Icon isSolid>
    <path d="M7.5 5v14L18 12z" />
  </Icon>
);

/** An arrowhead to the left: play backwards. */
export const BackwardsIcon = () => (
  <Icon isSolid>
    <path d="M16.5 5v14L6 12z" />
  </Icon>
);

/** Two bars: pause. */
export const PauseIcon = () => (
  <Icon isSolid>
    <path d="M7 5.5h2.5v13H7zM14.5 5.5H17v13h-2.5z" />
  </Icon>
);

/** An arrowhead before a bar: a step. */
export const StepIcon = () => (
  <Icon isSolid>
    <path d="M6 5.5v13l9-6.5zM18.5 5.5v13" />
  </Icon>
);

/** The same the other way round: a step back. */
export const StepBackIcon = () => (
  <Icon isSolid>
    <path d="M18 5.5v13L9 12zM5.5 5.5v13" />
  </Icon>
);

/** Two arrowheads before a bar: the end. */
export const LastIcon = () => (
  <Icon isSolid>
    <path d="M4 6.5v11l6-5.5zM12 6.5v11l6-5.5zM21 6v12" />
  </Icon>
);

/** The same the other way round: the beginning. */
export const FirstIcon = () => (
  <Icon isSolid>
    <path d="M20 6.5v11L14 12zM12 6.5v11L6 12zM3 6v12" />
  </Icon>
);

/** A chevron to the right: the next one. */
export const NextIcon = () => (
  <Icon>
    <path d="m9 5 7 7-7 7" />
  </Icon>
);

/** A chevron to the left: the previous one. */
export const PreviousIcon = () => (
  <Icon>
    <path d="m15 5-7 7 7 7" />
  </Icon>
);

/** Three dots: what else there is. */
export const MoreIcon = () => (
  <Icon isSolid>
    <circle cx="5" cy="12" r="1" />
    <circle cx="12" cy="12" r="1" />
    <circle cx="19" cy="12" r="1" />
  </Icon>
);

/** An arrow that goes around: from the beginning. */
export const RestartIcon = () => (
  <Icon>
    <path d="M4.5 4v5h5M4.9 9A7.8 7.8 0 1 1 4.2 13" />
  </Icon>
);

/** A tick: so it is. */
export const CheckIcon = () => (
  <Icon>
    <path d="m4.5 12.5 5 5L19.5 7" />
  </Icon>
);

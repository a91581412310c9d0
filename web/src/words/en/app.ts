// The frame of the page.

export const app = {
  title: "Delone: the theatre",
  modes: { play: "Play", predict: "Predict", race: "Race", mesh: "Mesh" },
  modeHints: {
    play: "Watch an algorithm, step by step",
    predict: "Guess which edge is flipped next",
    race: "Several algorithms beside each other",
    mesh: "Mesh a domain and save it",
  },
  mode: "What to do",
  language: "Language",
  theme: "Colours",
  themes: { auto: "System colours", light: "Light", dark: "Dark" },
  jobs: {
    draw: "Drawing",
    run: "Running the algorithm",
    mesh: "Meshing",
    save: "Writing",
    record: "Recording the run",
  },
  cancel: "Cancel",
  show: "Show",
  actions: { save: "Save …" },
  dismiss: "Dismiss",
  skip: "Skip to the stage",
  menu: "Menu",
  guide: "Guide",
  help: "Help",
  left: "Drawing and view",
  right: "What is done with it",
  panels: "Panels",
  works: { play: "Algorithm", predict: "Game", race: "Race", mesh: "Mesh" },
  loading: {
    now: "The module is being loaded …",
    failed: "The page cannot compute",
    reasons: {
      wasm: "This browser has no WebAssembly, or a rule forbids it here (some privacy modes do). Please allow it for this page, or take another browser of 2023 or later.",
      workers: "This browser has no workers. Please take another one, of 2023 or later.",
      start:
        "The module could not be started. Perhaps the connection broke: then loading the page again helps. Perhaps an extension blocks WebAssembly: then please allow it here. Browsers from 2023 on will do.",
    },
    again: "Load again",
  },
  space: "Space",
};

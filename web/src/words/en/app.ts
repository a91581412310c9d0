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
  themes: { auto: "as the system", light: "light", dark: "dark" },
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
  space: "Space",
};

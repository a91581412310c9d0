// Guessing the next flip.

export const predict = {
  heading: "Predict the next flip",
};

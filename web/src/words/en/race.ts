// Races.

export const race = {
  heading: "Race",
};

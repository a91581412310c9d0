// What can be shown over the stage.

export const see = {
  heading: "See",
};

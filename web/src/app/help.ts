// The key of the help.

import { dialog } from "../files/dialogs";
import { bind } from "./shortcuts";

bind("page", "?", "help", () => {
  dialog.value = "help";
});

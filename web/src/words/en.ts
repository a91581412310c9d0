// English.

import { app } from "./en/app";
import { drawing } from "./en/drawing";
import { files } from "./en/files";
import { help } from "./en/help";
import { mesh } from "./en/mesh";
import { play } from "./en/play";
import { predict } from "./en/predict";
import { race } from "./en/race";
import { see } from "./en/see";
import { stage } from "./en/stage";

export const en = { app, drawing, files, help, mesh, play, predict, race, see, stage };

// German.

import type { Words } from ".";
import { app } from "./de/app";
import { drawing } from "./de/drawing";
import { files } from "./de/files";
import { help } from "./de/help";
import { mesh } from "./de/mesh";
import { play } from "./de/play";
import { predict } from "./de/predict";
import { race } from "./de/race";
import { see } from "./de/see";
import { stage } from "./de/stage";

export const de: Words = { app, drawing, files, help, mesh, play, predict, race, see, stage };

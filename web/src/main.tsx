// Where everything begins. What all rooms share comes first in the style sheet, so that a room may differ.

import "./style/base.css";
import { render } from "preact";
import { App } from "./app/App";
import { begin } from "./app/begin";

document.getElementById("stuck")?.remove();
render(<App />, document.getElementById("app")!);
void begin();

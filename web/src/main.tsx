// Where everything begins.

import { render } from "preact";
import { App } from "./app/App";
import { begin } from "./app/begin";
import "./style/base.css";

render(<App />, document.getElementById("app")!);
void begin();

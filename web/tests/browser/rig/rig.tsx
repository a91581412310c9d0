// A stage alone on a page, for tests: the address names the scene. The page tells by data-attributes what tests want to
// know: `data-camera` of the main element is the view as JSON.

import { effect, signal } from "@preact/signals";
import { render } from "preact";
import { type Camera, toPlane } from "../../../src/stage/camera";
import { picture } from "../../../src/stage/picture";
import { type Overlay, Stage } from "../../../src/stage/Stage";
import { scenes } from "./scenes";
import "../../../src/style/base.css";
import "./rig.css";

const name = new URLSearchParams(location.search).get("scene") ?? "utm";
const scene = signal(scenes[name]());
const whole = signal(scene.peek().points);
const camera = signal<Camera | null>(null);
const main = document.getElementById("rig")!;

/** Tells the view in which overlays are drawn, which is that of the scene, and marks its middle. */
const tell: Overlay = (pen) => {
  main.dataset.camera = JSON.stringify(pen.camera);
  const { width, height } = pen.size;
  pen.dot(...toPlane(pen.camera, pen.size, width / 2, height / 2), { stroke: "#ff80ff", size: 12 });
};
const overlays = signal([tell]);

async function take(): Promise<void> {
  const image = new Image();
  image.src = URL.createObjectURL(await picture());
  await image.decode();
  main.dataset.picture = `${image.naturalWidth}×${image.naturalHeight}`;
}

/** Another array of the same points: something that an edit does. */
function edit(): void {
  whole.value = Float64Array.from([...scene.peek().points, 0, 0]);
}

const source = signal(0);
effect(() => {
  main.dataset.source = String(source.value);
});

render(
  <>
    <Stage scene={scene} overlays={overlays} camera={camera} whole={whole} source={source} />
    <button type="button" onClick={() => void take()}>
      Take a picture
    </button>
    <button type="button" onClick={edit}>
      Edit
    </button>
    <button
      type="button"
      onClick={() => {
        source.value += 1;
      }}
    >
      Another drawing
    </button>
  </>,
  main,
);

// The browser module does what the program does, bit for bit, and every algorithm plays to its end and back.
//
//   cargo run -p delone-web-build --release && cargo build -p delone-cli --release && node web/tests/module.mjs
//
// DELONE names another program than target/release/delone.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { Drawing, fileKind, formats, initSync, Mesh, Player, version } from "../src/wasm/delone.js";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const program = process.env.DELONE ?? here("../../target/release/delone");
const folder = mkdtempSync(join(tmpdir(), "delone-module-"));

initSync({ module: readFileSync(here("../src/wasm/delone_bg.wasm")) });

const milliseconds = (work) => {
  const begin = performance.now();
  const result = work();
  return [result, performance.now() - begin];
};

const native = (...args) =>
  JSON.parse(execFileSync(program, [...args, "--json", "-q"], { encoding: "utf8" }));

// Writes a sample by the program, and returns its file.
const sample = (name, count, extension) => {
  const file = join(folder, `${name}.${extension}`);
  execFileSync(program, ["sample", name, "-n", String(count), "--seed", "1", "-q", "-o", file]);
  return file;
};

// name, count, extension of its file, whether it has segments
const presets = [
  ["uniform", 5000, "csv", false],
  ["grid", 2500, "npy", false],
  ["f32-duplicates", 5000, "node", false],
  ["cocircular", 0, "poly", false],
  ["gallery", 0, "poly", false],
  ["lake", 0, "poly", true],
  ["coast", 3000, "poly", true],
  ["airfoil", 1000, "poly", true],
];

const hashesAgree = () => {
  for (const [name, count, extension, hasSegments] of presets) {
    const file = sample(name, count, extension);
    const expected = native("triangulate", file).hash;
    const drawings = [
      Drawing.preset(name, count, 1),
      Drawing.fromFile(`${name}.${extension}`, readFileSync(file)),
    ];
    for (const drawing of drawings) {
      const mesh = hasSegments ? Mesh.constrain(drawing) : Mesh.triangulate(drawing);
      assert.equal(mesh.hash(), expected, name);
    }
    console.log(`  ${name}: ${expected}`);
  }
};

const refinementAgrees = () => {
  for (const [name, options, args] of [
    ["lake", { minAngle: 30, maxEdge: 0.25 }, ["--min-angle", "30", "--max-edge", "0.25"]],
    ["airfoil", { minAngle: 25 }, []],
    ["thesis", { minAngle: 20, maxArea: 0.01 }, ["--min-angle", "20", "--max-area", "0.01"]],
  ]) {
    const expected = native("mesh", sample(name, 300, "poly"), ...args).hash;
    let calls = 0;
    const drawing = Drawing.preset(name, 300, 1);
    const mesh = Mesh.refine(drawing, JSON.stringify(options), () => {
      calls += 1;
    });
    assert.equal(mesh.hash(), expected, name);
    assert.equal(JSON.parse(mesh.quality()).outcome, "complete");
    assert(calls > 0);
    console.log(`  ${name}: ${expected}, ${mesh.triangles().length / 3} triangles`);
  }
};

const everyAlgorithmPlays = () => {
  for (const { name, takes } of JSON.parse(Player.algorithms())) {
    const drawing = Drawing.preset(takes === "domain" || name === "thesis" ? "thesis" : "uniform", 40, 1);
    const player = Player.run(name, drawing);
    for (let i = 0; i <= player.length; i++) {
      player.seek(i);
      const step = JSON.parse(player.step());
      assert.equal(step === null, i === 0);
      assert.equal(player.narration("en") === "", i === 0, `${name}: ${player.step()}`);
      assert.equal(player.narration("de") === "", i === 0);
      assert(player.line <= JSON.parse(player.code()).length);
    }
    const end = [player.hash(), ...player.edges(), ...player.triangles()];
    for (let i = player.length; i >= 0; i--) player.seek(i);
    assert.equal(player.edges().length, 0);
    player.seek(player.length);
    assert.deepEqual([player.hash(), ...player.edges(), ...player.triangles()], end);
    console.log(`  ${name}: ${player.length} steps`);
  }
};

const runsAreSurveyed = () => {
  const calls = [];
  const drawing = Drawing.preset("uniform", 400, 1);
  const player = Player.run("flip-list", drawing, undefined, (...told) => void calls.push(told));
  assert(
    calls.length > 0 &&
      calls.every(([phase, steps, total]) => phase === "recording" && steps > 0 && total === 0),
  );
  const flips = player.curve("flips", 100);
  assert(flips instanceof Float64Array && flips.length <= 200);
  assert.equal(flips.at(-1), JSON.parse(player.tally()).flips);
  assert.equal(player.tallyAt(player.length), player.tally());
  assert.equal(player.positionAt("steps", 100.5), 100);
  assert(player.total("milliseconds") > 0);
  assert.equal(player.positionAt("milliseconds", Infinity), player.length);
  const half = player.positionAt("predicates", player.total("predicates") / 2);
  assert(half > 0 && half < player.length);
  const position = player.search('[{"kind": "flip"}, {"curve": "flips", "above": 5}]', 0, false);
  assert.equal(position, player.next("flip", 0));
  assert.equal(player.search('[{"line": 999}]', player.length, true), undefined);
  player.seek(half);
  const illegal = player.illegal();
  assert(illegal.length > 0);
  const [a, b, c, d] = illegal;
  assert.deepEqual(JSON.parse(player.side(a, b, c, d)), { side: "inside", counts: "inside" });
  assert(JSON.parse(player.circle(a, b, c)).radius > 0);
  player.seek(player.length);
  assert.deepEqual([player.illegal().length, player.cocircular().length], [0, 0]);
  assert.equal(player.angles().reduce((sum, n) => sum + n) * 3, player.triangles().length);
  console.log(`  ${player.length} steps in ${player.total("milliseconds").toFixed(1)} ms`);
};

const placesAreFound = () => {
  const player = Player.run("incremental", Drawing.preset("grid", 400, 1));
  player.seek(player.length);
  assert.equal(player.cocircular().length / 4, 19 * 19);
  const looker = player.looker();
  const { vertex, distance, walk } = JSON.parse(looker.nearest(3.25, 4));
  assert.deepEqual([...player.points().slice(2 * vertex, 2 * vertex + 2), distance], [3, 4, 0.25]);
  const triangle = looker.triangleAt(3.6, 4.3);
  assert.equal(JSON.parse(looker.nearest(3.6, 4.3)).walk.at(-1), triangle);
  assert(walk.length > 0);
  assert.equal(looker.triangleAt(-9, 0), undefined);
  const cells = looker.cells();
  assert(cells instanceof Float64Array);
  assert.equal(cells.length / 4, 2 * 19 * 20);
  assert(looker.cells([0, 0, 3, 3]).every((coordinate) => coordinate >= 0 && coordinate <= 3));
  const large = Player.run("divide-and-conquer", Drawing.preset("uniform", 20000, 1));
  large.seek(large.length);
  const [made, making] = milliseconds(() => large.looker());
  const [, asking] = milliseconds(() => made.nearest(0.9, 0.9));
  const [, drawing] = milliseconds(() => made.cells());
  const figures = [making, asking, drawing].map((ms) => `${ms.toFixed(1)} ms`);
  console.log(`  20,000 points: looker ${figures[0]}, nearest ${figures[1]}, cells ${figures[2]}`);
};

const longRunsAreSoughtQuickly = () => {
  const drawing = Drawing.preset("uniform", 20000, 1);
  const [player, ran] = milliseconds(() => Player.run("divide-and-conquer", drawing));
  const [, first] = milliseconds(() => player.seek(player.length));
  let worst = 0;
  for (let i = 1; i <= 40; i++) {
    const [, took] = milliseconds(() => player.seek((i * 7919 * 7919) % player.length));
    worst = Math.max(worst, took);
  }
  const figures = [ran, first, worst].map((ms) => `${ms.toFixed(1)} ms`);
  console.log(
    `  ${player.length} steps: run ${figures[0]}, first time to the end ${figures[1]}, worst seek ${figures[2]}`,
  );
};

const filesAreWritten = () => {
  const drawing = Drawing.preset("lake", 0, 0);
  const mesh = Mesh.refine(drawing, '{"minAngle": 25}');
  for (const name of ["m.ele", "m.vtu", "m.npy", "m.geojson", "m.svg", "m.png"]) {
    assert(mesh.save(name).every((file) => file.bytes().length > 0));
  }
  assert(mesh.saveReport("r.html", "lake")[0].bytes().length > 1000);
  assert(mesh.saveCells("c.svg")[0].bytes().length > 1000);
  assert(drawing.save("d.poly")[0].bytes().length > 1000);
  const player = Player.run("incremental", Drawing.preset("uniform", 12, 1));
  for (const name of ["p.svg", "p.gif", "p.png", "p.json", "p.dlog"]) {
    const [file] = player.save(name, '{"size": 300, "maxFrames": 20}');
    assert.equal(file.name, name);
    if (name === "p.dlog") assert.equal(Player.fromLog(name, file.bytes()).length, player.length);
  }
};

const drawingsAreEdited = () => {
  const drawing = new Drawing([0, 0, 4, 0, 4, 4, 0, 4], [0, 1, 1, 2, 2, 3, 3, 0], []);
  const copy = drawing.copy();
  drawing.edit(
    JSON.stringify([
      { addPoint: [2, 6] },
      { addSegment: [2, 4] },
      { addSegment: [4, 3] },
      { removePoint: 0 },
    ]),
  );
  assert.deepEqual([...drawing.points()], [4, 0, 4, 4, 0, 4, 2, 6]);
  assert.deepEqual([...drawing.segments()], [0, 1, 1, 2, 1, 3, 3, 2]);
  assert.equal(copy.points().length, 8);
  assert.throws(() => drawing.edit(JSON.stringify([{ addPoint: [NaN, 1] }])), /edit 0, addPoint: .*finite/);
  drawing.edit('[{"addRegion": [3, 3, 7, null]}]');
  assert.deepEqual([...drawing.regions()], [3, 3, 7, NaN]);

  const large = Drawing.preset("coast", 100000, 1);
  const drag = (i) => large.edit(`[{"movePoint": [${i}, ${i % 7}, 1]}]`);
  const [, moved] = milliseconds(() => Array.from({ length: 1000 }, (_, i) => drag(i)));
  const [, removed] = milliseconds(() => large.edit('[{"removePoint": 500}]'));
  const many = JSON.stringify(Array.from({ length: 5000 }, (_, i) => ({ removePoint: 90000 - 2 * i })));
  const [, purged] = milliseconds(() => large.edit(many));
  const figures = [moved / 1000, removed, purged].map((ms) => `${ms.toFixed(3)} ms`);
  console.log(
    `  of 100,000 points one moved: ${figures[0]}, one removed: ${figures[1]}, 5,000 removed: ${figures[2]}`,
  );
};

const filesComeInParts = () => {
  const mesh = Mesh.refine(Drawing.preset("lake", 0, 0), '{"minAngle": 25}');
  const family = mesh.save("m.ele");
  const pick = (...ends) => ends.map((end) => family.find((file) => file.name === `m.${end}`));
  const open = (files) =>
    Drawing.fromFiles(
      files.map((file) => file.name),
      files.map((file) => file.bytes()),
    );
  const whole = open(pick("ele", "node", "poly"));
  assert.equal(whole.triangles().length, mesh.triangles().length);
  assert.equal(JSON.parse(whole.about()).rule, "carve");
  assert.deepEqual(open(pick("poly", "node")).points(), mesh.points());
  assert.throws(() => open(pick("ele")), /m\.ele needs m\.node: open both together/);
  const [log] = Player.run("incremental", Drawing.preset("uniform", 9, 1)).save("p.json");
  assert.equal(fileKind(log.name, log.bytes()), "log");
  assert.equal(fileKind("m.node", pick("node")[0].bytes()), "drawing");
  assert.equal(fileKind("m.docx", new Uint8Array()), "unknown");
  const list = JSON.parse(formats());
  assert(list.some(({ extension, mesh, reads }) => extension === "vtu" && mesh && reads));
  assert(list.some(({ extension, run }) => extension === "dlog" && run));
};

const meshesExplainThemselves = () => {
  const options = { thesis: true, minAngle: 29, maxEdge: 3, explains: true };
  const mesh = Mesh.refine(Drawing.preset("thesis", 0, 0), JSON.stringify(options));
  const points = mesh.points();
  const rules = new Set();
  mesh.measures("minAngle").forEach((angle, t) => {
    const told = JSON.parse(mesh.explain(t));
    assert(Math.abs(Math.min(...told.angles) - angle) < 1e-4);
    const middle = [0, 1].map((k) => told.corners.reduce((sum, v) => sum + points[2 * v + k] / 3, 0));
    assert.equal(mesh.triangleAt(...middle), t);
    for (const { origin, cause } of told.vertices) {
      assert.equal(cause === null, origin === "input");
      if (cause) rules.add(cause.rule);
    }
    for (const language of ["en", "de"]) assert.match(mesh.sentence(t, language), /\.$/);
  });
  assert(rules.has("size") && rules.size > 1);
  assert.equal(mesh.measures("area").length, mesh.triangles().length / 3);
  assert.equal(mesh.triangleAt(1e9, 0), undefined);
  console.log(`  ${mesh.sentence(0, "en")}\n  ${mesh.sentence(0, "de")}`);

  const large = Mesh.triangulate(Drawing.preset("uniform", 500000, 1));
  const passes = {
    points: [],
    triangles: [],
    edges: [],
    measures: ["minAngle"],
    looker: [],
    explain: [7],
  };
  const figures = Object.entries(passes).map(
    ([name, args]) => `${name} ${milliseconds(() => large[name](...args))[1].toFixed(0)} ms`,
  );
  console.log(`  a million triangles: ${figures.join(", ")}`);
};

const errorsHavePlaces = () => {
  const error = (work) => {
    try {
      work();
    } catch (e) {
      return e;
    }
    return assert.fail("no error");
  };
  const crossing = new Drawing([0, 0, 4, 0, 1, -1, 1, 1, 2, -1, 2, 1], [0, 1, 2, 3, 4, 5], []);
  const crossed = error(() => Mesh.constrain(crossing));
  assert.deepEqual([...crossed.places], [1, 0, 2, 0]);
  assert.deepEqual([...crossed.segments], [0, 1, 2]);
  assert.equal(crossed.points.length, 0);
  assert.deepEqual([...error(() => Mesh.triangulate(new Drawing([0, 0, NaN, 1], [], []))).points], [1]);
  const broken = error(() => Drawing.fromFile("a.csv", new TextEncoder().encode("x,y\n1,2\n3,oops\n")));
  assert.equal(broken.line, 3);
  assert(broken instanceof Error && broken.stack);
};

const errorsAreErrors = () => {
  const refused = (work, pattern) =>
    assert.throws(work, (e) => e instanceof Error && pattern.test(e.message));
  refused(() => Drawing.fromFile("a.csv", new TextEncoder().encode("x,y\n1,2\n3,oops\n")), /a\.csv:3/);
  refused(() => new Drawing([0, 0, 1, 1], [0, 2], []), /segment 0 joins 0 and 2/);
  refused(() => Drawing.preset("pond", 1, 1), /no preset is called/);
  refused(() => Mesh.triangulate(new Drawing([0, NaN], [], [])), /./);
  refused(() => Mesh.refine(Drawing.preset("lake", 0, 0), '{"minangle": 3}'), /options: /);
  refused(() => Mesh.constrain(Drawing.preset("degenerate-grid", 0, 0)), /cross/);
  refused(() => Mesh.triangulate(Drawing.preset("uniform", 100000, 1), () => false), /cancel/i);
  const large = Drawing.preset("uniform", 5000, 1);
  refused(() => Player.run("incremental", large, undefined, () => false), /^cancelled$/);
  const player = Player.run("incremental", Drawing.preset("uniform", 10, 1));
  refused(() => player.search('[{"vertexes": 3}]', 0, false), /conditions: /);
  refused(() => player.search("[{}]", 0, false), /one of the keys/);
  refused(() => player.curve("flaps"), /no curve is called/);
  refused(() => player.positionAt("hours", 1), /no unit/);
  refused(() => player.circle(0, 1, 10), /no vertex 10/);
  refused(() => player.looker().triangleAt(NaN, 0), /no place/);
};

const check = (name, work) => {
  console.log(`${name} (${milliseconds(work)[1].toFixed(0)} ms)`);
};

try {
  console.log(`module of version ${version()}`);
  check("hashes agree with the program's", hashesAgree);
  check("refined meshes agree with the program's", refinementAgrees);
  check("every algorithm plays", everyAlgorithmPlays);
  check("runs are surveyed", runsAreSurveyed);
  check("places are found", placesAreFound);
  check("long runs are sought quickly", longRunsAreSoughtQuickly);
  check("files are written", filesAreWritten);
  check("drawings are edited", drawingsAreEdited);
  check("files come in parts", filesComeInParts);
  check("meshes explain themselves", meshesExplainThemselves);
  check("errors are errors", errorsAreErrors);
  check("errors have places", errorsHavePlaces);
  const [mesh, took] = milliseconds(() => Mesh.triangulate(Drawing.preset("uniform", 1000000, 1)));
  console.log(`1,000,000 points drawn and triangulated in ${took.toFixed(0)} ms: ${mesh.hash()}`);
} finally {
  rmSync(folder, { recursive: true });
}

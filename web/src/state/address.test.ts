import { expect, test } from "vitest";
import { type Address, decode, encode } from "./address";

const whole: Address = {
  mode: "mesh",
  open: ["open/a b.ele", "c,d&e=f%.node"],
  preset: { name: "f32-duplicates", count: 4, seed: 4294967295 },
  drawing: "aB-_9",
  algorithm: "sweep",
  run: { seed: 3, minAngle: 20.5, domain: "evenodd" },
  position: 12,
  kind: "constrain",
  mesh: { minAngle: 0, crossings: "split", regionAreas: false, maxArea: 1e-300 },
  see: ["voronoi", "marks"],
};

test("what is written is read again", () => {
  expect(decode(encode(whole))).toEqual({ address: whole, broken: [] });
  expect(decode("")).toEqual({ address: {}, broken: [] });
  expect(decode(encode({ see: [] }))).toEqual({ address: { see: [] }, broken: [] });
});

test("names of files may be escaped or not", () => {
  const { address } = decode("open=open/a.ele,open%2Fb%2Cc.node");
  expect(address.open).toEqual(["open/a.ele", "open/b,c.node"]);
});

test.each([
  "mode=dance",
  "at=-1",
  "at=1.5",
  "n=3",
  "seed=4294967296",
  "what=ever",
  "mode",
  "open=a,,b",
  "open=",
  "open=%E0%A4",
  "run.colour=red",
  "run.__proto__=1",
  "mesh.minAngle=",
  "mesh.minAngle=NaN",
  "mesh.conforming=yes",
  "mesh.maxVertices=0.5",
  "mesh.smoothing=-1",
  "run.seed=1e300",
  "else.minAngle=3",
  "kind=toString",
])("%s is broken, and said to be", (text) => {
  const { address, broken } = decode(text);
  expect(broken).toHaveLength(1);
  expect(address).toEqual({});
});

test("an address that was escaped once more on its way is read", () => {
  const text = encode(whole);
  expect(decode(encodeURIComponent(text))).toEqual(decode(text));
});

test("whatever is written behind #, it is read without failing, and what is understood stays", () => {
  let state = 1;
  const random = (below: number) => {
    state = (state * 48271) % 2147483647;
    return state % below;
  };
  const text = encode(whole);
  for (let round = 0; round < 2000; round++) {
    const letters = [...text];
    for (let i = 0; i < 1 + random(6); i++)
      letters[random(letters.length)] = String.fromCharCode(33 + random(94));
    const { address } = decode(letters.join(""));
    expect(decode(encode(address))).toEqual({ address, broken: [] });
  }
});

// SPDX-License-Identifier: BSD-3-Clause
// The package has the native build's numbers and says what is wrong with its input:
// node check_package.mjs PACKAGE PIECES.json PATTERNS, the pieces of TestWithoutVtk.py --write as JSON and a folder of
// their patterns as SVG.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const precision = 1e-9; // of the size of the pieces
const [, , folder, file, patterns] = process.argv;
const { load } = await import(pathToFileURL(`${folder}/index.js`).href);
const clipper = createRequire(new URL("page/package.json", import.meta.url))("clipper-lib");
const engine = await load({ clipper });
const types = ["accessory", "key", "dart", "seam"];
const difference = (a, b) => a.reduce((most, value, k) => Math.max(most, Math.abs(value - b[k])), a.length === b.length ? 0 : Infinity);
const pathNumbers = (svg) => Array.from(svg.matchAll(/ d="([^"]*)"/g), ([, path]) => path.match(/-?[\d.]+/g).map(Number)).flat();
let worst = 0;
const pieces = Object.entries(JSON.parse(readFileSync(file, "utf8")));
for (const [name, piece] of pieces) {
  const curves = piece.types.map((type, k) => ({
    type: piece.shapes[k] === 1 ? "straight" : types[type],
    name: piece.names[k],
    points: Float64Array.from(piece.chains.slice(piece.ends[k], piece.ends[k + 1]).flatMap((id) => piece.curve_points[id])),
  }));
  const surface = engine.makeSurface(piece.points.flat(), piece.triangles.flat(), "cm");
  const start = performance.now();
  const flattening = surface.flatten(curves);
  const seconds = (performance.now() - start) / 1000;
  const report = flattening.report();
  assert.equal(report.status.name, piece.status, `${name}: ${report.status.message}`);
  const flat = flattening.flat().points.filter((_, k) => k % 3 !== 2);
  const wanted = piece.positions.flat();
  const size = Math.max(...wanted) - Math.min(...wanted);
  const found = Math.max(difference(Array.from(flat), wanted) / size, difference(report.pieces.map((row) => row.E_area), piece.E_area));
  const numbers = pathNumbers(new TextDecoder().decode(flattening.pattern("svg", { allowance: 0 }).bytes));
  const drawn = difference(numbers, pathNumbers(readFileSync(`${patterns}/${name}.svg`, "utf8"))) / Math.max(...numbers);
  worst = Math.max(worst, found, drawn);
  console.log(`${name}: ${piece.triangles.length} triangles, ${seconds.toFixed(2)} s, differences up to ${found.toExponential(1)}, of smooth borders ${drawn.toExponential(1)}`);
  assert.ok(found <= precision && drawn <= precision, name);
  flattening.delete();
  surface.delete();
}
assert.ok(pieces.length > 9);
console.log(`${pieces.length} pieces, differences up to ${worst.toExponential(1)}`);

// A sheet of one unit, bent along its diagonal.
const corners = [0, 1, 2, 0, 2, 3];
const obj = "# units: cm\nv 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\nf 1 2 3\nf 1 3 4\ng dart left\nl 1 3\n";
const read = (name, text) => engine.readSurface(name, new TextEncoder().encode(text));
const sheet = read("sheet.obj", obj);
assert.equal(sheet.unit(), "cm");
assert.deepEqual(Array.from(sheet.arrays().corners), corners);
assert.deepEqual(sheet.curves("").cellArrays.CurveName, ["left"]);
const { points } = sheet.arrays();
const drawn = sheet.flatten([{ type: "key", name: "fold", points: [...points.slice(0, 3), ...points.slice(6, 9)] }]);
const endings = { svg: "<?xml", dxf: "0\r\nSECTION", plt: "IN;", json: "{", csv: "curve," };
for (const [ending, start] of Object.entries(endings)) {
  const { status, bytes } = drawn.pattern(ending, { allowance: 0, date: "2026-01-01" });
  assert.equal(status.name, "Ok", `${ending}: ${status.message}`);
  assert.ok(new TextDecoder().decode(bytes).trimStart().startsWith(start), `${ending}: ${new TextDecoder().decode(bytes.slice(0, 40))}`);
}
// Around a rectangle a seam allowance adds its width on each side.
const plane = engine.makeSurface([0, 0, 0, 10, 0, 0, 10, 6, 0, 0, 6, 0], corners, "cm").flatten();
const cutLine = (allowance) => {
  const { status, bytes } = plane.pattern("svg", { allowance });
  assert.equal(status.name, "Ok", status.message);
  const numbers = /class="cut-line"[^]*? d="([^"]*)"/.exec(new TextDecoder().decode(bytes))[1].match(/-?[\d.]+/g).map(Number);
  return [0, 1].map((axis) => {
    const values = numbers.filter((_, k) => k % 2 === axis);
    return Math.max(...values) - Math.min(...values);
  });
};
assert.ok(difference(cutLine(0), [100, 60]) < 1e-3, `${cutLine(0)}`);
assert.ok(difference(cutLine(10), [120, 80]) < 1e-3, `${cutLine(10)}`);
// On cloth 1.4 m wide it lies upright, with its allowances.
const { status: laid, bytes: lay } = plane.pattern("svg", { allowance: 10, fabric_width: 1400 });
assert.equal(laid.name, "Ok", laid.message);
assert.match(new TextDecoder().decode(lay), /cloth 1400 mm x 80 mm/);
assert.match((await load()).makeSurface([0, 0, 0, 10, 0, 0, 10, 6, 0], [0, 1, 2], "cm").flatten().pattern("svg", { allowance: 10 }).status.message, /clipper-lib/);
const calls = {};
const canvas = new Proxy({}, { get: (_, name) => (...given) => (calls[name] ??= []).push(given) });
assert.equal(drawn.pattern("pdf", { allowance: 0, paper: "A4" }, canvas).status.name, "Ok");
assert.deepEqual(calls.beginPage[0], [210, 297]);
assert.ok(calls.rectangle.some((given) => given.join() === "0,0,100,50"));
assert.match(drawn.pattern("pdf", { allowance: 0 }).status.message, /cannot write PDF/);
const proposed = sheet.suggest([], { bound: 0.5 });
assert.ok(proposed.boundMet && proposed.cuts.length === 0);

const editor = engine.edit(sheet);
assert.equal(editor.add("dart", "d", [0, 0, 0, 1, 1, 0.5], "geodesic", false).name, "Ok");
assert.ok(Math.abs(editor.curves()[0].length - 1.5) < 1e-12);
assert.deepEqual(editor.curves()[0].kinds, ["geodesic"]);
// A quarter beside the diagonal a line is shorter by as much at both ends, where the halves are right-angled.
assert.notEqual(editor.addOffset(0, 2).name, "Ok");
assert.equal(editor.addOffset(0, 0.25).name, "Ok");
assert.ok(editor.curves()[1].length < editor.curves()[0].length);
editor.undo();
// x and y are alike.
assert.equal(editor.add("seam", "s", [0.2, 0, 0, 0.9, 0.3, 0.15], "geodesic", false).name, "Ok");
assert.equal(editor.addImage(1).name, "Ok");
assert.ok(difference(Array.from(editor.curves()[2].nodes), [0, 0.2, 0, 0.3, 0.9, 0.15]) < 1e-6, `${editor.curves()[2].nodes}`);
editor.undo();
editor.undo();
editor.undo();
assert.equal(editor.curves().length, 0);
assert.ok(editor.canRedo());
assert.notEqual(editor.remove(7).name, "Ok");

assert.equal(editor.addStroke([0, 0, 0, 0.5, 0.5, 0.25, 1, 1, 0.5], 0.01).name, "Ok");
assert.ok(Math.abs(editor.curves()[0].length - 1.5) < 1e-6);
assert.ok(engine.materials().some(({ name }) => name === "denim"));

// Errors name what is wrong and where.
assert.throws(() => read("broken.obj", "v 0 0\nf 1 2 3\n"), /broken\.obj:1: a vertex needs three/);
assert.throws(() => read("picture.png", "no surface"), /picture\.png/);
assert.throws(() => engine.makeSurface([0, 0, 0, 1], corners), /three numbers/);
assert.throws(() => sheet.flatten([], { scheme: "nonsense" }), /scheme must be one of .*isometric/);
assert.throws(() => sheet.flatten([], { no_such: 1 }), /no_such/);
assert.throws(() => sheet.flatten([{ type: "zip", points }]), /zip.*dart/);
assert.throws(() => editor.add("dart", "d", [0, 0], "geodesic", false), /three numbers/);
assert.throws(() => editor.moveNode(0, 0, []), /three numbers/);
const refused = (surface, words) => {
  const { refused: is, status } = surface.flatten().report();
  assert.ok(is && words.test(status.message), status.message);
};
refused(engine.makeSurface(points, [0, 1, 9]), /outside 0\.\.3/);
refused(engine.makeSurface([NaN, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]), /not a finite number/);
refused(engine.makeSurface([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], [0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2]), /closed/);
assert.throws(() => engine.edit(engine.makeSurface(points, [0, 1, 9])), /outside 0\.\.3/);
assert.equal(drawn.pattern("bmp").status.name, "InvalidOption");
console.log("patterns, curves and errors are as they should be");

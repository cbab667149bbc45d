// SPDX-License-Identifier: BSD-3-Clause
// Files that are opened, their measures, patterns that are saved, and what is wrong with broken ones.
import assert from "node:assert/strict";
import test from "node:test";
import { answered, checkAccess, grid, native, openExample, openPage, openText, picture, saved, verdict, withBrowser } from "./browser.mjs";

const sheet = "v 0 0 0\nv 30 0 0\nv 30 20 8\nv 0 20 0\nf 1 2 3\nf 1 3 4\n";
const tetrahedron = "# units: cm\nv 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";

await test("files", () => withBrowser(async (browser, address) => {
  const page = await openPage(browser, address);
  await checkAccess(page);
  const pieces = native("pieces");

  for (const name of ["shirt_front", "tshirt", "shoe_upper", "wetsuit_pants_back"]) {
    await openExample(page, `${name}_lines.obj`);
    const { rows, lengths } = await page.evaluate(() => ({ rows: window.workbench.report.pieces, lengths: window.workbench.report.curves }));
    const wanted = pieces[name];
    assert.equal(rows.length, wanted.E_area.length, name);
    rows.forEach((row, k) => assert.ok(Math.abs(row.E_area - wanted.E_area[k]) <= 1e-9, `${name}: ${row.E_area}, natively ${wanted.E_area[k]}`));
    lengths.forEach((row) => assert.ok(Math.abs(row.length_2d / row.length_3d - 1) < 1e-9, row.name));
    await picture(page, name);
  }

  await openExample(page, "shirt_front_lines.obj");
  await checkAccess(page);
  await page.click("#pattern");
  await checkAccess(page);
  await picture(page, "pattern_dialog");
  for (const [format, start, unit] of [["svg", "<?xml", "mm"], ["dxf", "0\r\nSECTION", "EOF"]]) {
    await page.selectOption("#pattern-format", format);
    const { name, text } = await saved(page, () => page.click("#pattern-save"));
    assert.equal(name, `shirt_front_lines.${format}`);
    assert.ok(text.trimStart().startsWith(start) && text.includes(unit), text.slice(0, 80));
    await page.click("#pattern");
  }
  await page.keyboard.press("Escape");

  // A file without a unit is asked for one; the answer sets the sizes.
  await openText(page, "sheet.obj", sheet);
  await page.waitForSelector("#unit-dialog[open]");
  await picture(page, "unit_dialog");
  await page.check("#unit-dialog input[value=mm]");
  await page.click("#unit-dialog .main");
  await answered(page);
  assert.match(await page.textContent("#surface-panel"), /3\.00 x 2\.00 x 0\.800 cm/);

  await openText(page, "broken.obj", "v 0 0\nf 1 2 3\n");
  await verdict(page, /broken\.obj:1: a vertex needs three/);
  assert.match(await page.textContent("#surface-panel"), /sheet\.obj/); // it is still open
  await openText(page, "picture.ply", "no surface");
  await verdict(page, /picture\.ply/);
  await openText(page, "lines.json", "{}");
  await verdict(page, /not a file of curves that this page has saved/);
  await openText(page, "tetrahedron.obj", tetrahedron);
  await verdict(page, /cannot be flattened.*closed.*Propose cuts/);
  await picture(page, "closed");
  await page.click("#propose");
  await page.waitForSelector("#proposal-panel .card", { timeout: 60_000 });
  await picture(page, "proposals");
  await page.click("#proposal-panel button.main");
  await answered(page);
  await verdict(page, /fits|lies flat/);

  // A search that is cancelled leaves the cuts found by then.
  const bumps = 48;
  const dents = Array.from({ length: bumps * 2 * bumps }, (_, k) => {
    const [a, b] = [Math.PI * (Math.floor(k / (2 * bumps)) + 0.5) / bumps, Math.PI * (k % (2 * bumps)) / bumps];
    const r = 1 + 0.3 * Math.sin(5 * a) * Math.cos(4 * b);
    return `v ${r * Math.sin(a) * Math.cos(b)} ${r * Math.sin(a) * Math.sin(b)} ${r * Math.cos(a)}`;
  });
  const around = Array.from({ length: 2 * bumps }, (_, k) => k);
  const faces = Array.from({ length: bumps - 1 }, (_, i) => around.map((j) => {
    const [a, b] = [2 * bumps * i + j + 1, 2 * bumps * i + (j + 1) % (2 * bumps) + 1];
    return `f ${a} ${a + 2 * bumps} ${b + 2 * bumps} ${b}`;
  })).flat();
  const [last, pole] = [2 * bumps * (bumps - 1), 2 * bumps * bumps + 1];
  const caps = around.flatMap((j) => {
    const next = (j + 1) % (2 * bumps);
    return [`f ${pole} ${j + 1} ${next + 1}`, `f ${pole + 1} ${last + next + 1} ${last + j + 1}`];
  });
  await openText(page, "bumps.obj", ["# units: cm", ...dents, "v 0 0 1", "v 0 0 -1", ...faces, ...caps, ""].join("\n"));
  await verdict(page, /cannot be flattened.*closed.*Propose cuts/);
  await page.click("#propose");
  await page.waitForFunction(() => window.workbench.ghosts.length > 0, null, { timeout: 60_000 });
  await picture(page, "preview");
  await page.click("#cancel");
  await page.click("#proposal-panel button.main");
  await answered(page);
  await verdict(page, /pieces; worst/);

  // A ramp of 1.4 turns covers a part of the plane twice.
  const ramp = Array.from({ length: 61 }, (_, k) => [1, 2].map((r) => `v ${r * Math.cos(0.147 * k)} ${r * Math.sin(0.147 * k)} ${0.03 * k}`)).flat();
  const quads = Array.from({ length: 60 }, (_, k) => `f ${2 * k + 1} ${2 * k + 2} ${2 * k + 4} ${2 * k + 3}`);
  await openText(page, "ramp.obj", ["# units: cm", ...ramp, ...quads, ""].join("\n"));
  await verdict(page, /lies over itself: part it by a seam/);

  // Of darts alone, and seams in about three pieces; a line in the mirror and one beside it.
  await openExample(page, "shirt_front.obj");
  for (const [cuts, pieces, word] of [["darts", "", "dart"], ["seams", "3", "seam"]]) {
    await page.getByRole("combobox", { name: "Propose" }).selectOption(cuts);
    await page.getByRole("spinbutton", { name: "Pieces, about" }).fill(pieces);
    await page.click("#propose");
    await page.waitForFunction((type) => document.querySelector("#proposal-panel .card")?.textContent.includes(type), word, { timeout: 60_000 });
  }
  await page.click("#proposal-panel .card button");
  await answered(page);
  const lines = () => page.evaluate(() => window.workbench.lines());
  const [first] = await lines();
  await page.getByRole("textbox", { name: "Name of line 1" }).focus();
  await page.getByRole("button", { name: "Mirror" }).click();
  await page.waitForFunction(() => window.workbench.lines().length === 2);
  const [, image] = await lines();
  assert.ok(Math.abs(image.length / first.length - 1) < 0.01, `${first.length}, mirrored ${image.length}`);
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => window.workbench.lines().length === 1);
  await page.getByRole("button", { name: /^Offset/ }).click();
  await page.waitForFunction(() => window.workbench.lines().length > 1);
  await picture(page, "copies");

  // The memory of a large surface is free when another one is opened.
  const megabytes = () => page.evaluate(async () => (await window.workbench.memory()) / 1e6);
  await openText(page, "huge.obj", grid(710));
  await verdict(page, /huge\.obj has 1,008,200 triangles\. Reduce it to at most 200,000/);
  const large = await megabytes();
  await openExample(page, "shirt_front.obj");
  const small = await megabytes();
  console.log(`memory with 1,008,200 triangles ${large.toFixed(0)} MB, then with a shirt ${small.toFixed(0)} MB`);
  assert.ok(small < 0.5 * large, `${large} MB, then ${small} MB`);
  assert.deepEqual(page.errors, []);

  const old = await openPage(browser, address, { prepare: (tab) => tab.addInitScript(() => delete window.WebAssembly) });
  await verdict(old, /no WebAssembly/);
  const plain = await openPage(browser, address, { prepare: (tab) => tab.addInitScript(() => (HTMLCanvasElement.prototype.getContext = () => null)) });
  await verdict(plain, /no 3D graphics/);
}));

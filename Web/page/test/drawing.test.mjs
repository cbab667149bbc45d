// SPDX-License-Identifier: BSD-3-Clause
// Curves drawn, dragged, typed and undone by mouse, keys and touch; the tutorial's five curves get its measures.
import assert from "node:assert/strict";
import test from "node:test";
import { answered, checkAccess, native, openExample, openPage, openText, picture, saved, withBrowser } from "./browser.mjs";

const state = (page) => page.evaluate(() => window.workbench.lines());

/** Shows the side from which a place of the surface is seen best, and gives a pixel there. */
async function pixelOf(page, place) {
  for (const side of ["Front", "Left", "Right"]) {
    await page.getByRole("button", { name: side, exact: true }).click();
    const found = await page.evaluate(([x, y, z]) => {
      const { surface } = window.workbench.scene;
      const at = surface.view.pixelOf([x, y, z]);
      const near = 5 * surface.view.unitsPerPixel();
      for (const [right, down] of [[0, 0], [2, 0], [-2, 0], [0, 2], [0, -2]]) {
        const hit = surface.hit(at.x + right, at.y + down);
        if (hit && Math.hypot(hit.position[0] - x, hit.position[1] - y, hit.position[2] - z) < near) {
          const { left, top } = surface.view.canvas.getBoundingClientRect();
          return { x: left + at.x + right, y: top + at.y + down };
        }
      }
      return null;
    }, place);
    if (found) {
      return found;
    }
  }
  throw new Error(`${place} is not seen`);
}

async function clickAt(page, place) {
  const { x, y } = await pixelOf(page, place);
  await page.mouse.move(x, y);
  await page.mouse.click(x, y);
  await answered(page);
}

/** Draws a curve by clicks on its nodes and names it. */
async function draw(page, { type, name, nodes }) {
  const before = (await state(page)).length;
  await page.click(`[data-tool=${type}]`);
  for (const node of nodes) {
    await clickAt(page, node);
  }
  await page.keyboard.press("Enter");
  const field = page.getByRole("textbox", { name: `Name of line ${before + 1}` });
  await field.fill(name);
  await field.press("Tab");
  await answered(page);
}

await test("the tutorial by mouse", () => withBrowser(async (browser, address) => {
  const page = await openPage(browser, address);
  await openExample(page, "shirt_front.obj");
  await page.selectOption("#kind", "section");
  const tutorial = native("tutorial");
  for (const curve of tutorial.curves) {
    await draw(page, curve);
  }
  await page.click("[data-tool=select]");
  await page.getByRole("button", { name: "Front", exact: true }).click();
  await checkAccess(page);
  await picture(page, "tutorial");
  const { E_area, E_ang, lengths } = await page.evaluate(() => {
    const { pieces, curves } = window.workbench.report;
    return { ...pieces[0], lengths: curves.map((row) => row.length_2d) };
  });
  const near = (actual, wanted, what) => assert.ok(Math.abs(actual / wanted - 1) < 1e-6, `${what}: ${actual}, natively ${wanted}`);
  near(E_area, tutorial.E_area, "area error");
  near(E_ang, tutorial.E_ang, "angle error");
  lengths.forEach((length, k) => near(length, tutorial.lengths[k], tutorial.curves[k].name));

  // A drag flattens live; one step of undo takes it back.
  const before = await state(page);
  const from = await pixelOf(page, tutorial.curves[1].nodes[1]);
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  for (let k = 1; k <= 12; ++k) {
    await page.mouse.move(from.x + 2 * k, from.y - 4 * k);
    await page.waitForTimeout(30);
  }
  const drafts = await page.evaluate(() => window.workbench.drafts);
  await picture(page, "dragged");
  await page.mouse.up();
  await answered(page);
  assert.ok(drafts > 2, `${drafts} drafts while dragging`);
  const after = await state(page);
  assert.ok(after[1].length > before[1].length + 0.01, `${before[1].length}, dragged ${after[1].length}`);
  await page.keyboard.press("Control+z");
  await answered(page);
  assert.deepEqual(await state(page), before);
  await page.keyboard.press("Control+y");
  await page.keyboard.press("Control+z");
  await answered(page);

  // Saved lines come back on the same surface.
  const { name, text } = await saved(page, () => page.click("#save"));
  assert.equal(name, "shirt_front_lines.json");
  await openExample(page, "shirt_front.obj");
  assert.equal((await state(page)).length, 0);
  await openText(page, name, text);
  await page.waitForFunction(() => window.workbench.lines().length === 5);
  await answered(page);
  const again = await state(page);
  again.forEach((curve, k) => near(curve.length, before[k].length, curve.name));

  // Another type, by its list.
  await page.getByRole("combobox", { name: "Type of centre_front" }).or(page.getByRole("combobox", { name: "Type of center_front" })).selectOption("straight");
  await answered(page);
  assert.equal((await state(page))[0].type, "straight");

  // A woven cloth along the grain.
  await page.getByRole("combobox", { name: "Material" }).selectOption("denim");
  await answered(page);
  await page.getByRole("spinbutton", { name: "Grain" }).fill("10");
  await page.keyboard.press("Tab");
  await answered(page);
  const cloth = await page.evaluate(() => window.workbench.report.pieces[0].cloth);
  near(cloth.grain_angle, 10, "grain");

  // The same place is shown in both views.
  const at = await pixelOf(page, tutorial.curves[1].nodes[1]);
  await page.mouse.move(at.x, at.y + 40);
  await picture(page, "linked");
  const pointed = await page.evaluate(() => window.workbench.scene.pointedPlace());
  assert.ok(pointed && pointed.plane[2] === 0);
  assert.deepEqual(page.errors, []);
}));

await test("freehand, keys and touch", () => withBrowser(async (browser, address) => {
  const page = await openPage(browser, address, { hasTouch: true });
  await openExample(page, "shirt_front.obj");
  const box = await page.locator("#surface").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.click("[data-tool=accessory]");
  await page.click("#freehand");
  await page.mouse.move(x - 80, y);
  await page.mouse.down();
  for (let k = 0; k <= 20; ++k) {
    await page.mouse.move(x - 80 + 8 * k, y + 15 * Math.sin(k / 3));
  }
  await page.mouse.up();
  await page.waitForFunction(() => window.workbench.lines().length === 1);
  const [stroke] = await state(page);
  assert.ok(stroke.nodes >= 3 && stroke.nodes <= 12, `${stroke.nodes} nodes`);

  // By keys alone: a dart from a point in the middle upward.
  await page.click("#freehand");
  await page.focus("#surface");
  await page.keyboard.press("d");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press(" ");
  await page.waitForFunction(() => window.workbench.lines().length === 2);
  for (let k = 0; k < 8; ++k) {
    await page.keyboard.press("ArrowUp");
  }
  await page.keyboard.press(" ");
  await page.waitForFunction(() => window.workbench.lines()[1].nodes === 2);
  await page.keyboard.press("Enter");
  await answered(page);
  await picture(page, "keys");
  assert.equal((await state(page))[1].type, "dart");
  await page.keyboard.press("Delete");
  await page.waitForFunction(() => window.workbench.lines().length === 1);

  // By fingers.
  await page.click("[data-tool=seam]");
  await page.touchscreen.tap(x, box.y + 160);
  await page.waitForFunction(() => window.workbench.lines().length === 2);
  await page.touchscreen.tap(x + 20, box.y + 220);
  await page.waitForFunction(() => window.workbench.lines()[1]?.nodes === 2);
  await page.click("[data-tool=select]");
  await answered(page);
  assert.deepEqual(page.errors, []);
}));

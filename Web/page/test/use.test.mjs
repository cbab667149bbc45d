// SPDX-License-Identifier: BSD-3-Clause
// Times, sizes, the dark and the small screen, and use without a network.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { gzipSync } from "node:zlib";
import { answered, checkAccess, grid, openExample, openPage, openText, pageFolder, picture, saved, withBrowser } from "./browser.mjs";

/** Limits hold for two processors that nothing else uses; beside other work they are multiplied by this. */
const slack = Number(process.env.SLACK ?? 4);

/** In the page: draws a line and moves its end. Gives the mean time in milliseconds from a move to its pieces, once all is drawn. */
async function timeEdits() {
  const { workbench } = window;
  const { surface } = workbench.scene;
  const at = (right) => surface.hit(surface.view.size.x * right, surface.view.size.y / 2).position;
  const until = async (isDone) => {
    while (!isDone()) {
      await new Promise((resolve) => setTimeout(resolve, 1));
    }
  };
  const curve = { type: "accessory", name: "timed", closed: false, nodes: [...at(0.3), ...at(0.6)], kinds: ["geodesic"] };
  workbench.apply(await workbench.editor.call("addCurves", [curve]), false);
  await until(() => workbench.isSettled());
  const count = 5;
  let total = 0;
  for (let k = 1; k <= count; ++k) {
    await new Promise((resolve) => setTimeout(resolve, 300)); // without a graphics card drawing takes long
    const { drafts } = workbench;
    const start = performance.now();
    workbench.apply(await workbench.editor.call("moveNode", 0, 1, at(0.6 + 0.01 * k), 0), true);
    await until(() => workbench.drafts > drafts);
    total += performance.now() - start;
  }
  return total / count;
}

await test("size", () => {
  const sizes = readdirSync(pageFolder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
    .map((entry) => gzipSync(readFileSync(join(entry.parentPath ?? entry.path, entry.name)), { level: 9 }).length);
  const total = sizes.reduce((a, b) => a + b, 0);
  console.log(`${(total / 1e6).toFixed(2)} MB compressed`);
  assert.ok(total < 4e6);
});

await test("times", () => withBrowser(async (browser, address) => {
  const page = await openPage(browser, address);
  await page.reload();
  await page.waitForSelector("body[data-ready]");
  const ready = Number(await page.getAttribute("body", "data-ready"));
  console.log(`ready after ${ready} ms`);
  assert.ok(ready <= 2000 * slack);
  for (const [side, editLimit, flatLimit] of [[32, 100, 1000], [100, 1000, 5000], [224, Infinity, 5000]]) {
    await openText(page, `grid${side}.obj`, grid(side));
    await page.waitForFunction((name) => document.querySelector("#surface-panel").textContent.includes(name), `grid${side}.obj`);
    await answered(page);
    const flat = await page.evaluate(() => window.workbench.milliseconds);
    const edit = await page.evaluate(timeEdits);
    console.log(`${2 * side * side} triangles: flattened in ${flat.toFixed(0)} ms, an edit answered in ${edit.toFixed(0)} ms`);
    assert.ok(flat <= flatLimit * slack && edit <= editLimit * slack);
  }
  assert.deepEqual(page.errors, []);
}));

await test("without a network", () => withBrowser(async (browser, address) => {
  const page = await openPage(browser, address);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(async () => (await caches.keys()).length === 1 && (await (await caches.open((await caches.keys())[0])).keys()).length > 8);
  await page.reload();
  await page.waitForFunction(() => navigator.serviceWorker.controller);
  await page.context().setOffline(true);
  await page.reload();
  await page.waitForSelector("body[data-ready]");
  await openExample(page, "shirt_front_lines.obj");
  await page.click("#pattern");
  const { text } = await saved(page, () => page.click("#pattern-save"));
  assert.ok(text.startsWith("%PDF"));
  assert.deepEqual(page.errors, []);
}));

await test("dark, and on a phone", () => withBrowser(async (browser, address) => {
  const dark = await openPage(browser, address, { colorScheme: "dark" });
  await openExample(dark, "shirt_front_lines.obj");
  await checkAccess(dark);
  await picture(dark, "dark");
  const phone = await openPage(browser, address, { viewport: { width: 390, height: 800 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
  await openExample(phone, "tshirt_lines.obj");
  await checkAccess(phone);
  assert.equal(await phone.evaluate(() => window.workbench.scene.surface.up()), "y"); // a tube stands as its file has it
  await picture(phone, "phone");
  assert.ok(await phone.evaluate(() => document.documentElement.scrollWidth) <= 390, "wider than the phone");
  const tablet = await openPage(browser, address, { viewport: { width: 820, height: 1100 } });
  await openExample(tablet, "shoe_upper_lines.obj");
  await picture(tablet, "tablet");
  assert.deepEqual([...dark.errors, ...phone.errors, ...tablet.errors], []);
}));

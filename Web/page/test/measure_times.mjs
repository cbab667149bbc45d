// SPDX-License-Identifier: BSD-3-Clause
// Prints how long the page takes to be ready, to flatten, and to answer an edit. Compare on a machine that does nothing else.
import { answered, grid, openPage, openText, withBrowser } from "./browser.mjs";

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

await withBrowser(async (browser, address) => {
  const page = await openPage(browser, address);
  await page.reload();
  await page.waitForSelector("body[data-ready]");
  const ready = Number(await page.getAttribute("body", "data-ready"));
  console.log(`ready after ${ready} ms`);
  for (const side of [32, 100, 224]) {
    await openText(page, `grid${side}.obj`, grid(side));
    await page.waitForFunction((name) => document.querySelector("#surface-panel").textContent.includes(name), `grid${side}.obj`);
    await answered(page);
    const flat = await page.evaluate(() => window.workbench.milliseconds);
    const edit = await page.evaluate(timeEdits);
    console.log(`${2 * side * side} triangles: flattened in ${flat.toFixed(0)} ms, an edit answered in ${edit.toFixed(0)} ms`);
  }
});


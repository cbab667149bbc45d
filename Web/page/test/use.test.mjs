// SPDX-License-Identifier: BSD-3-Clause
// Size, the dark and the small screen, and use without a network.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import test from "node:test";
import { gzipSync } from "node:zlib";
import { checkAccess, openExample, openPage, pageFolder, picture, saved, withBrowser } from "./browser.mjs";

await test("size", () => {
  const sizes = readdirSync(pageFolder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile())
    .map((entry) => gzipSync(readFileSync(join(entry.parentPath ?? entry.path, entry.name)), { level: 9 }).length);
  const total = sizes.reduce((a, b) => a + b, 0);
  console.log(`${(total / 1e6).toFixed(2)} MB compressed`);
  assert.ok(total < 4e6);
});

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

// SPDX-License-Identifier: BSD-3-Clause
// The page in a browser, for the tests beside this file.
import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import axe from "axe-core";
import { chromium } from "playwright-core";
import { serve } from "./serve.mjs";

const build = fileURLToPath(new URL("../../../build-web/", import.meta.url));
export const pictures = `${build}pictures`;
export const pageFolder = `${build}page`;

/** The native build's numbers: of "pieces" or of the "tutorial". */
export const native = (name) => JSON.parse(readFileSync(`${build}${name}.json`, "utf8"));

/** Starts a server and a browser; use() gets a new page. */
export async function withBrowser(use) {
  mkdirSync(pictures, { recursive: true });
  const server = await serve(pageFolder);
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--enable-unsafe-swiftshader", ...(process.getuid() === 0 ? ["--no-sandbox"] : [])],
  });
  try {
    return await use(browser, server.address);
  } finally {
    await browser.close();
    server.close();
  }
}

/** A page that is ready; its errors fail the test. */
export async function openPage(browser, address, options = {}) {
  const { prepare, ...settings } = options;
  const context = await browser.newContext({ viewport: { width: 1400, height: 850 }, ...settings });
  const page = await context.newPage();
  const errors = [];
  page.on("pageerror", (error) => errors.push(error.message));
  await prepare?.(page);
  await page.goto(address);
  await page.waitForSelector("body[data-ready], #verdict.problem");
  page.errors = errors;
  return page;
}

export async function openExample(page, file) {
  await page.selectOption("#examples", file);
  await answered(page);
}

export async function openText(page, name, text) {
  await page.setInputFiles("#file", { name, mimeType: "text/plain", buffer: Buffer.from(text) });
}

/** Waits for the careful result of the last command. */
export async function answered(page) {
  await page.waitForFunction(() => window.workbench.isSettled() && document.querySelector("#piece-panel .card"), null, { timeout: 60_000 });
}

export async function verdict(page, pattern) {
  await page.waitForFunction((source) => new RegExp(source).test(document.querySelector("#verdict").textContent), pattern.source, { timeout: 60_000 })
    .catch(async () => assert.match(await page.textContent("#verdict"), pattern));
  return page.textContent("#verdict");
}

export async function picture(page, name) {
  await page.waitForTimeout(300);
  await page.screenshot({ path: `${pictures}/${name}.png` });
}

/** Fails where axe-core finds something serious in what the page shows. */
export async function checkAccess(page) {
  await page.evaluate(axe.source);
  const { violations } = await page.evaluate(() => window.axe.run());
  const serious = violations.filter(({ impact }) => impact === "serious" || impact === "critical");
  assert.deepEqual(serious.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html.slice(0, 120)).join(" | ")}`), []);
}

/** A wavy sheet of two triangles a square. */
export function grid(side) {
  const lines = ["# units: cm"];
  for (let k = 0; k <= side; ++k) {
    for (let j = 0; j <= side; ++j) {
      lines.push(`v ${(100 * j) / side} ${(100 * k) / side} ${(5 * Math.sin((6 * j) / side) * Math.sin((6 * k) / side)).toFixed(4)}`);
    }
  }
  for (let k = 0; k < side; ++k) {
    for (let j = 1; j <= side; ++j) {
      const a = k * (side + 1) + j;
      lines.push(`f ${a} ${a + 1} ${a + side + 2}`, `f ${a} ${a + side + 2} ${a + side + 1}`);
    }
  }
  return lines.join("\n");
}

/** What a click makes the page save: { name, text }. */
export async function saved(page, click) {
  const [download] = await Promise.all([page.waitForEvent("download"), click()]);
  const path = await download.path();
  return { name: download.suggestedFilename(), path, text: readFileSync(path, "latin1") };
}

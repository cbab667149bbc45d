// SPDX-License-Identifier: BSD-3-Clause
// The PDF of the page at true scale, measured by poppler.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdtempSync, readFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { openExample, openPage, pictures, saved, withBrowser } from "./browser.mjs";

const millimeters = (points) => (points * 25.4) / 72;

/** Corners of the paths of a page as poppler draws them, in millimeters. */
function pathsOf(pdf, page) {
  const file = join(mkdtempSync(join(tmpdir(), "page-")), "page.svg");
  execFileSync("pdftocairo", ["-svg", "-f", String(page), "-l", String(page), pdf, file]);
  return cornersIn(readFileSync(file, "utf8"), 25.4 / 72);
}

/** Of the paths of an SVG, in its own unit times a factor. */
function cornersIn(svg, factor) {
  return Array.from(svg.matchAll(/<path [^>]*>/g), ([element]) => {
    const numbers = (/ d="([^"]*)"/.exec(element)?.[1].match(/-?[\d.]+/g) ?? []).map(Number);
    const [a, b, c, d, e, f] = (/matrix\(([^)]*)\)/.exec(element)?.[1].split(/[ ,]+/) ?? [1, 0, 0, 1, 0, 0]).map(Number);
    const corners = [];
    for (let k = 0; k + 1 < numbers.length; k += 2) {
      const [x, y] = [numbers[k], numbers[k + 1]];
      corners.push([factor * (a * x + c * y + e), factor * (b * x + d * y + f)]);
    }
    return corners;
  });
}

/** Width and height of the test rectangle of a page in millimeters, between the middles of its lines. */
function rectangleOf(pdf) {
  const perMillimeter = 20;
  const image = execFileSync("pdftoppm", ["-gray", "-r", String(25.4 * perMillimeter), "-l", "1", "-x", "0", "-y", "0", "-W", "3000", "-H", "2000", pdf], { maxBuffer: 1e8 });
  const [head, width, height] = /^P5\s+(\d+)\s+(\d+)\s+255\s/.exec(image.toString("latin1", 0, 40));
  const isDark = (x, y) => image[head.length + y * Number(width) + x] < 128;
  const spans = [];
  for (let y = 0; y < Number(height); ++y) {
    for (let x = 0, start = -1; x < Number(width); ++x) {
      start = isDark(x, y) ? (start < 0 ? x : start) : -1;
      if (start >= 0 && !isDark(x + 1, y) && x - start > 90 * perMillimeter) {
        spans.push({ y, length: x - start + 1 });
      }
    }
  }
  const lineWidth = spans.filter(({ y }) => y < spans[0].y + perMillimeter).length;
  return [spans[0].length - lineWidth, spans[spans.length - 1].y - spans[0].y + 1 - lineWidth].map((pixels) => pixels / perMillimeter);
}

/** How many runs of columns with ink the first mask of a PDF has. */
function lettersOf(pdf) {
  const file = join(mkdtempSync(join(tmpdir(), "mask-")), "mask");
  execFileSync("pdfimages", ["-l", "1", pdf, file]);
  const image = readFileSync(`${file}-000.pbm`);
  const [head, width, height] = /^P4\s+(\d+)\s+(\d+)\s/.exec(image.toString("latin1", 0, 40));
  const rows = Array.from({ length: Number(height) }, (_, y) => image.subarray(head.length + (y * width) / 8, head.length + ((y + 1) * width) / 8));
  const ink = Array.from({ length: Number(width) }, (_, x) => rows.some((row) => (row[x >> 3] >> (7 - (x % 8))) & 1));
  return ink.filter((isInk, x) => isInk && !ink[x - 1]).length;
}

const extent = (corners) => [0, 1].map((axis) => Math.max(...corners.map((p) => p[axis])) - Math.min(...corners.map((p) => p[axis])));

await test("PDF", () => withBrowser(async (browser, address) => {
  const page = await openPage(browser, address);
  await openExample(page, "shirt_front_lines.obj");
  await page.click("#pattern");
  await page.selectOption("#pattern-format", "svg");
  await page.fill("#pattern-allowance", "0");
  const { text: narrow } = await saved(page, () => page.click("#pattern-save"));
  await page.click("#pattern");
  await page.selectOption("#pattern-format", "svg");
  const { text: svg } = await saved(page, () => page.click("#pattern-save"));
  assert.match(svg, /width="[\d.]+mm"/);
  const outlines = cornersIn(svg, 1).map(extent);
  const largest = (sizes) => sizes.reduce((a, b) => (b[0] * b[1] > a[0] * a[1] ? b : a));
  const wanted = largest(outlines);
  // The allowance of 10 mm is outside of the sew line.
  const added = largest(cornersIn(narrow, 1).map(extent)).map((side, axis) => wanted[axis] - side);
  assert.ok(added.every((side) => side > 19 && side < 25), `${added}`);
  for (const [paper, width, height] of [["A4", 210, 297], ["letter", 215.9, 279.4], ["A0", 841, 1189], ["sheet", 0, 0]]) {
    await page.click("#pattern");
    await page.selectOption("#pattern-paper", paper);
    const { path, name } = await saved(page, () => page.click("#pattern-save"));
    assert.equal(name, "shirt_front_lines.pdf");
    const info = execFileSync("pdfinfo", [path], { encoding: "utf8" });
    const pages = Number(/Pages:\s+(\d+)/.exec(info)[1]);
    const [w, h] = /Page size:\s+([\d.]+) x ([\d.]+)/.exec(info).slice(1).map((points) => millimeters(Number(points)));
    if (width > 0) {
      assert.ok(Math.abs(w - width) < 0.1 && Math.abs(h - height) < 0.1 || Math.abs(w - height) < 0.1 && Math.abs(h - width) < 0.1, `${w} x ${h}`);
    }
    const square = rectangleOf(path);
    assert.ok(Math.abs(square[0] - 100) <= 0.05 && Math.abs(square[1] - 50) <= 0.05, `${square}`);
    assert.match(execFileSync("pdftotext", [path, "-"], { encoding: "utf8" }), /100 mm x 50 mm[^]*shirt_front_lines/);
    console.log(`${paper}: ${pages} pages, the rectangle measures ${square.map((side) => side.toFixed(3)).join(" x ")} mm`);
    if (paper === "sheet") {
      // The outline is as large as in SVG; poppler may shrink what it makes SVG by a thousandth.
      const sizes = pathsOf(path, 1).map(extent).filter(([x]) => x > 300);
      assert.ok(sizes.some((size) => size.every((side, axis) => Math.abs(side / wanted[axis] - 1) < 2e-3)), `${sizes.join("; ")}: none is ${wanted}`);
      copyFileSync(path, `${pictures}/pattern.pdf`);
    } else if (paper === "A4") {
      assert.ok(pages > 4, `${pages} pages`);
      copyFileSync(path, `${pictures}/pattern_a4.pdf`);
    }
  }

  // Letters that no PDF reader's font has.
  await page.click("#pattern");
  await page.fill("#pattern-name", "Ж Ω 前");
  const { path } = await saved(page, () => page.click("#pattern-save"));
  assert.equal(lettersOf(path), 3);
  assert.doesNotMatch(execFileSync("pdftotext", [path, "-"], { encoding: "utf8" }), /\?/);
  copyFileSync(path, `${pictures}/letters.pdf`);
  assert.deepEqual(page.errors, []);
}));

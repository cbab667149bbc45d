// SPDX-License-Identifier: BSD-3-Clause
import { createHash } from "node:crypto";
import { readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { exampleText, examples } from "./examples.mjs";

const at = (path) => fileURLToPath(new URL(path, import.meta.url));

/** Files that are elsewhere: the pieces of Data, the icon, licenses. */
function copies() {
  return {
    name: "copies",
    generateBundle() {
      for (const example of examples) {
        this.emitFile({ type: "asset", fileName: `examples/${example.file}`, source: exampleText(at("../../Data"), example) });
      }
      this.emitFile({ type: "asset", fileName: "manifest.webmanifest", source: readFileSync(at("manifest.webmanifest")) });
      this.emitFile({ type: "asset", fileName: "licenses.txt", source: licenses() });
      this.emitFile({ type: "asset", fileName: "icon.svg", source: readFileSync(at("../../Applications/PatternEditor/patterneditor.svg")) });
    },
  };
}

const bundled = ["three", "pdf-lib", "@pdf-lib/standard-fonts", "@pdf-lib/upng", "pako", "tslib", "clipper-lib"];

/** The license of the project and those of what the page bundles and what it links. */
function licenses() {
  const texts = [`SurfaceFlattening\n\n${readFileSync(at("../../LICENSE"))}`,
    "Eigen (https://eigen.tuxfamily.org) is under the Mozilla Public License 2.0, nlohmann-json under the MIT license."];
  for (const name of bundled) {
    const folder = at(`node_modules/${name}`);
    const file = readdirSync(folder).find((entry) => /^license/i.test(entry));
    const { license, homepage = "" } = JSON.parse(readFileSync(`${folder}/package.json`, "utf8"));
    const text = file ? readFileSync(`${folder}/${file}`, "utf8") : "";
    texts.push(`${name} ${homepage}: ${license}\n\n${text}`);
  }
  return texts.join(`\n${"-".repeat(80)}\n`);
}

/** What lets the page be installed and used without a network. */
function offline() {
  return {
    name: "offline",
    enforce: "post",
    generateBundle(_, bundle) {
      const hash = createHash("sha256");
      const files = Object.keys(bundle).sort();
      for (const file of files) {
        hash.update(bundle[file].code ?? bundle[file].source);
      }
      const head = `const files = ${JSON.stringify(files)};\nconst version = "${hash.digest("hex").slice(0, 16)}";\n`;
      this.emitFile({ type: "asset", fileName: "serviceWorker.js", source: head + readFileSync(at("serviceWorker.js")) });
    },
  };
}

export default defineConfig({
  base: "./",
  plugins: [copies(), offline()],
  define: { __EXAMPLES__: JSON.stringify(examples.map(({ file, words }) => ({ file, words }))) },
  resolve: { alias: { surfaceflattening: at("../../build-web/package") } },
  worker: { format: "es" },
  build: { outDir: at("../../build-web/page"), emptyOutDir: true, target: "es2022", chunkSizeWarningLimit: 1200 },
});

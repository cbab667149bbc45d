// SPDX-License-Identifier: BSD-3-Clause
import { clipperOf } from "./clipper.js";
import create from "./surfaceflattening.mjs";

const wasm = new URL("surfaceflattening.wasm", import.meta.url);

/** Under node the file is read here, in a browser the module fetches it. */
async function settingsOf(given) {
  if (given.wasmBinary || given.instantiateWasm || given.locateFile || wasm.protocol !== "file:") {
    return { locateFile: () => wasm.href, ...given };
  }
  const { readFile } = await import(/* @vite-ignore */ "node:fs/promises");
  return { wasmBinary: await readFile(wasm), ...given };
}

export async function load(given = {}) {
  const { clipper, ...others } = given;
  const module = await create({ ...(await settingsOf(others)), ...(clipper && { clipper: clipperOf(clipper) }) });
  // Functions of C++ take all their arguments.
  for (const [owner, name, count] of [["Surface", "flatten", 3], ["Surface", "suggest", 4], ["Flattening", "pattern", 3]]) {
    const { prototype } = module[owner];
    const whole = prototype[name];
    prototype[name] = function (...given) {
      return whole.apply(this, Array.from({ length: count }, (_, k) => given[k]));
    };
  }
  // A file is known by its ending alone; its name is in messages.
  const inFile = (name, bytes, use) => {
    const path = `/${name.replace(/^.*[\\/]/, "")}`;
    module.FS.writeFile(path, bytes);
    try {
      return use(path);
    } catch (error) {
      throw new Error(error.message.replaceAll(path, path.slice(1)));
    } finally {
      module.FS.unlink(path);
    }
  };
  return {
    readSurface: (name, bytes) => inFile(name, bytes, (path) => module.Surface.ofFile(path)),
    makeSurface: (points, triangles, unit = "") => module.Surface.ofArrays(points, triangles, unit),
    readCurves: (surface, name, bytes) => inFile(name, bytes, (path) => surface.curves(path)),
    edit: (surface) => module.Editor.of(surface),
    options: () => module.options(),
    materials: () => module.materials(),
    memory: () => module.HEAPU8.length,
  };
}

// SPDX-License-Identifier: BSD-3-Clause
// The pieces of Data as OBJ files with their curves, which the engine reads.
import { readFileSync } from "node:fs";
import { inflateSync } from "node:zlib";

export const examples = [
  { piece: "shirt_front", words: "Shirt, front", curves: false },
  { piece: "shirt_front", words: "Shirt, front, with lines", curves: true },
  { piece: "wetsuit_upper_front", words: "Wetsuit, front", curves: false },
  { piece: "wetsuit_pants_back", words: "Wetsuit, back of the pants, with lines", curves: true },
  { piece: "pants_front", words: "Pants, front, with lines", curves: true },
  { piece: "shoe_upper", words: "Shoe, with lines", curves: true },
  { piece: "tshirt", words: "T-shirt, with seams", curves: true },
].map((example) => ({ ...example, file: `${example.piece}${example.curves ? "_lines" : ""}.obj` }));

const types = ["accessory", "key", "dart", "seam"];
const readers = { Float64: Float64Array, Int64: BigInt64Array, Int32: Int32Array, UInt8: Uint8Array, Int8: Int8Array, String: Uint8Array };

/** The arrays of a .vtp file by name, from base64 of zlib's blocks. */
function arraysOf(path) {
  const arrays = {};
  for (const [, attributes, text] of readFileSync(path, "utf8").matchAll(/<(?:Data)?Array ([^>]*)>([^<]*)</g)) {
    const name = /Name="([^"]*)"/.exec(attributes)[1];
    const [, type] = /type="([^"]*)"/.exec(attributes);
    const words = text.trim();
    const count = Buffer.from(words.slice(0, 8), "base64").readUInt32LE(0);
    const headerLength = 4 * Math.ceil((4 * (3 + count)) / 3);
    const header = Buffer.from(words.slice(0, headerLength), "base64");
    const data = Buffer.from(words.slice(headerLength), "base64");
    const blocks = [];
    for (let k = 0, at = 0; k < count; ++k) {
      const size = header.readUInt32LE(4 * (3 + k));
      blocks.push(inflateSync(data.subarray(at, at + size)));
      at += size;
    }
    const bytes = Uint8Array.from(Buffer.concat(blocks));
    // The cells' arrays come after one another: vertices, lines, strips, polygons.
    const values = Array.from(new readers[type](bytes.buffer), Number);
    arrays[name] = [...(arrays[name] ?? []), values];
  }
  return arrays;
}

function cellsOf(arrays) {
  const which = arrays.offsets.findIndex((offsets) => offsets.length > 0);
  const [ids, ends] = [arrays.connectivity[which], arrays.offsets[which]];
  return ends.map((end, k) => ids.slice(k > 0 ? ends[k - 1] : 0, end));
}

/** Of curves each point is a vertex of the surface, bit for bit. */
function linesOf(path, vertexOf) {
  const arrays = arraysOf(path);
  const points = arrays.Points[0];
  const names = String.fromCharCode(...arrays.CurveName[0]).split("\0");
  return cellsOf(arrays).map((ids, k) => {
    const vertices = ids.map((id) => vertexOf.get(points.slice(3 * id, 3 * id + 3).join(" ")));
    return `g ${types[arrays.CurveType[0][k]]} ${names[k]}\nl ${vertices.join(" ")}\n`;
  });
}

export function exampleText(folder, { piece, curves }) {
  const arrays = arraysOf(`${folder}/${piece}.vtp`);
  const points = arrays.Points[0];
  const vertexOf = new Map();
  let text = "# units: cm\n";
  for (let p = 0; p < points.length; p += 3) {
    const place = points.slice(p, p + 3).join(" ");
    text += `v ${place}\n`;
    vertexOf.set(place, p / 3 + 1);
  }
  text += cellsOf(arrays).map((ids) => `f ${ids.map((id) => id + 1).join(" ")}\n`).join("");
  return text + (curves ? linesOf(`${folder}/${piece}_curves.vtp`, vertexOf).join("") : "");
}

// SPDX-License-Identifier: BSD-3-Clause
// Writes the types of the options from the table of the algorithms: node write_types.mjs PACKAGE
import { writeFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";

const folder = process.argv[2];
const { load } = await import(pathToFileURL(`${folder}/index.js`).href);
const types = ["boolean", "number", "number", "", "string", "string[]", "number[]", "number[]"];
const lines = (options) => options.filter(({ type, name }) => name && (type !== 5 || name === "grain"))
  .map(({ name, words, type, help, range, default: value }) =>
    `  /** ${help}${range ? ` In ${range}.` : ""} Default: ${value || "none"}. */\n` +
    `  ${name}?: ${type === 3 ? words.map((word) => JSON.stringify(word)).join(" | ") : types[type]};`).join("\n");
const options = (await load()).options();
await writeFile(`${folder}/options.d.ts`, `// Written by write_types.mjs.
export interface FlatteningOptions {
${lines(options.filter(({ ofSuggestion }) => !ofSuggestion))}
}
export interface SuggestionOptions extends FlatteningOptions {
${lines(options.filter(({ ofSuggestion }) => ofSuggestion))}
}
`);

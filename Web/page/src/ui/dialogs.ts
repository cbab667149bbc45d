// SPDX-License-Identifier: BSD-3-Clause
import type { Unit } from "surfaceflattening";
import { byId, make, option } from "./elements";
import { likeness, sizeWords, units } from "./words";

/** Asks in what unit a file is, beside the sizes that this gives. */
export function askUnit(name: string, extent: readonly number[], likely: Unit): Promise<Unit> {
  const dialog = byId<HTMLDialogElement>("unit-dialog");
  byId("unit-words").textContent = `${name} does not say its unit.`;
  const legend = byId("unit-choices").querySelector("legend") as HTMLElement;
  byId("unit-choices").replaceChildren(legend, ...(Object.keys(units) as Unit[]).map((unit) => {
    const input = make("input", { type: "radio", name: "unit", value: unit, checked: unit === likely });
    const size = Math.max(...extent) * units[unit].metres;
    return make("label", {}, input, ` ${units[unit].words}: ${sizeWords(extent, unit)}, ${likeness(size)}${unit === likely ? " (likely)" : ""}`);
  }));
  dialog.showModal();
  return new Promise((resolve) => {
    dialog.addEventListener("close", () => {
      const chosen = dialog.querySelector<HTMLInputElement>("input:checked");
      resolve((chosen?.value as Unit) ?? likely);
    }, { once: true });
  });
}

export interface PatternChoice {
  format: "pdf" | "svg" | "dxf" | "plt" | "json";
  paper: string;
  name: string;
  /** Millimeters. */
  allowance: number;
}

const formats: Record<PatternChoice["format"], string> = {
  pdf: "PDF, to print on pages", svg: "SVG, for drawing programs and lasers", dxf: "DXF, for CAD and cutters", plt: "HPGL, for plotters", json: "GarmentCode (JSON)",
};
const papers: Record<string, string> = { A4: "A4", letter: "Letter", A3: "A3", A0: "A0", sheet: "one sheet as large as the pattern" };

/** Lets the user choose a format until the dialog is closed. \param save may reject with what is wrong */
export function askPattern(title: string, save: (choice: PatternChoice) => Promise<string>): void {
  const dialog = byId<HTMLDialogElement>("pattern-dialog");
  const name = make("input", { id: "pattern-name", value: title });
  const format = make("select", { id: "pattern-format" }, ...Object.entries(formats).map(([key, words]) => option(key, words)));
  const paper = make("select", { id: "pattern-paper" }, ...Object.entries(papers).map(([key, words]) => option(key, words)));
  const allowance = make("input", { id: "pattern-allowance", type: "number", min: "0", max: "100", step: "any", value: "10" });
  const paperRow = make("label", {}, "Paper", paper);
  format.addEventListener("change", () => (paperRow.hidden = format.value !== "pdf"));
  byId("pattern-fields").replaceChildren(
    make("label", {}, "Name", name), make("label", {}, "Format", format), paperRow,
    make("label", {}, "Seam allowance, mm", allowance), make("p", { class: "quiet" }, "Lines are at true scale: print at 100 %."));
  const message = byId("pattern-message");
  message.textContent = "";
  const form = dialog.querySelector("form") as HTMLFormElement;
  form.onsubmit = (event) => {
    if ((event.submitter as HTMLButtonElement | null)?.value !== "save") {
      return;
    }
    event.preventDefault();
    message.textContent = "";
    save({ format: format.value as PatternChoice["format"], paper: paper.value, name: name.value, allowance: allowance.valueAsNumber || 0 })
      .then((words) => (message.textContent = words) || dialog.close(), (error: Error) => (message.textContent = error.message));
  };
  dialog.showModal();
}

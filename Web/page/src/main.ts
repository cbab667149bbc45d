// SPDX-License-Identifier: BSD-3-Clause
import wasmUrl from "surfaceflattening/surfaceflattening.wasm?url";
import type { Tool } from "./DrawTool";
import { addIcons, byId, option } from "./ui/elements";
import type { Side } from "./view/SurfaceView";
import { Workbench } from "./Workbench";

const sides: Side[] = ["front", "back", "left", "right", "top"];

async function compile(): Promise<WebAssembly.Module> {
  if (typeof WebAssembly !== "object") {
    throw new Error("This browser has no WebAssembly, which the page needs. It is off in some strict modes; any current browser has it.");
  }
  try {
    return await WebAssembly.compileStreaming(fetch(wasmUrl));
  } catch (error) {
    if (error instanceof WebAssembly.CompileError) {
      throw new Error("This browser is too old for the page: its WebAssembly has no exceptions. Take Chrome 95, Firefox 105, Safari 16.4 or later.");
    }
    const reply = await fetch(wasmUrl); // a server that does not say the type of the file
    return WebAssembly.compile(await reply.arrayBuffer());
  }
}

function connect(bench: Workbench): void {
  const click = (id: string, use: () => void): void => byId(id).addEventListener("click", use);
  const tools = Array.from(document.querySelectorAll<HTMLButtonElement>("[data-tool]"));
  const setTool = (tool: string): void => {
    tools.forEach((button) => button.setAttribute("aria-pressed", String(button.dataset.tool === tool)));
    bench.setTool(tool as Tool);
  };
  tools.forEach((button) => button.addEventListener("click", () => setTool(button.dataset.tool ?? "select")));
  const freehand = byId("freehand");
  click("freehand", () => {
    const on = freehand.getAttribute("aria-pressed") !== "true";
    freehand.setAttribute("aria-pressed", String(on));
    bench.setFreehand(on);
  });
  const input = byId<HTMLInputElement>("file");
  const open = (): void => input.click();
  click("open", open);
  click("welcome-open", open);
  input.addEventListener("change", async () => {
    const files = [...(input.files ?? [])];
    input.value = ""; // so that the same file can be chosen again
    for (const file of files) {
      await bench.open(file.name, file.arrayBuffer());
    }
  });
  click("undo", () => bench.step("undo"));
  click("redo", () => bench.step("redo"));
  click("propose", () => void bench.propose());
  click("cancel", () => void bench.cancel());
  click("save", () => bench.save());
  click("pattern", () => bench.askPattern());
  click("fit", () => bench.scene.pieces.fit());
  for (const button of document.querySelectorAll<HTMLButtonElement>("[data-side]")) {
    button.addEventListener("click", () => bench.scene.surface.lookFrom(button.dataset.side as Side));
  }
  connectExamples(bench);
  connectDrop(bench);
  connectKeys(bench, setTool, open);
}

function connectExamples(bench: Workbench): void {
  const list = byId<HTMLSelectElement>("examples");
  list.append(...__EXAMPLES__.map(({ file, words }) => option(file, words)));
  const openExample = (file: string): Promise<void> =>
    bench.open(file, fetch(`examples/${file}`).then((reply) => reply.arrayBuffer()));
  list.addEventListener("change", () => {
    if (list.value) {
      void openExample(list.value);
      list.value = "";
    }
  });
  byId("welcome-example").addEventListener("click", () => void openExample("shirt_front.obj"));
}

function connectDrop(bench: Workbench): void {
  const pane = byId("surface-pane");
  addEventListener("dragover", (event) => {
    event.preventDefault();
    pane.classList.add("drop");
  });
  addEventListener("dragleave", () => pane.classList.remove("drop"));
  addEventListener("drop", async (event) => {
    event.preventDefault();
    pane.classList.remove("drop");
    for (const file of [...(event.dataTransfer?.files ?? [])]) {
      await bench.open(file.name, file.arrayBuffer());
    }
  });
}

function connectKeys(bench: Workbench, setTool: (tool: string) => void, open: () => void): void {
  const { surface, pieces } = bench.scene;
  const tools: Record<string, string> = { v: "select", l: "accessory", k: "key", t: "straight", d: "dart", s: "seam" };
  const actions: Record<string, () => void> = {
    o: open, h: () => byId("freehand").click(), p: () => byId("propose").click(), e: () => byId("pattern").click(),
    Enter: () => bench.endCurve(), Escape: () => bench.endCurve(), Delete: () => bench.removeChosen(), Backspace: () => bench.removeChosen(),
    "0": () => pieces.fit(),
  };
  addEventListener("keydown", (event) => {
    const target = event.target as HTMLElement;
    if (target.closest("input, select, dialog") || (target.closest("button, summary") && /^( |Enter)$/.test(event.key))) {
      return;
    }
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.ctrlKey || event.metaKey) {
      const command = { z: event.shiftKey ? "redo" : "undo", y: "redo", s: "save" }[key];
      if (command) {
        byId(command).click();
        event.preventDefault();
      }
      return;
    }
    const isPieces = target.id === "pieces";
    const arrows: Record<string, [number, number]> = { ArrowLeft: [-30, 0], ArrowRight: [30, 0], ArrowUp: [0, 30], ArrowDown: [0, -30] };
    if (isPieces && arrows[key]) {
      pieces.pan(...arrows[key]);
      event.preventDefault();
    } else if (key === "+" || key === "-") {
      (isPieces ? pieces : surface).zoom(key === "+" ? 1.25 : 0.8);
    } else if (sides[Number(key) - 1]) {
      surface.lookFrom(sides[Number(key) - 1]);
    } else if (tools[key]) {
      setTool(tools[key]);
    } else {
      actions[key]?.();
    }
  });
}

declare global {
  const __EXAMPLES__: { file: string; words: string }[];
  interface Window {
    /** For tests and scripts. */
    workbench: Workbench;
  }
}

addIcons();
try {
  const bench = new Workbench(await compile());
  await bench.start();
  connect(bench);
  window.workbench = bench;
  document.body.dataset.ready = String(Math.round(performance.now()));
  if (import.meta.env.PROD && "serviceWorker" in navigator) {
    // Without it the page works while there is a network.
    navigator.serviceWorker.register("serviceWorker.js").catch(() => {});
  }
} catch (error) {
  const { message } = error as Error;
  byId("verdict").textContent = /WebGL/.test(message) ? "This browser shows no 3D graphics (WebGL), which the page needs. Turn hardware acceleration on in its settings." : message;
  byId("verdict").classList.add("problem");
}

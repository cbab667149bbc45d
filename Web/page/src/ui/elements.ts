// SPDX-License-Identifier: BSD-3-Clause
// Small helpers for elements of the page.

export function byId<T extends HTMLElement = HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (!found) {
    throw new Error(`the page has no ${id}`);
  }
  return found as T;
}

type Given<K extends keyof HTMLElementTagNameMap> = Partial<Omit<HTMLElementTagNameMap[K], "style" | "children">> & { class?: string; data?: Record<string, string> };

export function make<K extends keyof HTMLElementTagNameMap>(tag: K, given: Given<K> = {}, ...content: (Node | string)[]): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  const { class: name, data, ...rest } = given;
  Object.assign(element, rest);
  if (name) {
    element.className = name;
  }
  Object.assign(element.dataset, data);
  element.append(...content);
  return element;
}

export function option(value: string, words: string, selected = false): HTMLOptionElement {
  return make("option", { value, selected }, words);
}

const icons: Record<string, string> = {
  open: "M3 6h6l2 2h10v11H3z",
  select: "M6 3l12 9-6 1 4 7-3 1-3-7-4 4z",
  accessory: "M4 19C8 5 15 20 20 5",
  key: "M4 18L10 6l4 9 6-10",
  straight: "M4 20L20 4",
  dart: "M8 3l4 18 4-18",
  seam: "M4 12h3m3 0h4m3 0h3M12 3v4m0 10v4",
  freehand: "M3 17c3-8 5 4 8-2s4-9 6-6 0 8 4 6",
  undo: "M9 5L4 10l5 5M4 10h10a6 6 0 010 11h-3",
  redo: "M15 5l5 5-5 5M20 10H10a6 6 0 000 11h3",
  propose: "M12 3v5m0 8v5M3 12h5m8 0h5M6 6l3 3m6 6l3 3M18 6l-3 3m-6 6l-3 3",
  save: "M5 3h11l4 4v14H5zM8 3v6h7V3M8 21v-7h9v7",
  pattern: "M6 9V3h12v6M6 17H3V9h18v8h-3M6 14h12v7H6z",
};

/** Puts its icon before the words of each button with data-icon. */
export function addIcons(): void {
  for (const element of document.querySelectorAll<HTMLElement>("[data-icon]")) {
    element.insertAdjacentHTML("afterbegin",
      `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${icons[element.dataset.icon ?? ""]}"/></svg>`);
  }
}

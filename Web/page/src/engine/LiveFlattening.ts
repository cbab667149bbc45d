// SPDX-License-Identifier: BSD-3-Clause
import type { Curve, FlatteningOptions, SuggestionOptions, Unit } from "surfaceflattening";
import { Cancelled, EngineClient } from "./EngineClient";
import type { FlatteningAnswer, News, Proposal } from "./messages";
import type { PatternEnding, PatternOptions } from "./worker";

/** A draft follows a drag; the careful result comes when the drag rests. */
export type Care = "draft" | "full";

interface Order {
  curves: Curve[];
  care: Care;
}

/** How long a newer order waits for a careful run before that is ended, in milliseconds. */
const patience = 1500;

/** How long a draft by the careful scheme, with fewer steps, may take; above, drafts are by the paper's equations, which take a tenth. */
const promptness = 50;

/** Flattens the surface again and again, with other curves; of the orders that wait only the last one counts. */
export class LiveFlattening {
  private surface: { name: string; bytes: Uint8Array; unit: Unit } | null = null;
  private isSlow = false;
  private next: Order | null = null;
  private running: Promise<void> | null = null;
  private latest: Order | null = null;
  /** Of the cloth; taken from the next run on. */
  options: FlatteningOptions = {};

  constructor(
    private readonly client: EngineClient,
    private readonly show: (answer: FlatteningAnswer, care: Care) => void,
    private readonly fail: (error: Error) => void,
  ) {}

  async setSurface(name: string, bytes: Uint8Array, unit: Unit, triangles: number): Promise<void> {
    this.surface = { name, bytes, unit };
    this.isSlow = triangles > 2500;
    this.next = this.latest = null;
    await this.begin();
  }

  async setUnit(unit: Unit): Promise<void> {
    if (this.surface) {
      this.surface.unit = unit;
      await this.client.call("setUnit", unit);
    }
  }

  ask(curves: Curve[], care: Care): void {
    this.next = { curves, care };
    if (!this.running) {
      this.running = this.work();
      return;
    }
    if (this.latest?.care === "full") {
      const order = this.latest;
      setTimeout(() => this.next && this.latest === order && this.running && this.begin(), patience);
    }
  }

  isIdle(): boolean {
    return this.running === null;
  }

  memory(): Promise<number> {
    return this.client.call("memory");
  }

  /** Waits for the careful result of what was asked last. */
  async settled(): Promise<void> {
    while (this.running) {
      await this.running;
    }
    if (this.latest?.care === "draft") {
      this.ask(this.latest.curves, "full");
      await this.settled();
    }
  }

  async suggest(curves: Curve[], options: SuggestionOptions, watch: (news: News) => void): Promise<Proposal> {
    await this.settled();
    return this.client.callWatched("suggest", watch, curves, { ...this.options, ...options });
  }

  /** Ends what is under way. */
  async cancel(): Promise<void> {
    this.next = null;
    await this.begin();
  }

  async pattern(ending: PatternEnding, options: PatternOptions): Promise<{ bytes: Uint8Array; warnings: string[] }> {
    await this.settled();
    return this.client.call("pattern", ending, options);
  }

  private async begin(): Promise<void> {
    this.client.restart();
    const { surface } = this;
    if (surface) {
      await this.client.call("open", surface.name, surface.bytes);
      await this.client.call("setUnit", surface.unit);
    }
  }

  private async work(): Promise<void> {
    while (this.next) {
      const order = this.next;
      this.next = null;
      this.latest = order;
      try {
        const answer = await this.client.call("flatten", order.curves, { ...this.options, ...this.optionsFor(order.care) });
        this.isSlow ||= order.care === "draft" && answer.milliseconds > promptness;
        this.show(answer, order.care);
      } catch (error) {
        if (!(error instanceof Cancelled)) {
          this.fail(error as Error);
        }
      }
    }
    this.running = null;
  }

  private optionsFor(care: Care): FlatteningOptions {
    return care === "full" ? { release_trials: false }
      : this.isSlow ? { scheme: "global", interior: "laplacian" }
      : { release_trials: false, isometric_tolerance: 1e-3 };
  }
}

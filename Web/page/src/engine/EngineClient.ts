// SPDX-License-Identifier: BSD-3-Clause
import type { News, WorkerReply, WorkerRequest } from "./messages";
import type { EngineSession } from "./worker";

type Method = { [K in keyof EngineSession]: EngineSession[K] extends (...given: never[]) => unknown ? K : never }[keyof EngineSession];
type Answer<K extends Method> = EngineSession[K] extends (...given: never[]) => infer R ? Awaited<R> : never;

interface Waiting {
  resolve: (value: never) => void;
  reject: (error: Error) => void;
  watch?: (news: News) => void;
}

/** A call was given up since its worker was ended. */
export class Cancelled extends Error {}

/** Calls the functions of an EngineSession in a worker, in order. */
export class EngineClient {
  private worker: Worker;
  private readonly waiting = new Map<number, Waiting>();
  private count = 0;

  constructor(private readonly module: WebAssembly.Module) {
    this.worker = this.start();
  }

  call<K extends Method>(name: K, ...given: Parameters<EngineSession[K]>): Promise<Answer<K>> {
    return this.callWatched(name, undefined, ...given);
  }

  callWatched<K extends Method>(
    call: K, watch: ((news: News) => void) | undefined, ...given: Parameters<EngineSession[K]>
  ): Promise<Answer<K>> {
    const id = ++this.count;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject, watch });
      this.worker.postMessage({ id, call, given } satisfies WorkerRequest);
    });
  }

  isBusy(): boolean {
    return this.waiting.size > 0;
  }

  /** Ends the worker with all that it does and holds; the next one is empty. */
  restart(): void {
    this.end();
    this.worker = this.start();
  }

  end(): void {
    this.worker.terminate();
    this.giveUp(new Cancelled());
  }

  private start(): Worker {
    const worker = new Worker(new URL("./worker.ts", import.meta.url), { type: "module" });
    worker.addEventListener("message", ({ data }: MessageEvent<WorkerReply>) => this.take(data));
    worker.addEventListener("error", ({ message }) => {
      this.giveUp(new Error(message || "the engine could not be started"));
    });
    worker.postMessage({ module: this.module } satisfies WorkerRequest);
    return worker;
  }

  private giveUp(error: Error): void {
    const given = [...this.waiting.values()];
    this.waiting.clear();
    given.forEach(({ reject }) => reject(error));
  }

  private take(reply: WorkerReply): void {
    const waiting = this.waiting.get(reply.id);
    if ("progress" in reply || "preview" in reply) {
      waiting?.watch?.(reply);
      return;
    }
    this.waiting.delete(reply.id);
    "error" in reply ? waiting?.reject(new Error(reply.error)) : waiting?.resolve(reply.result as never);
  }
}

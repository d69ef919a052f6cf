// Requests that follow events: for each run one after the other, not more often than every `pause`, and none is missed.

export class Paced {
  private readonly busy = new Set<string>();
  private readonly again = new Set<string>();

  constructor(
    private readonly pause: number, // ms between two for the same run
    private readonly bringUpToDate: (id: string) => Promise<void>,
    private readonly onFailure: (id: string, error: unknown) => void,
  ) {}

  /** Something of the run has changed. */
  ask(id: string): void {
    if (this.busy.has(id)) this.again.add(id);
    else void this.work(id);
  }

  private async work(id: string): Promise<void> {
    this.busy.add(id);
    do {
      this.again.delete(id);
      try {
        await this.bringUpToDate(id);
      } catch (error) {
        this.onFailure(id, error);
      }
      await new Promise((resolve) => setTimeout(resolve, this.pause));
    } while (this.again.has(id));
    this.busy.delete(id);
  }
}

/** A map with one entry more, another one, or one less. */
export function withEntry<Value>(map: ReadonlyMap<string, Value>, id: string, value: Value | undefined): ReadonlyMap<string, Value> {
  const next = new Map(map);
  if (value === undefined) next.delete(id);
  else next.set(id, value);
  return next;
}

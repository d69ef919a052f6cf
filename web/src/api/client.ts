// The page's way to the program: one function per request.

import { readBlob, type Blob } from "./blob";
import type * as t from "./types";

/** The program refused a request; `mistake` says why in a sentence. */
export class Refused extends Error {
  constructor(
    readonly status: number,
    readonly mistake: t.Mistake,
  ) {
    super(mistake.message);
  }
}

async function answerTo(address: string, options: RequestInit = {}): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(address, options);
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") throw error;
    throw new Refused(0, { message: "KnitMech does not answer; is it still running?", key: null, line: null });
  }
  if (response.ok) return response;
  const body = (await response.json().catch(() => null)) as t.ErrorBody | null;
  throw new Refused(
    response.status,
    body?.error ?? { message: `KnitMech answered ${response.status}.`, key: null, line: null },
  );
}

async function get<Body>(address: string): Promise<Body> {
  return (await (await answerTo(address)).json()) as Body;
}

function sending(method: string, body: unknown, signal?: AbortSignal): RequestInit {
  return {
    method,
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body),
    ...(signal === undefined ? {} : { signal }),
  };
}

async function post<Body>(address: string, body: unknown): Promise<Body> {
  return (await (await answerTo(address, sending("POST", body))).json()) as Body;
}

async function blob<Head>(address: string, options: RequestInit = {}): Promise<Blob<Head>> {
  return readBlob<Head>(await (await answerTo(address, options)).arrayBuffer());
}

const runAddress = (id: string): string => `api/runs/${encodeURIComponent(id)}`;

export const program = (): Promise<t.Program> => get("api/program");
export const parameters = (): Promise<t.Parameters> => get("api/parameters");
export const design = (request: t.DesignRequest, signal?: AbortSignal): Promise<Blob<t.Design>> =>
  blob("api/design", sending("POST", request, signal));

export const cases = (): Promise<t.Cases> => get("api/cases");
export const readCase = (path: string): Promise<t.CaseText> => get(`api/case?path=${encodeURIComponent(path)}`);
export const example = (name: string): Promise<t.CaseText> => get(`api/example?name=${encodeURIComponent(name)}`);
export const template = (): Promise<t.CaseText> => get("api/template");
export const saveCase = async (request: t.SaveRequest): Promise<{ stamp: string }> =>
  (await (await answerTo("api/case", sending("PUT", request))).json()) as { stamp: string };

export const runs = (): Promise<t.RunHead[]> => get("api/runs");
export const startRun = (request: t.StartRequest): Promise<{ id: string }> => post("api/runs", request);
export const commandRun = (id: string, command: "pause" | "resume" | "stop"): Promise<unknown> =>
  post(`${runAddress(id)}/${command}`, {});
export const run = (id: string): Promise<t.RunDetail> => get(runAddress(id));
export const history = (id: string, from: number): Promise<t.History> => get(`${runAddress(id)}/history?from=${from}`);
export const runModel = (id: string): Promise<Blob<t.RunModel>> => blob(`${runAddress(id)}/model`);
export const frame = (id: string, index: number): Promise<Blob<t.FrameHead>> => blob(`${runAddress(id)}/frames/${index}`);
export const liveFrame = (id: string): Promise<Blob<t.FrameHead>> => blob(`${runAddress(id)}/live`);
export const writeReport = (id: string): Promise<unknown> => post(`${runAddress(id)}/report`, {});
export const pictureAddress = (id: string, words: Record<string, string>): string =>
  `${runAddress(id)}/picture?${new URLSearchParams(words).toString()}`;
export const fileAddress = (id: string, file: string): string => `runs/${encodeURIComponent(id)}/${file}`;

export const geometryAddress = (id: string, words: { format: string; frame: string; ending: string }): string =>
  `${runAddress(id)}/geometry?${new URLSearchParams(words).toString()}`;

/** The bytes of a file of a run, or of a picture. */
export const bytesAt = async (address: string, signal?: AbortSignal): Promise<globalThis.Blob> =>
  (await answerTo(address, signal === undefined ? {} : { signal })).blob();

export const measured = (request: t.MeasuredRequest): Promise<t.Measured> => post("api/measured", request);
export const formats = (): Promise<t.ExportFormat[]> => get("api/formats");
export const exportCase = async (text: string, format: string, stem: string, ending: string): Promise<globalThis.Blob> =>
  (await answerTo("api/export", sending("POST", { text, format, stem, ending }))).blob();

const kReconnect = 3000; // ms, where the browser has given the connection up

/** Tells of every change of a run; the connection is taken up again when it breaks. */
export function listen(onRun: (run: t.RunHead) => void, onGone: (id: string) => void, onLink: (up: boolean) => void): () => void {
  let source: EventSource;
  let timer = 0;
  const connect = (): void => {
    source = new EventSource("api/events");
    source.addEventListener("run", (event) => onRun(JSON.parse((event as MessageEvent<string>).data) as t.RunHead));
    source.addEventListener("gone", (event) => onGone((JSON.parse((event as MessageEvent<string>).data) as { id: string }).id));
    source.onopen = () => onLink(true);
    source.onerror = () => {
      onLink(false);
      if (source.readyState === EventSource.CLOSED) timer = window.setTimeout(connect, kReconnect);
    };
  };
  connect();
  return () => {
    clearTimeout(timer);
    source.close();
  };
}

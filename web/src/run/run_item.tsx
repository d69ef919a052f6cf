// One run in the list.

import { useSignal } from "@preact/signals";
import type { ComponentChildren, JSX } from "preact";
import { useEffect, useRef } from "preact/hooks";
import * as client from "../api/client";
import type { RunHead } from "../api/types";
import { note } from "../state/program";
import { addressOf } from "../state/route";
import { busy, command, openCase, writeReport, type Command } from "./commands";
import { details } from "../state/run_details";
import { colours, kMostShown, select, selectedId, shownIds, toggleShown } from "./shown";
import { isFinishing, progressText, statusText } from "./words";

function ShowBox({ run }: { run: RunHead }): JSX.Element {
  const isShown = shownIds.value.includes(run.id);
  const colour = isShown ? `var(--curve-${(colours.value.get(run.id) ?? 0) + 1})` : undefined;
  const onChange = (event: Event): void => {
    if (toggleShown(run.id)) return;
    (event.currentTarget as HTMLInputElement).checked = false;
    note(`${kMostShown} curves at most are shown together; take another one away first.`);
  };
  return (
    <input
      type="checkbox"
      checked={isShown}
      onChange={onChange}
      aria-label={`Show the curve of ${run.id}`}
      title="Show its curve"
      style={colour === undefined ? {} : { accentColor: colour, outlineColor: colour }}
    />
  );
}

function CommandButton({ run, word, children }: { run: RunHead; word: Command; children: ComponentChildren }): JSX.Element {
  return (
    <button type="button" disabled={busy.value.has(run.id)} onClick={() => void command(run.id, word)} aria-label={`${String(children)} ${run.id}`}>
      {children}
    </button>
  );
}

function StopQuestion({ run, onDone }: { run: RunHead; onDone: () => void }): JSX.Element {
  const no = useRef<HTMLButtonElement>(null);
  useEffect(() => no.current?.focus(), []);
  const stop = (): void => {
    void command(run.id, "stop");
    onDone();
  };
  return (
    <div class="question" role="group" aria-label={`Stop ${run.id}?`} onKeyDown={(event) => event.key === "Escape" && onDone()}>
      <span>{run.status === "waiting" ? "Stop? It has not begun." : "Stop? It can go on later."}</span>
      <button type="button" onClick={stop}>
        Stop
      </button>
      <button type="button" ref={no} onClick={onDone}>
        No
      </button>
    </div>
  );
}

function Controls({ run }: { run: RunHead }): JSX.Element | null {
  const asksToStop = useSignal(false);
  const stop = useRef<HTMLButtonElement>(null);
  const wasAsked = useRef(false);
  useEffect(() => {
    if (wasAsked.current && !asksToStop.value) stop.current?.focus(); // where it was before the question
    wasAsked.current = asksToStop.value;
  }, [asksToStop.value]);
  if (isFinishing(run) || (!run.active && !run.can_go_on)) return null;
  if (run.active && asksToStop.value) return <StopQuestion run={run} onDone={() => (asksToStop.value = false)} />;
  return (
    <div class="controls">
      {run.status === "running" ? (
        <CommandButton run={run} word="pause">
          Pause
        </CommandButton>
      ) : null}
      {run.status === "paused" ? (
        <CommandButton run={run} word="resume">
          Resume
        </CommandButton>
      ) : null}
      {run.active ? (
        <button type="button" ref={stop} disabled={busy.value.has(run.id)} onClick={() => (asksToStop.value = true)} aria-label={`Stop… ${run.id}`}>
          Stop…
        </button>
      ) : null}
      {run.can_go_on && !run.active ? (
        <CommandButton run={run} word="resume">
          Go on
        </CommandButton>
      ) : null}
    </div>
  );
}

function ReportLink({ run }: { run: RunHead }): JSX.Element | null {
  const detail = details.value.get(run.id);
  if (detail === undefined || run.active) return null;
  if (detail.report) {
    return (
      <a href={client.fileAddress(run.id, "report.html")} target="_blank" rel="noreferrer">
        Report
      </a>
    );
  }
  if (run.status === "damaged") return null;
  return (
    <button type="button" class="link" disabled={busy.value.has(run.id)} onClick={() => void writeReport(run.id)}>
      {busy.value.has(run.id) ? "Writing the report" : "Write the report"}
    </button>
  );
}

function Links({ run }: { run: RunHead }): JSX.Element {
  const detail = details.value.get(run.id);
  return (
    <div class="links">
      <a href={addressOf("explore", { run: run.id })}>Explore</a>
      <a href={addressOf("export", { run: run.id })}>Export</a>
      <ReportLink run={run} />
      {detail === undefined ? null : (
        <button type="button" class="link" onClick={() => openCase(detail.case_text)} title="Open the case of this run in Design, as a case that is in no file yet">
          Case
        </button>
      )}
    </div>
  );
}

function Progress({ run }: { run: RunHead }): JSX.Element {
  const share = run.target_strain > 0 ? Math.min(1, run.strain / run.target_strain) : 0;
  return (
    <div class="progress" role="progressbar" aria-label={`Progress of ${run.id}`} aria-valuenow={Math.round(100 * share)} aria-valuemin={0} aria-valuemax={100}>
      <div style={{ width: `${(100 * share).toFixed(2)}%` }} />
    </div>
  );
}

export function RunItem({ run }: { run: RunHead }): JSX.Element {
  const isSelected = selectedId.value === run.id;
  const title = run.title === "" ? run.id : run.title;
  return (
    <li class={`run-item ${run.status}${isSelected ? " selected" : ""}`} data-test="run" data-id={run.id} data-status={run.status}>
      <ShowBox run={run} />
      <div class="about">
        <button type="button" class="title" aria-current={isSelected ? "true" : undefined} onClick={() => select(run.id)} title={title}>
          {title}
        </button>
        <div class="line">
          <span class="id" title={run.id}>
            {run.id}
          </span>
          <span class="status">{statusText(run)}</span>
        </div>
        <Progress run={run} />
        <div class="line numbers">{run.status === "damaged" ? "" : progressText(run)}</div>
        {run.message === "" ? null : <p class="message" title={run.message}>{run.message}</p>}
        <Controls run={run} />
        {isSelected ? <Links run={run} /> : null}
      </div>
    </li>
  );
}

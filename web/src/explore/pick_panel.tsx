// The picked place: where it is and what the yarn and the contact bear there.

import type { JSX } from "preact";
import { frameName } from "./colour_panel";
import type { LoadedFrame } from "./frames";
import { opened, type OpenRun } from "./open_run";
import * as selection from "./selection";
import { nearest } from "./shown";
import { alongYarn, mm, placeWords, withUnit } from "./words";

function Row({ name, value }: { name: string; value: string }): JSX.Element {
  return (
    <>
      <dt>{name}</dt>
      <dd>{value}</dd>
    </>
  );
}

/** Values of the element, or of the nearer of its nodes. */
function Values({ frame, at }: { frame: LoadedFrame; at: selection.YarnPlace }): JSX.Element {
  const node = at.element + (at.share > 0.5 ? 1 : 0);
  if (frame.broken.includes(at.element)) return <p class="wrong">The yarn is broken here.</p>;
  return (
    <dl class="place-values">
      {frame.head.fields.map((field) => (
        <Row
          key={field.name}
          name={field.label}
          value={withUnit(frame.fields.get(field.name)![field.of_elements ? at.element : node]!, field.unit)}
        />
      ))}
    </dl>
  );
}

function stepByKey(event: KeyboardEvent): void {
  if (event.key !== "ArrowLeft" && event.key !== "ArrowRight") return;
  selection.stepAlong(event.key === "ArrowRight" ? 1 : -1);
  event.preventDefault();
}

function AlongYarn(): JSX.Element {
  return (
    <div class="buttons" role="group" aria-label="Along the yarn" onKeyDown={stepByKey}>
      <button type="button" onClick={() => selection.stepAlong(-1)} title="Element before (arrow left)" aria-label="Element before">
        ‹
      </button>
      <button type="button" onClick={() => selection.stepAlong(1)} title="Next element (arrow right)" aria-label="Next element">
        ›
      </button>
      <button
        type="button"
        aria-pressed={selection.isAlone.value}
        title="Draw this yarn only"
        onClick={() => (selection.isAlone.value = !selection.isAlone.value)}
      >
        Only this yarn
      </button>
      <button type="button" onClick={selection.clearSelection}>
        Clear
      </button>
    </div>
  );
}

function Where({ run, at }: { run: OpenRun; at: selection.YarnPlace }): JSX.Element {
  const yarn = selection.yarnOf(run, at.element);
  const { first_node: first, nodes } = run.fabric.yarns[yarn]!;
  return (
    <dl class="place-values" data-test="picked">
      <Row name="Place" value={placeWords(run, at.element)} />
      <Row name="Yarn" value={`${yarn + 1} of ${run.fabric.yarns.length}`} />
      <Row name="Element" value={`${at.element - first + 1} of ${nodes - 1}`} />
      <Row name="Along the yarn" value={mm(alongYarn(run, at))} />
    </dl>
  );
}

function Contact({ run, frame, index }: { run: OpenRun; frame: LoadedFrame; index: number }): JSX.Element {
  const { contacts } = frame;
  const { yarns, places } = selection.contactPlace(contacts, index);
  const where = yarns.map((yarn, i) => placeWords(run, selection.placeAt(run, yarn, places[i]!).element));
  return (
    <dl class="place-values" data-test="picked-contact">
      <Row name="Between" value={where[0]!} />
      <Row name="and" value={where[1]!} />
      <Row name="Normal force" value={withUnit(contacts.normalForce[index]!, "N")} />
      <Row name="Friction force" value={withUnit(contacts.friction[index]!, "N")} />
      <Row name="Gap" value={mm(contacts.gap[index]!)} />
      <Row name="Slip path" value={mm(contacts.slip[index]!)} />
      <Row name="State" value={contacts.slips[index] === 0 ? "stick" : "slip"} />
    </dl>
  );
}

function ContactPart({ run, frame }: { run: OpenRun; frame: LoadedFrame }): JSX.Element | null {
  if (selection.contact.value === null) return null;
  const index = selection.contactIndex.value;
  return (
    <>
      <h3>Contact</h3>
      {index === null ? <p class="quiet small">{`Open in ${frameName()}.`}</p> : <Contact run={run} frame={frame} index={index} />}
    </>
  );
}

export function PickPanel(): JSX.Element {
  const run = opened.value;
  const frame = nearest.value;
  const at = selection.place.value;
  const isThere = run !== null && frame !== null && at !== null;
  return (
    <section class="group" aria-labelledby="pick-title">
      <h2 id="pick-title">Picked</h2>
      {isThere ? (
        <>
          <AlongYarn />
          <Where run={run} at={at} />
          <ContactPart run={run} frame={frame} />
          <h3>{`Values of ${frameName()}`}</h3>
          <Values frame={frame} at={at} />
        </>
      ) : (
        <p class="quiet small">Click on a yarn, or on the disc of a contact, to see what it bears.</p>
      )}
    </section>
  );
}

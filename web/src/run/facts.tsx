// The numbers of the selected run: how far it is, the last row of its history, its quality.

import type { ComponentChildren, JSX } from "preact";
import type { Quality, RunDetail, RunHead } from "../api/types";
import { figures } from "../parts/curve_data";
import { details, detailTroubles } from "../state/run_details";
import { fabrics } from "./fabrics";
import { histories, type Table } from "./histories";
import { durationText, quantityText, shareText, statusText, strainText } from "./words";

function Row({ name, title, children }: { name: string; title?: string; children: ComponentChildren }): JSX.Element {
  return (
    <div class="fact" title={title}>
      <dt class="quiet">{name}</dt>
      <dd>{children}</dd>
    </div>
  );
}

const massText = (scaling: number): string => scaling.toLocaleString("en", { maximumSignificantDigits: 3 });

const last = (table: Table | undefined, column: string): number | null => table?.columns[column]?.at(-1) ?? null;

function largest(values: readonly number[] | undefined): number | null {
  return values === undefined || values.length === 0 ? null : values.reduce((most, value) => Math.max(most, value), 0);
}

/** Error of the energy balance in the last row, as a share of the work; null while there is hardly any work. */
function balanceNow(table: Table | undefined): number | null {
  const work = last(table, "external_work_mJ");
  if (work === null || work <= 0) return null;
  const held = ["internal_energy_mJ", "kinetic_energy_mJ", "contact_energy_mJ", "friction_loss_mJ", "damping_loss_mJ", "break_loss_mJ"];
  const sum = held.reduce((total, column) => total + (last(table, column) ?? 0), 0);
  return Math.abs(sum - work) / work;
}

function Times({ run, table }: { run: RunHead; table: Table | undefined }): JSX.Element {
  return (
    <dl>
      <Row name="Run for">{durationText(run.seconds)}</Row>
      {run.active ? <Row name="Left, about">{run.seconds_left === null ? "–" : durationText(run.seconds_left)}</Row> : null}
      <Row name="Strain">
        {strainText(run.strain)} of {Number((100 * run.target_strain).toFixed(1))} %
      </Row>
      <Row name="Force" title="At the pulled grip">
        {quantityText(table?.force.at(-1), "N")}
      </Row>
    </dl>
  );
}

const kEnergies: readonly { name: string; column: string }[] = [
  { name: "Work of the grip", column: "external_work_mJ" },
  { name: "Strain energy", column: "internal_energy_mJ" },
  { name: "Kinetic energy", column: "kinetic_energy_mJ" },
  { name: "Contact energy", column: "contact_energy_mJ" },
  { name: "Lost to friction", column: "friction_loss_mJ" },
  { name: "Lost to damping", column: "damping_loss_mJ" },
];

function LastRow({ table }: { table: Table | undefined }): JSX.Element {
  return (
    <dl>
      <Row name="Time step">{quantityText(last(table, "step_s"), "s")}</Row>
      <Row name="Contacts">{last(table, "contacts") ?? "–"}</Row>
      <Row name="Penetration">{quantityText(last(table, "largest_penetration_mm"), "mm")}</Row>
      {kEnergies.map(({ name, column }) => (
        <Row key={name} name={name}>
          {quantityText(last(table, column), "mJ")}
        </Row>
      ))}
    </dl>
  );
}

function LiveQuality({ run, table }: { run: RunHead; table: Table | undefined }): JSX.Element {
  const penetration = largest(table?.columns["largest_penetration_mm"]);
  const diameter = fabrics.value.get(run.id)?.model.head.diameter;
  return (
    <dl>
      <Row name="Energy balance" title="Error of the balance in the last row, as a share of the work">
        {shareText(balanceNow(table))}
      </Row>
      <Row name="Penetration over diameter" title="Largest so far, over the diameter of the yarn">
        {shareText(penetration === null || diameter === undefined ? null : penetration / diameter)}
      </Row>
    </dl>
  );
}

function Events({ sentences, none }: { sentences: readonly string[]; none: string }): JSX.Element {
  if (sentences.length === 0) return <p class="good">{none}</p>;
  return (
    <details>
      <summary>{sentences[0]}</summary>
      {sentences.length === 1 ? null : (
        <ul>
          {sentences.slice(1).map((sentence) => (
            <li key={sentence}>{sentence}</li>
          ))}
        </ul>
      )}
    </details>
  );
}

function FinalQuality({ quality }: { quality: Quality }): JSX.Element {
  return (
    <>
      <p class={quality.quasi_static ? "verdict good" : "verdict warn"} data-test="verdict">
        <span aria-hidden="true">{quality.quasi_static ? "✓ " : "! "}</span>
        {quality.verdict}
      </p>
      <p>{quality.crossings}</p>
      <Events sentences={quality.ravelling} none="No yarn end slipped out of a loop." />
      <Events sentences={quality.breaks} none="No yarn broke." />
      <dl>
        <Row name="Kinetic over strain energy" title="Largest, after the toe">
          {shareText(quality.kinetic_ratio)}
        </Row>
        <Row name="Energy balance" title="Largest error, as a share of the work">
          {shareText(quality.energy_balance)}
        </Row>
        <Row name="Difference of the grips" title="Largest, over the mean of both forces">
          {shareText(quality.grip_difference)}
        </Row>
        <Row name="Penetration">{quantityText(quality.penetration, "mm")}</Row>
        <Row name="Penetration over diameter">{shareText(quality.penetration_ratio)}</Row>
      </dl>
    </>
  );
}

function Stages({ stages }: { stages: RunDetail["stages"] }): JSX.Element | null {
  if (stages.length === 0) return null;
  return (
    <>
      <h3>Stages</h3>
      <dl>
        {stages.map((stage) => (
          <Row key={stage.name} name={stage.name.charAt(0).toUpperCase() + stage.name.slice(1)} title="Slope: force per unit of strain">
            {strainText(stage.from)} to {strainText(stage.to)}
            {stage.slope === null ? "" : `, slope ${figures(stage.slope)} N`}
          </Row>
        ))}
      </dl>
    </>
  );
}

export function Facts({ run }: { run: RunHead }): JSX.Element {
  const detail = details.value.get(run.id);
  const table = histories.value.get(run.id);
  const trouble = detailTroubles.value.get(run.id);
  const quality = run.active ? null : (detail?.quality ?? null);
  return (
    <section class="panel facts" aria-label="Values of the selected run" data-test="facts" tabIndex={0}>
      <header>
        <h2 title={run.title}>{run.id}</h2>
        <span class={`status ${run.status}`} role="status">
          {statusText(run)}
        </span>
      </header>
      {trouble === undefined ? null : (
        <p class="wrong" role="alert">
          {trouble}
        </p>
      )}
      {run.message === "" ? null : <p class={run.status === "failed" || run.status === "damaged" ? "wrong" : "warn"}>{run.message}</p>}
      <Times run={run} table={table} />
      <h3>Quality</h3>
      {quality === null ? <LiveQuality run={run} table={table} /> : <FinalQuality quality={quality} />}
      <Stages stages={detail?.stages ?? []} />
      <h3>Last row of the history</h3>
      <LastRow table={table} />
      {detail === undefined ? null : (
        <p class="quiet model">
          {detail.nodes} nodes, {detail.elements} elements
          {detail.mass_scaling === null ? "" : `, mass times ${massText(detail.mass_scaling)}`}
          {detail.threads === null ? "" : `, ${detail.threads === 1 ? "1 thread" : `${detail.threads} threads`}`}
        </p>
      )}
    </section>
  );
}

// The curves of the shown runs, growing, with measured ones.

import type { JSX } from "preact";
import { useRef } from "preact/hooks";
import { CurveChart } from "../parts/curve_chart";
import { curves, measuredColour, setUnit, unit, widthsDiffer, type ForceUnit } from "./curves";
import { historyTroubles } from "./histories";
import { measuredSets, removeMeasured, toggleSpecimens } from "./measured";
import { askAbout } from "./measured_dialog";
import { shown } from "./shown";

const kUnits: readonly { unit: ForceUnit; words: string }[] = [
  { unit: "N", words: "Force" },
  { unit: "N/mm", words: "Force per width" },
];

function FileButton(): JSX.Element {
  const input = useRef<HTMLInputElement>(null);
  const onChange = (event: Event): void => {
    const chosen = event.currentTarget as HTMLInputElement;
    askAbout(chosen.files ?? []);
    chosen.value = ""; // the same file may be chosen again
  };
  return (
    <>
      <input ref={input} type="file" hidden multiple accept=".csv,.txt,.tsv,.dat,text/*" onChange={onChange} data-test="measured-file" />
      <button type="button" onClick={() => input.current?.click()} title="A table of strains and forces; it can also be dropped on the page">
        Measured curves…
      </button>
    </>
  );
}

function Header(): JSX.Element {
  return (
    <header>
      <h2>Force and strain</h2>
      <span class="spread" />
      <div class="choice" role="group" aria-label="What is shown over the strain">
        {kUnits.map((each) => (
          <button key={each.unit} type="button" aria-pressed={unit.value === each.unit} onClick={() => setUnit(each.unit)}>
            {each.words}
          </button>
        ))}
      </div>
      <FileButton />
    </header>
  );
}

function MeasuredRow(): JSX.Element | null {
  if (measuredSets.value.length === 0) return null;
  return (
    <div class="measured-row" role="group" aria-label="Measured curves">
      {measuredSets.value.map((set, place) => (
        <span key={set.id} class="measured" data-test="measured">
          <i style={{ borderColor: `var(--curve-${measuredColour(place) + 1})` }} />
          <span class="file" title={`${set.name}: specimens ${set.gaugeLength} mm long and ${set.width} mm wide`}>
            {set.name}
          </span>
          <button type="button" class="plain" aria-pressed={set.showsSpecimens} onClick={() => toggleSpecimens(set.id)} aria-label={`Show each specimen of ${set.name}`}>
            {set.specimens.length === 1 ? "1 specimen" : `${set.specimens.length} specimens`}
          </button>
          <button type="button" class="plain" onClick={() => removeMeasured(set.id)} aria-label={`Remove ${set.name}`} title="Remove">
            ×
          </button>
        </span>
      ))}
      {widthsDiffer.value && unit.value === "N" ? <span class="quiet">Fabrics and specimens differ in width: compare the force per width.</span> : null}
    </div>
  );
}

export function ChartPanel(): JSX.Element {
  const troubles = shown.value.flatMap(({ id }) => (historyTroubles.value.has(id) ? [`${id}: ${historyTroubles.value.get(id)}`] : []));
  const rows = curves.value.reduce((sum, curve) => sum + curve.strain.length, 0);
  return (
    <section class="panel chart" aria-label="Curves" data-test="curves" data-rows={rows}>
      <Header />
      <MeasuredRow />
      {troubles.map((trouble) => (
        <p key={trouble} class="wrong trouble" role="alert">
          {trouble}
        </p>
      ))}
      <div class="chart-box">
        <CurveChart
          curves={curves.value}
          unit={unit.value}
          quantity={unit.value === "N" ? "Force" : "Force per width"}
          label="Force over strain, of the shown runs and of measured specimens"
          reach={Math.max(0, ...shown.value.filter((run) => run.active).map((run) => run.target_strain))}
          zoomable
        />
      </div>
    </section>
  );
}

// The fabric in three dimensions; where the case makes none that can be drawn, the last one stays, dimmed.

import { computed } from "@preact/signals";
import type { JSX } from "preact";
import { FabricView } from "../parts/fabric_view";
import { design, fabric, fabricGeneration } from "../state/design";

/** The newest fabric with its arrays, taken out of the answer once. */
const shown = computed(() => {
  const answer = fabric.value;
  if (answer === null || answer.head.fabric === null) return null;
  return {
    fabric: answer.head.fabric,
    positions: answer.floats("positions"),
    course: answer.integers("course"),
    wale: answer.integers("wale"),
  };
});

/** Why the fabric that is shown, if any, is not that of the case; "" if it is. */
function noteOnFabric(): string {
  const now = design.value;
  if (now === null) return "";
  if (now.mistakes.length === 0) {
    return now.fabric === null ? "This fabric is too large to be drawn here; it can be run all the same." : "";
  }
  return shown.value === null
    ? "The fabric appears here when there is no mistake."
    : "This is the fabric as it was before the mistake.";
}

export function FabricPanel(): JSX.Element {
  const note = noteOnFabric();
  const yarns = shown.value?.fabric.yarns.length ?? 0;
  return (
    <section class="panel drawing" aria-label="The fabric">
      <header>
        <h2>Fabric</h2>
        <span class="quiet">{yarns === 0 ? "" : yarns === 1 ? "one yarn" : `${yarns} yarns`}</span>
      </header>
      <div class="sheet holds-view">
        {shown.value === null ? null : (
          <FabricView {...shown.value} generation={fabricGeneration.value} label="The fabric before the test" dimmed={note !== ""} />
        )}
        {note === "" ? null : <p class="over">{note}</p>}
      </div>
    </section>
  );
}

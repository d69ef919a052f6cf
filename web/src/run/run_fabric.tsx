// The fabric of one run as it is now: live while it runs, otherwise its last stored frame.

import type { JSX } from "preact";
import type { RunHead } from "../api/types";
import { FabricView, type Box, type CameraState, type FabricViewHandle } from "../parts/fabric_view";
import { colouringOf, type Scale } from "./colouring";
import { fabrics, fabricTroubles } from "./fabrics";
import { strainText } from "./words";

/** What is seen: "at 8.3 %", "stored frame at 8.0 %". */
export function instantText(run: RunHead): string {
  const frame = fabrics.value.get(run.id)?.frame;
  if (frame === undefined) return "";
  if (frame === null) return "before the test";
  const strain = strainText(frame.head.strain);
  if (frame.head.index !== null) return `stored frame at ${strain}`;
  return run.status === "paused" ? `paused at ${strain}` : `live at ${strain}`;
}

interface Props {
  run: RunHead;
  scale: Scale | null;
  room?: Box | undefined; // left out: that of its own test
  camera?: CameraState | undefined;
  onCamera?: ((camera: CameraState) => void) | undefined;
  handle?: { current: FabricViewHandle | null } | undefined;
}

export function RunFabric({ run, scale, room, camera, onCamera, handle }: Props): JSX.Element {
  const fabric = fabrics.value.get(run.id);
  const trouble = fabricTroubles.value.get(run.id);
  if (fabric === undefined) {
    return <p class={trouble === undefined ? "no-fabric quiet" : "no-fabric wrong"}>{trouble ?? "Reading the fabric."}</p>;
  }
  return (
    <div class="run-fabric" data-test="run-fabric" data-id={run.id} data-strain={fabric.frame?.head.strain ?? 0}>
      <FabricView
        fabric={fabric.model.head}
        positions={fabric.positions}
        course={fabric.course}
        wale={fabric.wale}
        colour={colouringOf(fabric, scale)}
        broken={fabric.broken}
        room={room ?? fabric.room}
        camera={camera}
        onCamera={onCamera}
        handle={handle}
        generation={fabric.generation}
        label={`The fabric of ${run.id}, ${instantText(run)}`}
      />
      {trouble === undefined ? null : <p class="wrong over">{trouble}</p>}
    </div>
  );
}

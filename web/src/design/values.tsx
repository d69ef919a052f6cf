// What follows from the case: lengths, angles, counts, stiffnesses, weight and how long a run takes.

import type { ComponentChildren, JSX } from "preact";
import type { Facts, LoopDrawing } from "../api/types";
import { design } from "../state/design";
import { goToField } from "./pointing";
import { Symbol } from "./symbol";
import { duration, significant } from "./words";

interface RowProps {
  name: string;
  symbol?: string;
  title?: string;
  children: ComponentChildren;
}

function Row({ name, symbol = "", title, children }: RowProps): JSX.Element {
  return (
    <div class="value" title={title}>
      <dt>
        {name} <Symbol symbol={symbol} />
      </dt>
      <dd>{children}</dd>
    </div>
  );
}

function Block({ title, children }: { title: string; children: ComponentChildren }): JSX.Element {
  return (
    <section>
      <h3>{title}</h3>
      <dl>{children}</dl>
    </section>
  );
}

const Number = ({ value, unit = "" }: { value: number; unit?: string }): JSX.Element => (
  <>
    {significant(value)}
    {unit === "" ? null : <span class="quiet"> {unit}</span>}
  </>
);

function LoopValues({ facts, loop }: { facts: Facts; loop: LoopDrawing | null }): JSX.Element {
  return (
    <Block title="Loop">
      <Row name="Yarn in a stitch">
        <Number value={facts.loop_length} unit="mm" />
      </Row>
      {loop === null ? null : (
        <Row name="Inclination of the leg" symbol="theta" title="Above 90° the leg leans back under the head, as in most jersey">
          {loop.theta1_degrees === loop.theta2_degrees ? (
            `${significant(loop.theta1_degrees)}°`
          ) : (
            `${significant(loop.theta1_degrees)}° head, ${significant(loop.theta2_degrees)}° foot`
          )}
        </Row>
      )}
      <Row name="Out of plane" symbol="p" title={facts.out_of_plane_chosen ? "Chosen by the program" : "As it is given"}>
        <Number value={facts.out_of_plane} unit="/mm" />
      </Row>
      <Row name="Least without overlap" symbol="p">
        <Number value={facts.least_out_of_plane} unit="/mm" />
      </Row>
    </Block>
  );
}

function Gap({ name, gap }: { name: string; gap: Facts["least_gap"] }): JSX.Element | null {
  if (gap === null) return null;
  return (
    <>
      <Row name={name}>
        <Number value={gap.gap} unit="mm" />
      </Row>
      <p class="between quiet">
        between {gap.between[0]} and {gap.between[1]}
      </p>
    </>
  );
}

function Clearance({ facts }: { facts: Facts }): JSX.Element {
  const alike = JSON.stringify(facts.least_gap?.between) === JSON.stringify(facts.least_gap_on_elements?.between);
  if (!alike || facts.least_gap === null || facts.least_gap_on_elements === null) {
    return (
      <Block title="Clearance">
        <Gap name="Least gap" gap={facts.least_gap} />
        <Gap name="Least gap on the elements" gap={facts.least_gap_on_elements} />
      </Block>
    );
  }
  return (
    <Block title="Clearance">
      <Row name="Least gap">
        <Number value={facts.least_gap.gap} unit="mm" />
      </Row>
      <Gap name="Least gap on the elements" gap={facts.least_gap_on_elements} />
    </Block>
  );
}

function FabricValues({ facts }: { facts: Facts }): JSX.Element {
  return (
    <Block title="Fabric">
      <Row name="Size" title="Width, height and thickness">
        {significant(facts.width)} × {significant(facts.height)} × {significant(facts.thickness, 3)}
        <span class="quiet"> mm</span>
      </Row>
      <Row name="Weight">
        <Number value={facts.mass_per_area} unit="g/m²" />
      </Row>
      <Row name="Yarn in the fabric">
        <Number value={facts.yarn_length / 1000} unit="m" />
      </Row>
      <Row name="Yarns">{facts.yarns}</Row>
      {facts.turning_arcs === 0 ? null : <Row name="Turning arcs">{facts.turning_arcs}</Row>}
      {facts.ties === 0 ? null : <Row name="Ties">{facts.ties}</Row>}
      <Row name="Elements, nodes">
        {facts.elements}, {facts.nodes}
      </Row>
    </Block>
  );
}

function YarnValues({ facts }: { facts: Facts }): JSX.Element {
  return (
    <Block title="Yarn">
      <Row name="Axial stiffness" symbol="EA">
        <Number value={facts.axial_stiffness} unit="N" />
      </Row>
      <Row name="Bending stiffness" symbol="EI">
        <Number value={facts.bending_stiffness} unit="N mm²" />
      </Row>
      <Row name="Torsional stiffness" symbol="GJ">
        <Number value={facts.torsional_stiffness} unit="N mm²" />
      </Row>
      <Row name="Contact stiffness">
        <Number value={facts.contact_stiffness} unit="N/mm" />
      </Row>
    </Block>
  );
}

function RunValues({ facts }: { facts: Facts }): JSX.Element {
  return (
    <Block title="Run">
      <Row name="Mass scaling">{significant(facts.mass_scaling)}</Row>
      <Row name="Time it takes">
        {facts.estimated_seconds === null ? <span class="quiet">not estimated</span> : duration(facts.estimated_seconds)}
      </Row>
    </Block>
  );
}

export function Values(): JSX.Element {
  const facts = design.value?.facts ?? null;
  if (facts === null) {
    const first = design.value?.mistakes[0];
    return (
      <div class="values">
        <p class="quiet">
          {first === undefined ? "The values follow." : "The values follow when the mistakes are gone."}{" "}
          {first?.key == null ? null : (
            <button type="button" class="link" onClick={() => goToField(first.key as string)}>
              Go to the first one
            </button>
          )}
        </p>
      </div>
    );
  }
  return (
    <div class="values" data-test="values">
      <LoopValues facts={facts} loop={design.value?.loop ?? null} />
      <Clearance facts={facts} />
      <FabricValues facts={facts} />
      <YarnValues facts={facts} />
      <RunValues facts={facts} />
    </div>
  );
}

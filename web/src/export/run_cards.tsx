// What a run has left: its curve, its frames, its report.

import type { JSX } from "preact";
import * as client from "../api/client";
import type { RunDetail, RunHead } from "../api/types";
import { program } from "../state/program";
import { readDetail } from "../state/run_details";
import { Card, Copied, quoted } from "./card";
import { save, useAction, type Action } from "./download";
import { runFolder } from "./subject";

interface Props {
  run: RunHead;
  detail: RunDetail | null;
}

interface FileProps {
  run: RunHead;
  file: string; // in the folder of the run
  as: string;
  action: Action;
  main?: boolean;
}

function FileButton({ run, file, as, action, main }: FileProps): JSX.Element {
  const download = async (): Promise<void> => save(as, await client.bytesAt(client.fileAddress(run.id, file)));
  return (
    <button type="button" class={main === true ? "main" : undefined} disabled={action.isBusy} onClick={() => action.act(download)}>
      Download {as}
    </button>
  );
}

export function CurveCard({ run, detail }: Props): JSX.Element {
  const action = useAction();
  const chart = detail?.report === true ? "figures/force-strain.svg" : "pictures/force-strain.svg";
  return (
    <Card
      title="Curve"
      about="The history: forces, energies and more in one row for each instant; and the force-strain chart, for a paper."
      trouble={action.trouble}
      terminal="Both are in the folder of the run; this draws the charts anew:"
      command={`knitmech report ${quoted(runFolder(run.id))}`}
    >
      <FileButton run={run} file="history.csv" as={`${run.id}-history.csv`} action={action} main />
      <FileButton run={run} file={chart} as={`${run.id}-force-strain.svg`} action={action} />
    </Card>
  );
}

const padded = (index: number): string => String(index).padStart(4, "0");

export function FramesCard({ run, detail }: Props): JSX.Element {
  const action = useAction();
  const folder = `${program.value?.folder ?? ""}/${runFolder(run.id)}/frames`;
  return (
    <Card
      title="Frames"
      about="The fabric and its contacts at the stored strains, with all fields, as files of VTK. ParaView opens frames.pvd of the folder and has all of them:"
      trouble={action.trouble}
      terminal="To see them in ParaView:"
      command={`paraview ${quoted(`${runFolder(run.id)}/frames/frames.pvd`)}`}
      size="double"
    >
      <Copied text={folder} name="the folder of the frames" />
      <ul class="frame-files" aria-label="Single frames" tabIndex={0}>
        {(detail?.frame_list ?? []).map(({ index, strain }) => (
          <li key={index}>
            <span>{(100 * strain).toFixed(1)} %</span>
            {["frame", "contacts"].map((kind) => {
              const file = `${kind}_${padded(index)}.vtp`;
              const download = async (): Promise<void> => save(`${run.id}-${file}`, await client.bytesAt(client.fileAddress(run.id, `frames/${file}`)));
              return (
                <button key={kind} type="button" class="link" disabled={action.isBusy} onClick={() => action.act(download)}>
                  {file}
                </button>
              );
            })}
          </li>
        ))}
      </ul>
    </Card>
  );
}

export function ReportCard({ run, detail }: Props): JSX.Element {
  const action = useAction();
  const write = async (): Promise<void> => {
    await client.writeReport(run.id);
    readDetail(run.id);
  };
  const isThere = detail?.report === true;
  return (
    <Card
      title="Report"
      about="Curve, pictures, contacts, quality and parameters on one page that needs no network."
      trouble={action.trouble}
      command={`knitmech report ${quoted(runFolder(run.id))}`}
    >
      {run.active ? <p class="quiet">The report is written when the run has ended.</p> : null}
      {isThere && !run.active ? (
        <>
          <a class="button" href={client.fileAddress(run.id, "report.html")} target="_blank" rel="noreferrer">
            Open
          </a>
          <FileButton run={run} file="report.html" as={`${run.id}-report.html`} action={action} main />
        </>
      ) : null}
      {run.active || detail === null ? null : (
        <button type="button" class={isThere ? undefined : "main"} disabled={action.isBusy} onClick={() => action.act(write)}>
          {isThere ? "Write it anew" : "Write the report"}
        </button>
      )}
      {action.isBusy ? <span class="quiet">At work.</span> : null}
    </Card>
  );
}

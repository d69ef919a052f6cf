// The page Design: the form, the loop and the fabric that follow it, and what comes out.

import type { JSX } from "preact";
import { useEffect } from "preact/hooks";
import { generation } from "../state/design";
import { FabricPanel } from "./fabric_panel";
import { Form } from "./form";
import { listenToKeys } from "./keys";
import { LoopPanel } from "./loop_drawing";
import { OpenDialog } from "./open_dialog";
import { Questions } from "./questions";
import { SidePanel } from "./side_panel";
import { ToolBar } from "./tool_bar";

export function DesignPage(): JSX.Element {
  useEffect(listenToKeys, []);
  return (
    <div class="design" data-generation={generation.value}>
      <h1 class="unseen">Design</h1>
      <ToolBar />
      <Form />
      <div class="drawings">
        <LoopPanel />
        <FabricPanel />
      </div>
      <SidePanel />
      <OpenDialog />
      <Questions />
    </div>
  );
}

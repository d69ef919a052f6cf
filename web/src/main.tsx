import "./style/page.css";

import { render } from "preact";
import { Shell } from "./parts/shell";
import { begin } from "./state/begin";

render(<Shell />, document.getElementById("page") as HTMLElement);
void begin();

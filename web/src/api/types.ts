// What the program and the page say to each other. The program's side is src/serve; every address is relative to that of
// the page, which holds the token. Lengths are mm, forces N, times s unless a name says something else.

/** A mistake in a case, in the words of the command line. */
export interface Mistake {
  message: string;
  key: string | null; // "loop.height"; null: it belongs to no key
  line: number | null; // from 1
}

/** The body of every answer whose status is not 2xx: {error: Mistake}. */
export interface ErrorBody {
  error: Mistake;
}

/** GET api/program */
export interface Program {
  version: string;
  folder: string; // the folder that the page may read and write, as a person writes it
  processors: number;
  opened: { case: string | null; run: string | null }; // named on the command line: a path in the folder, the id of a run
}

export type Kind = "text" | "quantity" | "whole number" | "list of quantities" | "choice";
export type Need = "required" | "defaulted" | "automatic" | "optional";

/** One input parameter. Numbers are in `unit`. */
export interface Parameter {
  key: string; // "loop.height"
  section: string; // "loop"; "" at the top of the file
  name: string; // "height"
  symbol: string; // "H"; "" if there is none
  kind: Kind;
  unit: string; // "mm"; "" without
  need: Need;
  value: string; // defaulted: the default, otherwise an example, as a person types it: "7 mm"
  least: number | null;
  greatest: number | null;
  least_excluded: boolean;
  choices: string[];
  help: string; // one line
}

/** GET api/parameters */
export interface Parameters {
  sections: { name: string; help: string }[];
  parameters: Parameter[];
}

/** A change of one value in the text of a case. */
export interface Edit {
  key: string;
  typed: string; // as a person types it: 7 mm, 0.1, basic, 0.08 0.16; "" takes the key out of the text
}

/** POST api/design. The answer is a blob (see blob.ts) whose head is a Design and whose arrays are DesignArrays. */
export interface DesignRequest {
  text: string; // of the case file
  edit?: Edit; // done first; Design.text is the text after it
  fabric: boolean; // whether the centrelines of the whole fabric are wanted
}

export interface GivenValue {
  typed: string; // as a person types it, "7 mm"
  line: number;
}

/** One dimension of the drawing of the loop. */
export interface Design {
  text: string;
  given: Record<string, GivenValue>; // by key: the values that stand in the text, right or wrong
  effective: Record<string, string>; // by key: what holds, typed; empty while there is a mistake
  mistakes: Mistake[]; // empty: the case can be run
  loop: LoopDrawing | null; // null while no loop can be drawn
  facts: Facts | null; // null while there is a mistake
  fabric: FabricHead | null; // null while there is a mistake, or if it was not wanted
}

/** The ERC in plan, from the middle of the head to the middle of the foot, x along the course and y along the wale. */
export interface LoopDrawing {
  points: Record<"P1" | "P2" | "P3" | "P4" | "P5" | "P6" | "P7" | "P8", [number, number]>; // P7, P8: middles of the circles
  path: [number, number, number][]; // points of the centreline from P1 to P6, with z
  height: number;
  width: number;
  head_flat: number;
  head_radius: number;
  foot_flat: number;
  foot_radius: number;
  diameter: number; // of the yarn
  course_spacing: number | null;
  theta1_degrees: number;
  theta2_degrees: number;
  erc_length: number;
}

export interface Facts {
  loop_length: number; // yarn in a stitch
  yarn_length: number; // in the fabric
  elements: number;
  nodes: number;
  yarns: number;
  ties: number;
  turning_arcs: number;
  out_of_plane: number; // 1/mm
  out_of_plane_chosen: boolean; // by the program
  least_out_of_plane: number; // 1/mm
  least_gap: { gap: number; between: [string, string] } | null; // of the true centreline
  least_gap_on_elements: { gap: number; between: [string, string] } | null;
  width: number;
  height: number;
  thickness: number;
  mass_per_area: number; // g/m^2
  axial_stiffness: number; // EA, N
  bending_stiffness: number; // EI, N mm^2
  torsional_stiffness: number; // GJ, N mm^2
  contact_stiffness: number; // N/mm
  mass_scaling: number;
  estimated_seconds: number | null; // of a run on this computer
}

/** Arrays: positions f32[3 nodes], course i32[nodes], wale i32[nodes] (-1 on turning arcs). Node i and i + 1 are joined
 *  unless i is the last node of its yarn. */
export interface FabricHead {
  nodes: number;
  yarns: { first_node: number; nodes: number }[];
  diameter: number;
  edge_diameter: number | null; // of the turning arcs
  gauge_length: number;
}

/** GET api/cases */
export interface Cases {
  cases: { path: string; title: string }[]; // in the folder
  examples: { name: string; title: string }[];
}

/** GET api/case?path=..., GET api/example?name=... (path is null), GET api/template (path is null) */
export interface CaseText {
  path: string | null;
  text: string;
  stamp: string | null; // of the file as it was read
}

/** PUT api/case. 409 if the file is there and its stamp is another one than `stamp`. Answer: {stamp}. */
export interface SaveRequest {
  path: string;
  text: string;
  stamp: string | null; // null: the file is new
}

export type RunStatus = "waiting" | "running" | "paused" | "completed" | "interrupted" | "failed" | "damaged";

/** GET api/runs: RunHead[], newest first. The event `run` of api/events carries one RunHead whenever it changes. */
export interface RunHead {
  id: string; // name of the folder of the run
  title: string;
  status: RunStatus;
  active: boolean; // this program runs it: it can be paused, resumed, stopped
  can_go_on: boolean; // interrupted with a checkpoint
  strain: number; // reached
  target_strain: number;
  rows: number; // of the history
  frames: number; // stored
  live: number; // counts the live views; 0: none
  seconds: number; // that it has run
  seconds_left: number | null; // estimated
  message: string; // reason and advice of a run that failed or ended early, what is damaged; else ""
  modified: number; // s since 1970
}

/** POST api/runs {text, name} -> {id}: runs a case in a new folder called name, name-2, ...
 *  POST api/runs/ID/pause, /resume (also an interrupted one), /stop -> {} */
export interface StartRequest {
  text: string;
  name: string;
}

/** GET api/runs/ID */
export interface RunDetail extends RunHead {
  case_text: string;
  frame_list: { index: number; strain: number }[];
  width: number; // mm, at the start
  gauge_length: number;
  nodes: number;
  elements: number;
  quality: Quality | null; // null while it runs
  stages: { name: string; from: number; to: number; slope: number | null }[]; // slope: N per unit of strain
  report: boolean; // whether report.html is there
  mass_scaling: number | null;
  threads: number | null;
}

export interface Quality {
  quasi_static: boolean;
  verdict: string; // sentences
  crossings: string; // a sentence
  ravelling: string[];
  breaks: string[];
  kinetic_ratio: number | null;
  energy_balance: number | null;
  grip_difference: number | null;
  penetration: number; // mm
  penetration_ratio: number; // over the diameter
}

/** GET api/runs/ID/history?from=ROW: columns by the names of history.csv, each with the rows from ROW on. */
export interface History {
  from: number;
  columns: Record<string, number[]>;
}

/** GET api/runs/ID/model: blob; arrays: positions f32 (stress-free), course i32, wale i32, arc_length f32 (from the yarn's
 *  first node). */
export interface RunModel extends FabricHead {
  title: string;
}

/** GET api/runs/ID/frames/INDEX, GET api/runs/ID/live (the newest state of an active run): blob.
 *  Arrays: positions f32[3 nodes]; each field f32[nodes] under its name, element values at the element's first node
 *  (of_elements true) or node values; broken i32 (elements, by first node);
 *  contact_positions f32[3 contacts], contact_normals f32[3 contacts], contact_normal_force f32, contact_friction f32
 *  (magnitude), contact_gap f32, contact_slip f32, contact_slips i32 (0/1), contact_yarns i32[2 contacts],
 *  contact_places f32[2 contacts] (arc lengths). */
export interface FrameHead {
  index: number | null; // null: live
  live: number; // number of the live view; 0 for a stored frame
  strain: number;
  force: number; // at the driven grip
  fields: FieldHead[];
  contacts: number;
}

export interface FieldHead {
  name: string; // axial_force, shear_force, bending_moment, torque, axial_strain, curvature, contact_force, out_of_plane
  label: string; // "Axial force"
  unit: string; // "N"
  of_elements: boolean;
  lowest: number; // round ends of a colour bar
  highest: number;
}

/** POST api/measured: curves from a dropped file. Strain and force are turned by gauge length and width where the file has
 *  displacements or needs them; the answer is in force per width. */
export interface MeasuredRequest {
  name: string;
  text: string;
  gauge_length: string; // "100 mm"
  width: string; // "50 mm"
}

export interface MeasuredCurve {
  name: string;
  strain: number[];
  force_per_width: number[]; // N/mm
}

/** POST api/measured */
export interface Measured {
  specimens: MeasuredCurve[];
  mean: { strain: number[]; mean: number[]; lowest: number[]; highest: number[] }; // N/mm
}

/** GET api/formats: what POST api/export {text, format, stem, ending} writes; its answer is the file itself. */
export interface ExportFormat {
  name: string; // "abaqus"
  label: string; // "Abaqus/Explicit input file"
  kind: "deck" | "geometry";
  endings: string[]; // [".inp"]: of its files, whose names are the stem and one of these
}

// POST api/runs/ID/report -> {}: writes report.html anew.
// GET api/runs/ID/picture?frame=0&colour=contact&view=front&width=1200: a PNG drawn by the program (words of knitmech render).
// GET api/runs/ID/geometry?format=gltf&frame=3&ending=.glb: a file of knitmech export of a stored frame.
// GET runs/ID/...: the files of the run folder: runs/ID/report.html, runs/ID/history.csv, runs/ID/figures/...
// GET api/events: server-sent events: run (RunHead), gone ({id}).

// The view as a whole: follows what it is given, draws when something has changed and at no other time.

import * as three from "three";
import type { FabricHead } from "../api/types";
import { fitted, Projection, seenFrom, stateBetween } from "./camera";
import { ContactDots } from "./contact_dots";
import { addControls } from "./controls";
import { drawOverlay } from "./overlay";
import { pick } from "./pick";
import { Tubes } from "./tubes";
import type {
  Box,
  CameraState,
  ClipBox,
  ContactLayer,
  FabricColouring,
  Highlight,
  Mark,
  Picked,
  Vec3,
  ViewColours,
  ViewName,
} from "./types";

const kSettle = 55; // ms in which a movement of the camera comes 63 % of its way
const kFirstStep = 16; // ms
const kLargestRatio = 2; // pixels of the screen per px
const kRestAfter = 160; // ms without a change until the finest picture is drawn

export interface StageInput {
  fabric: FabricHead;
  positions: Float32Array;
  course: Int32Array;
  wale: Int32Array;
  colouring: FabricColouring;
  broken: Int32Array | undefined;
  contacts: ContactLayer | undefined;
  clip: ClipBox | undefined;
  highlight: Highlight | undefined;
  marks: readonly Mark[];
  room: Box | undefined;
  camera: CameraState | undefined;
  colours: ViewColours;
  generation: number;
}

export interface StageEvents {
  camera(state: CameraState): void;
  pick(picked: Picked | null): void;
  drawn(generation: number, milliseconds: number, elements: number): void;
  lost(isLost: boolean): void;
  covered(): number; // height of what lies over the top of the view [px]
}

/** Whether the numbers of one fabric fit the other. */
export function isSameFabric(a: FabricHead, b: FabricHead): boolean {
  if (a === b) return true;
  return (
    a.nodes === b.nodes &&
    a.diameter === b.diameter &&
    a.edge_diameter === b.edge_diameter &&
    a.yarns.length === b.yarns.length &&
    a.yarns.every((yarn, i) => yarn.first_node === b.yarns[i]!.first_node && yarn.nodes === b.yarns[i]!.nodes)
  );
}

const hasReducedMotion = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

export class Stage {
  private readonly renderer: three.WebGLRenderer;
  private readonly scene = new three.Scene();
  private readonly camera = new three.Camera();
  private readonly endControls: () => void;
  private readonly resizing: ResizeObserver;
  private tubes: Tubes | null = null;
  private dots: ContactDots | null = null;
  private input: StageInput | null = null;
  private shown: CameraState;
  private wanted: CameraState;
  private told: CameraState | null = null; // the camera last given to or by the page
  private isWhole = true; // nobody has moved or zoomed: the whole fabric stays in view
  private frame = 0; // of requestAnimationFrame; 0: none
  private rest: ReturnType<typeof setTimeout> | undefined;
  private lastTime = 0; // of the last step; 0: nothing moved
  private spent = 0; // ms, on changes since the last picture
  private isGone = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly overlay: HTMLCanvasElement,
    view: ViewName,
    private readonly events: StageEvents,
  ) {
    this.renderer = new three.WebGLRenderer({ canvas, antialias: true, powerPreference: "high-performance" });
    this.scene.matrixWorldAutoUpdate = false;
    this.camera.matrixWorldAutoUpdate = false;
    this.shown = this.wanted = seenFrom(
      { azimuth: 0, elevation: 0, target: [0, 0, 0], span: 1, orthographic: true },
      view,
    );
    this.endControls = addControls(canvas, {
      change: (change, atOnce) => this.change(change, atOnce),
      showWhole: () => this.showWhole(),
      click: (column, row) => this.events.pick(this.pickAt(column, row)),
    });
    this.resizing = new ResizeObserver(() => this.resize());
    this.resizing.observe(canvas);
    canvas.addEventListener("webglcontextlost", this.noteLost);
    canvas.addEventListener("webglcontextrestored", this.noteRestored);
  }

  private readonly noteLost = (): void => this.events.lost(true);
  private readonly noteRestored = (): void => {
    this.events.lost(false);
    this.request();
  };

  /** Takes over what has changed. */
  update(input: StageInput): void {
    const begin = performance.now();
    this.takeOver(input);
    this.spent += performance.now() - begin;
    this.request();
  }

  private takeOver(input: StageInput): void {
    const last = this.input;
    this.input = input;
    const isNew = last === null || this.tubes === null || !isSameFabric(last.fabric, input.fabric);
    if (isNew) this.build(input);
    const tubes = this.tubes as Tubes;
    const dots = this.dots as ContactDots;
    if (isNew || input.positions !== last.positions || input.generation !== last.generation)
      tubes.setPositions(input.positions);
    if (isNew || input.broken !== last.broken) tubes.setBroken(input.broken);
    if (isNew || input.colouring !== last.colouring || input.broken !== last.broken)
      tubes.setColouring(input.colouring);
    if (isNew || input.clip !== last.clip) tubes.setClip(input.clip);
    if (isNew || input.highlight !== last.highlight) tubes.setHighlight(input.highlight);
    if (isNew || input.contacts !== last.contacts || input.highlight !== last.highlight)
      dots.setLayer(input.contacts, input.highlight?.contact);
    dots.setClip(tubes.clip);
    if (isNew || input.colours !== last.colours) this.paint(input.colours);
    if (input.camera !== undefined && input.camera !== this.told) this.take(input.camera);
    else if (isNew || input.room !== last.room) this.fitIfWhole(true);
  }

  private build(input: StageInput): void {
    this.clear();
    this.tubes = new Tubes(input.fabric, input.course, input.wale);
    this.dots = new ContactDots(input.fabric.diameter);
    this.scene.add(this.tubes.mesh, this.dots.mesh);
  }

  private clear(): void {
    this.scene.clear();
    this.tubes?.dispose();
    this.dots?.dispose();
  }

  private paint(colours: ViewColours): void {
    this.renderer.setClearColor(new three.Color().setRGB(...colours.back, three.SRGBColorSpace));
    this.tubes?.setColours(colours);
    this.dots?.setColours(colours);
  }

  private take(state: CameraState): void {
    this.told = this.shown = this.wanted = state;
    this.isWhole = false;
  }

  /** The box that the whole view shows. */
  private roomOf(): Box | null {
    return this.input?.room ?? this.tubes?.chunks.box ?? null;
  }

  private size(): [number, number] {
    return [Math.max(1, this.canvas.clientWidth), Math.max(1, this.canvas.clientHeight)];
  }

  private fitIfWhole(atOnce: boolean): void {
    const room = this.roomOf();
    if (!this.isWhole || room === null) return;
    this.wanted = fitted(this.wanted, room, ...this.size(), this.events.covered());
    if (atOnce) this.shown = this.told = this.wanted; // nothing that the user did
  }

  private change(change: (state: CameraState) => CameraState, atOnce = false): void {
    const before = this.wanted;
    this.wanted = change(before);
    if (this.wanted.span !== before.span || this.wanted.target !== before.target) this.isWhole = false;
    if (atOnce) this.shown = this.wanted;
    this.request();
  }

  showWhole(): void {
    this.isWhole = true;
    this.fitIfWhole(false);
    this.request();
  }

  show(view: ViewName): void {
    this.wanted = seenFrom(this.wanted, view);
    this.showWhole();
  }

  setOrthographic(orthographic: boolean): void {
    this.wanted = { ...this.wanted, orthographic };
    this.shown = { ...this.shown, orthographic };
    this.fitIfWhole(false);
    this.shown = this.wanted;
    this.request();
  }

  pickAt(column: number, row: number): Picked | null {
    if (this.input === null || this.tubes === null || this.dots === null) return null;
    return pick(this.input.fabric, this.input.positions, this.tubes, this.dots, this.projection(), column, row);
  }

  request(): void {
    if (this.frame === 0 && !this.isGone) this.frame = requestAnimationFrame(this.step);
  }

  private readonly step = (time: number): void => {
    this.frame = 0;
    const isMoving = this.follow(this.lastTime === 0 ? kFirstStep : time - this.lastTime);
    this.lastTime = isMoving ? time : 0;
    this.draw(true);
    if (isMoving) this.request();
    else this.tellCamera();
    clearTimeout(this.rest);
    if (!isMoving) this.rest = setTimeout(() => this.draw(false), kRestAfter);
  };

  /** Moves the camera on; whether it has farther to go. */
  private follow(milliseconds: number): boolean {
    const share = hasReducedMotion() ? 1 : 1 - Math.exp(-milliseconds / kSettle);
    const next = stateBetween(this.shown, this.wanted, share);
    this.shown = next ?? this.wanted;
    return next !== null;
  }

  private tellCamera(): void {
    if (this.told === this.wanted) return;
    this.told = this.wanted;
    this.events.camera(this.wanted);
  }

  private projection(): Projection {
    const box = this.tubes?.chunks.box ?? { lowest: [0, 0, 0], highest: [1, 1, 1] };
    return new Projection(this.shown, ...this.size(), box);
  }

  private resize(): void {
    this.fitIfWhole(true);
    this.draw(true);
    this.request();
  }

  private ratio(): number {
    return Math.min(kLargestRatio, devicePixelRatio);
  }

  private draw(isMoving: boolean): void {
    if (this.isGone || this.input === null || this.canvas.clientWidth === 0) return;
    const begin = performance.now();
    this.paintAt(this.ratio(), isMoving);
    this.events.drawn(this.input.generation, performance.now() - begin + this.spent, (this.tubes as Tubes).drawn);
    this.spent = 0;
  }

  private paintAt(ratio: number, isMoving: boolean): void {
    const input = this.input as StageInput;
    const projection = this.projection();
    const size = [Math.round(projection.width * ratio), Math.round(projection.height * ratio)] as const;
    if (this.canvas.width !== size[0] || this.canvas.height !== size[1]) {
      this.renderer.setSize(size[0], size[1], false);
      [this.overlay.width, this.overlay.height] = size;
    }
    projection.applyTo(this.camera);
    (this.tubes as Tubes).prepare(projection, this.camera, isMoving);
    (this.dots as ContactDots).prepare(projection.pixelsPerMm);
    this.renderer.render(this.scene, this.camera);
    drawOverlay(this.overlay, projection, input.colours, ratio, { marks: input.marks, picked: this.pickedPlace() });
  }

  private pickedPlace(): Vec3 | null {
    const input = this.input as StageInput;
    const { element, contact } = input.highlight ?? {};
    if (contact !== undefined && input.contacts !== undefined && contact < input.contacts.force.length)
      return [0, 1, 2].map((axis) => input.contacts!.positions[3 * contact + axis]!) as unknown as Vec3;
    if (element === undefined) return null;
    const middle = [0, 1, 2].map(
      (axis) => 0.5 * (input.positions[3 * element + axis]! + input.positions[3 * element + 3 + axis]!),
    );
    return middle.every(Number.isFinite) ? (middle as unknown as Vec3) : null;
  }

  /** The present picture with all that is written over it, at up to twice its size on the screen. */
  picture(ratio: number): HTMLCanvasElement {
    const result = document.createElement("canvas");
    this.paintAt(ratio, false);
    [result.width, result.height] = [this.canvas.width, this.canvas.height];
    const paper = result.getContext("2d");
    paper?.drawImage(this.canvas, 0, 0);
    paper?.drawImage(this.overlay, 0, 0);
    this.paintAt(this.ratio(), false);
    return result;
  }

  dispose(): void {
    this.isGone = true;
    cancelAnimationFrame(this.frame);
    clearTimeout(this.rest);
    this.endControls();
    this.resizing.disconnect();
    this.canvas.removeEventListener("webglcontextlost", this.noteLost);
    this.canvas.removeEventListener("webglcontextrestored", this.noteRestored);
    this.clear();
    this.renderer.dispose();
    this.renderer.forceContextLoss(); // or its memory stays until the canvas is collected
  }
}

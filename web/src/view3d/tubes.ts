// The yarns as instanced tubes. Everything that changes from frame to frame is one texture: positions and the values of the
// shown field. Which elements are drawn, and how finely, follows from what is in sight.

import * as three from "three";
import type { FabricHead } from "../api/types";
import { Chunks } from "./chunks";
import { kMapSize, mapPixels } from "./colour_map";
import type { Projection } from "./camera";
import * as shader from "./tube_shader";
import type { Box, FabricColouring, Highlight, ViewColours } from "./types";

const kEverywhere: Box = { lowest: [-1e9, -1e9, -1e9], highest: [1e9, 1e9, 1e9] };
const kVerticesMoving = 900_000; // as many as are drawn while something moves
const kVerticesAtRest = 4_000_000;
const kRibbonPixels = 2.5; // diameter up to which a yarn is a strip
const kThinnest = 1.1; // px; thinner yarns would be drawn here and there
const kRimDarkness = 0.66; // of a thick yarn

export interface Detail {
  sides: number; // 1: a strip that faces the viewer
  pieces: number; // along an element
}

/** Sides and pieces for yarns of a diameter and elements of a length [px]; fewer where there would be too many vertices. */
export function detailFor(diameter: number, length: number, elements: number, vertices: number): Detail {
  const wantedSides = diameter < kRibbonPixels ? 1 : diameter < 6 ? 6 : diameter < 14 ? 10 : diameter < 40 ? 16 : 24;
  const wantedPieces = Math.min(12, Math.max(1, Math.round(length / 5)));
  let [sides, pieces] = [wantedSides, wantedPieces];
  while (elements * (sides + 1) * (pieces + 1) > vertices && sides * pieces > 1) {
    if (pieces > 1 && pieces * 4 >= sides) pieces -= 1;
    else sides = sides > 4 ? sides - 1 : 1;
  }
  return { sides, pieces };
}

function setTemplate(geometry: three.BufferGeometry, { sides, pieces }: Detail): void {
  const corners: number[] = [];
  const triangles: number[] = [];
  for (let piece = 0; piece <= pieces; ++piece)
    for (let side = 0; side <= sides; ++side) corners.push(side / sides, piece / pieces);
  for (let piece = 0; piece < pieces; ++piece)
    for (let side = 0; side < sides; ++side) {
      const i = piece * (sides + 1) + side;
      triangles.push(i, i + 1, i + sides + 1, i + 1, i + sides + 2, i + sides + 1);
    }
  geometry.setAttribute("corner", new three.BufferAttribute(new Float32Array(corners), 2));
  geometry.setIndex(new three.BufferAttribute(new Uint16Array(triangles), 1));
}

function colourMapTexture(): three.DataTexture {
  const texture = new three.DataTexture(mapPixels(), kMapSize, 1);
  texture.minFilter = texture.magFilter = three.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

function makeUniforms(nodes: three.DataTexture) {
  const colour = (): three.Vector3 => new three.Vector3();
  return {
    nodes: { value: nodes },
    radius: { value: 0 },
    edgeRadius: { value: 0 },
    eye: { value: new three.Vector4() },
    isRibbon: { value: false },
    leastRadius: { value: 0 },
    widening: { value: 1 },
    colouring: { value: 0 },
    courses: { value: [colour(), colour()] },
    plain: { value: colour() },
    unknown: { value: colour() },
    picked: { value: colour() },
    back: { value: colour() },
    colourMap: { value: colourMapTexture() },
    range: { value: new three.Vector2(0, 1) },
    clipLowest: { value: new three.Vector3() },
    clipHighest: { value: new three.Vector3() },
    orthographic: { value: 1 },
    depths: { value: new three.Vector2() },
    rimDarkness: { value: 0 },
    pickedYarn: { value: new three.Vector2(-1, -1) },
    pickedElement: { value: -1 },
  };
}

export class Tubes {
  readonly mesh: three.Mesh<three.InstancedBufferGeometry, three.RawShaderMaterial>;
  readonly chunks: Chunks;
  readonly hidden: Uint8Array; // by element: broken, or without a position
  drawn = 0; // elements in the last picture
  detail: Detail = { sides: 0, pieces: 0 };
  clip: Box = kEverywhere;
  private readonly packed: Float32Array;
  private readonly keys: Uint32Array;
  private readonly broken: Uint8Array;
  private readonly inSight: three.InstancedBufferAttribute;
  private readonly uniforms: ReturnType<typeof makeUniforms>;
  private readonly geometries = new Map<string, three.InstancedBufferGeometry>();
  private shownChunks: Uint8Array;
  private isWhole = true; // every node has a position
  private isListStale = true;
  private meanLength = 1; // of the elements [mm]
  private alone = -1; // the only yarn that is drawn

  constructor(
    private readonly fabric: FabricHead,
    course: Int32Array,
    wale: Int32Array,
  ) {
    const rows = Math.max(1, Math.ceil(fabric.nodes / shader.kTextureColumns));
    this.packed = new Float32Array(4 * rows * shader.kTextureColumns);
    const nodes = new three.DataTexture(this.packed, shader.kTextureColumns, rows, three.RGBAFormat, three.FloatType);
    this.uniforms = makeUniforms(nodes);
    this.uniforms.radius.value = fabric.diameter / 2;
    this.uniforms.edgeRadius.value = (fabric.edge_diameter ?? fabric.diameter) / 2;
    this.chunks = new Chunks(fabric);
    this.shownChunks = new Uint8Array(this.chunks.count);
    this.hidden = new Uint8Array(fabric.nodes);
    this.broken = new Uint8Array(fabric.nodes);
    this.keys = Uint32Array.from(course, (row, i) => {
      const onArc = wale[i]! < 0 || (wale[i + 1] ?? 0) < 0;
      return (i | (onArc ? shader.kEdgeYarn : 0) | (row % 2 !== 0 ? shader.kOddCourse : 0)) >>> 0;
    });
    this.inSight = new three.InstancedBufferAttribute(new Uint32Array(fabric.nodes), 1);
    this.inSight.gpuType = three.IntType;
    this.inSight.setUsage(three.DynamicDrawUsage);
    const material = new three.RawShaderMaterial({
      glslVersion: three.GLSL3,
      vertexShader: shader.tubeVertexShader,
      fragmentShader: shader.tubeFragmentShader,
      uniforms: this.uniforms,
      side: three.DoubleSide,
    });
    this.mesh = new three.Mesh(this.geometryOf({ sides: 6, pieces: 1 }), material);
    this.mesh.frustumCulled = false;
  }

  /** New positions of the same fabric. */
  setPositions(positions: Float32Array): void {
    let isWhole = true;
    for (let i = 0; i < this.fabric.nodes; ++i) {
      const x = positions[3 * i]!;
      const y = positions[3 * i + 1]!;
      const z = positions[3 * i + 2]!;
      this.packed[4 * i] = x;
      this.packed[4 * i + 1] = y;
      this.packed[4 * i + 2] = z;
      isWhole &&= Number.isFinite(x + y + z);
    }
    this.uniforms.nodes.value.needsUpdate = true;
    this.chunks.follow(positions);
    this.meanLength = this.findMeanLength();
    if (isWhole && this.isWhole) return;
    this.isWhole = isWhole;
    this.findHidden();
  }

  private findMeanLength(): number {
    const step = Math.max(1, Math.floor(this.fabric.nodes / 500));
    let [sum, count] = [0, 0];
    for (let i = 0; i + 1 < this.fabric.nodes; i += step) {
      const length = Math.hypot(...[0, 1, 2].map((axis) => this.packed[4 * i + 4 + axis]! - this.packed[4 * i + axis]!));
      if (!(length < 100 * this.fabric.diameter)) continue; // from one yarn to the next, or not a number
      sum += length;
      count += 1;
    }
    return count > 0 ? sum / count : this.fabric.diameter;
  }

  setBroken(elements: Int32Array | undefined): void {
    this.broken.fill(0);
    for (const element of elements ?? []) this.broken[element] = 1;
    this.findHidden();
  }

  private hasPlace(node: number): boolean {
    return Number.isFinite(this.packed[4 * node]! + this.packed[4 * node + 1]! + this.packed[4 * node + 2]!);
  }

  /** Marks what cannot be drawn, and where yarns begin and end for it. */
  private findHidden(): void {
    this.hidden.set(this.broken);
    for (let i = 0; !this.isWhole && i < this.fabric.nodes; ++i) {
      if (this.hasPlace(i)) continue;
      this.hidden[i] = 1;
      if (i > 0) this.hidden[i - 1] = 1;
    }
    const ends = shader.kFirstOfYarn | shader.kLastOfYarn;
    for (const yarn of this.fabric.yarns) {
      const last = yarn.first_node + yarn.nodes - 2;
      for (let i = yarn.first_node; i <= last; ++i) {
        const begins = i === yarn.first_node || this.hidden[i - 1] === 1;
        const finishes = i === last || this.hidden[i + 1] === 1;
        const flags = (begins ? shader.kFirstOfYarn : 0) | (finishes ? shader.kLastOfYarn : 0);
        this.keys[i] = ((this.keys[i]! & ~ends) | flags) >>> 0;
      }
    }
    this.isListStale = true;
  }

  setColouring(colouring: FabricColouring): void {
    this.uniforms.colouring.value = ["course", "plain", "field"].indexOf(colouring.by);
    if (colouring.by !== "field") return;
    this.uniforms.range.value.set(colouring.lowest, Math.max(colouring.highest, colouring.lowest + 1e-30));
    if (colouring.ofElements) this.packAveraged(colouring.values);
    else this.pack((i) => colouring.values[i]!);
    this.uniforms.nodes.value.needsUpdate = true;
  }

  private pack(valueAt: (node: number) => number): void {
    for (let i = 0; i < this.fabric.nodes; ++i) {
      const value = valueAt(i);
      this.packed[4 * i + 3] = Number.isFinite(value) ? value : shader.kNotANumber;
    }
  }

  /** The value of a node is the mean of its elements that are whole. */
  private packAveraged(values: Float32Array): void {
    for (const yarn of this.fabric.yarns) {
      const end = yarn.first_node + yarn.nodes - 1;
      for (let i = yarn.first_node; i <= end; ++i) {
        const before = i > yarn.first_node && this.broken[i - 1] === 0 ? values[i - 1]! : null;
        const after = i < end && this.broken[i] === 0 ? values[i]! : null;
        const mean = before !== null && after !== null ? 0.5 * (before + after) : (before ?? after ?? NaN);
        this.packed[4 * i + 3] = Number.isFinite(mean) ? mean : shader.kNotANumber;
      }
    }
  }

  setClip(clip: Box | undefined): void {
    this.clip = clip ?? kEverywhere;
    this.uniforms.clipLowest.value.set(...this.clip.lowest);
    this.uniforms.clipHighest.value.set(...this.clip.highest);
  }

  setHighlight(highlight: Highlight | undefined): void {
    const index = highlight?.yarn ?? -1;
    const yarn = this.fabric.yarns[index];
    const isMarked = yarn !== undefined && highlight?.alone !== true;
    this.uniforms.pickedYarn.value.set(
      isMarked ? yarn.first_node : -1,
      isMarked ? yarn.first_node + yarn.nodes - 1 : -1,
    );
    this.uniforms.pickedElement.value = highlight?.element ?? -1;
    const alone = highlight?.alone === true ? index : -1;
    this.isListStale ||= alone !== this.alone;
    this.alone = alone;
  }

  setColours(colours: ViewColours): void {
    this.uniforms.courses.value.forEach((vector, i) => vector.set(...colours.courses[i]!));
    for (const name of ["plain", "unknown", "picked", "back"] as const)
      this.uniforms[name].value.set(...colours[name]);
  }

  isDrawn(chunk: number): boolean {
    return (this.alone < 0 || this.chunks.yarn[chunk] === this.alone) && this.chunks.overlaps(chunk, this.clip);
  }

  /** Chooses what is drawn, and how finely, before a picture. */
  prepare(projection: Projection, camera: three.Camera, isMoving: boolean): void {
    this.findInSight(camera);
    const vertices = isMoving ? kVerticesMoving : kVerticesAtRest;
    const diameter = this.fabric.diameter * projection.pixelsPerMm;
    this.detail = detailFor(diameter, this.meanLength * projection.pixelsPerMm, this.drawn, vertices);
    const geometry = this.geometryOf(this.detail);
    geometry.instanceCount = this.drawn;
    this.mesh.geometry = geometry;
    const part = (2 * Math.PI) / this.detail.sides;
    this.uniforms.leastRadius.value = kThinnest / 2 / projection.pixelsPerMm;
    this.uniforms.isRibbon.value = this.detail.sides === 1;
    this.uniforms.widening.value = this.detail.sides === 1 ? 1 : Math.sqrt(part / Math.sin(part)); // to the yarn's section
    const isParallel = projection.state.orthographic;
    this.uniforms.eye.value.set(...(isParallel ? projection.axes.towards : projection.eye), isParallel ? 0 : 1);
    this.uniforms.rimDarkness.value = kRimDarkness * Math.min(1, Math.max(0, (diameter - 1.5) / 6));
    this.uniforms.orthographic.value = projection.state.orthographic ? 1 : 0;
    this.findDepths(camera);
  }

  private findInSight(camera: three.Camera): void {
    const matrix = new three.Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    const planes = new three.Frustum()
      .setFromProjectionMatrix(matrix)
      .planes.map(({ normal, constant }) => [normal.x, normal.y, normal.z, constant] as const);
    let changed = this.isListStale;
    for (let chunk = 0; chunk < this.chunks.count; ++chunk) {
      const seen = this.isDrawn(chunk) && this.chunks.isInside(chunk, planes) ? 1 : 0;
      changed ||= seen !== this.shownChunks[chunk];
      this.shownChunks[chunk] = seen;
    }
    if (changed) this.listInSight();
  }

  private listInSight(): void {
    const list = this.inSight.array as Uint32Array;
    let count = 0;
    for (let chunk = 0; chunk < this.chunks.count; ++chunk) {
      if (this.shownChunks[chunk] === 0) continue;
      const begin = this.chunks.first[chunk]!;
      for (let i = begin; i < begin + this.chunks.elements[chunk]!; ++i)
        if (this.hidden[i] === 0) list[count++] = this.keys[i]!;
    }
    this.drawn = count;
    this.isListStale = false;
    this.inSight.addUpdateRange(0, count);
    this.inSight.needsUpdate = true;
  }

  /** The depth cue spans the fabric as it is seen. */
  private findDepths(camera: three.Camera): void {
    const { lowest, highest } = this.chunks.box;
    const e = camera.matrixWorldInverse.elements;
    let [near, far] = [Infinity, -Infinity];
    for (let i = 0; i < 8; ++i) {
      const corner = [i & 1, (i >> 1) & 1, i >> 2].map((end, axis) => (end === 1 ? highest : lowest)[axis]!);
      const depth = -(e[2]! * corner[0]! + e[6]! * corner[1]! + e[10]! * corner[2]! + e[14]!);
      near = Math.min(near, depth);
      far = Math.max(far, depth);
    }
    this.uniforms.depths.value.set(near, far);
  }

  private geometryOf(detail: Detail): three.InstancedBufferGeometry {
    const name = `${detail.sides} ${detail.pieces}`;
    let geometry = this.geometries.get(name);
    if (geometry === undefined) {
      geometry = new three.InstancedBufferGeometry();
      setTemplate(geometry, detail);
      geometry.setAttribute("key", this.inSight);
      this.geometries.set(name, geometry);
    }
    return geometry;
  }

  dispose(): void {
    for (const geometry of this.geometries.values()) geometry.dispose();
    this.uniforms.nodes.value.dispose();
    this.uniforms.colourMap.value.dispose();
    this.mesh.material.dispose();
  }
}

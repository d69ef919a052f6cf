// Contacts as discs that face the viewer: area by the force, colour and a hole by whether they stick or slip.

import * as three from "three";
import type { Box, ContactLayer, ViewColours } from "./types";

const kLargestDiameters = 1.1; // radius of the largest disc, in diameters of the yarn
const kSmallestPixels = 1.6; // radius
const kForwardDiameters = 1.5; // towards the viewer, out of the yarns

const vertexShader = /* glsl */ `
precision highp float;
uniform mat4 viewMatrix;
uniform mat4 projectionMatrix;
uniform float largestRadius;  // mm
uniform float forward;        // mm
uniform float pixelsPerMm;
in vec2 corner;
in vec3 centre;
in vec3 look;  // share of the largest force, below 0: hidden; 1 if it slips; 1 if it is picked
out vec2 across;
out vec3 place;
flat out vec3 looks;
flat out float pixels;

void main() {
  if (look.x < 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  float radius = max(largestRadius * sqrt(look.x), ${kSmallestPixels.toFixed(1)} / pixelsPerMm);
  if (look.z > 0.5) radius *= 1.35;
  vec4 seen = viewMatrix * vec4(centre, 1.0);
  seen.z += forward;
  pixels = radius * pixelsPerMm + 1.0;
  seen.xy += corner * (radius + 1.0 / pixelsPerMm);
  across = corner;
  place = centre;
  looks = look;
  gl_Position = projectionMatrix * seen;
}
`;

const fragmentShader = /* glsl */ `
precision highp float;
uniform vec3 stick;
uniform vec3 slip;
uniform vec3 picked;
uniform vec3 back;
uniform vec3 clipLowest;
uniform vec3 clipHighest;
in vec2 across;
in vec3 place;
flat in vec3 looks;
flat in float pixels;
out vec4 colour;

void main() {
  if (any(lessThan(place, clipLowest)) || any(greaterThan(place, clipHighest))) discard;
  float r = length(across) * pixels;
  if (r > pixels) discard;
  vec3 ink = looks.z > 0.5 ? picked : looks.y > 0.5 ? slip : stick;
  bool isHole = looks.y > 0.5 && pixels > 5.0 && r < 0.45 * pixels;
  colour = vec4(isHole || r > pixels - 1.2 ? back : ink, 1.0);
}
`;

export class ContactDots {
  readonly mesh: three.Mesh<three.InstancedBufferGeometry, three.RawShaderMaterial>;
  layer: ContactLayer | undefined;
  private readonly uniforms = {
    largestRadius: { value: 0 },
    forward: { value: 0 },
    pixelsPerMm: { value: 1 },
    stick: { value: new three.Vector3() },
    slip: { value: new three.Vector3() },
    picked: { value: new three.Vector3() },
    back: { value: new three.Vector3() },
    clipLowest: { value: new three.Vector3() },
    clipHighest: { value: new three.Vector3() },
  };

  constructor(private readonly diameter: number) {
    this.uniforms.largestRadius.value = kLargestDiameters * diameter;
    this.uniforms.forward.value = kForwardDiameters * diameter;
    const material = new three.RawShaderMaterial({
      glslVersion: three.GLSL3,
      vertexShader,
      fragmentShader,
      uniforms: this.uniforms,
    });
    this.mesh = new three.Mesh(new three.InstancedBufferGeometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  setLayer(layer: ContactLayer | undefined, picked: number | undefined): void {
    this.layer = layer;
    this.mesh.visible = layer !== undefined && layer.force.length > 0;
    if (layer === undefined || !this.mesh.visible) return;
    const look = new Float32Array(3 * layer.force.length);
    layer.force.forEach((force, i) => {
      const share = layer.largest > 0 && Number.isFinite(force) ? Math.min(1, force / layer.largest) : 0;
      look.set([layer.hidden?.[i] === 1 ? -1 : share, layer.slips[i] === 0 ? 0 : 1, i === picked ? 1 : 0], 3 * i);
    });
    const geometry = new three.InstancedBufferGeometry();
    geometry.setAttribute("corner", new three.BufferAttribute(new Float32Array([-1, -1, 1, -1, 1, 1, -1, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    geometry.setAttribute("centre", new three.InstancedBufferAttribute(layer.positions, 3));
    geometry.setAttribute("look", new three.InstancedBufferAttribute(look, 3));
    this.mesh.geometry.dispose();
    this.mesh.geometry = geometry;
  }

  setColours(colours: ViewColours): void {
    for (const name of ["stick", "slip", "picked", "back"] as const) this.uniforms[name].value.set(...colours[name]);
  }

  setClip(clip: Box): void {
    this.uniforms.clipLowest.value.set(...clip.lowest);
    this.uniforms.clipHighest.value.set(...clip.highest);
  }

  prepare(pixelsPerMm: number): void {
    this.uniforms.pixelsPerMm.value = pixelsPerMm;
  }

  /** Radius of a disc [px], at a size of a mm [px]. */
  radiusOf(contact: number, pixelsPerMm: number): number {
    const { force, largest } = this.layer as ContactLayer;
    const share = largest > 0 ? Math.min(1, Math.max(0, force[contact]! / largest)) : 0;
    return Math.max(kLargestDiameters * this.diameter * Math.sqrt(share) * pixelsPerMm, kSmallestPixels) + 1;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

// VTP, CSV, BCC and .yarns, read by what their descriptions say and compared with the frames of the run.
import assert from "node:assert/strict";
import { readdirSync, readFileSync, rmSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { inflateSync } from "node:zlib";
import { exported, lengthOf, makeFabrics, minus, yarnsOfCsv } from "./fabrics.mjs";

let folder;
before(() => (folder = makeFabrics()));
after(() => rmSync(folder, { recursive: true, force: true }));

const numberTypes = { Float64: Float64Array, Int32: Int32Array, Int64: BigInt64Array };

/** An array of a part of a VTK XML file ("PointData"): base64 of the head, then of zlib blocks (VTK's file formats, "compressed data"). */
function vtkArray(text, part, name) {
  const [, type, data] = new RegExp(`<${part}>[^]*?<DataArray type="(\\w+)" Name="${name}"[^>]*format="binary">([^<]*)<`).exec(text);
  const n_blocks = Number(Buffer.from(data.slice(0, 12), "base64").readBigUInt64LE());
  const head_length = Math.ceil((8 * (3 + n_blocks)) / 3) * 4;
  const head = Buffer.from(data.slice(0, head_length), "base64");
  const blocks = Buffer.from(data.slice(head_length), "base64");
  const parts = [];
  for (let block = 0, place = 0; block < n_blocks; ++block) {
    const size = Number(head.readBigUInt64LE(8 * (3 + block)));
    parts.push(inflateSync(blocks.subarray(place, place + size)));
    place += size;
  }
  const bytes = Buffer.concat(parts);
  const Numbers = numberTypes[type];
  return Array.from(new Numbers(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)), Number);
}

const threes = (numbers) => Array.from({ length: numbers.length / 3 }, (_, i) => numbers.slice(3 * i, 3 * i + 3));
const strainOf = (text) => vtkArray(text, "FieldData", "strain");
const framePath = (run) => join(folder, "results", run, "frames");
const lastFrame = (run) => readFileSync(join(framePath(run), readdirSync(framePath(run)).filter((name) => /^frame_\d+.vtp$/.test(name)).sort().at(-1)), "utf8");
const frameFile = (run, index) => readFileSync(join(framePath(run), `frame_${String(index).padStart(4, "0")}.vtp`), "utf8");
const csv = (...words) => yarnsOfCsv(exported(folder, words[0], "csv", ...words.slice(1)).toString());

test("Given a frame of a run, then the lines for ParaView pass through its nodes, with their data.", () => {
  const frame = frameFile("jersey", 2);
  const text = exported(folder, "results/jersey", "vtp", "--frame", 2).toString();
  const points = threes(vtkArray(text, "Points", "points_mm"));
  const place = new Map(points.map((point, i) => [point.join(), i]));
  const arrays = Object.fromEntries(["yarn", "course", "wale", "tube_radius_mm", "displacement_mm"].map((name) => [name, vtkArray(text, "PointData", name)]));
  const at_nodes = Object.fromEntries(["course", "wale", "displacement_mm", "tube_radius_mm"].map((name) => [name, vtkArray(frame, "PointData", name)]));
  const nodes = threes(vtkArray(frame, "Points", "points_mm"));
  assert.ok(points.length > nodes.length, "there is more between them where the yarn is bent");
  nodes.forEach((node, i) => {
    const there = place.get(node.join());
    assert.notEqual(there, undefined, `node ${i}`);
    for (const name of ["course", "wale", "tube_radius_mm"]) assert.equal(arrays[name][there], at_nodes[name][i], name);
    assert.equal(arrays.yarn[there], at_nodes.course[i], "a course is a yarn here");
    const away = minus(arrays.displacement_mm.slice(3 * there, 3 * there + 3), at_nodes.displacement_mm.slice(3 * i, 3 * i + 3));
    assert.ok(Math.hypot(...away) < 1e-12);
  });
  assert.deepEqual(strainOf(text), strainOf(frame));
});

test("Given a frame by its strain or none, then it is that one or the last.", () => {
  const last = exported(folder, "results/jersey", "vtp");
  const first = exported(folder, "results/jersey", "vtp", "--strain", 0);
  assert.deepEqual(strainOf(last.toString()), strainOf(lastFrame("jersey")));
  assert.deepEqual(strainOf(first.toString()), [0]);
  assert.deepEqual(exported(folder, "jersey.toml", "vtp"), exported(folder, "results/jersey", "vtp", "--frame", 0), "frame 0 is the fabric as knitted");
});

test("Given a broken yarn, then no line crosses the gap.", () => {
  const text = exported(folder, "results/broken", "vtp").toString();
  const nLines = (vtp) => Number(/NumberOfLines="(\d+)"/.exec(vtp)[1]);
  const n_lines = nLines(text);
  assert.ok(n_lines > 3);
  assert.equal(n_lines, nLines(lastFrame("broken")));
  assert.equal(csv("results/broken").length, n_lines);
});

test("Given a fabric, then the table has evenly spaced points of yarns as long as they are.", () => {
  const yarns = csv("jersey.toml");
  const arcs = vtkArray(exported(folder, "jersey.toml", "vtp").toString(), "PointData", "arc_length_mm");
  assert.equal(yarns.length, 3);
  for (const { radius, points } of yarns) {
    assert.equal(radius, 0.06);
    const steps = points.slice(1).map((point, i) => Math.hypot(...minus(point, points[i])));
    assert.ok(Math.max(...steps) < 1.1 * Math.min(...steps));
    assert.ok(Math.abs(lengthOf(points) - Math.max(...arcs)) < 2e-3 * lengthOf(points));
  }
});

test("Given a fabric, then BCC and .yarns have the points of the table.", () => {
  const yarns = csv("jersey.toml");
  const bcc = exported(folder, "jersey.toml", "bcc");
  assert.equal(bcc.toString("latin1", 0, 8), "BCC\x44C0\x03\x02");
  assert.equal(bcc.readBigUInt64LE(8), 3n);
  let place = 64;
  for (const { points } of yarns) {
    assert.equal(bcc.readInt32LE(place), points.length + 2, "one more at each end shapes it");
    place += 4 + 12;
    for (const point of points) {
      point.forEach((value, axis) => assert.equal(bcc.readFloatLE(place + 4 * axis), Math.fround(value)));
      place += 12;
    }
    place += 12;
  }
  assert.equal(place, bcc.length);
  const count = yarns.reduce((sum, { points }) => sum + points.length, 0);
  const curves = exported(folder, "jersey.toml", "yarns");
  assert.equal(curves.toString("latin1", 0, 4), "f3..");
  assert.equal(curves.readUInt32LE(4), 12 * count);
  yarns[0].points[0].forEach((value, axis) => assert.equal(curves.readFloatLE(8 + 4 * axis), Math.fround(value)));
});

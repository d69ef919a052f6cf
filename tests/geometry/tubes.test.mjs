// glTF, OBJ and STL in the glTF validator of Khronos and in the readers of three.js.
import assert from "node:assert/strict";
import { rmSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { checkout } from "../browser/harness.mjs";
import { boxOf, cross, dot, exported, lengthOf, makeFabrics, minus, yarnsOfCsv } from "./fabrics.mjs";

const modules = join(checkout, "web/node_modules");
const { validateBytes } = createRequire(join(checkout, "web/package.json"))("gltf-validator");
const loader = async (name) => new (await import(pathToFileURL(join(modules, `three/examples/jsm/loaders/${name}.js`))))[name]();

let folder;
before(() => (folder = makeFabrics()));
after(() => rmSync(folder, { recursive: true, force: true }));

/** The bytes alone, without the pool that Node keeps them in. */
const bufferOf = (bytes) => bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);

/** Triangles of a geometry of three.js: corners and normals [[a, b, c], ...], in the units of the scene. */
function trianglesOf(geometry, matrix) {
  const { position, normal } = geometry.attributes;
  const Vector = geometry.boundingSphere?.center.constructor ?? (geometry.computeBoundingSphere(), geometry.boundingSphere.center.constructor);
  const vertex = (i) => {
    const point = new Vector().fromBufferAttribute(position, i);
    if (matrix) point.applyMatrix4(matrix);
    return { point: point.toArray(), normal: new Vector().fromBufferAttribute(normal, i).toArray() };
  };
  const count = geometry.index?.count ?? position.count;
  const at = (i) => vertex(geometry.index ? geometry.index.getX(i) : i);
  return Array.from({ length: count / 3 }, (_, i) => [at(3 * i), at(3 * i + 1), at(3 * i + 2)]);
}

function meshesOf(root) {
  root.updateMatrixWorld(true);
  const meshes = [];
  root.traverse((object) => {
    if (object.isMesh) meshes.push({ name: object.name, triangles: trianglesOf(object.geometry, object.matrixWorld) });
  });
  return meshes;
}

async function readGltf(bytes) {
  const reader = await loader("GLTFLoader");
  const { scene } = await new Promise((resolve, reject) => reader.parse(bufferOf(bytes), "", resolve, reject));
  return meshesOf(scene);
}
const readObj = async (bytes) => meshesOf((await loader("OBJLoader")).parse(bytes.toString()));
const readStl = async (bytes) => trianglesOf((await loader("STLLoader")).parse(bufferOf(bytes)));

/** Every edge is passed once in each direction, by where its ends are. */
function expectClosed(triangles) {
  const edges = new Set();
  const key = ({ point }) => point.join();
  for (const corners of triangles) {
    corners.forEach((corner, i) => {
      const edge = `${key(corner)} ${key(corners[(i + 1) % 3])}`;
      assert.ok(!edges.has(edge), `twice: ${edge}`);
      edges.add(edge);
    });
  }
  for (const edge of edges) assert.ok(edges.has(edge.split(" ").reverse().join(" ")), `no way back: ${edge}`);
}

const volumeOf = (triangles) => triangles.reduce((sum, [a, b, c]) => sum + dot(a.point, cross(b.point, c.point)) / 6, 0);

function expectNormalsOutward(triangles) {
  for (const corners of triangles) {
    const [a, b, c] = corners.map(({ point }) => point);
    const face = cross(minus(b, a), minus(c, a));
    for (const { normal } of corners) assert.ok(dot(normal, face) > 0.8 * Math.hypot(...face) * Math.hypot(...normal));
  }
}

/** Volume of tubes of polygons about yarns [mm^3]. */
function expectedVolume(yarns, sides) {
  const area = (radius) => (sides / 2) * Math.sin((2 * Math.PI) / sides) * radius ** 2;
  return yarns.reduce((sum, { radius, points }) => sum + area(radius) * lengthOf(points), 0);
}

/** Tubes about yarns: as large and as wide as they are. unit: how long 1 mm is in the file. */
function expectTubes(triangles, yarns, unit = 1, sides = 12) {
  expectNormalsOutward(triangles);
  const volume = expectedVolume(yarns, sides) * unit ** 3;
  assert.ok(Math.abs(volumeOf(triangles) - volume) < 0.005 * volume, `${volumeOf(triangles)} is not ${volume}`);
  const line = boxOf(yarns.flatMap(({ points }) => points));
  const box = boxOf(triangles.flat().map(({ point }) => point));
  const { radius } = yarns[0];
  for (const axis of [1, 2]) {  // the yarns end along x, where there is nothing beyond the line
    assert.ok(Math.abs(line.highest[axis] + radius - box.highest[axis] / unit) < 0.1 * radius, `axis ${axis}`);
    assert.ok(Math.abs(line.lowest[axis] - radius - box.lowest[axis] / unit) < 0.1 * radius, `axis ${axis}`);
  }
  assert.ok(Math.abs(line.lowest[0] - box.lowest[0] / unit) < 0.1 * radius, "axis 0");
  assert.ok(Math.abs(line.highest[0] - box.highest[0] / unit) < 0.1 * radius, "axis 0");
}

const centrelines = (source, ...words) => yarnsOfCsv(exported(folder, source, "csv", ...words).toString());

for (const [what, source, words] of [
  ["a case", "jersey.toml", []],
  ["the last frame of a run", "results/jersey", []],
  ["a triangle for a circle", "jersey.toml", ["--sides", 3]],
  ["a yarn of two diameters", "joined.toml", []],
  ["broken yarns", "results/broken", []],
]) {
  test(`Given ${what}, then the glTF validator of Khronos has nothing to say.`, async () => {
    const { issues, info } = await validateBytes(new Uint8Array(exported(folder, source, "gltf", ...words)));
    assert.deepEqual(issues.messages, []);
    assert.ok(info.totalTriangleCount > 1000);
  });
}

test("Given a tube of more than 65 536 points, then its indices have 32 bits, and the validator agrees.", async () => {
  const bytes = exported(folder, "jersey.toml", "gltf", "--sides", 256);
  const { accessors } = JSON.parse(bytes.toString("utf8", 20, 20 + bytes.readUInt32LE(12)));
  const { issues, info } = await validateBytes(new Uint8Array(bytes));
  assert.deepEqual(issues.messages, []);
  assert.ok(info.totalVertexCount / 3 > 65536);
  assert.deepEqual(accessors.filter(({ type }) => type === "SCALAR").map(({ componentType }) => componentType), [5125, 5125, 5125]);
});

for (const [what, ...words] of [["as knitted", "jersey.toml"], ["in a frame of a run", "results/jersey", "--frame", 2]]) {
  test(`Given a fabric ${what}, then each reader finds the same closed tubes, in mm or in metres.`, async () => {
    const yarns = centrelines(...words);
    const [source, ...rest] = words;
    const gltf = await readGltf(exported(folder, source, "gltf", ...rest));
    const obj = await readObj(exported(folder, source, "obj", ...rest));
    const stl = await readStl(exported(folder, source, "stl", ...rest));
    assert.deepEqual(gltf.map(({ name }) => name), ["yarn_1", "yarn_2", "yarn_3"]);
    assert.deepEqual(obj.map(({ name }) => name), ["yarn_1", "yarn_2", "yarn_3"]);
    for (const { triangles } of [...gltf, ...obj]) expectClosed(triangles);
    expectClosed(stl);
    const all = (meshes) => meshes.flatMap(({ triangles }) => triangles);
    assert.equal(all(gltf).length, stl.length);
    assert.equal(all(obj).length, stl.length);
    expectTubes(all(gltf), yarns, 1e-3);
    expectTubes(all(obj), yarns);
    expectTubes(stl, yarns);
  });
}

test("Given sides, then the tubes have as many.", async () => {
  for (const sides of [3, 8, 40]) {
    const triangles = await readStl(exported(folder, "jersey.toml", "stl", "--sides", sides));
    const yarns = centrelines("jersey.toml");
    const volume = expectedVolume(yarns, sides);
    assert.ok(Math.abs(volumeOf(triangles) - volume) < 0.005 * volume, `${sides} sides`);
    assert.equal((triangles.length / yarns.length - 2 * (sides - 2)) % (2 * sides), 0, "rings of so many sides and two ends");
  }
});

test("Given a yarn of two diameters, then every part of it is closed and has its own.", async () => {
  const meshes = await readGltf(exported(folder, "joined.toml", "gltf"));
  assert.equal(meshes.length, 5, "three courses and two arcs");
  for (const { triangles } of meshes) expectClosed(triangles);
  const obj = await readObj(exported(folder, "joined.toml", "obj"));
  assert.deepEqual(obj.map(({ name }) => name), ["yarn_1"]);
});

test("Given yarns that have broken, then each piece is closed.", async () => {
  const pieces = centrelines("results/broken");
  assert.ok(pieces.length > 3, "a yarn is broken");
  const meshes = await readGltf(exported(folder, "results/broken", "gltf"));
  assert.equal(meshes.length, pieces.length);
  for (const { triangles } of meshes) expectClosed(triangles);
});

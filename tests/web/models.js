// Models other than OBJ: each format is drawn as the desktop draws it, byte for byte; a broken one is said, and harms nobody; a model
// that is dropped on the page is shown.
"use strict";

const { PATIENCE, check, drop, openPage, serve, waitError } = require("./browser.js");
const { openEmpty, runCommand } = require("./command.js");
const { execFileSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

/** A surface of waves: its corners, of numbers that no float has exactly, and its triangles. */
const RINGS = 12;
const corners = [], triangles = [];
for (let i = 0; i <= RINGS; i++) {
  for (let j = 0; j <= RINGS; j++) {
    corners.push([i / 7 - 0.9, Math.sin(i / 3) * Math.cos(j / 5) / 3, j / 7 - 0.9]);
    if (i < RINGS && j < RINGS) {
      const first = i * (RINGS + 1) + j, next = first + RINGS + 1;
      triangles.push([first, first + 1, next], [first + 1, next + 1, next]);
    }
  }
}

const ply = () => `ply\nformat ascii 1.0\nelement vertex ${corners.length}\nproperty float x\nproperty float y\nproperty float z\n` +
  `element face ${triangles.length}\nproperty list uchar int vertex_indices\nend_header\n` +
  corners.map((corner) => corner.join(" ")).concat(triangles.map((triangle) => `3 ${triangle.join(" ")}`)).join("\n") + "\n";
const stl = () => {
  const bytes = Buffer.alloc(84 + 50 * triangles.length);
  bytes.writeUInt32LE(triangles.length, 80);
  triangles.forEach((triangle, i) => triangle.forEach((corner, k) => corners[corner].forEach((number, axis) =>
    bytes.writeFloatLE(number, 84 + 50 * i + 12 + 12 * k + 4 * axis))));
  return bytes;
};
/** A node turns and moves the surface. */
const gltf = () => {
  const positions = Buffer.from(new Float32Array(corners.flat()).buffer), indices = Buffer.from(new Uint16Array(triangles.flat()).buffer);
  const of = (axis) => corners.map((corner) => Math.fround(corner[axis]));
  return JSON.stringify({ asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, translation: [0.1, 0.2, 0.3], rotation: [0, 0.6, 0, 0.8], scale: [1.1, 0.9, 1] }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [{ bufferView: 0, componentType: 5126, count: corners.length, type: "VEC3", min: [0, 1, 2].map((axis) => Math.min(...of(axis))),
      max: [0, 1, 2].map((axis) => Math.max(...of(axis))) }, { bufferView: 1, componentType: 5123, count: triangles.length * 3, type: "SCALAR" }],
    bufferViews: [{ buffer: 0, byteLength: positions.length }, { buffer: 0, byteOffset: positions.length, byteLength: indices.length }],
    buffers: [{ byteLength: positions.length + indices.length,
      uri: "data:application/octet-stream;base64," + Buffer.concat([positions, indices]).toString("base64") }] });
};
const MODELS = { "waves.ply": ply(), "waves.stl": stl(), "waves.gltf": gltf() };
const BROKEN = { "huge.ply": fs.readFileSync("tests/meshes/ply-hand-huge-count.ply"), "index.ply": fs.readFileSync("tests/meshes/ply-hand-index-out-of-range.ply"),
  "none.glb": "no glb at all", "none.gltf": "{}", "none.stl": "solid" };
const scene = (name) => `camera { position = {0, 2, 4}, look_at = {0, 0, 0} }\nlight { position = {2, 5, 3} }\nmesh { file = "${name}" }\n`;

/** Draws each model in the page and on the desktop. */
const compare = async (browser, url, program, folder) => {
  const page = await openEmpty(browser);
  const options = ["-s", "80x60", "--samples", "1", "--engine", "f64x1"];
  const reader = ["/dioptre/models.wasm", fs.readFileSync("build/web/models.wasm")];
  const draw = (name, bytes) => runCommand(page, url, program, ["render", "/scenes/model.lua", ...options, "-o", "/page.bmp"], "/page.bmp",
    [reader, [`/scenes/${name}`, Buffer.from(bytes)], ["/scenes/model.lua", Buffer.from(scene(name))]]);
  for (const [name, bytes] of Object.entries(MODELS)) {
    fs.writeFileSync(path.join(folder, name), bytes);
    fs.writeFileSync(path.join(folder, "model.lua"), scene(name));
    execFileSync(process.env.DIOPTRE, ["render", path.join(folder, "model.lua"), ...options, "-o", path.join(folder, "desktop.bmp")], { stdio: "ignore" });
    const drawn = await draw(name, bytes).catch((error) => ({ bytes: Buffer.from(error.message) }));
    check(drawn.bytes.equals(fs.readFileSync(path.join(folder, "desktop.bmp"))), `${name}: the picture of ${program} is the desktop's, byte for byte`);
  }
  for (const [name, bytes] of Object.entries(BROKEN)) {
    const said = await draw(name, bytes).then(() => "nothing", (error) => error.message);
    check(said.includes(`${name}: `), `a broken model is said: ${said.split("\n").find((line) => line.includes(name))}`);
  }
  await page.close();
};

/** Drops a model and a scene with it on the page. */
const testDrop = async (browser, url) => {
  const problems = [];
  const page = await openPage(browser, url, problems);
  await drop(page, [["dropped.lua", scene("waves.ply")], ["waves.ply", ply()]]);
  await page.waitForFunction(() => /1 mesh.*middle is: mesh/.test(document.getElementById("canvas").getAttribute("aria-label")), null, { timeout: PATIENCE });
  check(await page.textContent("#errors") === "", "a model that is dropped with its scene is shown");
  await drop(page, [["broken.lua", scene("none.glb")], ["none.glb", "no glb at all"]]);
  check(true, `a broken one is said: ${await waitError(page, /none\.glb/)}`);
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "dioptre-web-"));
  await compare(browser, url, "dioptre.js", folder);
  await compare(browser, url, "dioptre-single.js", folder);
  await testDrop(browser, `${url}index.html`);
  await testDrop(browser, `${url}index.html?one-thread`);
  fs.rmSync(folder, { recursive: true });
  server.close();
};

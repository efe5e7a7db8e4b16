// What the window shows, in the page as on the desktop: a lesson without hands chooses each layer, changes settings, moves camera and
// light and an object, and its pictures are the desktop's, byte for byte, with threads and with one.
"use strict";

const { check, serve } = require("./browser.js");
const { openEmpty, runCommand } = require("./command.js");
const { execFileSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

/** What is pressed before each picture. The layer of the time is another each time. */
const STEPS = {
  "the light": "",
  "normals": 'press "layer normals"',
  "the distance": 'press "layer distance"',
  "shapes": 'press "layer shapes"',
  "places on pictures": 'press "layer places"',
  "numbers of rays": 'press "layer rays"',
  "steps of marching": 'press "layer steps"',
  "operations of marching": 'press "layer operations"',
  "the error, against quad": 'press "layer error"',
  "acne and leaks, against double": 'press "layer acne"',
  "shadow rays without an offset": 'press "layer light" press "offset"',
  "an offset that is fixed, of twice the size": 'press "offset" press "epsilon twice"',
  "the next engine": 'press "engine"',
  "less depth": 'press "as at first" press "less deep" press "less deep"',
  "more samples": 'press "as at first" press "samples twice"',
  "the formulas of a report": 'press "as at first" press "methods"',
  "other lights": 'press "as at first" press "light mode"',
  "a light that was moved": 'press "as at first" hold("light left", 0.5)',
  "a camera that was moved": 'hold("camera up", 0.3) turn(5, -3) zoom(2)',
  "a sphere of another size": 'set("sphere", 1, "radius", 0.8)',
  "the other of two pictures": 'press "split" press "other side" press "layer normals"',
};
const SCENES = ["glass-sphere", "twins", "figure-19"];
const SIZE = "{80, 60}";
const PROGRAMS = ["dioptre.js", "dioptre-single.js"];
/** Where the pixels of a BMP file begin. */
const BMP_HEADER = 54;

const compareScene = async (page, url, scene, folder) => {
  const names = Object.keys(STEPS), lesson = path.join(folder, `${scene}-shown.lua`);
  const text = (where) => `lesson { scene = "${where}/${scene}.lua", size = ${SIZE}, samples = 2 }\n` +
    Object.values(STEPS).map((step) => `${step} snapshot()\n`).join("");
  const shot = (i) => `${scene}-shown-${String(i + 1).padStart(4, "0")}.bmp`;
  fs.writeFileSync(lesson, text(path.resolve("scenes")));
  execFileSync(process.env.DIOPTRE, ["view", "--lesson", lesson, "--lesson-snapshots", folder],
    { stdio: "ignore", env: { ...process.env, SDL_VIDEODRIVER: "dummy" } });
  for (const program of PROGRAMS) {
    const drawn = await runCommand(page, url, program, ["view", "--lesson", `/${scene}-shown.lua`, "--lesson-snapshots", "/shots"],
      names.map((name, i) => `/shots/${shot(i)}`), [[`/${scene}-shown.lua`, Buffer.from(text("/scenes"))]]);
    const others = names.filter((name, i) => !drawn.all[i].equals(fs.readFileSync(path.join(folder, shot(i)))));
    check(others.length === 0, `${scene}, ${program}: ${names.length - others.length} of ${names.length} pictures are the desktop's${
      others.map((name) => "\n      not: " + name).join("")}`);
    const different = new Set(drawn.all.map((bytes) => bytes.toString("base64"))).size;
    check(different > names.length / 2, `${different} of them are different`);
  }
};

/** WebAssembly rounds to nearest only: the layer of rounding shows the picture in grey, as nothing is measured, and not that nothing
 * hangs on the last bits, which would be black. */
const testRounding = async (page, url) => {
  const lesson = Buffer.from(`lesson { scene = "/scenes/figure-19.lua", size = ${SIZE} } press "layer rounding" snapshot()`);
  for (const program of PROGRAMS) {
    const { bytes } = await runCommand(page, url, program, ["view", "--lesson", "/rounding.lua", "--lesson-snapshots", "/shots"],
      "/shots/rounding-0001.bmp", [["/rounding.lua", lesson]]);
    const pixels = bytes.subarray(BMP_HEADER), isGrey = pixels.every((byte, i) => byte === pixels[i - i % 3]);
    check(isGrey && new Set(pixels).size > 20, `${program}: the layer of rounding is grey: ${new Set(pixels).size} greys`);
  }
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "dioptre-web-"));
  const page = await openEmpty(browser);
  for (const scene of SCENES) {
    await compareScene(page, url, scene, folder);
  }
  await testRounding(page, url);
  await page.close();
  fs.rmSync(folder, { recursive: true });
  server.close();
};

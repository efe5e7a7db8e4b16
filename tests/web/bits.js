// All scenes at 80x60 in each engine: the page's bytes are the desktop's.
"use strict";

const { check, serve } = require("./browser.js");
const { openEmpty, runCommand } = require("./command.js");
const { execFileSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

/** Engines whose pictures are compared; f32x8 is the page's default. */
const ENGINES = ["f32x1", "f64x1", "f32x4", "f64x4", "f32x8"];
/** All of the page. */
const ALL_ENGINES = [...ENGINES, "f128x1"];

/** The scene of tests/test_thread_stack.c: each ray goes as deep as it may. WebAssembly does not notice a stack that is too small: it
 * overwrites what lies beside it. */
const DEEP = /SCENE\[\] =\n([^;]*);\n/.exec(fs.readFileSync("tests/test_thread_stack.c", "utf8"))[1].split("\n").map((line) => JSON.parse(line.trim())).join("");

/** Compares the pictures of a build of the page. @param program Its script. */
const compare = async (browser, url, program, engines) => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "dioptre-web-"));
  const page = await openEmpty(browser);
  const names = process.env.SCENES ? process.env.SCENES.split(" ") : fs.readdirSync("scenes").filter((name) => name.endsWith(".lua"));
  let equal = 0;
  for (const name of names) {
    for (const engine of engines) {
      const options = ["-s", "80x60", "--samples", "1", "--engine", engine];
      const file = path.join(folder, "desktop.bmp");
      execFileSync(process.env.DIOPTRE, ["render", `scenes/${name}`, ...options, "-o", file], { stdio: "ignore" });
      const drawn = await runCommand(page, url, program, ["render", `/scenes/${name}`, ...options, "-o", "/page.bmp"], "/page.bmp")
        .catch((error) => { console.log(error.message.split("\n").slice(0, 3).join(" ")); return { bytes: Buffer.alloc(0) }; });
      if (drawn.bytes.equals(fs.readFileSync(file))) {
        equal++;
      } else {
        check(false, `${name} in ${engine}: the picture of ${program} is the desktop's`);
      }
    }
  }
  check(equal === names.length * engines.length,
    `${equal} of ${names.length * engines.length} pictures of ${program} are the desktop's, byte for byte`);
  fs.rmSync(folder, { recursive: true });
  await page.close();
};

/** Rays of the largest depth, in each engine and build. */
const compareDeep = async (browser, url) => {
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), "dioptre-web-")), scene = path.join(folder, "deep.lua"), file = path.join(folder, "desktop.bmp");
  const page = await openEmpty(browser);
  fs.writeFileSync(scene, DEEP);
  for (const engine of ALL_ENGINES) {
    const options = ["-s", "16x16", "--samples", "1", "--depth", "256", "--cutoff", "0", "--engine", engine];
    execFileSync(process.env.DIOPTRE, ["render", scene, ...options, "-o", file], { stdio: "ignore" });
    for (const program of ["dioptre.js", "dioptre-single.js"]) {
      const drawn = await runCommand(page, url, program, ["render", "/deep.lua", ...options, "-o", "/page.bmp"], "/page.bmp", [["/deep.lua", Buffer.from(DEEP)]])
        .catch((error) => { console.log(error.message.split("\n").slice(0, 3).join(" ")); return { bytes: Buffer.alloc(0) }; });
      check(drawn.bytes.equals(fs.readFileSync(file)), `depth 256 in ${engine}: the picture of ${program} is the desktop's`);
    }
  }
  fs.rmSync(folder, { recursive: true });
  await page.close();
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  const engines = process.env.ENGINES ? process.env.ENGINES.split(" ") : ENGINES;
  await compareDeep(browser, url);
  await compare(browser, url, "dioptre.js", engines);
  await compare(browser, url, "dioptre-single.js", engines.slice(-1));
  server.close();
};

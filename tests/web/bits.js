// All scenes at 80x60 in each engine: the page's bytes are the desktop's.
"use strict";

const { check, serve } = require("./browser.js");
const { openEmpty, runCommand } = require("./command.js");
const { execFileSync } = require("child_process");
const fs = require("fs");
const os = require("os");
const path = require("path");

/** Engines whose pictures are compared; f32x8 is the page's default. */
const ENGINES = ["f32x1", "f64x1", "f32x4", "f32x8"];

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

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  const engines = process.env.ENGINES ? process.env.ENGINES.split(" ") : ENGINES;
  await compare(browser, url, "dioptre.js", engines);
  await compare(browser, url, "dioptre-single.js", engines.slice(-1));
  server.close();
};

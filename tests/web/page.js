// Tests build/web in real browsers: tests/web/page.js [PART...]; see `make test-web` and tests/web/browser.js.
"use strict";

const { launch, result } = require("./browser.js");
const windows = require("./window.js");

const PARTS = {
  window: windows.window,
  host: windows.host,
  single: windows.single,
  layers: require("./layers.js"),
  links: require("./links.js"),
  editor: require("./editor.js"),
  lesson: require("./lesson.js"),
  panel: require("./panel.js"),
  models: require("./models.js"),
  layout: require("./layout.js"),
  access: require("./access.js"),
  firefox: require("./firefox.js"),
  hostile: require("./hostile.js"),
  keys: require("./keys.js"),
  bits: require("./bits.js"),
};
/** Parts that run only when they are named: `speed` is no test. */
const NAMED_ONLY = { speed: require("./speed.js") };

(async () => {
  const asked = process.argv.slice(2);
  const browser = await launch();
  for (const name of asked.length > 0 ? asked : Object.keys(PARTS)) {
    console.log(`${name}:`);
    await (PARTS[name] || NAMED_ONLY[name])(browser);
  }
  await browser.close();
  process.exitCode = result.failures > 0 ? 1 : 0;
})();

// The page in Firefox, with threads and without: it draws the same pixels as Chromium, its keys work, an error is shown at its line.
"use strict";

const { check, launchFirefox, openInFirefox, openPage, pause, serve, settled, until } = require("./browser.js");

const SIZE = { width: 1000, height: 700 };

const testFirefox = async (firefox, url, mode, expected) => {
  const problems = [];
  const page = await openInFirefox(firefox, url, problems, SIZE);
  const said = await page.$eval("#mode", (element) => element.textContent);
  check(said.includes(mode), `Firefox says how it runs: ${said}`);
  const picture = await settled(page);
  check(picture === expected, "Firefox shows Chromium's pixels");
  await page.focus("#canvas");
  await page.keyboard.down("ArrowLeft");
  await pause(700);
  await page.keyboard.up("ArrowLeft");
  check(await settled(page) !== picture, "an arrow key moves the light");
  await page.evaluate(() => dioptre.editor.replace(dioptre.editor.text().replace("camera", "camra")));
  await until(page, () => /:\d+: /.test(document.getElementById("errors").textContent));
  check(true, "a mistake is said with its line");
  check(problems.length === 0, `no script fails${problems.map((problem) => ": " + problem)}`);
  await page.close();
};

module.exports = async (chromium) => {
  const { server, url } = await serve(true);
  // The bar on the picture has the same text at the same place: letters are the program's own.
  const reference = await openPage(chromium, `${url}index.html`, [], { viewport: SIZE });
  const expected = await settled(reference);
  await reference.context().close();
  const firefox = await launchFirefox("en-US");
  await testFirefox(firefox, `${url}index.html`, "threads", expected);
  await testFirefox(firefox, `${url}index.html?one-thread`, "one thread", expected);
  await testFirefox(firefox, `file://${process.cwd()}/build/web/dioptre.html`, "one thread", expected);
  await firefox.close();
  server.close();
};

// The panel of commands: each gives its table or picture; a command can be stopped.
"use strict";

const { PATIENCE, check, openPage, serve } = require("./browser.js");
const { execFileSync } = require("child_process");

const run = async (page, line) => {
  await page.fill("#line", line);
  await page.click("#run");
  await page.waitForFunction(() => !/^$|running/.test(document.getElementById("status").textContent), null, { timeout: 2 * PATIENCE });
  return { status: await page.textContent("#status"), text: await page.textContent("#output"),
    made: await page.locator("#made button").allTextContents() };
};

module.exports = async (browser) => {
  const { server, url } = await serve(true);
  const problems = [];
  const page = await openPage(browser, `${url}index.html`, problems);
  await page.click("#commands");
  const info = await run(page, "info SCENE");
  const desktop = execFileSync(process.env.DIOPTRE, ["info", "scenes/box.lua", "--engine", "f32x8"], { encoding: "utf8", env: { ...process.env, LANGUAGE: "en" } });
  check(info.status === "done" && info.text.split("\n")[0].replace("/scenes/", "scenes/") === desktop.split("\n")[0],
    `info: ${info.text.split("\n")[0]}`);
  const expectations = {
    "render SCENE -s 80x60 --samples 1 -o picture.png": /^picture\.png$/,
    "probe SCENE 40 30 -s 80x60 --svg rays.svg": /^rays\.svg$/,
    "needs SCENE -s 40x30": /^$/,
    "chart SCENE -s 20x15 --samples 1 --out charts": /charts\/.*\.csv/,
    "lab sphere-ground --out results": /results\/.*\.csv/,
  };
  for (const [line, made] of Object.entries(expectations)) {
    const result = await run(page, line);
    check(result.status === "done" && made.test(result.made.join(" ")), `${line}: ${result.status}, ${result.text.split("\n").length} lines, ${result.made}`);
  }
  await run(page, "lab sphere-ground --out results");
  check(await page.locator("#made svg").count() === 2 && await page.locator("#made svg polyline").count() > 6, "lab: the page draws a chart for each number type");
  await run(page, "chart SCENE -s 20x15 --samples 1 --out charts");
  check(await page.locator("#made svg circle").count() > 20, "chart: the page draws its table");
  const wrong = await run(page, "render SCENE --nonsense");
  check(/^ended with/.test(wrong.status) && wrong.text.includes("nonsense"), `a mistake is said: ${wrong.text.trim().split("\n")[0]}`);
  await page.fill("#line", "render SCENE -s 4000x3000 --samples 4096 -o x.bmp");
  await page.click("#run");
  await page.waitForTimeout(1500);
  await page.click("#run");
  await page.waitForFunction(() => /ended/.test(document.getElementById("status").textContent), null, { timeout: PATIENCE });
  check(true, "a command can be stopped");
  check(problems.length === 0, `the console is silent${problems.map((problem) => ": " + problem)}`);
  await page.context().close();
  server.close();
};

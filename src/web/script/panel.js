// The panel of commands: what `dioptre render`, `info`, `needs`, `probe`, `lab` and `chart` say of the scene, with their pictures.
import { drawCharts } from "./chart.js";
import { runCommand, splitWords } from "./commands.js";
import { isFrench, say } from "./words.js";

/** Command lines to begin with; SCENE is the scene of the window. */
const EXAMPLES = {
  info: "info SCENE",
  render: "render SCENE -s 400x300 --samples 4 -o picture.png",
  probe: "probe SCENE 200 150 -s 400x300 --svg rays.svg",
  needs: "needs SCENE -s 160x120",
  chart: "chart SCENE -s 80x60 --samples 1 --out charts",
  lab: "lab sphere-ground --out results",
};
const IMAGES = { png: "image/png", bmp: "image/bmp", svg: "image/svg+xml", jpg: "image/jpeg" };
const $ = (id) => document.getElementById(id);

/** Shows a file that a command has made: a picture as such, all as downloads. */
const showFile = (name, bytes, offerDownload) => {
  const type = IMAGES[name.split(".").pop()];
  if (type) {
    const picture = document.createElement("img");
    picture.src = URL.createObjectURL(new Blob([bytes], { type }));
    picture.alt = name;
    $("made").append(picture);
  }
  if (name.endsWith(".csv")) {
    $("made").append(...drawCharts(name, bytes));
  }
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = name;
  button.addEventListener("click", () => offerDownload(name.split("/").pop(), bytes));
  $("made").append(button);
};

/** @param page { scene, files, later, offerDownload }: of start.js. */
export const createPanel = (page) => {
  let running = null;
  const setRunning = (command) => {
    running = command;
    $("run").textContent = say(command ? "Stop" : "Run");
  };
  const run = async () => {
    if (running) {
      running.stop();
      return;
    }
    $("made").replaceChildren();
    $("output").textContent = "";
    $("status").textContent = say("running …");
    let isStopped = false;
    setRunning({ stop: () => { isStopped = true; } });
    await page.later().catch(() => {}); // A command that needs a missing file says so.
    if (isStopped) {
      setRunning(null);
      $("status").textContent = say("ended with %d").replace("%d", 130);
      return;
    }
    const scene = page.scene();
    const words = splitWords($("line").value.replace(/^dioptre\s+/, "")).map((word) => word === "SCENE" ? scene : word);
    let isOnlyUncharted = false;
    const command = runCommand(words, page.files(), isFrench ? "fr" : "en", (line, kind) => {
      isOnlyUncharted = kind === "err" ? /gnuplot/.test(line) : isOnlyUncharted;
      if (isOnlyUncharted && kind === "err") {
        line = say("The tables are written. A page has no gnuplot: it draws their charts itself.");
      }
      // A line that replaces itself shows its last state.
      $("output").textContent += line.split("\r").pop().replace(/\x1b\[K/g, "") + "\n";
    });
    setRunning(command);
    const { status, made, reason } = await command.done;
    setRunning(null);
    $("status").textContent = status === 0 || (status === 1 && isOnlyUncharted) ? say("done") : say("ended with %d").replace("%d", status) + (reason ? ": " + reason : "");
    made.forEach(([name, bytes]) => showFile(name, bytes, page.offerDownload));
  };
  for (const [name, line] of Object.entries(EXAMPLES)) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = name;
    button.addEventListener("click", () => { $("line").value = line; $("line").focus(); });
    $("examples").append(button);
  }
  $("line").value = EXAMPLES.info;
  $("command").addEventListener("submit", (event) => { event.preventDefault(); run(); });
};

// Charts of the tables that `dioptre chart` writes: seconds of the processor for a megapixel against the
// error of all together, as in the right half of what gnuplot draws on a desktop.
import { say } from "./words.js";

const WIDTH = 560, HEIGHT = 380, LEFT = 70, RIGHT = 150, TOP = 30, BOTTOM = 45;
/** Colours that the colour-blind tell apart (Okabe and Ito). */
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];

const SVG = "http://www.w3.org/2000/svg";
const add = (parent, name, attributes, text) => {
  const element = parent.appendChild(document.createElementNS(SVG, name));
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
  element.textContent = text ?? "";
  return element;
};

/** The rows of a table of CSV, as objects; lines of # and text in quotes without commas. */
const readTable = (text) => {
  const [head, ...rows] = text.split("\n").filter((line) => line && !line.startsWith("#")).map((line) => line.replaceAll('"', "").split(","));
  return rows.map((row) => Object.fromEntries(head.map((name, i) => [name, row[i]])));
};

/** A logarithmic scale between the powers of ten around the values. */
const scale = (values, from, to) => {
  const low = Math.floor(Math.log10(Math.min(...values))), high = Math.max(low + 1, Math.ceil(Math.log10(Math.max(...values))));
  return { at: (value) => from + (to - from) * (Math.log10(value) - low) / (high - low),
    ticks: Array.from({ length: high - low + 1 }, (_, i) => 10 ** (low + i)) };
};

/** @return A chart of a table of `dioptre chart`; null: it is another table. */
export const drawChart = (name, bytes) => {
  const rows = readTable(new TextDecoder().decode(bytes)).filter((row) => row.seconds > 0 && row.total_rms > 0);
  if (rows.length === 0) {
    return null;
  }
  const x = scale(rows.map((row) => Number(row.seconds)), LEFT, WIDTH - RIGHT), y = scale(rows.map((row) => Number(row.total_rms)), HEIGHT - BOTTOM, TOP);
  const chart = document.createElementNS(SVG, "svg");
  chart.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  chart.setAttribute("role", "img");
  chart.setAttribute("aria-label", name);
  add(chart, "rect", { width: WIDTH, height: HEIGHT, fill: "#fff" });
  const text = { "font-family": "sans-serif", "font-size": 12, fill: "#000" };
  add(chart, "text", { ...text, x: LEFT, y: 18 }, name);
  for (const tick of x.ticks) {
    add(chart, "line", { x1: x.at(tick), x2: x.at(tick), y1: TOP, y2: HEIGHT - BOTTOM, stroke: "#ddd" });
    add(chart, "text", { ...text, x: x.at(tick), y: HEIGHT - BOTTOM + 16, "text-anchor": "middle" }, tick);
  }
  for (const tick of y.ticks) {
    add(chart, "line", { x1: LEFT, x2: WIDTH - RIGHT, y1: y.at(tick), y2: y.at(tick), stroke: "#ddd" });
    add(chart, "text", { ...text, x: LEFT - 6, y: y.at(tick) + 4, "text-anchor": "end" }, tick.toExponential(0));
  }
  add(chart, "text", { ...text, x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 8, "text-anchor": "middle" }, say("CPU seconds a megapixel"));
  add(chart, "text", { ...text, x: 14, y: HEIGHT / 2, transform: `rotate(-90 14 ${HEIGHT / 2})`, "text-anchor": "middle" }, say("error, rms of linear light"));
  [...new Set(rows.map((row) => row.group))].filter((group) => group !== "front").forEach((group, i) => {
    const fill = COLOURS[i % COLOURS.length];
    add(chart, "circle", { cx: WIDTH - RIGHT + 14, cy: TOP + 10 + 18 * i, r: 4, fill });
    add(chart, "text", { ...text, x: WIDTH - RIGHT + 24, y: TOP + 14 + 18 * i }, group);
    for (const row of rows.filter((each) => each.group === group)) {
      const point = add(chart, "circle", { cx: x.at(row.seconds), cy: y.at(row.total_rms), r: 4, fill });
      add(point, "title", {}, `${row.series} ${row.setting}: ${Number(row.seconds).toPrecision(3)} s, ${Number(row.total_rms).toPrecision(3)}`);
    }
  });
  return chart;
};

// Charts of the tables that commands write, as gnuplot draws them on a desktop: of `dioptre chart`, seconds of the processor for a megapixel
// against the error of all together; of `dioptre lab`, the largest error of each method against the stress, for each number type; of
// `dioptre chart --kernels`, against nanoseconds.
import { say } from "./words.js";

const WIDTH = 560, HEIGHT = 380, LEFT = 70, RIGHT = 150, TOP = 30, BOTTOM = 45;
/** Colours that the colour-blind tell apart (Okabe and Ito). */
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];
/** Of lines of the same colour. */
const DASHES = ["none", "6 3", "2 3"];
/** Most ticks of an axis. */
const TICKS_MAXIMUM = 7;
/** What is drawn of a table of the laboratory: the first of its columns that has numbers above 0. */
const LAB_COLUMNS = ["error_max", "wrong", "false_misses", "false_hits", "leaks", "double_hits", "nan", "work"];
/** The reference of the others. */
const LAB_REFERENCE = "quad";

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
  const step = Math.ceil((high - low + 1) / TICKS_MAXIMUM);
  return { at: (value) => from + (to - from) * (Math.log10(value) - low) / (high - low),
    ticks: Array.from({ length: Math.floor((high - low) / step) + 1 }, (_, i) => 10 ** (low + step * i)) };
};

const TEXT = { "font-family": "sans-serif", "font-size": 12, fill: "#000" };
/** @return What is written at a tick: powers of ten that are no short number. */
const tickText = (tick) => tick >= 0.01 && tick < 1e5 ? String(Number(tick.toPrecision(3))) : tick.toExponential(0);

/** @return { chart, x, y, addKey }: a chart with its axes, its scales, a function for its legend: (number, words, dashes of a line). */
const createChart = (title, xWords, yWords, xValues, yValues) => {
  const x = scale(xValues, LEFT, WIDTH - RIGHT), y = scale(yValues, HEIGHT - BOTTOM, TOP);
  const chart = document.createElementNS(SVG, "svg");
  chart.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  chart.setAttribute("role", "img");
  chart.setAttribute("aria-label", title);
  add(chart, "rect", { width: WIDTH, height: HEIGHT, fill: "#fff" });
  add(chart, "text", { ...TEXT, x: LEFT, y: 18 }, title);
  for (const tick of x.ticks) {
    add(chart, "line", { x1: x.at(tick), x2: x.at(tick), y1: TOP, y2: HEIGHT - BOTTOM, stroke: "#ddd" });
    add(chart, "text", { ...TEXT, x: x.at(tick), y: HEIGHT - BOTTOM + 16, "text-anchor": "middle" }, tickText(tick));
  }
  for (const tick of y.ticks) {
    add(chart, "line", { x1: LEFT, x2: WIDTH - RIGHT, y1: y.at(tick), y2: y.at(tick), stroke: "#ddd" });
    add(chart, "text", { ...TEXT, x: LEFT - 6, y: y.at(tick) + 4, "text-anchor": "end" }, tick.toExponential(0));
  }
  add(chart, "text", { ...TEXT, x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 8, "text-anchor": "middle" }, xWords);
  add(chart, "text", { ...TEXT, x: 14, y: HEIGHT / 2, transform: `rotate(-90 14 ${HEIGHT / 2})`, "text-anchor": "middle" }, yWords);
  const addKey = (i, words, dashes) => {
    const fill = COLOURS[i % COLOURS.length], middle = TOP + 10 + 18 * i;
    dashes && add(chart, "line", { x1: WIDTH - RIGHT + 4, x2: WIDTH - RIGHT + 22, y1: middle, y2: middle, stroke: fill, "stroke-dasharray": dashes });
    add(chart, "circle", { cx: WIDTH - RIGHT + 13, cy: middle, r: 4, fill });
    add(chart, "text", { ...TEXT, x: WIDTH - RIGHT + 24, y: TOP + 14 + 18 * i }, words);
  };
  return { chart, x, y, addKey };
};

const distinct = (rows, column) => [...new Set(rows.map((row) => row[column]))];

/** @return The chart of a table of `dioptre chart`. */
const drawSettings = (name, rows) => {
  const { chart, x, y, addKey } = createChart(name, say("CPU seconds a megapixel"), say("error, rms of linear light"),
    rows.map((row) => Number(row.seconds)), rows.map((row) => Number(row.total_rms)));
  distinct(rows, "group").filter((group) => group !== "front").forEach((group, i) => {
    addKey(i, group);
    for (const row of rows.filter((each) => each.group === group)) {
      const point = add(chart, "circle", { cx: x.at(row.seconds), cy: y.at(row.total_rms), r: 4, fill: COLOURS[i % COLOURS.length] });
      add(point, "title", {}, `${row.series} ${row.setting}: ${Number(row.seconds).toPrecision(3)} s, ${Number(row.total_rms).toPrecision(3)}`);
    }
  });
  return chart;
};

/** @return The chart of a number type in a table of `dioptre lab`. @param words { stress, error }: what the axes are. */
const drawMethods = (name, rows, column, words) => {
  const { chart, x, y, addKey } = createChart(name, words.stress, words.error, rows.map((row) => Number(row.stress)), rows.map((row) => Number(row[column])));
  distinct(rows, "method").forEach((method, i) => {
    const points = rows.filter((row) => row.method === method), stroke = COLOURS[i % COLOURS.length];
    const dashes = DASHES[Math.floor(i / COLOURS.length) % DASHES.length];
    addKey(i, method, dashes);
    add(chart, "polyline", { points: points.map((row) => `${x.at(row.stress)},${y.at(row[column])}`).join(" "), fill: "none", stroke,
      "stroke-width": 1.5, "stroke-dasharray": dashes });
    for (const row of points) {
      const point = add(chart, "circle", { cx: x.at(row.stress), cy: y.at(row[column]), r: 3, fill: stroke });
      add(point, "title", {}, `${method}, ${row.stress}: ${Number(row[column]).toPrecision(3)}`);
    }
  });
  return chart;
};

/** @return Charts of a table of `dioptre lab`, whose first line says what stress and error are. */
const drawLab = (name, text, rows) => {
  const column = LAB_COLUMNS.find((each) => rows.some((row) => row[each] > 0));
  const hasTimes = rows.some((row) => row.ns > 0); // Of `chart --kernels`, at one stress.
  const drawn = rows.filter((row) => row[column] > 0 && row.stress > 0 && row.type !== LAB_REFERENCE)
    .map((row) => hasTimes ? { ...row, stress: row.ns } : row);
  const [, stress, error] = /; stress: (.*); error: (.*)/.exec(text.split("\n")[0]) ?? [, "stress", "error"];
  const words = { stress: hasTimes ? "ns" : stress, error: column === "error_max" ? `${error}: ${say("largest")}` : column };
  return distinct(drawn, "type").map((type) => drawMethods(`${name}: ${type}`, drawn.filter((row) => row.type === type), column, words));
};

/** @return The charts of a table; none: it is another table. */
export const drawCharts = (name, bytes) => {
  const text = new TextDecoder().decode(bytes), rows = readTable(text);
  const settings = rows.filter((row) => row.seconds > 0 && row.total_rms > 0);
  if (settings.length > 0) {
    return [drawSettings(name, settings)];
  }
  return rows.some((row) => row.stress && row.method) ? drawLab(name, text, rows) : [];
};

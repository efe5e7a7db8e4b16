// Puts the page into one file, which opens by double click: node one-file.mjs FOLDER FILE; see `make web`. What the page would
// fetch is packed behind its script: compressed, in base64. The policy of the page names the hash of its only script.
import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

const [folder, output] = process.argv.slice(2);
const read = (name) => readFileSync(join(folder, name));
const { later } = JSON.parse(read("files.json"));
const names = ["files.json", "editor.js", "dioptre-single.js", "dioptre-single.wasm", "dioptre.data", "models.wasm", ...later.map((name) => "scenes/" + name)];
const contents = names.map(read);
const index = Buffer.from(JSON.stringify(names.map((name, i) => [name, contents[i].length])));
const size = Buffer.alloc(4);
size.writeUInt32LE(index.length);
const pack = gzipSync(Buffer.concat([size, index, ...contents]), { level: 9 }).toString("base64");

const script = read("page.js").toString().replaceAll("</script", "<\\/script");
const style = read("style.css").toString();
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const icon = "data:image/svg+xml;base64," + read("icon.svg").toString("base64");
const page = read("index.html").toString()
  .replace("script-src 'self' blob:", `script-src ${hash(script)} blob:`)
  .replace("style-src 'self'", `style-src ${hash(style)}`)
  .replace("worker-src 'self' blob:", "worker-src blob:").replace("connect-src 'self' blob: data:", "connect-src blob: data:")
  .replace('<link rel="stylesheet" href="style.css">', () => `<style>${style}</style>`)
  .replace('href="icon.svg"', `href="${icon}"`)
  .replace('<script src="page.js"></script>',
    () => `<script type="application/octet-stream" id="pack">${pack}</script>\n<script>${script}</script>`);
writeFileSync(output, page);

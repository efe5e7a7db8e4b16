// The files of the page: fetched, or out of the page itself when it is one file (src/web/script/one-file.mjs).

/** The pack of a page that is one file; null: it is a folder. */
const element = document.getElementById("pack");
export const isOneFile = element !== null;

const readPack = async () => {
  const response = await fetch("data:application/octet-stream;base64," + element.textContent.trim())
    .catch(() => null);
  const bytes = response ? await response.blob() : new Blob([Uint8Array.from(atob(element.textContent.trim()), (c) => c.charCodeAt(0))]);
  const unpacked = await new Response(bytes.stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
  const size = new DataView(unpacked).getUint32(0, true);
  const index = JSON.parse(new TextDecoder().decode(new Uint8Array(unpacked, 4, size)));
  const files = new Map();
  let offset = 4 + size;
  for (const [name, length] of index) {
    files.set(name, new Uint8Array(unpacked, offset, length));
    offset += length;
  }
  element.remove();
  return files;
};
const packed = isOneFile ? readPack() : null;

/** @return The bytes of a file of the page; it throws an Error if there is none. */
export const readFile = async (name) => {
  if (isOneFile) {
    const bytes = (await packed).get(name);
    if (!bytes) {
      throw new Error(name);
    }
    return bytes;
  }
  const response = await fetch(name);
  if (!response.ok) {
    throw new Error(name);
  }
  return new Uint8Array(await response.arrayBuffer());
};

/** @return The address of a script of the page. */
export const scriptUrl = async (name) => isOneFile
  ? URL.createObjectURL(new Blob([await readFile(name)], { type: "text/javascript" })) : new URL(name, document.baseURI).href;

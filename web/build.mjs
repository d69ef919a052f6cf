// Makes the page: checks no types (npm run check does), bundles src/main.tsx with all it needs and writes the files that the
// program serves, packed with gzip, as C++ source.
//   node build.mjs FOLDER     FOLDER/site: the files as they are; FOLDER/page_files.cpp: the source
import { build } from "esbuild";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = fileURLToPath(new URL(".", import.meta.url));
const folder = process.argv[2];
if (folder === undefined) {
  console.error("node build.mjs FOLDER");
  process.exit(2);
}
const site = join(folder, "site");

const types = {
  "index.html": "text/html; charset=utf-8",
  "page.js": "text/javascript; charset=utf-8",
  "page.css": "text/css; charset=utf-8",
  "icon.svg": "image/svg+xml",
};

function source() {
  const entries = Object.entries(types).map(([name, type]) => {
    const bytes = gzipSync(readFileSync(join(site, name)), { level: 9 });
    const numbers = Array.from(bytes).join(",").replace(/(.{1,118}),/g, "$1,\n");
    return { name, type, numbers, variable: `k_${name.replace(/\W/g, "_")}` };
  });
  return `#include "serve/page_files.h"

namespace knitmech::serve {
namespace {

${entries.map((e) => `const unsigned char ${e.variable}[] = {\n${e.numbers}};`).join("\n\n")}

}  // namespace

const std::vector<PageFile>& page_files() {
  static const std::vector<PageFile> files{
${entries.map((e) => `      {"${e.name}", "${e.type}", ${e.variable}},`).join("\n")}
  };
  return files;
}

}  // namespace knitmech::serve
`;
}

const options = {
  entryPoints: { page: join(here, "src/main.tsx") },
  outdir: site,
  bundle: true,
  minify: true,
  format: "esm",
  target: ["chrome110", "firefox115"],
  jsx: "automatic",
  jsxImportSource: "preact",
  legalComments: "eof",
  logLevel: "warning",
};

mkdirSync(site, { recursive: true });
await build(options);
for (const name of ["index.html", "icon.svg"]) copyFileSync(join(here, name), join(site, name));
writeFileSync(join(folder, "page_files.cpp"), source());

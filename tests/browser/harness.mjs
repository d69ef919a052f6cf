// What the tests of the page share: the program in a folder of its own, a browser, and a page that complains about every
// error in the browser and every address outside of the program.
//   node --test tests/browser/design.test.mjs      PROGRAM, CHECKOUT and, if it is no Debian, CHROMIUM in the environment
import { spawn, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";

export const checkout = process.env.CHECKOUT;
const program = process.env.PROGRAM;
const chromium = process.env.CHROMIUM ?? "/usr/bin/chromium";
if (checkout === undefined || program === undefined) throw new Error("PROGRAM and CHECKOUT must be set");

const { chromium: browserType, selectors } = createRequire(join(checkout, "web/package.json"))("playwright-core");
selectors.setTestIdAttribute("data-test");

/** Longest wait for anything that the page does by itself [ms]; a busy machine must fit in. */
export const patience = 60_000;

/** Starts `knitmech ui` and waits for its address. */
export async function startProgram(folder, ...words) {
  const child = spawn(program, ["ui", "--no-browser", "--port", "0", "--folder", folder, ...words], { cwd: folder });
  let complaints = "";
  child.stderr.on("data", (text) => (complaints += text));
  const address = await new Promise((resolve, reject) => {
    createInterface({ input: child.stdout }).on("line", (line) => {
      const found = /http:\S+/.exec(line);
      if (found) resolve(found[0]);
    });
    child.on("exit", (code) => reject(new Error(`knitmech ui ended with ${code}: ${complaints}`)));
  });
  const ended = new Promise((resolve) => child.on("exit", resolve));
  return {
    address,
    async end() {
      child.kill("SIGINT");
      return ended;
    },
  };
}

export function newFolder() {
  return mkdtempSync(join(tmpdir(), "knitmech-page-"));
}

/** The first example made so small that it is run in about a second: 3 x 3 stitches to 18 % strain. */
export function smallCase(title = "Small jersey") {
  return readFileSync(join(checkout, "examples/01-first-loop/case.toml"), "utf8")
    .replace(/^title = .*/m, `title = "${title}"`)
    .replace(/^wales = .*/m, "wales = 3")
    .replace(/^courses = .*/m, "courses = 3")
    .replace(/^strain = .*/m, "strain = 0.18");
}

/** What a command of the program writes, called in a folder. */
export function runProgram(folder, ...words) {
  const ended = spawnSync(program, words, { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 });
  if (ended.status !== 0) throw new Error(`knitmech ${words.join(" ")} ended with ${ended.status}: ${ended.stderr}`);
  return ended.stdout;
}

/** A finished run in a folder, as a terminal leaves it. */
export function makeRun(folder, id, text = smallCase()) {
  writeFileSync(join(folder, `${id}.toml`), text);
  runProgram(folder, "run", `${id}.toml`, "-o", join("results", id), "--quiet");
}

/** A folder, the program in it, a browser and a page on it; `end` takes all away and throws if the page had an error. */
export async function openPage({ width = 1440, height = 900, hash = "", words = [], prepare = () => undefined } = {}) {
  const folder = newFolder();
  prepare(folder);
  const ui = await startProgram(folder, ...words);
  const browser = await browserType.launch({
    executablePath: chromium,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true });
  const errors = [];
  const watch = (page) => {
    page.setDefaultTimeout(patience);
    page.on("pageerror", (error) => errors.push(String(error)));
    page.on("console", (message) => {
      if (message.type() === "error") errors.push(message.text());
    });
    page.on("request", (request) => {
      if (!/^(blob|data):/.test(request.url()) && !request.url().startsWith(ui.address)) {
        errors.push(`asks for ${request.url()}`);
      }
    });
    return page;
  };
  const newPage = async (where = hash) => {
    const page = watch(await context.newPage());
    await page.goto(ui.address + where);
    return page;
  };
  const page = await newPage();
  return {
    folder,
    ui,
    page,
    newPage,
    /** Errors that a test provoked itself are taken away here: an answer with a status of 4xx is one to the browser. */
    forgive(pattern) {
      errors.splice(0, errors.length, ...errors.filter((text) => !pattern.test(text)));
    },
    async end() {
      await browser.close();
      await ui.end();
      rmSync(folder, { recursive: true, force: true });
      if (errors.length > 0) throw new Error(`The page had errors:\n${errors.join("\n")}`);
    },
  };
}

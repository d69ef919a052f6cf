// The page Run: from Design to the end of a run, its report, and a page that is closed meanwhile.
import assert from "node:assert/strict";
import { existsSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openPage, smallCase } from "./harness.mjs";

/** The true mass makes steps a dozen times shorter, a fifth of the speed five times as many, 12 wales each four times as long. */
function longCase() {
  return smallCase("Long test")
    .replace(/^mass_scaling = .*/m, "mass_scaling = 1")
    .replace(/^wales = .*/m, "wales = 12")
    .replace(/^strain = .*/m, (line) => `${line}\nspeed = "1 mm/s"`)
    .concat("[output]\nhistory_points = 5000\n");
}

let it;
let page;
before(async () => {
  // The long case would take minutes; it is stopped by the tests.
  it = await openPage({
    prepare: (folder) => {
      writeFileSync(join(folder, "small.toml"), smallCase());
      writeFileSync(join(folder, "long.toml"), longCase());
    },
    words: ["small.toml"],
  });
  page = it.page;
});
after(() => it.end());

const item = (id, on = page) => on.locator(`[data-test=run][data-id="${id}"]`);
const status = (id, wanted, on = page) => on.locator(`[data-test=run][data-id="${id}"][data-status="${wanted}"]`).waitFor();
const rows = (on = page) => on.locator("[data-test=curves]").getAttribute("data-rows").then(Number);
const rowsGrow = async (on = page) => {
  const was = await rows(on);
  await on.waitForFunction((n) => Number(document.querySelector("[data-test=curves]").dataset.rows) > n, was);
};

/** Starts a case of the folder from the page Design. */
async function start(path, on = page) {
  await on.goto(`${it.ui.address}#/design?case=${path}`);
  await on.reload();
  await on.getByText(path.includes("long") ? "Long test" : "Small jersey").first().waitFor();
  await on.getByRole("button", { name: "Run", exact: true }).click();
  await on.locator("[data-test=run]").first().waitFor();
}

test("Given a case in Design, when it is run, then its curve grows to the end and it judges itself.", async () => {
  await start("small.toml");
  await item("small").waitFor();
  await status("small", "completed");
  assert.ok((await rows()) > 500);
  await page.getByTestId("verdict").waitFor();
  assert.match(await page.getByTestId("facts").innerText(), /crossings were kept/);
  await page.locator("[data-test=fabric-view]").first().waitFor();
});

test("Given the finished run, when its report is opened, then it is there with its pictures.", async () => {
  const [report] = await Promise.all([
    page.context().waitForEvent("page"),
    item("small").getByRole("link", { name: /Report/ }).click(),
  ]);
  await report.waitForLoadState();
  assert.match(report.url(), /runs\/small\/report\.html$/);
  assert.match(await report.locator("body").innerText(), /Small jersey/);
  assert.ok((await report.locator("svg, img").count()) > 3);
  await report.close();
});

test("Given a run under way, when it is paused, then it stands still until it goes on.", async () => {
  await start("long.toml");
  await status("long", "running");
  await rowsGrow();
  await item("long").getByRole("button", { name: /^Pause/ }).click();
  await status("long", "paused");
  await item("long").getByRole("button", { name: /^(Resume|Go on)/ }).click();
  await status("long", "running");
  await rowsGrow();
});

test("Given a run under way, then the fabric deforms as it goes.", async () => {
  await item("long").getByRole("button", { name: "Long test" }).click();
  const fabric = page.locator('[data-test=run-fabric][data-id="long"]');
  await fabric.waitFor();
  const was = Number(await fabric.getAttribute("data-strain"));
  await page.waitForFunction(
    (strain) => Number(document.querySelector('[data-test=run-fabric][data-id="long"]').dataset.strain) > strain,
    was,
  );
});

test("Given a run under way, when the page is closed, then the run goes on, and a new page finds it.", async () => {
  const before = await rows();
  const context = page.context();
  await page.close();
  page = await it.newPage("#/run");
  assert.equal(context.pages().length, 1);
  await status("long", "running");
  await page.waitForFunction((n) => Number(document.querySelector("[data-test=curves]")?.dataset.rows) > n, before);
});

test("Given a second run, then both curves are shown together, with measured ones.", async () => {
  await item("small").getByRole("checkbox").check();
  await page.waitForFunction(() => /runs=/.test(location.hash));
  const curve = "strain [-],force [N]\n" + Array.from({ length: 20 }, (_, i) => `${i / 100},${(i * i) / 1e5}`).join("\n");
  await page.getByTestId("measured-file").setInputFiles({ name: "fabric.csv", mimeType: "text/csv", buffer: Buffer.from(curve) });
  const dialog = page.getByRole("dialog");
  await dialog.locator("button.main").click();
  await page.getByTestId("measured").waitFor();
});

test("Given a file that is no curve, then the page says why and keeps what it shows.", async () => {
  await page.getByTestId("measured-file").setInputFiles({ name: "poem.csv", mimeType: "text/csv", buffer: Buffer.from("roses,red\n") });
  const dialog = page.getByRole("dialog");
  await dialog.locator("button.main").click();
  await dialog.getByText(/poem\.csv/).first().waitFor();
  await dialog.getByRole("alert").waitFor();
  it.forgive(/400/);
  await page.keyboard.press("Escape");
  assert.equal(await page.getByTestId("measured").count(), 1);
});

test("Given a run under way, when it is stopped, then it can go on later.", async () => {
  await item("long").getByRole("button", { name: /^Stop…/ }).click();
  await item("long").getByRole("button", { name: "Stop", exact: true }).click();
  await status("long", "interrupted");
  assert.ok(existsSync(join(it.folder, "results", "long", "checkpoint.bin")));
  await item("long").getByRole("button", { name: /^Go on/ }).click();
  await status("long", "running");
});

test("Given a run under way, when the program is ended, then it keeps a checkpoint.", async () => {
  it.forgive(/./);
  assert.equal(await it.ui.end(), 0);
  assert.ok(existsSync(join(it.folder, "results", "long", "checkpoint.bin")));
  await page.getByText(/No link to the program/).first().waitFor();
  await page.close();  // it would go on asking
  it.forgive(/ERR_|Failed to load|asks for/);
});

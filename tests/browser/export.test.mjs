// The page Export: what is saved is what the command line writes.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { makeRun, openPage, runProgram } from "./harness.mjs";

let it;
let page;
before(async () => {
  it = await openPage({ prepare: (folder) => makeRun(folder, "jersey"), hash: "#/export?run=jersey" });
  page = it.page;
});
after(() => it.end());

const card = (name) => page.getByRole("region", { name, exact: true });

async function downloaded(button) {
  const [download] = await Promise.all([page.waitForEvent("download"), button.click()]);
  return { name: download.suggestedFilename(), bytes: readFileSync(await download.path()) };
}

test("Given a run, when its deck is saved, then it is the one of knitmech export.", async () => {
  const { name, bytes } = await downloaded(card("Simulation deck").locator("button.main"));
  assert.match(name, /\.inp$/);
  assert.deepEqual(bytes.toString(), runProgram(it.folder, "export", "results/jersey/case.toml", "-f", "abaqus"));
});

test("Given the windows of a small and a large screen, then no choice and no button stands out of its card.", async () => {
  for (const width of [1024, 1280, 1920]) {
    await page.setViewportSize({ width, height: 900 });
    const outside = await page.evaluate(() =>
      [...document.querySelectorAll(".export .card")].flatMap((card) =>
        [...card.querySelectorAll("select, button, .button")]
          .filter((part) => part.getBoundingClientRect().right > card.getBoundingClientRect().right - 8)
          .map((part) => `${card.ariaLabel}: ${part.ariaLabel ?? part.textContent}`),
      ),
    );
    assert.deepEqual(outside, [], `${width} pixels wide`);
  }
});

test("Given a stored strain, when the geometry is saved, then it is the one of knitmech export.", async () => {
  const geometry = card("Geometry");
  await geometry.getByRole("combobox", { name: "Format" }).selectOption("obj");
  await geometry.getByRole("combobox", { name: "Frame of the geometry" }).selectOption("1");
  const { name, bytes } = await downloaded(geometry.locator("button.main"));
  assert.match(name, /^jersey\.obj$/);
  assert.equal(bytes.toString(), runProgram(it.folder, "export", "results/jersey", "-f", "obj", "--frame", "1"));
});

test("Given a run, when its curve is saved, then it is history.csv.", async () => {
  const { bytes } = await downloaded(card("Curve").getByRole("button", { name: /history\.csv/ }));
  assert.deepEqual(bytes, readFileSync(join(it.folder, "results/jersey/history.csv")));
});

test("Given a colour, when the picture is drawn, then it is a PNG of the wanted width.", async () => {
  await page.getByTestId("picture").waitFor();
  await card("Picture").getByRole("combobox", { name: "Colour" }).selectOption("contact");
  await page.waitForFunction(() => /contact/.test(document.querySelector("[data-test=picture]").dataset.words));
  const { name, bytes } = await downloaded(card("Picture").locator("button.main"));
  assert.match(name, /\.png$/);
  assert.equal(bytes.subarray(1, 4).toString(), "PNG");
});

test("Given the commands that are shown, then they are what a terminal takes.", async () => {
  const commands = await page.locator("code").allInnerTexts();
  const known = runProgram(it.folder, "--help");
  assert.ok(commands.length >= 4);
  for (const command of commands.filter((text) => text.startsWith("knitmech "))) {
    assert.ok(known.includes(`\n  ${command.split(" ")[1]} `), command);
  }
});

test("Given the report, when it is written anew, then it can be opened.", async () => {
  await card("Report").getByRole("button", { name: /anew|Write/ }).click();
  await card("Report").getByRole("link").first().waitFor();
});

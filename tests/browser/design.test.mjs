// The page Design: what is typed is drawn, and what is wrong is told where it is.
import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openPage } from "./harness.mjs";

let it;
let page;
before(async () => {
  it = await openPage();
  page = it.page;
  await page.waitForFunction(() => Number(document.querySelector(".design")?.dataset.generation) > 0);
});
after(() => it.end());

const field = (name) => page.getByRole("textbox", { name, exact: false }).first();
const drawing = () => page.getByTestId("loop-drawing");
const generation = async () => Number(await page.locator(".design").getAttribute("data-generation"));

/** Waits until the drawings have followed something that is done here. */
async function followed(action) {
  const was = await generation();
  await action();
  await page.waitForFunction((n) => Number(document.querySelector(".design").dataset.generation) > n, was);
}

const mistakes = () => page.getByRole("list", { name: "Mistakes" }).getByRole("listitem").allInnerTexts();

test("Given the first example, when the page opens, then loop, fabric and values are there.", async () => {
  await page.getByText("First loop").first().waitFor();
  await drawing().getByText("1.1").waitFor();
  await page.waitForFunction(() => Number(document.querySelector("[data-test=fabric-view]")?.dataset.generation) > 0);
  assert.match(await page.getByTestId("values").innerText(), /17\.29/); // yarn in a stitch, as knitmech check tells
});

test("Given a loop, when its head radius is changed, then picture, values and text follow.", async () => {
  const before = await drawing().innerHTML();
  const fabricBefore = await page.getByTestId("fabric-view").getAttribute("data-generation");
  await followed(() => field("Head radius").fill("1.05 mm"));
  assert.notEqual(await drawing().innerHTML(), before);
  await drawing().getByText("1.05").waitFor();
  await page.waitForFunction((was) => document.querySelector("[data-test=fabric-view]").dataset.generation !== was, fabricBefore);
  await page.getByRole("tab", { name: "Case file" }).click();
  await page.getByTestId("case-text").getByText(/head_radius = "1\.05 mm"\s+# R1/).waitFor();
  await page.getByRole("tab", { name: "Values" }).click();
});

test("Given the text, when it is edited, then the form follows.", async () => {
  await page.getByRole("tab", { name: "Case file" }).click();
  const line = page.getByTestId("case-text").getByText("wales = 5");
  await line.click();
  await page.keyboard.press("End");
  await page.keyboard.press("Home");
  await followed(async () => {
    await page.keyboard.press("Shift+End");
    await page.keyboard.type("wales = 4");
  });
  await page.waitForFunction(() => [...document.querySelectorAll("input")].some((input) => input.value === "4"));
  assert.equal(await field("Wales").inputValue(), "4");
  await page.getByRole("tab", { name: "Values" }).click();
});

/** Mistakes of each kind: the field, what is typed, what must be said, and what was there. */
const kinds = [
  ["Height", "7 kg", /kg/, "a wrong unit"],
  ["Height", "-7 mm", /must be/, "out of range"],
  ["Height", "", /length|number/, "nothing at all"],
  ["Wales", "4.5", /whole number/, "no whole number"],
  ["Course spacing", "6.9 mm", /do not interlock/, "courses that do not interlock"],
  ["Head radius", "2 mm", /overlap/, "heads that overlap"],
  ["Out of plane", "0.001 /mm", /out_of_plane/, "too flat a loop"],
];
for (const [name, typed, words, what] of kinds) {
  test(`Given ${what}, then it is told at "${name}" in the words of the command line, and goes when it is mended.`, async () => {
    const input = field(name);
    const was = await input.inputValue();
    await followed(() => input.fill(typed));
    assert.equal(await input.getAttribute("aria-invalid"), "true");
    const below = await page.locator(`[id="${await input.getAttribute("aria-describedby")}"]`).innerText();
    assert.match(below, words);
    assert.equal((await mistakes()).length, 1);
    assert.ok(await page.getByRole("button", { name: "Run", exact: true }).isDisabled());
    await followed(() => input.fill(was));
    assert.notEqual(await input.getAttribute("aria-invalid"), "true");
    assert.deepEqual(await mistakes(), []);
  });
}

test("Given a text that is no TOML, then the line is named, and the form does not change it.", async () => {
  await page.getByRole("tab", { name: "Case file" }).click();
  await page.getByTestId("case-text").getByText("title =").click();
  await page.keyboard.press("Home");
  await followed(() => page.keyboard.type("= "));
  assert.match((await mistakes())[0], /Line \d+/);
  await followed(async () => {
    await page.keyboard.press("Backspace");
    await page.keyboard.press("Backspace");
  });
  await page.waitForFunction(() => document.querySelector(".mistakes li") === null);
  await page.getByRole("tab", { name: "Values" }).click();
});

test("Given a new case, when it is saved, then it is a file, which another program's change is safe from.", async () => {
  await page.getByRole("button", { name: "Save", exact: true }).click();
  const dialog = page.getByRole("dialog");
  await dialog.getByRole("textbox").fill("my-jersey.toml");
  await dialog.getByRole("button", { name: "Save" }).click();
  await page.getByText("Saved my-jersey.toml.").waitFor();
  const file = join(it.folder, "my-jersey.toml");
  assert.match(readFileSync(file, "utf8"), /wales = 4/);

  writeFileSync(file, readFileSync(file, "utf8") + "# from another program\n");
  await followed(() => field("Wales").fill("3"));
  await page.getByRole("button", { name: "Save", exact: true }).click();
  await page.getByRole("dialog").getByText(/changed by another program/).waitFor();
  it.forgive(/409/);
  await page.keyboard.press("Escape");
  assert.match(readFileSync(file, "utf8"), /from another program/);
});

test("Given unsaved changes, when another case is opened, then the page asks first.", async () => {
  await page.getByRole("button", { name: "Open…" }).click();
  await page.getByRole("dialog").getByText("02-wale-tension").click();
  await page.getByRole("dialog").getByText(/change/i).first().waitFor();
  while ((await page.getByRole("dialog").count()) > 0) await page.keyboard.press("Escape");
  assert.equal(await field("Wales").inputValue(), "3");
});

test("Given a fabric that is too large to be drawn, then the page says so, and it can be run.", async () => {
  const note = page.getByText(/too large to be drawn/);
  await followed(() => field("Courses").fill("300"));
  assert.equal(await note.count(), 0);
  await followed(() => field("Wales").fill("200")); // 300 x 200 x 20 elements
  await note.waitFor();
  assert.ok(await page.getByRole("button", { name: "Run", exact: true }).isEnabled());
  await followed(() => field("Wales").fill("3"));
  await followed(() => field("Courses").fill("5"));
  assert.equal(await note.count(), 0);
});

test("Given only a keyboard, then a number is stepped, undone, and the fabric turned.", async () => {
  await field("Course spacing").focus();
  const was = await field("Course spacing").inputValue();
  await followed(() => page.keyboard.press("ArrowUp"));
  assert.notEqual(await field("Course spacing").inputValue(), was);
  await followed(() => page.getByRole("button", { name: "Undo" }).press("Enter"));
  assert.equal(await field("Course spacing").inputValue(), was);
});

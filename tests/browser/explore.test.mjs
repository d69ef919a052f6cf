// The page Explore: a finished run, its frames, colours and values.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { makeRun, openPage } from "./harness.mjs";

let it;
let page;
before(async () => {
  it = await openPage({ prepare: (folder) => makeRun(folder, "jersey"), hash: "#/explore?run=jersey" });
  page = it.page;
  await drawn();
});
after(() => it.end());

const view = () => page.getByTestId("fabric-view");
const canvas = () => view().locator("canvas").first();

/** Waits until the state that the page shows is also the one in the picture. */
async function drawn() {
  await page.waitForFunction(() => {
    const shown = document.querySelector(".explore")?.dataset.generation;
    return Number(shown) > 0 && document.querySelector("[data-test=fabric-view]")?.dataset.generation === shown;
  });
}

test("Given a run named in the address, then its last frame and its curve are shown.", async () => {
  await page.getByText("Small jersey").first().waitFor();
  await page.getByText("18.00 %").first().waitFor();
});

test("Given the slider, when it is moved to the start, then the fabric is the undeformed one.", async () => {
  const slider = page.getByRole("slider").first();
  const before = await canvas().screenshot();
  await slider.focus();
  await page.keyboard.press("Home");
  await page.getByText(/^0\.00 %/).first().waitFor();
  await drawn();
  assert.notDeepEqual(await canvas().screenshot(), before);
});

test("Given a colour, then the bar tells its quantity and unit, and the address restores it.", async () => {
  await page.getByRole("slider").first().press("End");
  await page.getByRole("combobox", { name: "By" }).selectOption("contact_force");
  await page.getByText(/Contact force/).first().waitFor();
  await page.waitForFunction(() => /contact/.test(location.hash));
  const other = await it.newPage(new URL(page.url()).hash);
  await other.getByText(/Contact force/).first().waitFor();
  await other.close();
});

test("Given a click on a yarn, then its place and values are told.", async () => {
  // The yarns cover a tenth of the view: points on a line across it hit one.
  const box = await canvas().boundingBox();
  for (let share = 0.2; share < 0.8; share += 0.01) {
    await page.mouse.click(box.x + share * box.width, box.y + 0.52 * box.height);
    if ((await page.getByTestId("picked").count()) > 0) break;
  }
  assert.match(await page.getByTestId("picked").innerText(), /course \d, wale \d/);
  assert.match(await page.locator("main").innerText(), /Bending moment\s+\S+ N mm/);
});

test("Given the picture button, then a PNG is saved.", async () => {
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save picture" }).click()]);
  const bytes = readFileSync(await download.path());
  assert.equal(bytes.subarray(1, 4).toString(), "PNG");
  assert.ok(bytes.length > 5000);
});


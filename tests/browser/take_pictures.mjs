// The pictures of the page in docs/: the first example in Design, a run under way beside a finished one, the main example
// at 16 % strain with its contact forces, and the page Export.
//   node take_pictures.mjs FOLDER     called by tools/page_pictures
import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { checkout, makeRun, openPage } from "./harness.mjs";

const folder = process.argv[2];
const mainExample = readFileSync(join(checkout, "examples/02-wale-tension/case.toml"), "utf8");
const it = await openPage({
  width: 1280,
  height: 800,
  prepare: (place) => {
    makeRun(place, "wale-tension", mainExample);
    writeFileSync(
      join(place, "friction-0.3.toml"),
      mainExample.replace(/^friction = 0.1/m, "friction = 0.3").replace("wale-wise tension", "friction 0.3"),
    );
  },
});
const { page } = it;

async function take(name) {
  await page.evaluate(() => document.fonts.ready);
  await page.screenshot({ path: join(folder, `page-${name}.png`) });
}

async function goTo(hash) {
  await page.goto(it.ui.address + hash);
  await page.reload();
}

page.setDefaultTimeout(120_000);
page.setDefaultNavigationTimeout(120_000);
await page.locator("[data-test=fabric-view][data-generation]").waitFor();
await page.getByRole("textbox", { name: "Head radius" }).focus();
await take("design");

await goTo("#/design?case=friction-0.3.toml");
await page.getByText("friction 0.3").first().waitFor();
await page.getByRole("button", { name: "Run", exact: true }).click();
await page.locator('[data-test=run][data-id="wale-tension"]').getByRole("checkbox").check();
// Far enough for the fabric to look pulled, and early enough for the picture to be taken while it runs.
await page.waitForFunction(() => Number(document.querySelector("[data-test=run-fabric]")?.dataset.strain) > 0.1);
await take("run");

await goTo("#/explore?run=wale-tension&strain=16&colour=contact_force");
await page.getByText("stored frame 3", { exact: true }).waitFor();
await page.getByRole("img", { name: /^Contact force from/ }).waitFor();
const view = await page.locator("[data-test=fabric-view] canvas").first().boundingBox();
for (const turn of [-5, -5, -5]) {
  await page.mouse.move(view.x + view.width / 2, view.y + view.height / 2);
  await page.mouse.wheel(0, 60 * turn);
}
await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
await take("explore");

await goTo("#/export?run=wale-tension");
await page.locator("[data-test=picture] img").waitFor();
await take("export");
await it.end();

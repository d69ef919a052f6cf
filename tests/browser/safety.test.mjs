// Other pages of the same browser, and links that are not complete, get nowhere.
import assert from "node:assert/strict";
import { existsSync, readdirSync } from "node:fs";
import { createServer } from "node:http";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { openPage, smallCase } from "./harness.mjs";

let it;
let foreign; // a server of another page on this computer
let foreignAddress;
before(async () => {
  it = await openPage();
  foreign = createServer((request, response) => response.end("<!doctype html><title>Another page</title>"));
  await new Promise((resolve) => foreign.listen(0, "127.0.0.1", resolve));
  foreignAddress = `http://127.0.0.1:${foreign.address().port}/`;
});
after(async () => {
  foreign.close();
  it.forgive(/foreign|CORS|Cross-Origin|Failed to load|blocked|ERR_|asks for|frame|refused/i);
  await it.end();
});

test("Given another page that knows the address, when it tries to start a run, then there is none.", async () => {
  const page = await it.newPage("");
  await page.goto(foreignAddress);
  const outcomes = await page.evaluate(
    async ({ address, text }) => {
      const body = JSON.stringify({ text, name: "stolen" });
      const tries = [
        () => fetch(`${address}api/runs`, { method: "POST", body, headers: { "Content-Type": "application/json" } }),
        () => fetch(`${address}api/runs`, { method: "POST", body, mode: "no-cors" }),
        () => fetch(`${address}api/case`, { method: "PUT", body, headers: { "Content-Type": "application/json" } }),
        () => fetch(`${address}api/program`),
      ];
      const outcomes = [];
      for (const attempt of tries) {
        outcomes.push(
          await attempt().then(
            async (answer) => (answer.type === "opaque" ? "nothing to read" : answer.text()),
            () => "refused",
          ),
        );
      }
      return outcomes;
    },
    { address: it.ui.address, text: smallCase() },
  );
  assert.deepEqual(outcomes, ["refused", "refused", "refused", "refused"]);
  assert.ok(!existsSync(join(it.folder, "results", "stolen")));
  await page.close();
});

test("Given another page that shows this one in a frame, then the frame stays empty.", async () => {
  const page = await it.newPage("");
  await page.goto(foreignAddress);
  await page.evaluate((address) => {
    const frame = document.createElement("iframe");
    frame.src = address;
    document.body.append(frame);
    return new Promise((resolve) => (frame.onload = resolve));
  }, it.ui.address);
  const inner = page.frames().find((frame) => frame !== page.mainFrame());
  assert.equal(await inner.locator(".top-bar").count(), 0);
  await page.close();
});

test("Given the address of an earlier start, then the page says which one to open.", async () => {
  const page = await it.newPage("");
  const answer = await page.goto(it.ui.address.replace(/[0-9a-f]{32}/, "0".repeat(32)));
  assert.equal(answer.status(), 403);
  assert.match(await page.locator("body").innerText(), /open the one that knitmech ui prints/);
  await page.close();
});

test("Given all that, then the folder is as it was.", () => {
  assert.deepEqual(readdirSync(it.folder), []);
});

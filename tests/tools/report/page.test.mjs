// Copyright 2026 The musclewarp authors.
// SPDX-License-Identifier: Apache-2.0

// The page in a browser: the embedded scene.

import assert from "node:assert/strict";
import { cpSync, readFileSync, renameSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, afterEach, before, describe, test } from "node:test";

import {
  Browser,
  countOf,
  countRed,
  cut,
  differentPixels,
} from "./browser.mjs";
import {
  dataDir,
  deform,
  readReport,
  workDir,
  writePage,
  writeReport,
} from "./programs.mjs";

const run = join(workDir, "motion");
const html = join(run, "report.html");
let browser;

before(async () => {
  const scene = join(dataDir, "phantom", "motion.json");
  assert.equal(
    deform(`--scene=${scene}`, `--out=${run}`, "--fibres=20", "--html"),
    0,
  );
  browser = await Browser.launch();
});

after(() => browser?.close());
afterEach(() => browser?.closePages());

// Without what is drawn over the surfaces.
async function openPlain(file = html, options = {}) {
  const page = await browser.openReady(file, options);
  await page.locator("#show-lines").uncheck();
  await page.locator("#show-crossings").uncheck();
  await page.locator(".bones summary").click();
  return page;
}

// By name: the colour the list of meshes gives.
function swatches(page) {
  return page.$$eval("#meshes li", (items) =>
    Object.fromEntries(
      items.map((item) => [
        item.dataset.mesh,
        getComputedStyle(item.querySelector(".swatch"))
          .backgroundColor.match(/\d+/g)
          .slice(0, 3)
          .map(Number),
      ]),
    ),
  );
}

const frameShown = async (page) => Number(await page.inputValue("#slider"));

// Waits for a text, however the page breaks its lines.
function hasText(page, text) {
  return page.waitForFunction(
    (wanted) => document.body.innerText.includes(wanted),
    text,
  );
}

describe("the page", () => {
  test("opens from disk without complaint or request", async () => {
    const page = await browser.openReady(html);
    await browser.keep(page, "embedded");
    await browser.keep(page, "embedded_whole", { fullPage: true });
    assert.deepEqual(page.complaints, []);
    assert.equal(await page.title(), "hip_motion: musclewarp");
  });

  test("shows every muscle and bone in its colour", async () => {
    const page = await openPlain();
    const colors = await swatches(page);
    assert.equal(Object.keys(colors).length, 5);
    const picture = await browser.look(page);
    for (const [name, color] of Object.entries(colors)) {
      assert.ok(countOf(picture, color) > 200, `${name} is not seen`);
    }
  });

  test("hides and fades a muscle", async () => {
    const page = await openPlain();
    const color = (await swatches(page)).gluteus_medius_r;
    const shown = countOf(await browser.look(page), color);
    const item = page.locator('[data-mesh="gluteus_medius_r"]');
    await item.locator("input[type=checkbox]").uncheck();
    assert.equal(countOf(await browser.look(page), color), 0);
    await item.locator("input[type=checkbox]").check();
    assert.equal(countOf(await browser.look(page), color), shown);
    await item.locator("input[type=range]").fill("0.2");
    assert.ok(countOf(await browser.look(page), color) < shown / 2);
  });

  test("plays, steps and scrubs", async () => {
    const page = await openPlain();
    await page.locator("#slider").fill("0");
    const rest = await browser.look(page);
    await page.locator("#next").click();
    assert.equal(await frameShown(page), 1);
    assert.ok(differentPixels(rest, await browser.look(page)) > 100);
    await page.locator("#play").click();
    await page.waitForFunction(
      () => Number(document.querySelector("#slider").value) >= 4,
    );
    await page.locator("#play").click();
    await page.locator('#play[title^="Play"]').waitFor();
    const paused = await frameShown(page);
    await page.waitForTimeout(300);
    assert.equal(await frameShown(page), paused);
    await page.locator("#slider").fill("15");
    await hasText(page, "hip_flexion_r 60 degrees · frame 15 of 15");
  });

  test("pauses although frames pass while the button is down", async () => {
    const page = await openPlain();
    await page.locator("#play").click();
    await page.locator("#play").hover();
    await page.mouse.down();
    const pressed = await frameShown(page);
    await page.waitForFunction(
      (frame) => Number(document.querySelector("#slider").value) !== frame,
      pressed,
    );
    await page.mouse.up();
    await page.locator('#play[title^="Play"]').waitFor({ timeout: 20_000 });
  });

  test("goes round when it plays to the end", async () => {
    const page = await openPlain();
    await page.locator("#slider").fill("15");
    await page.locator("#play").click();
    await page.waitForFunction(() => {
      const frame = Number(document.querySelector("#slider").value);
      return frame >= 1 && frame < 15; // rest is no part of the motion
    });
  });

  test("a click on a plot moves the slider", async () => {
    const page = await browser.openReady(html);
    const plot = page.locator("#figure-line-lengths svg[viewBox]").first();
    await plot.scrollIntoViewIfNeeded();
    const box = await plot.boundingBox();
    // The right end of the axis is the last frame, its left end the first.
    await page.mouse.click(box.x + box.width - 20, box.y + box.height / 2);
    assert.equal(await frameShown(page), 15);
    await page.mouse.click(box.x + 62, box.y + box.height / 2);
    assert.equal(await frameShown(page), 1);
    const mark = await page.$eval("#figure-line-lengths .cursor", (line) =>
      Number(line.getAttribute("x1")),
    );
    assert.ok(Math.abs(mark - 62) < 1);
  });

  test("every figure is there, with its curves", async () => {
    const page = await browser.openReady(html);
    const figures = await page.$$eval(".figure", (all) =>
      all.map((figure) => figure.id),
    );
    assert.deepEqual(figures, [
      "figure-carried-moment-arms-hip_flexion_r",
      "figure-moment-arms-hip_flexion_r",
      "figure-line-lengths",
      "figure-stretch-999",
      "figure-stretch",
      "figure-stretch-patch",
      "figure-volume-ratio",
      "figure-section-areas",
      "figure-crossing-pairs",
      "figure-gap",
      "figure-drift",
      "figure-change",
      "figure-time",
    ]);
    const curves = () =>
      page.locator("#figure-line-lengths [aria-label=line] path").count();
    assert.equal(await curves(), 7);
    await page.locator(".chips label").nth(2).click(); // the psoas, one line
    await browser.drawn(page);
    assert.equal(await curves(), 6);
    await page.locator("#plotted-muscle").selectOption("gluteus_medius_r");
    await browser.drawn(page);
    assert.equal(await curves(), 3);
  });

  test("the certificate equals report.json", async () => {
    // Frames of every kind, by hand: the page must tell what the report says.
    const other = join(workDir, "verdicts");
    cpSync(run, other, { recursive: true });
    const report = readReport(other);
    const nothing = { triangle_pairs: 0, vertices_inside: 0, pairs: [] };
    for (const i of [2, 3, 7]) {
      Object.assign(report.frames[i].intersections, nothing);
    }
    report.frames[5].usable = false;
    writeReport(other, report);
    const page = await browser.openReady(
      writePage(other, join(workDir, "verdicts.html")),
    );
    const verdicts = await page.$$eval(".strip .mark", (marks) =>
      marks.map((mark) => mark.dataset.verdict),
    );
    const isClean = ({ triangle_pairs, vertices_inside }) =>
      triangle_pairs === 0 && vertices_inside === 0;
    const expected = [
      isClean(report.rest.intersections) ? "clean" : "crossing",
      ...report.frames.map((frame) =>
        !frame.usable
          ? "unusable"
          : isClean(frame.intersections)
            ? "clean"
            : "crossing",
      ),
    ];
    assert.deepEqual(verdicts, expected);
    assert.ok(expected.includes("clean") && expected.includes("unusable"));
    await page.locator(".strip .mark").nth(8).click();
    assert.equal(await frameShown(page), 8);
    // What the files say otherwise is told.
    await hasText(page, "report.json says 0");
    await hasText(page, "yes; not tested for crossings (contact none)");
    await browser.keep(page, "verdicts");
  });

  test("crossing triangles are red, and the list flies there", async () => {
    const page = await browser.openReady(html);
    await page.getByLabel("All bones", { exact: true }).uncheck();
    const before = await browser.look(page);
    assert.ok(countRed(before) > 100);
    await page.locator(".place").first().click();
    const there = await browser.look(page);
    assert.ok(differentPixels(before, there) > 10000);
    assert.ok(countRed(there) > 100);
    await browser.keep(page, "crossing");
    await page.locator("#show-crossings").uncheck();
    assert.equal(countRed(await browser.look(page)), 0);
    const report = readReport(run);
    const { triangle_pairs } = report.frames[0].intersections;
    await hasText(page, `${triangle_pairs} crossing triangle pairs`);
  });

  test("colours muscles by figures, with legend and unit", async () => {
    const page = await openPlain();
    const { gluteus_medius_r } = await swatches(page);
    for (const [coloring, words] of [
      ["displacement", "displacement from rest, mm"],
      ["stretch", "area, to that at rest"],
      ["gap", "gap to the nearest mesh, looked for up to 5 mm, mm"],
      ["attachment", "attached to"],
      ["contact", "contact"],
    ]) {
      await page.locator("#coloring").selectOption(coloring);
      await page.locator("#slider").fill("15");
      const picture = await browser.look(page);
      assert.equal(await page.locator(".legend figcaption").innerText(), words);
      assert.ok(countOf(picture, gluteus_medius_r) < 200, coloring);
      await browser.keep(page, `colour_${coloring}`);
    }
    // Parts of the embedded muscles are inside bones: orange.
    await page.getByLabel("All bones", { exact: true }).uncheck();
    assert.ok(countOf(await browser.look(page), [255, 140, 26]) > 50);
    await page.locator("#coloring").selectOption("name");
    assert.ok(await page.locator(".legend").isHidden());
  });

  test("a click says what is there", async () => {
    const page = await openPlain();
    await page.locator("#coloring").selectOption("gap");
    const box = await page.locator("#view").boundingBox();
    await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
    assert.match(
      await page.locator(".picked").innerText(),
      /^(gluteus medius r: .* mm|pelvis|femur r)/,
    );
    await page.mouse.click(box.x + 5, box.y + 5);
    assert.equal(await page.locator(".picked").textContent(), "");
  });

  test("shows action lines and fibres", async () => {
    const page = await openPlain();
    const plain = await browser.look(page);
    await page.locator("#show-lines").check();
    assert.ok(differentPixels(plain, await browser.look(page)) > 300);
    await page.locator("#show-lines").uncheck();
    await page.locator("#show-fibres").check();
    assert.ok(differentPixels(plain, await browser.look(page)) > 300);
    await browser.keep(page, "fibres");
  });

  test("a section begins in the middle, and shows what is cut", async () => {
    const page = await openPlain();
    const before = await browser.look(page);
    await page.locator("#section-axis").selectOption("superior");
    const place = page.locator("#section-place");
    const middle = await browser.look(page);
    await browser.keep(page, "section", { fullPage: true });
    assert.ok(differentPixels(before, middle) > 10000); // turned to face it
    await hasText(page, "in the middle");
    const range = await place.evaluate(({ min, max }) => [+min, +max]);
    const colors = await swatches(page);
    await place.fill(String(Math.round((range[0] + 2 * range[1]) / 3)));
    assert.ok(differentPixels(middle, await browser.look(page)) > 300);
    await hasText(page, "mm superior of the middle");
    // Above everything nothing is cut; flipped, all of it is.
    await place.fill(String(range[1]));
    await hasText(page, "Nothing is cut here.");
    assert.ok(countOf(await browser.look(page), colors.gluteus_medius_r) > 100);
    await page.getByRole("button", { name: "Keep the other side" }).click();
    assert.equal(countOf(await browser.look(page), colors.gluteus_medius_r), 0);
  });

  test("areas of a section sum up to the volume", async () => {
    // The trapezoidal rule over 40 slices of a smooth body: within a hundredth.
    const page = await openPlain();
    await page.locator("#section-axis").selectOption("lateral");
    const place = page.locator("#section-place");
    const [low, high] = await place.evaluate(({ min, max }) => [+min, +max]);
    const step = (high - low) / 40;
    let volume = 0;
    for (let at = low + step / 2; at < high; at += step) {
      const value = Math.round(2 * at) / 2;
      await place.fill(String(value));
      await page.evaluate(
        () =>
          new Promise((done) => requestAnimationFrame(() => setTimeout(done))),
      );
      const rows = page.locator(".areas tr", { hasText: "gluteus medius r" });
      if ((await rows.count()) === 0) continue;
      volume += step * parseFloat(await rows.locator("td").innerText());
    }
    const [frame] = readReport(run).frames;
    const { volume_mm3 } = frame.muscles.find(
      ({ name }) => name === "gluteus_medius_r",
    );
    assert.ok(Math.abs(volume / volume_mm3 - 1) < 0.02, `${volume}`);
  });

  test("a muscle is shown alone, as large as the view allows", async () => {
    const page = await openPlain();
    const { gluteus_medius_r: color } = await swatches(page);
    await page.getByLabel("All bones", { exact: true }).uncheck();
    const among = countOf(await browser.look(page), color);
    await page
      .getByRole("button", { name: "Show only gluteus medius r of" })
      .click();
    const picture = await browser.look(page);
    assert.ok(countOf(picture, color) > 1.5 * among);
    const isShown = (name) =>
      page.locator(`[data-mesh="${name}"] input[type=checkbox]`).isChecked();
    assert.equal(await isShown("gluteus_medius_r"), true);
    assert.equal(await isShown("psoas_major_r"), false);
  });

  test("a ruler measures between two clicks", async () => {
    const page = await openPlain();
    await page.keyboard.press("m");
    const box = await page.locator("#view").boundingBox();
    const middle = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.click(middle[0], middle[1] - 20);
    await hasText(page, "Ruler: click at another place");
    await page.mouse.click(middle[0], middle[1] + 20);
    await page.locator(".ruler").waitFor();
    const said = await page.locator(".picked").innerText();
    // Forty pixels, as long as the scale bar says, or longer in depth.
    const bar = await page.$eval(".scale-bar", (group) => ({
      mm: parseFloat(group.querySelector("text").textContent),
      pixels: group.querySelector("path").getBoundingClientRect().width,
    }));
    const expected = (40 * bar.mm) / bar.pixels;
    assert.ok(parseFloat(said) > 0.8 * expected, `${said} of ${expected}`);
    await browser.keep(page, "ruler");
    await page.keyboard.press("m");
    await page.locator(".ruler").waitFor({ state: "detached" });
  });

  test("letters tell the axes as the view turns", async () => {
    const page = await openPlain();
    const place = (axis) =>
      page.$eval(`[data-axis=${axis}]`, (text) => [
        Number(text.getAttribute("x")),
        Number(text.getAttribute("y")),
      ]);
    await page.getByRole("button", { name: "View from anterior" }).click();
    await browser.settle(page);
    const [rightOfAnterior] = await place("lateral"); // of a right hip
    assert.ok(rightOfAnterior < -30);
    assert.ok((await place("superior"))[1] < -25);
    await page.getByRole("button", { name: "View from posterior" }).click();
    await browser.settle(page);
    assert.ok((await place("lateral"))[0] > 30);
  });

  test("the address keeps what is seen", async () => {
    const page = await openPlain();
    await page.locator("#slider").fill("7");
    await page.locator("#coloring").selectOption("stretch");
    await page.getByRole("button", { name: "View from medial" }).click();
    const picture = await browser.look(page);
    await page.waitForFunction(() => location.hash.includes("frame=7"));
    await page.waitForTimeout(500);
    const hash = new URL(page.url()).hash;
    const again = await browser.openReady(html, {}, hash);
    await again.locator("#show-crossings").uncheck();
    assert.equal(await frameShown(again), 7);
    assert.equal(await again.inputValue("#coloring"), "stretch");
    // The camera is kept to a hundredth of a millimetre: edges may move a little.
    const different = differentPixels(picture, await browser.look(again));
    assert.ok(
      different < 0.005 * picture.width * picture.height,
      `${different}`,
    );
  });

  test("what an address says wrongly is passed over", async () => {
    const wrong = "#frame=99&colour=%3Cb%3E&camera=1,2&section=up&hidden=x";
    const page = await browser.openReady(html, {}, wrong);
    assert.deepEqual(page.complaints, []);
    assert.equal(await page.inputValue("#coloring"), "name");
  });

  test("saves the view as a picture", async () => {
    const page = await openPlain();
    for (const [name, alpha] of [
      ["Save the view as a picture, on white", 255],
      ["Save the view as a picture, transparent", 0],
    ]) {
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.getByRole("button", { name }).click(),
      ]);
      const picture = await browser.decode(readFileSync(await download.path()));
      const box = await page.locator("#view").boundingBox();
      assert.equal(picture.width, 2 * Math.round(box.width));
      assert.equal(picture.data[3], alpha);
      const { gluteus_medius_r } = await swatches(page);
      assert.ok(countOf(picture, gluteus_medius_r) > 1000);
    }
  });

  test("without WebGL there is a still picture and what to do", async () => {
    const page = await browser.openFlat(html);
    await hasText(page, "Switch on hardware acceleration");
    const [colors, picture] = [
      await swatches(page),
      await browser.lookAt(page, "canvas.still"),
    ];
    assert.ok(countOf(picture, colors.gluteus_medius_r) > 500);
    await browser.keep(page, "no_webgl");
  });

  test("views, turning and resetting", async () => {
    const page = await openPlain();
    const start = await browser.look(page);
    const pictures = [];
    for (const name of ["anterior", "posterior", "medial", "superior"]) {
      await page.getByRole("button", { name: `View from ${name}` }).click();
      pictures.push(await browser.look(page));
    }
    pictures.reduce((before, now) => {
      assert.ok(differentPixels(before, now) > 1000);
      return now;
    }, start);
    const box = await page.locator("#view").boundingBox();
    const center = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(...center);
    await page.mouse.down();
    await page.mouse.move(center[0] + 100, center[1] + 30);
    await page.mouse.up();
    const turned = await browser.look(page);
    assert.ok(differentPixels(pictures.at(-1), turned) > 1000);
    await page.mouse.wheel(0, -300);
    assert.ok(differentPixels(turned, await browser.look(page)) > 1000);
    await page.getByRole("button", { name: /Reset/ }).click();
    assert.ok(differentPixels(start, await browser.look(page)) < 50);
  });

  test("is used by keyboard", async () => {
    const page = await browser.openReady(html);
    const press = (key) => page.keyboard.press(key);
    await press("Home");
    assert.equal(await frameShown(page), 0);
    await press("ArrowRight");
    await press("ArrowRight");
    assert.equal(await frameShown(page), 2);
    await press("ArrowLeft");
    assert.equal(await frameShown(page), 1);
    await press("End");
    assert.equal(await frameShown(page), 15);
    await press("c");
    assert.equal(await page.inputValue("#coloring"), "displacement");
    await press("p");
    assert.equal(await page.inputValue("#section-axis"), "anterior");
    await press("x");
    assert.equal(await page.isChecked("#show-crossings"), false);
    const before = await browser.look(page);
    await press("2");
    assert.ok(differentPixels(before, await browser.look(page)) > 1000);
    await press(" ");
    await page.waitForFunction(
      () => document.querySelector("#play").title === "Pause (space)",
    );
    await press(" ");
    await press("?");
    assert.ok(await page.locator("dialog").isVisible());
    await press("Escape");
    assert.ok(await page.locator("dialog").isHidden());
  });

  test("figures are downloaded as SVG and CSV", async () => {
    const page = await browser.openReady(html);
    const get = async (type, figure = "line-lengths") => {
      const [download] = await Promise.all([
        page.waitForEvent("download"),
        page.locator(`#figure-${figure}`).getByText(type).click(),
      ]);
      return readFileSync(await download.path(), "utf8");
    };
    const rows = (await get("CSV")).trim().split("\n");
    const report = readReport(run);
    assert.equal(rows.length, 1 + report.frames.length);
    const fields = (row) => row.match(/"[^"]*"|[^,]+/g);
    const columns = fields(rows[0]);
    const last = report.frames.at(-1);
    for (const { line_lengths_mm } of last.muscles) {
      for (const [line, length] of Object.entries(line_lengths_mm)) {
        const at = columns.indexOf(line);
        assert.equal(Number(fields(rows.at(-1))[at]), length);
      }
    }
    const svg = await get("SVG");
    assert.match(svg, /^<svg/);
    assert.match(svg, /Line lengths/);
    assert.doesNotMatch(svg, /var\(--(?!plot)/);
    assert.doesNotMatch(await get("SVG", "crossing-pairs"), /var\(--(?!plot)/);
    const drawn = await browser.open(
      (writeFileSync(join(workDir, "lengths.svg"), svg),
      join(workDir, "lengths.svg")),
    );
    assert.deepEqual(drawn.complaints, []);
  });

  test("lays measured moment arms over the plots", async () => {
    const table = join(workDir, "arms.csv");
    writeFileSync(
      table,
      "joint,coordinate,muscle,angle_deg,moment_arm_mm,sd_mm,source\n" +
        "hip,flexion,gluteus_medius,10,-20,2,A\n" +
        "hip,flexion,gluteus_medius,50,-10,,A\n" +
        "hip,flexion,gluteus_medius,10,-30,,B\n" +
        "hip,flexion,gluteus_medius,50,-25,,B\n" +
        "hip,flexion,psoas,,35,,C\n" +
        "knee,flexion,soleus,10,3,,D\n",
    );
    const file = writePage(
      run,
      join(workDir, "overlay.html"),
      `--overlay=${table}`,
    );
    const page = await browser.openReady(file);
    await hasText(page, "5 of 6 measured moment arms are laid over the plots");
    const figure = "#figure-carried-moment-arms-hip_flexion_r";
    const count = (what) => page.locator(`${figure} ${what}`).count();
    assert.equal(await count(".measured circle"), 4);
    assert.equal(await count("[aria-label=area] path"), 1); // of two studies
    await page.locator("#plotted-muscle").selectOption("psoas_major_r");
    await browser.drawn(page);
    assert.equal(await count(".measured circle"), 0);
    assert.deepEqual(page.complaints, []);
  });

  test("the summary has what a reader asks for", async () => {
    const page = await browser.openReady(html);
    const report = readReport(run);
    for (const text of [
      // A page that is mailed names no folders.
      ...report.command.split(" ").map((word) => word.split("/").pop()),
      report.inputs_hash,
      report.machine.processor,
      "converged: 15 frames",
      "merged points",
      "finished, 15 frames",
    ]) {
      await hasText(page, text);
    }
    await page.locator("#licences summary").click();
    for (const name of ["three", "@observablehq/plot", "d3-scale"]) {
      assert.match(
        await page.locator("#licences pre").innerText(),
        new RegExp(`^${name} [0-9.]+ \\(`, "m"),
      );
    }
  });

  test("all controls have names", async () => {
    const page = await browser.openReady(html);
    const session = await page.context().newCDPSession(page);
    const { nodes } = await session.send("Accessibility.getFullAXTree");
    const roles = ["button", "checkbox", "slider", "combobox", "Canvas"];
    const controls = nodes.filter(
      ({ ignored, role }) => !ignored && roles.includes(role?.value),
    );
    assert.ok(controls.length > 40);
    const nameless = controls.filter(({ name }) => !name?.value);
    assert.deepEqual(nameless, []);
  });

  test("fits a phone, light and dark", async () => {
    for (const colorScheme of ["light", "dark"]) {
      const page = await browser.openReady(html, {
        viewport: { width: 390, height: 844 },
        isMobile: true,
        hasTouch: true,
        colorScheme,
      });
      const { wide, background } = await page.evaluate(() => ({
        wide: document.documentElement.scrollWidth,
        background: getComputedStyle(document.body).backgroundColor,
      }));
      assert.ok(wide <= 390, `${wide} pixels wide`);
      const light = background.match(/\d+/g).map(Number)[0] > 128;
      assert.equal(light, colorScheme === "light");
      assert.ok(await page.locator("#play").isVisible());
      await browser.keep(page, `phone_${colorScheme}`);
      await page.locator("#theme").tap();
      assert.notEqual(
        await page.evaluate(
          () => getComputedStyle(document.body).backgroundColor,
        ),
        background,
      );
      assert.deepEqual(page.complaints, []);
    }
  });
});

describe("a design of postures", () => {
  test("is drawn as dots, with the functions that were fitted", async () => {
    const design = join(workDir, "design");
    cpSync(run, design, { recursive: true });
    const report = readReport(design);
    report.motion.design = { kind: "latin_hypercube" };
    writeReport(design, report);
    const errors = { mean: 0.125, quantile_95: 0.5, largest: 1 };
    const psoas = {
      muscle: "psoas_major_r",
      coordinates: ["hip_flexion_r"],
      terms: 7,
      held_back: { length_error_mm: errors, arm_error_mm: errors },
      lines_through_range: { lines: 500, jumps: 2, with_sign_change: 3 },
      within_bounds: false,
    };
    writeFileSync(
      join(design, "fit.json"),
      JSON.stringify({
        max_length_error_mm: 0.5,
        max_arm_error_mm: 1,
        largest_arm_error_mm: 5,
        frames: report.frames.length,
        frames_doubtful: [],
        frames_left_out: ["frame_0003"],
        microseconds: 1.5,
        muscles: { psoas_r: psoas },
      }),
    );
    const page = await browser.openReady(
      writePage(
        design,
        join(workDir, "design.html"),
        `--fit=${join(design, "fit.json")}`,
      ),
    );
    await hasText(page, "Over the postures");
    const marks = (kind) =>
      page.locator(`#figure-line-lengths [aria-label=${kind}] > *`).count();
    assert.equal(await marks("line"), 0);
    assert.equal(await marks("dot"), 7 * report.frames.length);
    assert.match(await page.innerText("#functions"), /1 left out/);
    assert.deepEqual(
      await page.locator("#functions tbody tr > *").allInnerTexts(),
      [
        "psoas_r",
        "hip_flexion_r",
        "7",
        ...["0.13", "0.50", "1.00", "0.13", "0.50", "1.00"],
        ...["2", "3 of 500", "no"],
      ],
    );
    assert.deepEqual(page.complaints, []);
  });
});

describe("two runs", () => {
  test("stand beside each other under one camera", async () => {
    const other = join(workDir, "copy");
    cpSync(run, other, { recursive: true });
    const page = await openPlain(
      writePage(run, join(workDir, "both.html"), `--compare=${other}`),
    );
    assert.deepEqual(page.complaints, []);
    const halves = async () => {
      const picture = await browser.look(page);
      const half = picture.width >> 1;
      return [0, picture.width - half].map((left) =>
        cut(picture, left, 30, half, picture.height - 30),
      );
    };
    const compare = async () => {
      const [left, right] = await halves();
      const seen = countOf(left, (await swatches(page)).gluteus_medius_r);
      assert.ok(seen > 100);
      // The same run twice; the middle of a pixel may lie elsewhere.
      assert.ok(differentPixels(left, right) < 0.01 * left.width * left.height);
      return left;
    };
    const first = await compare();
    const box = await page.locator("#view").boundingBox();
    await page.mouse.move(box.x + 200, box.y + 200);
    await page.mouse.down();
    await page.mouse.move(box.x + 320, box.y + 220);
    await page.mouse.up();
    const turned = await compare();
    assert.ok(differentPixels(first, turned) > 1000);
    assert.equal(await page.locator(".strip").count(), 2);
    await browser.keep(page, "two_runs");
  });

  test("may have frames that the other lacks", async () => {
    const few = join(workDir, "few");
    const scene = join(dataDir, "phantom", "motion.json");
    deform(`--scene=${scene}`, `--out=${few}`, "--frames=0:2");
    const page = await browser.openReady(
      writePage(run, join(workDir, "uneven.html"), `--compare=${few}`),
    );
    await page.locator("#slider").fill("9");
    await hasText(page, "This run has no such frame.");
    const verdicts = await page.$$eval(".strip", (strips) =>
      strips.map((strip) => strip.children[9].dataset.verdict),
    );
    assert.equal(verdicts[1], "missing");
    assert.deepEqual(page.complaints, []);
  });
});

describe("what went wrong", () => {
  test("a run that stopped half way says why and shows what is there", async () => {
    const stopped = join(workDir, "stopped");
    cpSync(run, stopped, { recursive: true });
    const report = readReport(stopped);
    report.frames.length = 6;
    Object.assign(report.summary, {
      finished: false,
      stopped: "interrupted by SIGINT (Ctrl-C)",
    });
    const psoas = report.frames[5].muscles.find(
      (muscle) => muscle.name === "psoas_major_r",
    );
    psoas.stop_reason = "iteration_limit";
    writeReport(stopped, report);
    const page = await browser.openReady(
      writePage(stopped, join(workDir, "stopped.html")),
    );
    const notices = await page.locator(".notice").allInnerTexts();
    assert.match(
      notices.join("\n"),
      /stopped after 6 of 15 frames: interrupted by SIGINT/,
    );
    assert.match(notices.join("\n"), /iteration_limit \(psoas_major_r\)/);
    await page.locator("#slider").fill("6");
    await hasText(page, "frame 6 of 6");
    assert.deepEqual(page.complaints, []);
    await browser.keep(page, "stopped");
  });

  test("a run without a frame shows rest", async () => {
    const empty = join(workDir, "empty");
    cpSync(run, empty, { recursive: true });
    const report = readReport(empty);
    report.frames = [];
    report.summary.finished = false;
    delete report.summary.stopped;
    writeReport(empty, report);
    const page = await browser.openReady(
      writePage(empty, join(workDir, "empty.html")),
    );
    await hasText(page, "so far; not tested for crossings (contact none)");
    assert.match(
      (await page.locator(".notice").allInnerTexts()).join(),
      /stopped after 0 of 15 frames: the program ended without saying why/,
    );
    const colors = await swatches(page);
    assert.ok(countOf(await browser.look(page), colors.pelvis) > 200);
    assert.deepEqual(page.complaints, []);
  });

  test("names are text wherever they stand", async () => {
    const evil = join(workDir, "evil");
    cpSync(join(dataDir, "phantom"), evil, { recursive: true });
    const name = "<img src=x onerror=alert(1)>";
    const scene = JSON.parse(readFileSync(join(evil, "scene.json"), "utf8"));
    scene.name = "</script><script>alert(2)</script>";
    scene.muscles[0].name = name;
    scene.muscles[0].lines[0].name = "<b onclick=alert(3)>line</b>";
    scene.poses[0].name = "'\"><svg onload=alert(4)>";
    scene.poses.length = 2;
    writeFileSync(join(evil, "scene.json"), JSON.stringify(scene));
    const out = join(evil, "out");
    assert.equal(
      deform(`--scene=${join(evil, "scene.json")}`, `--out=${out}`, "--html"),
      0,
    );
    const page = await browser.openReady(join(out, "report.html"));
    await hasText(page, name);
    await hasText(page, scene.name);
    await page.locator(".place").first().click();
    await page.locator("#figure-line-lengths svg[viewBox]").hover();
    assert.equal(await page.locator("img, svg[onload], b").count(), 0);
    assert.deepEqual(page.complaints, []);
  });

  test("a page that was cut short says so", async () => {
    const text = readFileSync(html, "utf8");
    const damage = {
      "no data": text.replace(
        /<script type="text\/plain" id="runs".*?<\/script>/s,
        "",
      ),
      "cut numbers": text.replace(
        /(id="numbers">.{1000}).*?<\/script>/s,
        (_, start) => start + "</script>",
      ),
    };
    for (const [kind, damaged] of Object.entries(damage)) {
      const file = join(workDir, "damaged.html");
      writeFileSync(file, damaged);
      const page = await browser.open(file);
      const alert = page.locator("[role=alert]");
      await alert.waitFor();
      assert.match(await alert.innerText(), /cannot be shown/, kind);
    }
  });
});

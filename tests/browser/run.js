/* The report in a browser: pages load without complaints, links and pictures resolve, tables sort,
 * no text is clipped or on another at four widths, axe finds nothing in light or dark.
 *
 *     node run.js REPORT AXE PICTURES     the test; screenshots go to the folder PICTURES
 *     node run.js --top REPORT AXE PICTURES   of the pages in the top folder alone
 *     node run.js --every REPORT AXE      of each page in full, whatever its name, at two widths
 *     node run.js --labels FOLDER AXE     of the labels of all pictures in the folder alone
 *     node run.js --self-test REPORT AXE  each fault, put into a copy, turns the test red
 *
 * The last line is `N passed, N failed, N skipped`; exit status 1 if one failed.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";
const fs = require("node:fs");
const path = require("node:path");
const { pathToFileURL } = require("node:url");
const { Browser } = require("./devtools.js");
const { call } = require("./in_page.js");
const { call: callInFigure } = require("./in_figure.js");
const { filesOf, linksOf } = require("./site.js");
const { faults, spoiledCopy } = require("./faults.js");

const WIDTHS = [360, 500, 768, 1440];
/* Widths of axe, which sees what scrolls in a narrow window alone: the scheme of those that are not in the sample. */
const AXE_WIDTHS = { 500: "light", 1440: "dark" };
const SCHEMES = ["light", "dark"];
/* Cases whose pages are checked in full: few and many checks, pictures, a comparison, failures reported.
 * All others are loaded, and their links, layout and access checked at one width with each scheme. */
const SAMPLE = ["R1", "S2", "W1", "G1", "D2"];
const inSample = (page) => SAMPLE.some((name) => page.startsWith(`cases/${name}/`));
/* The scheme changes colours alone. */
const AXE_RULES = {
  light: { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"] },
  dark: { runOnly: { type: "rule", values: ["color-contrast", "link-in-text-block"] } },
};
/* Width and scheme of the screenshots of a page. */
const PICTURES = { 360: ["light"], 500: SCHEMES, 768: ["dark"], 1440: SCHEMES };

class Test {
  constructor(folder, axe) {
    this.folder = path.resolve(folder);
    this.axe = fs.readFileSync(axe, "utf8");
    this.passed = 0;
    this.failures = [];
  }

  judge(what, complaints) {
    if (complaints.length === 0) this.passed++;
    else this.failures.push({ what, complaints });
  }

  async open(tab, page) {
    await tab.open(pathToFileURL(path.join(this.folder, page)).href);
  }

  /* Loading, links, pictures. */
  async load(tab, page) {
    await this.open(tab, page);
    const { hrefs, broken, ids } = await tab.ask(call("references"));
    this.judge(`${page}: loads`, tab.complaints.slice());
    this.judge(`${page}: links and pictures`, broken.concat(linksOf(this.folder, page, hrefs, ids)));
  }

  async sort(tab, page) {
    const complaints = await tab.ask(call("sorting"));
    /* with the keyboard as well */
    const first = "document.querySelector('table.sortable thead button')";
    if (await tab.ask(`${first} !== null`)) {
      const before = await tab.ask(`${first}.focus(), ${first}.parentNode.getAttribute('aria-sort')`);
      await tab.key("Enter", 13);
      if (await tab.ask(`${first}.parentNode.getAttribute('aria-sort')`) === before)
        complaints.push("Enter on a heading does not sort");
    }
    this.judge(`${page}: tables sort`, complaints);
  }

  async filter(tab, page) {
    this.judge(`${page}: fields filter`, await tab.ask(call("filtering")));
  }

  async layout(tab, page, width) {
    await tab.width(width);
    this.judge(`${page}: layout at ${width} px`, await tab.ask(call("layout")));
  }

  async accessibility(tab, page, scheme, width) {
    await tab.width(Number(width));
    await tab.scheme(scheme);
    await tab.ask(call("thin"));
    await tab.ask(`(() => { if (!window.axe) { ${this.axe} } })()`);
    const found = await tab.ask(`axe.run(document, ${JSON.stringify({ ...AXE_RULES[scheme], resultTypes: ["violations"] })})
      .then(({ violations }) => violations.map((v) =>
        v.id + ": " + v.help + " (" + v.nodes.length + "), first " + v.nodes[0].html.slice(0, 160)))`);
    this.judge(`${page}: axe, ${scheme} at ${width} px`, found);
  }

  /* All checks of one page; without a folder for pictures at the widths of axe alone. */
  async whole(tab, page, pictures = null) {
    await this.load(tab, page);
    await this.sort(tab, page);
    await this.filter(tab, page);
    await this.open(tab, page); /* rows as they were */
    for (const width of pictures !== null ? WIDTHS : Object.keys(AXE_WIDTHS).map(Number)) {
      await this.layout(tab, page, width);
      if (pictures !== null) await this.pictures(tab, page, width, pictures);
    }
    for (const width of Object.keys(AXE_WIDTHS))
      for (const scheme of SCHEMES) await this.accessibility(tab, page, scheme, width);
    await tab.scheme("light");
  }

  /* What no page is without. */
  async brief(tab, page) {
    await this.load(tab, page);
    for (const width of Object.keys(AXE_WIDTHS)) await this.layout(tab, page, Number(width));
    for (const [width, scheme] of Object.entries(AXE_WIDTHS)) await this.accessibility(tab, page, scheme, width);
    await tab.scheme("light");
  }

  /* The part of it that a fault concerns. */
  async look(tab, { file, look }) {
    if (look === "labels") return this.labels(tab, file);
    if (look === "load") return this.load(tab, file);
    if (look === "brief") return this.brief(tab, file);
    await this.open(tab, file);
    if (look === "sort") return this.sort(tab, file);
    if (look === "filter") return this.filter(tab, file);
    return look === "layout" ? this.layout(tab, file, WIDTHS[0]) : this.accessibility(tab, file, "light", 500);
  }

  async pictures(tab, page, width, folder) {
    for (const scheme of PICTURES[width]) {
      await tab.scheme(scheme);
      await tab.picture(path.join(folder,
        `${page.replace(/\.html$/, "").replaceAll("/", "-")}-${width}-${scheme}.png`));
    }
    await tab.scheme("light");
  }

  async labels(tab, file) {
    await this.open(tab, file);
    this.judge(`${file}: labels`, await tab.ask(call("picture")));
    this.judge(`${file}: legend, units and size of letters`, await tab.ask(callInFigure("figure")));
  }

  say() {
    for (const { what, complaints } of this.failures) {
      console.log(`FAIL ${what}`);
      complaints.slice(0, 8).forEach((text) => console.log(`     ${text}`));
      if (complaints.length > 8) console.log(`     and ${complaints.length - 8} more`);
    }
  }
}

/* A report that holds part of the catalogue must not pass for one that holds it all. */
function missing(pages) {
  return SAMPLE.map((name) => `cases/${name}/index.html`).filter((page) => !pages.includes(page))
    .map((page) => `${page} is to be checked in full, and is not there`);
}

async function testReport(browser, folder, axe, pictures, { top, every }) {
  const test = new Test(folder, axe), tab = await browser.tab(), pages = filesOf(folder, ".html");
  if (!every) {
    fs.rmSync(pictures, { recursive: true, force: true });
    fs.mkdirSync(pictures, { recursive: true });
  }
  if (!top && !every) test.judge("the sample of cases", missing(pages));
  for (const page of pages.filter((name) => !top || !name.includes("/"))) {
    await tab.width(WIDTHS.at(-1));
    if (every || !page.includes("/") || inSample(page)) await test.whole(tab, page, every ? null : pictures);
    else await test.brief(tab, page);
  }
  if (top) return test;
  await tab.width(WIDTHS.at(-1));
  if (fs.existsSync(path.join(folder, "api/index.html"))) await test.load(tab, "api/index.html");
  for (const file of filesOf(folder, ".svg")) await test.labels(tab, file);
  return test;
}

async function testLabels(browser, folder, axe) {
  const test = new Test(folder, axe), tab = await browser.tab(), pictures = filesOf(folder, ".svg", 4);
  await tab.width(WIDTHS.at(-1));
  test.judge("pictures", pictures.length > 0 ? [] : [`none in ${folder}`]);
  for (const file of pictures) await test.labels(tab, file);
  return test;
}

/* A fault that the test does not see is a failure, and so is one that it calls by another name. */
async function testItself(browser, folder, axe) {
  const test = new Test(folder, axe), tab = await browser.tab();
  for (const fault of faults) {
    const copy = spoiledCopy(folder, fault);
    try {
      const inner = new Test(copy, axe);
      await tab.width(WIDTHS.at(-1));
      await inner.look(tab, fault);
      const said = inner.failures.flatMap(({ complaints }) => complaints);
      const seen = said.find((text) => fault.complaint.test(text));
      console.log(`${seen ? "red" : "NOT SEEN"}: ${fault.name}${seen ? ` (${seen.slice(0, 90)})` : ""}`);
      test.judge(`self-test: ${fault.name}`, seen ? [] : ["the test did not turn red", ...said]);
    } finally {
      fs.rmSync(copy, { recursive: true, force: true });
    }
  }
  return test;
}

async function main(args) {
  const option = args[0].startsWith("--") ? args.shift() : "";
  const [folder, axe, pictures] = args;
  const browser = new Browser(process.env.CHROMIUM || "chromium");
  try {
    const test = option === "--self-test" ? await testItself(browser, folder, axe)
      : option === "--labels" ? await testLabels(browser, folder, axe)
      : await testReport(browser, folder, axe, pictures, { top: option === "--top", every: option === "--every" });
    test.say();
    console.log(`${test.passed} passed, ${test.failures.length} failed, 0 skipped`);
    return test.failures.length === 0 ? 0 : 1;
  } finally {
    await browser.close();
  }
}

main(process.argv.slice(2)).then((status) => { process.exitCode = status; }, (error) => {
  console.error(`browser test: ${error.message}`);
  process.exitCode = 1;
});

/* Faults that the browser test must see: each spoils one file of a copy of the report, and `look` says
 * which part of the test is to see it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");

/* A figure as gnuplot writes it: a curve with its entry in the legend, then its line. */
const figure = (size, title, line) => () => '<svg xmlns="http://www.w3.org/2000/svg" width="400" height="200">' +
  `<text transform="translate(20,120) rotate(270)" font-size="14">${title}</text>` +
  `<g id="f_plot_1"><title>a curve</title><g font-size="${size}"><text x="100" y="40">a curve</text></g>` +
  `<path d="M150,36 L180,36" stroke="black"/><path d="${line}" fill="none" stroke="black"/></g>` +
  '<text x="180" y="190">time (s)</text></svg>';
const addStyle = (rule) => (text) => text.replace("</head>", `<style>${rule}</style></head>`);
const addMarkup = (markup) => (text) => text.replace("</main>", `${markup}</main>`);

const faults = [
  { name: "a broken link", file: "glossary.html", look: "load", complaint: /^broken link/,
    spoil: (text) => text.replace('href="limits.html"', 'href="nowhere.html"') },
  { name: "a link to a place that is not there", file: "glossary.html", look: "load", complaint: /place that is not there/,
    spoil: addMarkup('<p><a href="#nowhere">nowhere</a></p>') },
  { name: "a link to the network", file: "glossary.html", look: "load", complaint: /out of the report/,
    spoil: addMarkup('<p><a href="https://example.org/">out</a></p>') },
  { name: "a picture that is not there", file: "glossary.html", look: "load", complaint: /^picture not shown/,
    spoil: addMarkup('<img src="nowhere.svg" alt="nothing" />') },
  { name: "a clipped label", file: "glossary.html", look: "layout", complaint: /^text is clipped/,
    spoil: addStyle(".state { display: inline-block; width: 2.2rem; overflow: hidden; }") },
  { name: "a clipped label in a picture", file: "picture.svg", look: "labels", complaint: /^text is clipped/,
    spoil: () => '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100">' +
      '<text x="150" y="50">a label that is too long</text></svg>' },
  { name: "a picture without a title of the y axis", file: "picture.svg", look: "labels", complaint: /^no title of the y axis/,
    spoil: () => '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100">' +
      '<text x="20" y="80">1</text><text x="80" y="95">time</text></svg>' },
  { name: "a picture without a title of the x axis", file: "picture.svg", look: "labels", complaint: /^no title of the x axis/,
    spoil: () => '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100">' +
      '<text transform="translate(20,80) rotate(270)">speed</text><text x="80" y="95">1.5</text></svg>' },
  { name: "letters too small to read", file: "picture.svg", look: "labels", complaint: /^text of 6.0 px/,
    spoil: figure(6, "speed (m/s)", "M60,150 L380,160") },
  { name: "an axis without its unit", file: "picture.svg", look: "labels", complaint: /^an axis without a unit/,
    spoil: figure(14, "speed", "M60,150 L380,160") },
  { name: "a legend on a curve", file: "picture.svg", look: "labels", complaint: /^the legend is on a curve/,
    spoil: figure(14, "speed (m/s)", "M60,150 L100,34 L380,37") },
  { name: "a legend as large as its figure", file: "picture.svg", look: "labels", complaint: /^the legend takes/,
    spoil: figure(90, "speed (m/s)", "M60,150 L380,160") },
  { name: "texts on each other", file: "glossary.html", look: "layout", complaint: /^texts overlap/,
    spoil: addStyle("h2 + dl { margin-top: -2rem; }") },
  { name: "a word that breaks in a column", file: "glossary.html", look: "layout", complaint: /^a word is broken/,
    spoil: addMarkup('<table style="width: 6rem; table-layout: fixed"><tr><td style="overflow-wrap: anywhere">method.shape=classic</td></tr></table>') },
  { name: "a page that scrolls sideways", file: "glossary.html", look: "layout", complaint: /scrolls sideways|leaves the page/,
    spoil: addStyle(".scroll { overflow: visible; } table { min-width: 60rem; }") },
  { name: "a table that sorts wrongly", file: "glossary.html", look: "sort", complaint: /stands before|aria-sort/,
    spoil: (text) => text.replace("rising ? order : -order", "rising ? -order : order") },
  { name: "a field that filters nothing", file: "glossary.html", look: "filter", complaint: /leaves \d+ rows|rows stay/,
    spoil: (text) => text.replace("row.hidden = !fits;", "") },
  { name: "an exception in a script", file: "glossary.html", look: "load", complaint: /^exception/,
    spoil: addMarkup("<script>throw new Error('spoiled');</script>") },
  { name: "an error on the console", file: "glossary.html", look: "load", complaint: /^console/,
    spoil: addMarkup("<script>console.error('spoiled');</script>") },
  { name: "too little contrast", file: "glossary.html", look: "axe", complaint: /^color-contrast/,
    spoil: addStyle("main, main * { color: #c8c8c8 !important; background: #ffffff !important; }") },
  { name: "what scrolls in a narrow window without the keyboard", file: "glossary.html", look: "axe",
    complaint: /^scrollable-region-focusable/, spoil: addMarkup("<style>@media (max-width: 40rem) { .spoiled { overflow-x: auto; } }" +
      '.spoiled img { width: 60rem; height: 4rem; }</style><div class="spoiled"><img alt="wide" src="data:image/gif;base64,' +
      'R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7" /></div>') },
  { name: "a page out of the sample that scrolls sideways", file: "glossary.html", look: "brief", complaint: /scrolls sideways|leaves the page/,
    spoil: addStyle(".scroll { overflow: visible; } table { min-width: 60rem; }") },
  { name: "a button without a name", file: "glossary.html", look: "axe", complaint: /^button-name/,
    spoil: addMarkup('<button type="button"></button>') },
];

/* A folder with the report's files as links, and the spoiled one as a file of its own. */
function spoiledCopy(folder, fault) {
  const copy = fs.mkdtempSync(path.join(os.tmpdir(), "touchstone-spoiled-"));
  for (const name of fs.readdirSync(folder))
    if (name !== fault.file) fs.symlinkSync(path.resolve(folder, name), path.join(copy, name));
  const source = path.join(folder, fault.file);
  const before = fs.existsSync(source) ? fs.readFileSync(source, "utf8") : "";
  const after = fault.spoil(before);
  if (after === before) throw new Error(`${fault.name}: nothing to spoil in ${fault.file}`);
  fs.writeFileSync(path.join(copy, fault.file), after);
  return copy;
}

module.exports = { faults, spoiledCopy };

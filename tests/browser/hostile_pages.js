/* A run whose names are as long as they may be, whose texts have markup, long words and other scripts,
 * and whose numbers have all digits, signs and powers: every kind of page has to bear them. Few cases,
 * each with its pictures, every status, and all pages that a report may have beside them.
 *
 *     node hostile_pages.js REPORT FOLDER
 *
 * writes to FOLDER: report/, before/, build/ and mutants.json, as additions.js does.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";
const fs = require("node:fs");
const path = require("node:path");

/* With particles, motion, cracks, contact, heat; many variants; comparisons that the others quote. */
const CASES = ["C4", "D3", "E3", "H2", "M1", "R1"];
const LONGEST = 64; /* of a name */
const WORD = "Donaudampfschifffahrtsgesellschaftskapitänsmützenabzeichenverordnung";
const TEXT = ` <b>bold</b> & "quoted" 'once' %s \\n {{title}} ${WORD} 数値流体力学 עברית <script>alert(1)</script>`;
const UNIT = "g·mm⁻¹·ms⁻²·K⁻¹ <per> & more";
const NUMBERS = [-1.2345678901234567e-300, 123456789.12345678, 9.876543210987654e299, 0, -0.00012345678912345, 99999999,
  -1.2345678901234567e25, 1e-7, null];
const STATUSES = ["fail", "error", "timeout", "unexpected-pass", "inconclusive", "expected-fail", "pass", "skip"];
/* Texts that a record is judged, found or drawn by, and names, which have their own letters. */
const KEPT = new Set(["kind", "family", "tier", "version", "revision", "better", "script", "script_sha256", "quantity", "main", "cost", "pareto_x", "pareto_y",
  "where", "status", "part", "started", "outcome", "kernels", "figure", "readme"]);
const NAMES = new Set(["case", "variant", "check"]);

/* The words that make a method stay in front; no place where a line could break behind them. */
const longName = (name) => (name + "_" + "W".repeat(LONGEST)).slice(0, LONGEST);

/* `variants` lists names in a comparison and records in a case; `needs` and `tags` are looked up. */
function hostile(value, key) {
  if (Array.isArray(value)) return ["tags", "needs"].includes(key) ? value
    : value.map((entry) => hostile(entry, key === "variants" ? "variant" : key));
  if (value !== null && typeof value === "object")
    return Object.fromEntries(Object.entries(value).map(([name, entry]) => [name, hostile(entry, name)]));
  if (typeof value !== "string" || value === "" || KEPT.has(key)) return value;
  if (NAMES.has(key)) return /^[\w-]+$/.test(value) ? longName(value) : value;
  return key === "unit" ? (value === "1" ? value : UNIT) : value + TEXT;
}

const linesOf = (file) => fs.readFileSync(file, "utf8").trim().split("\n").map((line) => JSON.parse(line));
const write = (file, records) => fs.writeFileSync(file, records.map((record) => JSON.stringify(record)).join("\n") + "\n");
const belongs = (record) => record.case === undefined || CASES.includes(record.case);

function hostileCheck(check, place, shift) {
  const number = (step) => NUMBERS[(place + step + shift) % NUMBERS.length];
  const low = number(1) ?? 0, high = number(2) ?? 1;
  const status = STATUSES[(place + shift) % STATUSES.length], weak = ["expected-fail", "unexpected-pass"].includes(status);
  return { ...hostile(check), value: number(0), expected: number(3), low: Math.min(low, high), high: Math.max(low, high),
    fails_low: weak ? -1.2345678901e-5 : null, fails_high: weak ? 1.2345678901e15 : null, margin: number(4), status };
}

/* `own` is the report's folder: it has pictures too. */
function writeRun(report, folder, shift, own) {
  fs.mkdirSync(folder, { recursive: true });
  const [run, ...checks] = linesOf(path.join(report, "checks.jsonl")).filter(belongs);
  const cases = run.cases.filter(belongs);
  write(path.join(folder, "checks.jsonl"),
    [hostile({ ...run, cases }), ...checks.map((check, place) => hostileCheck(check, place, shift))]);
  const [head, ...measurements] = linesOf(path.join(report, "measurements.jsonl")).filter(belongs);
  write(path.join(folder, "measurements.jsonl"), [head, ...measurements.map(hostile).map((record, place) =>
    place % 3 === shift % 3 ? { ...record, value: NUMBERS[place % NUMBERS.length] } : record)]);
  for (const { case: name, picture } of own ? cases.filter((entry) => entry.picture) : []) {
    const file = path.join(report, "cases", name, `picture-${picture.variant}.json`);
    if (!fs.existsSync(file)) continue;
    const home = path.join(folder, "cases", longName(name)), object = JSON.parse(fs.readFileSync(file, "utf8"));
    fs.mkdirSync(home, { recursive: true });
    object.variant = longName(object.variant);
    for (const body of object.scene.bodies ?? []) body.name += TEXT;
    fs.writeFileSync(path.join(home, `picture-${longName(picture.variant)}.json`), JSON.stringify(object));
  }
  return checks;
}

function mutantOf(place, checks) {
  const check = hostile(checks[place % checks.length]);
  const outcome = ["killed", "survived", "equivalent", "not-built"][place % 4];
  return { name: longName(`mutant-${place}`), room: `room${TEXT}`, outcome, what: `what${TEXT}`, patch: `-old${TEXT}\n+new${TEXT}\n`,
    killed_by: outcome === "killed" ? [`${check.case}/${check.check}/${check.variant}`] : [],
    equivalent: outcome === "equivalent" ? `reason${TEXT}` : "", fault: outcome === "not-built" ? `fault${TEXT}` : "" };
}

function main(report, folder) {
  fs.rmSync(folder, { recursive: true, force: true });
  const checks = writeRun(report, path.join(folder, "report"), 0, true);
  ["before", "build"].forEach((name, place) => writeRun(report, path.join(folder, name), place + 1, false));
  fs.writeFileSync(path.join(folder, "mutants.json"), JSON.stringify({ format: 1, revision: `0123456789ab${TEXT}`,
    mutants: Array.from({ length: 24 }, (_, place) => mutantOf(place, checks)) }));
}

main(...process.argv.slice(2));

/* Pictures of comparisons with numbers that no run of today has: the same places, close and far ones,
 * signs, the times of other machines. Their labels must not overlap whatever the numbers are.
 *
 *     node hostile.js REPORT FOLDER
 *
 * writes to FOLDER a run for each kind of numbers, measurements without checks, and prints their
 * folders, a line each. `mpm-verify report` makes the pictures.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
"use strict";
const fs = require("node:fs");
const path = require("node:path");

/* Numbers from 0 to 1, the same each time. */
function randomOf(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 4294967296;
  };
}

const KINDS = {
  "other-times": (random, value) => value * Math.exp(2 * random() - 1),
  "any": (random) => random(),
  "one-place": () => 0.1234567,
  "few-places": (random) => 0.1 * (1 + Math.floor(3 * random())),
  "close": (random) => 0.123456 * (1 + 1e-4 * random()),
  "closer-than-digits": (random) => 0.123456 * (1 + 1e-12 * random()),
  "corner": (random) => random() < 0.05 ? 0.9 : 0.01 * random(),
  "decades": (random) => 10 ** (-8 * random()),
  "far": (random) => 10 ** (-280 * random()),
  "signs": (random) => 0.5 - random(),
  "zeros": (random) => random() < 0.5 ? 0 : 1e-5 * random(),
};

function main(report, folder) {
  fs.rmSync(folder, { recursive: true, force: true });
  const read = (name) => fs.readFileSync(path.join(report, name), "utf8").trim().split("\n").map((line) => JSON.parse(line));
  const checks = read("checks.jsonl").filter(({ kind }) => kind !== "check"), measurements = read("measurements.jsonl");
  /* A quantity with a limit decides which runs are drawn: it stays as it was measured. */
  const limited = new Set(checks.flatMap(({ cases }) => cases ?? []).flatMap(({ comparison }) => comparison?.columns ?? [])
    .filter(({ limit }) => limit !== undefined).map(({ quantity }) => quantity));
  Object.entries(KINDS).forEach(([name, numberOf], seed) => {
    const own = path.join(folder, name), random = randomOf(seed + 1);
    fs.mkdirSync(own, { recursive: true });
    const write = (file, records) =>
      fs.writeFileSync(path.join(own, file), records.map((record) => JSON.stringify(record)).join("\n") + "\n");
    write("checks.jsonl", checks);
    write("measurements.jsonl", measurements.map((record) =>
      typeof record.value === "number" && !limited.has(record.quantity) ? { ...record, value: numberOf(random, record.value) } : record));
    console.log(own);
  });
}

main(...process.argv.slice(2));

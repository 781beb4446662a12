#!/usr/bin/env python3
"""Prints columns of history.csv or probes.csv; standard Python 3 alone.

    columns.py FILE [--at T,...] [--name PROBE] COLUMN[:TAKE]...

Without TAKE: a table, with the rows at the times of --at (the first row at or after each), or all
of them. With TAKE: one number for each; first, last, min, max, mean and integral (over time, by
the trapezoidal rule).

SPDX-License-Identifier: GPL-3.0-or-later
"""
import argparse
import csv
import sys


def integral(times, values):
    return sum((t1 - t0) * (v0 + v1) / 2
               for t0, t1, v0, v1 in zip(times, times[1:], values, values[1:]))


TAKES = {
    "first": lambda times, values: values[0],
    "last": lambda times, values: values[-1],
    "min": lambda times, values: min(values),
    "max": lambda times, values: max(values),
    "mean": lambda times, values: integral(times, values) / (times[-1] - times[0]),
    "integral": integral,
}


def read(path, name):
    """The units by column, and the rows; of probes.csv those of one probe."""
    with open(path, newline="", encoding="utf-8") as file:
        names = next(csv.reader(file))
        lines = list(csv.reader(file))
    units = {}
    if lines and lines[0][0].startswith("#"):
        units = dict(zip(names, [lines[0][0].lstrip("# ")] + lines[0][1:]))
        del lines[0]
    rows = [dict(zip(names, line)) for line in lines]
    if name is not None:
        rows = [row for row in rows if row.get("name") == name]
    return names, units, rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("file")
    parser.add_argument("columns", nargs="+", metavar="COLUMN[:TAKE]")
    parser.add_argument("--at", help="times, with commas between them")
    parser.add_argument("--name", help="of a probe or line")
    options = parser.parse_args()
    names, units, rows = read(options.file, options.name)
    wanted = [column.partition(":")[::2] for column in options.columns]
    for column, take in wanted:
        if column not in names or (take and take not in TAKES):
            sys.exit(f"{options.file}: no {column}:{take}; allowed: {', '.join(names)}, and "
                     f"{', '.join(TAKES)}")
    if not rows:
        sys.exit(f"{options.file}: no rows of {options.name}")
    times = [float(row["time"]) for row in rows]
    if any(take for _, take in wanted):
        for column, take in wanted:
            value = TAKES[take or "last"](times, [float(row[column]) for row in rows])
            print(f"{column}:{take or 'last'} {value:.6g}")
        return
    print(" ".join(f"{column}/{units[column]}" if units.get(column, "1") not in ("1", "")
                   else column for column, _ in wanted))
    if options.at is not None:
        nearly = 1 - 1e-9
        instants = [next((t for t in times if t >= float(at) * nearly), times[-1])
                    for at in options.at.split(",")]
        rows = [row for row in rows if float(row["time"]) in instants]
    for row in rows:
        print(" ".join(f"{float(row[column]):.6g}" for column, _ in wanted))


if __name__ == "__main__":
    main()

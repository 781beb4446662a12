#!/usr/bin/env python3
# The numbers that the bundle of case E1 requires, from a table of energies over time.
#
#   impact_numbers.py HISTORY.csv RESULTS.csv
#
# HISTORY.csv is what `mpm run` writes: names, a line of units, then a row for each instant. Supports
# that rest do no work, so that kinetic and strain energy add up to the same at all times.
#
# SPDX-License-Identifier: GPL-3.0-or-later
import csv
import sys


def main():
    history, results = sys.argv[1:]
    with open(history, encoding="utf-8") as table:
        rows = list(csv.DictReader(line for line in table if not line.startswith("#")))
    kinetic = [float(row["kinetic_energy"]) for row in rows]
    total = [float(row["strain_energy"]) + k for row, k in zip(rows, kinetic)]
    drift = max(abs(now - total[0]) for now in total) / total[0]
    with open(results, "w", encoding="utf-8") as table:
        print("number,value,unit", file=table)
        print(f"energy_drift,{100 * drift},%", file=table)
        print(f"least_kinetic,{100 * min(kinetic) / total[0]},%", file=table)


main()

#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Draws how time grows, from the tables of goal_alignment_measure. Needs python3-matplotlib.

usage: plots.py CSV… DIR        writes DIR/calls_<kind>_<x>.svg (a line for each family),
                                alignments_<x>.svg and growth_<x>.svg (a line for each phase),
                                those without a point left out
"""
import csv
import os
import sys

AXES = ('objects', 'operators', 'candidates')
FINISHED = {'solved', 'unsolvable', 'plan_found', 'no_plan'}
PHASES = ('total', 'first_question', 'longest_step', 'ground', 'belief', 'conflict_s', 'question_s')


def number(record, name):
    """0 where the record has no such number."""
    try:
        return float(record.get(name) or 0)
    except ValueError:
        return 0.0


def points(records, x, y):
    """(x, y) of the finished records, by rising x; a logarithmic axis shows positive values only."""
    pairs = [(number(r, x), number(r, y)) for r in records if r.get('status') in FINISHED]
    return sorted((a, b) for a, b in pairs if a > 0 and b > 0)


def by_suite(records, kind, x):
    """The whole time, a series for each suite."""
    suites = sorted({r['suite'] for r in records if r['kind'] == kind})
    return {suite: points([r for r in records if r['kind'] == kind and r['suite'] == suite],
                          x, 'total') for suite in suites}


def by_phase(records, x):
    """A series for each phase, of the suite in which x alone grows."""
    own = [r for r in records if r['kind'] == 'align' and r['suite'] == x]
    return {phase: points(own, x, phase) for phase in PHASES}


def plots(records):
    """(file name, title, name of x, series, whether points are joined) of each plot with a point."""
    found = []
    for x in AXES:
        for kind in ('first', 'optimal'):
            found.append((f'calls_{kind}_{x}.svg', f'{kind} plan: time by {x}', x,
                          by_suite(records, kind, x), True))
        found.append((f'alignments_{x}.svg', f'alignment: time by {x}', x,
                      by_suite(records, 'align', x), False))
        found.append((f'growth_{x}.svg', f'alignment: time as only the {x} grow', x,
                      by_phase(records, x), True))
    return [plot for plot in found if any(plot[3].values())]


def draw(plot, folder):
    import matplotlib
    matplotlib.use('svg')
    matplotlib.rcParams['svg.hashsalt'] = 'goal_alignment'  # the same data gives the same file
    matplotlib.rcParams['svg.fonttype'] = 'none'  # texts stay texts
    from matplotlib import pyplot
    name, title, x, series, joined = plot
    figure, axes = pyplot.subplots(figsize=(7.2, 4.4), layout='constrained')
    for label, pairs in series.items():
        if pairs:
            axes.loglog(*zip(*pairs), marker='o', markersize=3, linestyle='-' if joined else 'none',
                        label=label)
    axes.set(title=title, xlabel=x, ylabel='seconds')
    axes.grid(True, alpha=0.3)
    axes.legend(loc='upper left', bbox_to_anchor=(1.02, 1), fontsize='small')
    figure.savefig(os.path.join(folder, name), metadata={'Date': None})
    pyplot.close(figure)


def main(arguments):
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    *tables, folder = arguments
    records = []
    for table in tables:
        with open(table, encoding='utf-8', newline='') as file:
            records += csv.DictReader(file)
    os.makedirs(folder, exist_ok=True)
    for plot in plots(records):
        draw(plot, folder)
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What benchmark/plots.py takes out of the tables; the drawing is matplotlib's."""
import os
import sys
import unittest

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '../../../benchmark'))
import plots  # noqa: E402  (found by the line above)


def record(suite, kind, status, **figures):
    return {'suite': suite, 'kind': kind, 'status': status, **figures}


class Plots(unittest.TestCase):
    RECORDS = [
        record('crates', 'first', 'solved', operators='20', total='2'),
        record('crates', 'first', 'solved', operators='10', total='1'),
        record('crates', 'first', 'limit: time', operators='40', total='60'),
        record('crates', 'first', 'solved', operators='0', total='1'),
        record('lifts', 'first', 'unsolvable', operators='5', total='0.5'),
        record('objects', 'align', 'plan_found', objects='7', total='3', ground='1', belief=''),
    ]

    def test_finished_tasks_are_sorted_and_those_a_logarithm_cannot_show_left_out(self):
        self.assertEqual(plots.by_suite(self.RECORDS, 'first', 'operators'),
                         {'crates': [(10, 1), (20, 2)], 'lifts': [(5, 0.5)]})

    def test_phases_are_of_the_suite_in_which_x_grows(self):
        series = plots.by_phase(self.RECORDS, 'objects')
        self.assertEqual((series['total'], series['ground'], series['belief']),
                         ([(7, 3)], [(7, 1)], []))

    def test_only_plots_with_a_point_are_drawn(self):
        self.assertEqual({plot[0] for plot in plots.plots(self.RECORDS)},
                         {'calls_first_operators.svg', 'alignments_objects.svg',
                          'growth_objects.svg'})


if __name__ == '__main__':
    unittest.main()

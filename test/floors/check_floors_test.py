#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Shows that check_floors.py can fail: each fault it knows is built into a small tree."""
import os
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import check_floors  # noqa: E402


class CheckFloors(unittest.TestCase):
    def faults(self, files):
        with tempfile.TemporaryDirectory() as root:
            for path, text in files.items():
                os.makedirs(os.path.join(root, os.path.dirname(path)), exist_ok=True)
                with open(os.path.join(root, path), 'w', encoding='utf-8') as file:
                    file.write(text)
            return check_floors.faults(root)

    def header(self, folder):
        return f'include/goal_alignment/{folder}/a.h', f'#include "goal_alignment/{folder}/a.h"\n'

    def expect(self, folder, included, words):
        path, include = self.header(included)
        found = self.faults({path: '', f'src/{folder}/b.cpp': '\n' + include})
        self.assertEqual(len(found), 1 if words else 0, found)
        if words:
            self.assertTrue(found[0].startswith(f'src/{folder}/b.cpp:2: '), found)
            self.assertIn(words, found[0])

    def test_going_down_and_staying_is_fine(self):
        self.expect('search', 'task', None)
        self.expect('grounding', 'pddl', None)
        self.expect('grounding', 'task', None)
        self.expect('nodes', 'ros_common', None)
        self.expect('session', 'session', None)

    def test_going_up(self):
        self.expect('task', 'search', 'goes up')
        self.expect('session', 'cli', 'goes up')
        self.expect('common', 'pddl', 'goes up')

    def test_going_sideways(self):
        self.expect('pddl', 'task', 'goes sideways')
        self.expect('phrasing', 'session', 'goes sideways')
        self.expect('grounding', 'heuristics', 'goes sideways')

    def test_narrower_than_the_floors(self):
        self.expect('validation', 'task', "may not know 'task'")
        self.expect('heuristics', 'pddl', "may not know 'pddl'")
        self.expect('rviz_panel', 'session', "may not know 'session'")

    def test_relative_path_is_no_way_out(self):
        found = self.faults({'src/search/private.h': '',
                             'src/task/b.cpp': '#include "../search/private.h"\n'})
        self.assertEqual(len(found), 1)
        self.assertIn('goes up', found[0])

    def test_private_header_of_the_own_folder_is_fine(self):
        self.assertEqual([], self.faults({'src/task/private.h': '',
                                          'src/task/b.cpp': '#include "private.h"\n'}))

    def test_ros_in_the_core(self):
        for header in ('<ros/ros.h>', '<actionlib/server/action_server.h>', '"std_msgs/String.h"',
                       '<catkin/x.h>', '"goal_alignment/Fluent.h"'):
            found = self.faults({'src/session/b.cpp': f'#  include {header}\n'})
            self.assertEqual(len(found), 1, header)
            self.assertIn('the core includes', found[0])

    def test_ros_above_the_core_and_libraries_in_it_are_fine(self):
        self.assertEqual([], self.faults({
            'src/nodes/b.cpp': '#include <ros/ros.h>\n#include "goal_alignment/Fluent.h"\n',
            'src/search/b.cpp': '#include <vector>\n#include <boost/dynamic_bitset.hpp>\n'}))

    def test_circle(self):
        found = self.faults({
            'include/goal_alignment/task/a.h': '#include "goal_alignment/task/b.h"\n',
            'include/goal_alignment/task/b.h': '#include "goal_alignment/task/c.h"\n',
            'include/goal_alignment/task/c.h': '#include "goal_alignment/task/a.h"\n'})
        self.assertEqual(len(found), 1, found)
        self.assertIn('a circle', found[0])

    def test_folder_without_a_floor(self):
        found = self.faults({'src/utils/b.cpp': ''})
        self.assertEqual(len(found), 1)
        self.assertIn("'utils' stands on no floor", found[0])


if __name__ == '__main__':
    unittest.main()

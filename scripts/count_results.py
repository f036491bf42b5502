#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the test cases in JUnit files (gtest, rostest, roslaunch checks).

usage: count_results.py FILE…      prints "PASSED FAILED", the names of failed ones to stderr

rostest writes a file of its own about each test program, rostest-….xml with one case `testNAME`, next
to rosunit-NAME.xml, the cases of that program. The former counts only where it alone tells of a
failure: the program crashed, hung, or never started.
"""
import os
import sys
import xml.etree.ElementTree as ElementTree

ROSTEST = 'rostest.runner.RosTest'


def cases(path):
    """(class, name, whether it passed) of every case that ran."""
    try:
        tree = ElementTree.parse(path)
    except (OSError, ElementTree.ParseError) as error:
        return [(path, f'no test result: {error}', False)]
    return [(case.get('classname'), case.get('name'),
             case.find('failure') is None and case.find('error') is None)
            for case in tree.iter('testcase')
            if case.get('status') != 'notrun' and case.find('skipped') is None]


def main(paths):
    programs_failed = set()  # as rostest names their cases
    about_programs, counted = [], []
    for path in paths:
        for case in cases(path):
            (about_programs if case[0] == ROSTEST else counted).append(case)
            program = os.path.basename(path)
            if program.startswith('rosunit-') and not case[2]:
                programs_failed.add('test' + program[len('rosunit-'):-len('.xml')])
    counted += [case for case in about_programs
                if not case[2] and case[1] not in programs_failed]
    failed = [case for case in counted if not case[2]]
    for classname, name, _ in failed:
        print(f'  failed: {classname}.{name}', file=sys.stderr)
    print(len(counted) - len(failed), len(failed))


if __name__ == '__main__':
    main(sys.argv[1:])

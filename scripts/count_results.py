#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Counts the test cases in JUnit files (gtest, rostest, roslaunch checks).

usage: count_results.py FILE…      prints "PASSED FAILED", the names of failed ones to stderr
"""
import sys
import xml.etree.ElementTree as ElementTree


def count(path):
    try:
        tree = ElementTree.parse(path)
    except (OSError, ElementTree.ParseError) as error:
        print(f'  failed: {path} is no test result: {error}', file=sys.stderr)
        return 0, 1
    passed = failed = 0
    for case in tree.iter('testcase'):
        if case.get('status') == 'notrun' or case.find('skipped') is not None:
            continue
        if case.find('failure') is None and case.find('error') is None:
            passed += 1
        else:
            failed += 1
            print(f"  failed: {case.get('classname')}.{case.get('name')}", file=sys.stderr)
    return passed, failed


def main(paths):
    counts = [count(path) for path in paths]
    print(sum(passed for passed, _ in counts), sum(failed for _, failed in counts))


if __name__ == '__main__':
    main(sys.argv[1:])

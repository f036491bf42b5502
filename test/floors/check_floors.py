#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Holds the house together: fails on an include that goes up or sideways, on a circle, and on a
ROS or catkin header in the core. doc/architecture.md, "Floors", lists the same floors.

usage: check_floors.py [ROOT]        prints file:line: message for each fault, exits with 1
"""
import os
import re
import sys

FLOORS = {
    'common': 0,
    'pddl': 1, 'task': 1,
    'validation': 2, 'grounding': 2, 'heuristics': 2, 'spatial_facts': 2,
    'search': 3,
    'achievability': 4,
    'alignment': 5,
    'questions': 6,
    'session': 7, 'phrasing': 7,
    'cli': 8, 'ros_common': 8, 'any_message': 8,
    'aligner': 9, 'dialogues': 9, 'execution': 9, 'rviz_panel': 9,
    'nodes': 10,
}
CORE_TOP = 7

# Narrower than the floors alone: validation must not share a fault with grounding, heuristics see
# grounded tasks only, and the panel speaks messages.
ONLY = {
    'validation': {'common', 'pddl'},
    'heuristics': {'common', 'task'},
    'spatial_facts': {'common', 'pddl'},
    'rviz_panel': set(),
}

# What the core may use besides the standard library, whose headers have no folder.
CORE_LIBRARIES = {'boost', 'fmt', 'yaml-cpp'}

SOURCE = re.compile(r'\.(h|hpp|cpp|cc|ipp)$')
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def sources(root):
    """(path below root, its folder in FLOORS or an unknown name) of every C++ file."""
    for top in ('include/goal_alignment', 'src'):
        for folder, _, files in os.walk(os.path.join(root, top)):
            inside = os.path.relpath(folder, os.path.join(root, top)).split(os.sep)[0]
            for file in sorted(files):
                if SOURCE.search(file):
                    yield os.path.relpath(os.path.join(folder, file), root), inside


def includes(root, path):
    """(line number, whether in quotes, what) of every include of the file."""
    with open(os.path.join(root, path), encoding='utf-8') as file:
        for number, line in enumerate(file, 1):
            match = INCLUDE.match(line)
            if match:
                yield number, match.group(1) == '"', match.group(2)


def resolve(root, path, quoted, what):
    """The included file below root, or None where it is not one of ours."""
    places = [os.path.join('include', what), os.path.join('src', what)]
    if quoted:
        places.insert(0, os.path.normpath(os.path.join(os.path.dirname(path), what)))
    return next((p for p in places if os.path.isfile(os.path.join(root, p))), None)


def folder_of(path):
    parts = path.split(os.sep)
    return parts[2] if parts[0] == 'include' else parts[1]


def own_include_fault(folder, included):
    """Why a file of `folder` may not include one of folder `included`, or None."""
    if included == folder:
        return None
    if included not in FLOORS:
        return f"'{included}' stands on no floor"
    if folder in ONLY and included not in ONLY[folder]:
        return f"'{folder}' may not know '{included}'"
    if FLOORS[included] > FLOORS[folder]:
        return f"'{folder}' (floor {FLOORS[folder]}) goes up to '{included}' " \
               f"(floor {FLOORS[included]})"
    if FLOORS[included] == FLOORS[folder]:
        return f"'{folder}' goes sideways to '{included}' (both floor {FLOORS[folder]})"
    return None


def foreign_include_fault(folder, quoted, what):
    """Why a file of `folder` may not include a header that is not ours, or None."""
    if FLOORS[folder] > CORE_TOP:
        return None
    library = what.split('/')[0] if '/' in what else None
    if quoted or (library and library not in CORE_LIBRARIES):
        return f"the core includes '{what}', but may use only the standard library, " \
               f"{', '.join(sorted(CORE_LIBRARIES))} and itself"
    return None


def circle(graph):
    """The files of one circle of includes, or an empty list."""
    done, path = set(), []

    def visit(node):
        if node in done:
            return []
        if node in path:
            return path[path.index(node):] + [node]
        path.append(node)
        for neighbour in graph.get(node, []):
            found = visit(neighbour)
            if found:
                return found
        path.pop()
        done.add(node)
        return []

    for start in sorted(graph):
        found = visit(start)
        if found:
            return found
    return []


def faults(root):
    result, graph = [], {}
    for path, folder in sources(root):
        if folder not in FLOORS:
            result.append(f"{path}:1: '{folder}' stands on no floor")
            continue
        for line, quoted, what in includes(root, path):
            target = resolve(root, path, quoted, what)
            if target:
                graph.setdefault(path, []).append(target)
                fault = own_include_fault(folder, folder_of(target))
            else:
                fault = foreign_include_fault(folder, quoted, what)
            if fault:
                result.append(f'{path}:{line}: {fault}')
    round_trip = circle(graph)
    if round_trip:
        result.append(f"{round_trip[0]}:1: a circle: {' -> '.join(round_trip)}")
    return result


def main(arguments):
    here = os.path.dirname(os.path.abspath(__file__))
    root = arguments[0] if arguments else os.path.join(here, '..', '..')
    if not any(sources(root)):
        print(f'{root}: no sources found', file=sys.stderr)
        return 1
    found = faults(root)
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares README.md, section "The ROS interface", and config/goal_alignment.yaml with a running graph."""
import os
import re
import time
import unittest

import rosgraph
import roslib.message
import rospkg
import rospy
import rosservice
import rostest
import yaml
from goal_alignment.msg import AlignmentState, HumanTask, PlanStep
from rosgraph_msgs.msg import Log

PATIENCE = 20  # seconds
ALIGNER = '/goal_alignment'
EXECUTOR = '/simulated_executor'
# What every roscpp node has.
ROSCPP_TOPICS = {'/rosout', '/clock'}
ROSCPP_SERVICES = {'get_loggers', 'set_logger_level'}
ACTION_TOPICS = {'goal': ('sub', 'ActionGoal'), 'cancel': ('sub', None), 'feedback': ('pub', 'ActionFeedback'),
                 'result': ('pub', 'ActionResult'), 'status': ('pub', None)}

PACKAGE = rospkg.RosPack().get_path('goal_alignment')


def text_of(file):
    with open(os.path.join(PACKAGE, file), encoding='utf-8') as stream:
        return stream.read()


def eventually(holds):
    end = time.monotonic() + PATIENCE
    while not holds():
        if time.monotonic() > end:
            return False
        time.sleep(0.01)
    return True


def leading_types(rule):
    """The types that a rule begins with: "Question, AlignmentState, Plan. No node …" has three."""
    types = []
    while True:
        found = re.match(r'\s*((?:[a-z0-9_]+/)?[A-Z]\w+)\s*(,?)', rule)
        if not found:
            return types
        types.append(found.group(1) if '/' in found.group(1) else 'goal_alignment/' + found.group(1))
        if not found.group(2):
            return types
        rule = rule[found.end():]


class Name:
    """A row of README.md's table names one or more of these."""

    def __init__(self, kind, text, later, type_name, node):
        self.kind = kind
        self.name = ALIGNER + '/' + text[1:] if text.startswith('~') else '/' + text.lstrip('/')
        self.later = later
        self.type = type_name
        self.node = node

    def __repr__(self):
        return f'{self.kind} {self.name} ({self.type})'


def documented_names():
    section = re.search(r'^### Topics, services, actions\n(.*?)^###? ', text_of('README.md'), re.M | re.S).group(1)
    names = []
    for row in re.findall(r'^\|(.*)\|$', section, re.M):
        kind, cell, rule = [part.strip() for part in row.split('|', 2)]
        if kind == 'kind' or set(kind) == {'-'}:
            continue
        named = [(text, later) for text, later in re.findall(r'`([^`]+)`( ○)?', cell)]
        types = leading_types(rule)
        if len(types) < len(named):  # what comes later need not have one yet
            given = iter(types)
            types = [None if later else next(given, None) for _, later in named]
        node = EXECUTOR if 'executor' in rule else ALIGNER
        names += [Name(kind.split(',')[0], text, bool(later), types[i], node)
                  for i, (text, later) in enumerate(named)]
    return names


class Graph:
    """What the master knows of a node: its topics and services, with their types."""

    def __init__(self, node):
        master = rosgraph.Master('/documented_names')
        types = dict(master.getTopicTypes())
        publishers, subscribers, services = master.getSystemState()

        def of(entries):
            return {name for name, nodes in entries if node in nodes}

        self.topics = {'pub': {name: types.get(name) for name in of(publishers) - ROSCPP_TOPICS},
                       'sub': {name: types.get(name) for name in of(subscribers) - ROSCPP_TOPICS}}
        self.services = {name: rosservice.get_service_type(name) for name in of(services)
                         if name.rsplit('/', 1)[1] not in ROSCPP_SERVICES}
        self.actions = {name[:-len('/goal')] for name in self.topics['sub'] if name.endswith('/goal')}
        self.clients = {name[:-len('/goal')] for name in self.topics['pub'] if name.endswith('/goal')}
        for client in self.clients:
            for part, (kind, _) in ACTION_TOPICS.items():
                self.topics['sub' if kind == 'pub' else 'pub'].pop(f'{client}/{part}', None)
        self.action_types = {}
        for action in self.actions:
            for part, (kind, _) in ACTION_TOPICS.items():
                self.action_types[f'{action}/{part}'] = self.topics[kind].pop(f'{action}/{part}', None)


class DocumentedNames(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.names = documented_names()
        assert eventually(lambda: {EXECUTOR + '/get_loggers', ALIGNER + '/get_facts'} <= cls.services()), 'no graph'
        assert eventually(lambda: '/execute_plan' in Graph(EXECUTOR).actions), 'no executor'
        cls.graphs = {node: Graph(node) for node in (ALIGNER, EXECUTOR)}

    @staticmethod
    def services():
        return {name for name, _ in rosgraph.Master('/documented_names').getSystemState()[2]}

    def test_the_table_is_read(self):
        self.assertGreater(len(self.names), 15)
        for expected in (ALIGNER + '/answer', '/human_task', '/diagnostics', '/action_dispatch'):
            self.assertIn(expected, [name.name for name in self.names])

    def test_every_documented_name_is_there_with_its_type(self):
        for name in self.names:
            if name.kind == 'client of an action':
                self.assertIn(name.name, self.graphs[name.node].clients)
            if name.later or name.kind.startswith('client'):  # the master does not know clients
                continue
            graph = self.graphs[name.node]
            with self.subTest(name=name):
                self.assertIsNotNone(name.type, 'README.md gives no type')
                if name.kind == 'action':
                    self.assertIn(name.name, graph.actions)
                    for part, (_, suffix) in ACTION_TOPICS.items():
                        if suffix:
                            self.assertEqual(graph.action_types[f'{name.name}/{part}'], name.type + suffix)
                else:
                    there = graph.services if name.kind == 'srv' else graph.topics[name.kind]
                    self.assertEqual(there.get(name.name), name.type)

    def test_what_is_marked_as_coming_later_is_not_there(self):
        for name in self.names:
            graph = self.graphs[name.node]
            if name.later:
                with self.subTest(name=name):
                    self.assertNotIn(name.name, {**graph.services, **graph.topics['pub'], **graph.topics['sub']})

    def test_every_name_that_is_there_is_documented(self):
        for node, graph in self.graphs.items():
            known = {(name.kind, name.name) for name in self.names if name.node == node}
            there = {('srv', name) for name in graph.services} | {('action', name) for name in graph.actions}
            there |= {('client of an action', name) for name in graph.clients}
            there |= {(kind, name) for kind, topics in graph.topics.items() for name in topics}
            self.assertEqual(there - known, set(), f'names of {node} that README.md does not know')

    def test_every_documented_type_can_be_loaded(self):
        for name in self.names:
            if name.type is None:
                continue
            with self.subTest(name=name):
                if name.kind in ('srv', 'client'):
                    self.assertIsNotNone(roslib.message.get_service_class(name.type))
                else:
                    suffix = 'Action' if 'action' in name.kind else ''
                    self.assertIsNotNone(roslib.message.get_message_class(name.type + suffix))


class DocumentedParameters(unittest.TestCase):
    """goal_alignment.launch has set every parameter of config/goal_alignment.yaml and those of the models."""

    @classmethod
    def setUpClass(cls):
        cls.warnings = []
        cls.states = []
        cls.log = rospy.Subscriber('/rosout', Log, cls.hear)
        cls.state = rospy.Subscriber(ALIGNER + '/state', AlignmentState, cls.states.append)
        cls.tasks = rospy.Publisher('/human_task', HumanTask, queue_size=10)
        assert eventually(lambda: cls.tasks.get_num_connections() > 0)
        assert eventually(lambda: cls.states)

    @classmethod
    def hear(cls, line):
        if line.name == ALIGNER and 'unknown parameter' in line.msg:
            cls.warnings.append(line.msg)

    def align(self, task_id):
        self.tasks.publish(HumanTask(task_id=task_id, plan=[PlanStep(name='sweep', args=['hall'])]))

        def ends():
            return [s for s in self.states if s.task_id == task_id and s.phase == AlignmentState.DONE]
        # Also after a plan that the executor may be about to begin.
        self.assertTrue(eventually(ends))
        self.assertEqual(ends()[0].outcome, 1, ends()[0].message)

    @staticmethod
    def configured():
        keys = set(yaml.safe_load(text_of('config/goal_alignment.yaml')))
        return keys | set(re.findall(r'<param name="(\w+)" type="str" value="\$\(arg \1\)"/>',
                                     text_of('launch/goal_alignment.launch').split('</node>')[0]))

    def test_every_configured_parameter_is_read(self):
        # roslaunch sets no struct that is empty.
        empty = {key for key, value in yaml.safe_load(text_of('config/goal_alignment.yaml')).items() if value == {}}
        self.assertEqual(set(rospy.get_param(ALIGNER)), self.configured() - empty)
        # A warning that must come shows that the others would have come; the log may reach us late.
        for attempt in range(100):
            rospy.set_param(f'{ALIGNER}/nobody_reads_this_{attempt}', 1)
            self.align(str(attempt))
            if self.warnings:
                break
        self.assertTrue(eventually(lambda: self.warnings))
        for attempt in range(100):
            if rospy.has_param(f'{ALIGNER}/nobody_reads_this_{attempt}'):
                rospy.delete_param(f'{ALIGNER}/nobody_reads_this_{attempt}')
        for warning in self.warnings:
            self.assertIn('nobody_reads_this', warning)

    def test_every_parameter_that_is_read_is_configured(self):
        source = text_of('src/aligner/node_options.cpp')
        read = set(re.findall(r'\.read(?:Choice)?\(\s*"(\w+)"', source))
        self.assertEqual(read, self.configured())


def all_tests():
    """Of both classes; rostest takes one name."""
    load = unittest.defaultTestLoader.loadTestsFromTestCase
    return unittest.TestSuite([load(DocumentedNames), load(DocumentedParameters)])


if __name__ == '__main__':
    rospy.init_node('documented_names')
    rostest.rosrun('goal_alignment', 'documented_names', '__main__.all_tests')

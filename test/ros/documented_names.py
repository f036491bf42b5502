#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Compares doc/interface.md, the names on all other pages, and the files in config/ with a running graph and the source."""
import glob
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


class Name:
    """A row of one of doc/interface.md's tables of names."""

    def __init__(self, kind, text, type_name, node):
        self.kind = kind
        self.name = f'{node or "/dialogue"}/{text[1:]}' if text.startswith('~') else '/' + text.lstrip('/')
        self.type = type_name if '/' in type_name else 'goal_alignment/' + type_name
        self.node = node

    def __repr__(self):
        return f'{self.kind} {self.name} ({self.type})'


# Headings of doc/interface.md, and the node of the graph whose names stand below each.
SECTIONS = {'goal_alignment_node': ALIGNER, 'plan_executor and simulated_executor': EXECUTOR, 'Dialogue nodes': None}


def section_of(page, heading):
    return re.search(f'^### {heading}\n(.*?)^##', page, re.M | re.S).group(1)


def documented_names():
    page = text_of('doc/interface.md')
    names = []
    for heading, node in SECTIONS.items():
        for row in re.findall(r'^\|(.*)\|$', section_of(page, heading), re.M):
            kind, name, type_name, _ = [part.strip() for part in row.split('|', 3)]
            if kind == 'kind' or set(kind) == {'-'}:
                continue
            type_name = re.sub(r'^\[(\w+)\]\(#\w+\)$', r'\1', type_name)
            names.append(Name(kind.split(',')[0], re.fullmatch(r'`([^`]+)`', name).group(1), type_name, node))
    return names


def documented_parameters(heading):
    """The first column of all tables below the heading."""
    rows = re.findall(r'^\| ((?:`\w+` ?)+)\|', section_of(text_of('doc/interface.md'), heading), re.M)
    return {name for row in rows for name in re.findall(r'`(\w+)`', row)}


def pages():
    files = [os.path.join(PACKAGE, 'README.md'), *glob.glob(os.path.join(PACKAGE, 'doc', '*.md'))]
    return {os.path.relpath(file, PACKAGE): text_of(file) for file in files}


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
            if name.node is None:  # a dialogue, which does not run here
                continue
            if name.kind == 'client of an action':
                self.assertIn(name.name, self.graphs[name.node].clients)
            if name.kind.startswith('client'):  # the master does not know clients
                continue
            graph = self.graphs[name.node]
            with self.subTest(name=name):
                if name.kind == 'action':
                    self.assertIn(name.name, graph.actions)
                    for part, (_, suffix) in ACTION_TOPICS.items():
                        if suffix:
                            self.assertEqual(graph.action_types[f'{name.name}/{part}'], name.type + suffix)
                else:
                    there = graph.services if name.kind == 'srv' else graph.topics[name.kind]
                    self.assertEqual(there.get(name.name), name.type)

    def test_every_name_that_is_there_is_documented(self):
        for node, graph in self.graphs.items():
            known = {(name.kind, name.name) for name in self.names if name.node == node}
            there = {('srv', name) for name in graph.services} | {('action', name) for name in graph.actions}
            there |= {('client of an action', name) for name in graph.clients}
            there |= {(kind, name) for kind, topics in graph.topics.items() for name in topics}
            self.assertEqual(there - known, set(), f'names of {node} that doc/interface.md does not know')

    def test_every_documented_type_can_be_loaded(self):
        for name in self.names:
            with self.subTest(name=name):
                if name.kind in ('srv', 'client'):
                    self.assertIsNotNone(roslib.message.get_service_class(name.type))
                else:
                    suffix = 'Action' if 'action' in name.kind else ''
                    self.assertIsNotNone(roslib.message.get_message_class(name.type + suffix))

    def test_names_on_every_page_are_in_the_reference(self):
        known = {name.name.rsplit('/', 1)[1] for name in self.names}
        checked = 0
        for page, text in pages().items():
            # `~answer`, `~align/cancel`, and /goal_alignment/answer in commands
            for name in re.findall(r'`~([a-z_]+)', text) + re.findall(r'[\s`]/goal_alignment/([a-z_]+)', text):
                checked += 1
                with self.subTest(page=page, name=name):
                    self.assertIn(name, known | ROSCPP_SERVICES)
        self.assertGreater(checked, 50)


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

    @staticmethod
    def read_in(file):
        return set(re.findall(r'\.read(?:Choice|Texts)?\(\s*"(\w+)"', text_of(file)))

    def test_every_parameter_that_is_read_is_configured(self):
        self.assertEqual(self.read_in('src/aligner/node_options.cpp'), self.configured())

    def test_files_with_the_parameters_of_other_nodes_are_complete(self):
        for file, source in (('config/plan_executor.yaml', 'src/execution/executor_options.cpp'),
                             ('config/speech_dialogue.yaml', 'src/dialogues/speech_options.cpp')):
            with self.subTest(file=file):
                self.assertEqual(set(yaml.safe_load(text_of(file))), self.read_in(source))

    def test_every_parameter_is_documented(self):
        self.assertEqual(documented_parameters('Parameters of goal_alignment_node'), self.configured())
        for heading, file in (('Parameters of the executors', 'config/plan_executor.yaml'),
                              ('Parameters of the dialogue nodes', 'config/speech_dialogue.yaml')):
            self.assertEqual(documented_parameters(heading), set(yaml.safe_load(text_of(file))))

    def test_former_names_stand_in_the_reference_alone(self):
        former = r'\b(?:(?:tf|servers?|facts|cancel)_patience|hidden_(?:not_)?wanted)\b|--hidden-'
        for page, text in pages().items():
            if page != 'doc/interface.md':
                with self.subTest(page=page):
                    self.assertIsNone(re.search(former, text))


def all_tests():
    """Of both classes; rostest takes one name."""
    load = unittest.defaultTestLoader.loadTestsFromTestCase
    return unittest.TestSuite([load(DocumentedNames), load(DocumentedParameters)])


if __name__ == '__main__':
    rospy.init_node('documented_names')
    rostest.rosrun('goal_alignment', 'documented_names', '__main__.all_tests')

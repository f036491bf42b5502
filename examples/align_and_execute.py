#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Sends a task, leaves the questions to a dialogue node, and has the plan executed.

usage: align_and_execute.py "(served tea)" "(boil kettle)" "(serve tea)"      the goal, then the person's plan
"""
import sys

import actionlib
import rospy
from goal_alignment.msg import (AlignAction, AlignGoal, AlignResult, ExecutePlanAction, ExecutePlanGoal,
                                ExecutePlanResult, Fluent, HumanTask, PlanStep)


def result_of(name, action, goal):
    client = actionlib.SimpleActionClient(name, action)
    client.wait_for_server()
    rospy.on_shutdown(lambda: client.get_result() or client.cancel_goal())
    client.send_goal_and_wait(goal)
    return client.get_result()


rospy.init_node('align_and_execute', anonymous=True)
words = [text.strip('() ').split() for text in rospy.myargv(sys.argv)[1:]]
if not all(words):
    sys.exit(__doc__)
task = HumanTask(goal=[Fluent(name=name, args=args) for name, *args in words[:1]],
                 plan=[PlanStep(name=name, args=args) for name, *args in words[1:]])
# A bare AlignGoal() has max_questions 0: nobody would be asked anything.
aligned = result_of('goal_alignment/align', AlignAction, AlignGoal(task=task, max_questions=-1))
if aligned.outcome != AlignResult.SUCCESS:
    sys.exit(aligned.message)
executed = result_of('execute_plan', ExecutePlanAction, ExecutePlanGoal(plan=aligned.plan))
sys.exit(0 if executed.outcome == ExecutePlanResult.SUCCESS else executed.reason)

#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A robot that is none: move_base, a tray and a door, which always succeed, and tf of where it is.

usage: fake_robot.py       then plan_executor with config/domains/ward/robot_execution.yaml
"""
import actionlib
import rospy
from geometry_msgs.msg import Quaternion, TransformStamped, Vector3
from move_base_msgs.msg import MoveBaseAction
from std_srvs.srv import SetBool, Trigger
from tf2_msgs.msg import TFMessage

rospy.init_node('fake_robot')
base = TransformStamped(child_frame_id='base_link')
base.header.frame_id = 'map'
base.transform.rotation = Quaternion(w=1.0)
tf = rospy.Publisher('/tf', TFMessage, queue_size=10)


def show(_event):
    base.header.stamp = rospy.Time.now()
    tf.publish([base])


def go(goal):
    rospy.sleep(1.0)
    place = goal.target_pose.pose
    base.transform.translation = Vector3(place.position.x, place.position.y, place.position.z)
    base.transform.rotation = place.orientation
    move_base.set_succeeded()


move_base = actionlib.SimpleActionServer('move_base', MoveBaseAction, execute_cb=go, auto_start=False)
move_base.start()
rospy.Service('/doors/fire_door/open', SetBool, lambda request: (True, 'open'))
rospy.Service('/tray/load', Trigger, lambda request: (True, 'loaded'))
rospy.Service('/tray/unload', Trigger, lambda request: (True, 'unloaded'))
rospy.Timer(rospy.Duration(0.1), show)
rospy.spin()

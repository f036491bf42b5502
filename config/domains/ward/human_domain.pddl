; SPDX-License-Identifier: BSD-3-Clause
; What people on the ward believe of the robot: it carries as much as one likes, its battery is no
; concern of theirs, and doors are open.
(define (domain ward)
  (:requirements :strips :typing)
  (:types place thing)
  (:predicates
    (robot-at ?p - place)
    (thing-at ?t - thing ?p - place)
    (on-tray ?t - thing))

  (:action go
    :parameters (?from ?to - place)
    :precondition (robot-at ?from)
    :effect (and (not (robot-at ?from)) (robot-at ?to)))

  (:action load
    :parameters (?t - thing ?p - place)
    :precondition (and (robot-at ?p) (thing-at ?t ?p))
    :effect (and (not (thing-at ?t ?p)) (on-tray ?t)))

  (:action unload
    :parameters (?t - thing ?p - place)
    :precondition (and (robot-at ?p) (on-tray ?t))
    :effect (and (not (on-tray ?t)) (thing-at ?t ?p))))

; SPDX-License-Identifier: BSD-3-Clause
; What the delivery robot can do in the hospital: its tray takes one thing, a fire door may be shut, and
; every journey costs it a part of what its battery still holds.
(define (domain ward)
  (:requirements :adl)
  (:types place thing charge door)
  (:constants c0 - charge)                ; the empty battery
  (:predicates
    (robot-at ?p - place)
    (thing-at ?t - thing ?p - place)
    (on-tray ?t - thing)
    (tray-empty)
    (shut ?d - door)
    (leads ?d - door ?p - place)          ; the way to ?p goes through ?d
    (battery ?c - charge)
    (less ?low ?high - charge))           ; by one journey

  (:action go
    :parameters (?from ?to - place)
    :precondition (and (robot-at ?from) (not (battery c0))
                       (forall (?d - door) (imply (leads ?d ?to) (not (shut ?d)))))
    :effect (and (not (robot-at ?from)) (robot-at ?to)
                 (forall (?before ?after - charge)
                   (when (and (battery ?before) (less ?after ?before))
                         (and (not (battery ?before)) (battery ?after))))))

  (:action open-door
    :parameters (?d - door)
    :precondition (shut ?d)
    :effect (not (shut ?d)))

  (:action load
    :parameters (?t - thing ?p - place)
    :precondition (and (robot-at ?p) (thing-at ?t ?p) (tray-empty))
    :effect (and (not (thing-at ?t ?p)) (not (tray-empty)) (on-tray ?t)))

  (:action unload
    :parameters (?t - thing ?p - place)
    :precondition (and (robot-at ?p) (on-tray ?t))
    :effect (and (not (on-tray ?t)) (tray-empty) (thing-at ?t ?p))))

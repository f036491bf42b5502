; SPDX-License-Identifier: BSD-3-Clause
; What the robot can do in the kitchen. It carries a ladder but can't climb one: the human's model
; has climb-up, climb-down and take-from-high-shelf, this one has a grabber instead, of which the
; human knows nothing. Its battery lasts for one more reach.
(define (domain tea)
  (:requirements :strips :typing :equality :negative-preconditions)
  (:types place thing - object
          leaves cup water grabber - thing)
  (:constants cupboard counter sink table - place
              the-kettle - thing
              the-grabber - grabber)
  (:predicates
    (robot-at ?p - place)
    (plenty-of ?t - thing ?p - place)     ; there is always one more
    (on-high-shelf ?t - thing)            ; of the cupboard
    (holding ?t - thing)
    (dusty ?c - cup)
    (ladder-at ?p - place)
    (kettle-at ?p - place)
    (kettle-empty)
    (kettle-filled-with ?w - water)
    (kettle-hot)
    (pot-clean)
    (tea-in-pot)
    (tea-in-cup ?c - cup)
    (made-with ?l - leaves)
    (brewed-with ?w - water)
    (served-in ?c - cup)
    (tea-served)
    (drawer-open)
    (grabber-in-drawer ?g - grabber)
    (grabber-charged ?g - grabber))

  (:action go
    :parameters (?from ?to - place)
    :precondition (and (robot-at ?from) (not (= ?from ?to)))
    :effect (and (not (robot-at ?from)) (robot-at ?to)))

  (:action carry-ladder
    :parameters (?from ?to - place)
    :precondition (and (robot-at ?from) (ladder-at ?from) (not (= ?from ?to)))
    :effect (and (not (robot-at ?from)) (robot-at ?to)
                 (not (ladder-at ?from)) (ladder-at ?to)))

  (:action take-kettle
    :parameters (?p - place)
    :precondition (and (robot-at ?p) (kettle-at ?p))
    :effect (and (not (kettle-at ?p)) (holding the-kettle)))

  (:action put-kettle
    :parameters (?p - place)
    :precondition (and (robot-at ?p) (holding the-kettle))
    :effect (and (not (holding the-kettle)) (kettle-at ?p)))

  (:action take-one
    :parameters (?t - thing ?p - place)
    :precondition (and (robot-at ?p) (plenty-of ?t ?p))
    :effect (holding ?t))

  (:action open-drawer
    :parameters ()
    :precondition (and (robot-at counter) (not (drawer-open)))
    :effect (drawer-open))

  (:action take-from-drawer
    :parameters (?g - grabber)
    :precondition (and (robot-at counter) (drawer-open) (grabber-in-drawer ?g))
    :effect (and (not (grabber-in-drawer ?g)) (holding ?g)))

  (:action reach-with-grabber
    :parameters (?t - thing ?g - grabber)
    :precondition (and (robot-at cupboard) (on-high-shelf ?t) (holding ?g) (grabber-charged ?g))
    :effect (and (not (on-high-shelf ?t)) (holding ?t) (not (grabber-charged ?g))))

  (:action wipe
    :parameters (?c - cup)
    :precondition (and (holding ?c) (dusty ?c))
    :effect (not (dusty ?c)))

  (:action fill-kettle
    :parameters (?w - water ?p - place)
    :precondition (and (robot-at ?p) (plenty-of ?w ?p) (holding the-kettle) (kettle-empty))
    :effect (and (not (kettle-empty)) (kettle-filled-with ?w) (not (kettle-hot))))

  ; The kettle boils on its base, which stands on the counter.
  (:action boil-kettle
    :parameters ()
    :precondition (and (robot-at counter) (kettle-at counter) (not (kettle-empty)))
    :effect (kettle-hot))

  (:action brew
    :parameters (?l - leaves ?w - water)
    :precondition (and (robot-at counter) (kettle-at counter) (holding ?l)
                       (kettle-filled-with ?w) (kettle-hot) (pot-clean))
    :effect (and (not (holding ?l)) (not (kettle-filled-with ?w)) (kettle-empty)
                 (not (pot-clean)) (tea-in-pot) (made-with ?l) (brewed-with ?w)))

  (:action pour
    :parameters (?c - cup)
    :precondition (and (robot-at counter) (holding ?c) (not (dusty ?c)) (tea-in-pot))
    :effect (and (not (tea-in-pot)) (tea-in-cup ?c)))

  (:action serve
    :parameters (?c - cup)
    :precondition (and (robot-at table) (holding ?c) (tea-in-cup ?c))
    :effect (and (not (holding ?c)) (not (tea-in-cup ?c)) (served-in ?c) (tea-served))))

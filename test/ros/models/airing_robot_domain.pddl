; SPDX-License-Identifier: BSD-3-Clause
; To air a room takes the robot three steps more than to sweep it.
(define (domain tidy)
  (:requirements :strips)
  (:predicates (room ?r) (clean ?r) (quiet ?r) (aired ?r) (unlocked ?r) (opened ?r))
  (:action sweep
    :parameters (?r)
    :precondition (room ?r)
    :effect (clean ?r))
  (:action unlock
    :parameters (?r)
    :precondition (room ?r)
    :effect (unlocked ?r))
  (:action open
    :parameters (?r)
    :precondition (unlocked ?r)
    :effect (opened ?r))
  (:action air
    :parameters (?r)
    :precondition (opened ?r)
    :effect (aired ?r)))

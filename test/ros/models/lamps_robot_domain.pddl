; SPDX-License-Identifier: BSD-3-Clause
; The robot knows that the circuit feeds one lamp of a pair.
(define (domain lamps)
  (:requirements :strips)
  (:predicates (pair ?l ?m) (lit ?l) (checked))
  (:action light
    :parameters (?l ?m)
    :precondition (pair ?l ?m)
    :effect (and (lit ?l) (not (lit ?m))))
  (:action check
    :parameters ()
    :effect (checked)))

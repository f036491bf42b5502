; SPDX-License-Identifier: BSD-3-Clause
; The person believes that all lamps can be lit.
(define (domain lamps)
  (:requirements :strips)
  (:predicates (pair ?l ?m) (lit ?l) (checked))
  (:action light
    :parameters (?l ?m)
    :precondition (pair ?l ?m)
    :effect (lit ?l))
  (:action check
    :parameters ()
    :effect (checked)))

; SPDX-License-Identifier: BSD-3-Clause
; The fault is at 6:3, where a parenthesis of the predicates is missing.
(define (domain tidy)
  (:requirements :strips)
  (:predicates (room ?r) (clean ?r) (quiet ?r)
  (:action sweep
    :parameters (?r)
    :precondition (room ?r)
    :effect (clean ?r)))

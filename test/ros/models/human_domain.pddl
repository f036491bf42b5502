; SPDX-License-Identifier: BSD-3-Clause
; The person believes that sweeping is silent.
(define (domain tidy)
  (:requirements :strips)
  (:predicates (room ?r) (clean ?r) (quiet ?r))
  (:action sweep
    :parameters (?r)
    :precondition (room ?r)
    :effect (clean ?r)))

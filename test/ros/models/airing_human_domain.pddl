; SPDX-License-Identifier: BSD-3-Clause
; The person believes that who sweeps a room airs it.
(define (domain tidy)
  (:requirements :strips)
  (:predicates (room ?r) (clean ?r) (quiet ?r) (aired ?r))
  (:action sweep
    :parameters (?r)
    :precondition (room ?r)
    :effect (and (clean ?r) (aired ?r))))

; SPDX-License-Identifier: BSD-3-Clause
; The robot knows that it makes a noise.
(define (domain tidy)
  (:requirements :strips)
  (:predicates (room ?r) (clean ?r) (quiet ?r))
  (:action sweep
    :parameters (?r)
    :precondition (room ?r)
    :effect (and (clean ?r) (not (quiet ?r)))))

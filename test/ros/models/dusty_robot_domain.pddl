; SPDX-License-Identifier: BSD-3-Clause
; Sweeping raises dust, of which the person's model knows nothing.
(define (domain tidy)
  (:requirements :strips)
  (:predicates (room ?r) (clean ?r) (quiet ?r) (dusty ?r))
  (:action sweep
    :parameters (?r)
    :precondition (room ?r)
    :effect (and (clean ?r) (dusty ?r))))

; SPDX-License-Identifier: BSD-3-Clause
; A robot that can only make a noise.
(define (domain tidy)
  (:requirements :strips)
  (:predicates (room ?r) (clean ?r) (quiet ?r))
  (:action hum
    :parameters (?r)
    :precondition (room ?r)
    :effect (not (quiet ?r))))

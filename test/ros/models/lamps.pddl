; SPDX-License-Identifier: BSD-3-Clause
; Two pairs of lamps, and a task that has nothing to do with them.
(define (problem lamps)
  (:domain lamps)
  (:objects a1 a2 b1 b2)
  (:init (pair a1 a2) (pair a2 a1) (pair b1 b2) (pair b2 b1))
  (:goal (checked)))

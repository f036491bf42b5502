; SPDX-License-Identifier: BSD-3-Clause
; Enough charge for four journeys; charging takes all night.
(define (problem evening-round)
  (:domain ward)
  (:objects dock pharmacy kitchen bedside - place
            medicine soup - thing
            fire-door - door
            c1 c2 c3 c4 - charge)
  (:init (robot-at dock) (tray-empty)
         (thing-at medicine pharmacy) (thing-at soup kitchen)
         (shut fire-door) (leads fire-door bedside)
         (battery c4) (less c0 c1) (less c1 c2) (less c2 c3) (less c3 c4))
  (:goal (thing-at medicine bedside)))

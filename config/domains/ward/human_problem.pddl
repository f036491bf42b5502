; SPDX-License-Identifier: BSD-3-Clause
; How things are for the person who asks.
(define (problem evening-round)
  (:domain ward)
  (:objects dock pharmacy kitchen bedside - place
            medicine soup - thing)
  (:init (robot-at dock) (thing-at medicine pharmacy) (thing-at soup kitchen))
  (:goal (thing-at medicine bedside)))

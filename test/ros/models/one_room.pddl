; SPDX-License-Identifier: BSD-3-Clause
(define (problem one-room)
  (:domain tidy)
  (:objects hall)
  (:init (room hall) (quiet hall))
  (:goal (clean hall)))

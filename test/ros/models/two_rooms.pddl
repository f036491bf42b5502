; SPDX-License-Identifier: BSD-3-Clause
(define (problem two-rooms)
  (:domain tidy)
  (:objects hall kitchen)
  (:init (room hall) (room kitchen) (quiet hall) (quiet kitchen))
  (:goal (and (clean hall) (clean kitchen))))

; SPDX-License-Identifier: BSD-3-Clause
(define (problem errand)
  (:domain errand)
  (:objects hall corridor study)
  (:init (at hall) (path hall corridor) (path corridor hall) (path corridor study)
         (path study corridor) (lawn hall study) (lawn study hall) (letter-at hall)
         (office study) (quiet study) (lawn-whole))
  (:goal (delivered)))

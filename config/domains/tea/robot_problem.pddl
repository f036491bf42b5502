; SPDX-License-Identifier: BSD-3-Clause
; The kitchen as it is: the kettle is empty and the jug of filtered water has run dry.
(define (problem cup-of-tea)
  (:domain tea)
  (:objects back-door - place
            good-leaves stale-leaves - leaves
            china-cup mug - cup
            filtered-water tap-water - water)
  (:init
    (robot-at counter)
    (ladder-at back-door)
    (on-high-shelf good-leaves)
    (on-high-shelf china-cup)
    (dusty china-cup)
    (plenty-of stale-leaves cupboard)
    (plenty-of mug counter)
    (plenty-of tap-water sink)
    (kettle-at counter)
    (kettle-empty)
    (pot-clean)
    (grabber-in-drawer the-grabber)
    (grabber-charged the-grabber))
  (:goal (tea-served)))

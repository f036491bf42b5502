; SPDX-License-Identifier: BSD-3-Clause
; The home as it is: the china cup is in the dishwasher, unwashed, and the honey on the sideboard;
; somebody has taken the newspaper into the dining room, and the reading glasses and the car
; keys upstairs.
(define (problem afternoon-tea)
  (:domain home)
  (:objects kitchen dining-room living-room hall landing bedroom - room
            kitchen-door living-door dining-door sliding-door bedroom-door - door
            worktop - counter
            kitchen-sink - sink
            the-hob - hob
            low-cupboard top-cupboard - container
            the-dishwasher - dishwasher
            dining-table sideboard coffee-table hall-table bedside-table - surface
            china-cup mug - cup
            the-kettle - kettle
            green-tea black-tea - tea
            honey sugar - sweetener
            newspaper reading-glasses car-keys - keepsake
            grace - person)
  (:init
    (connects kitchen-door hall kitchen) (connects kitchen-door kitchen hall)
    (connects living-door hall living-room) (connects living-door living-room hall)
    (connects dining-door kitchen dining-room) (connects dining-door dining-room kitchen)
    (connects sliding-door dining-room living-room) (connects sliding-door living-room dining-room)
    (connects bedroom-door landing bedroom) (connects bedroom-door bedroom landing)
    (stairs hall landing) (stairs landing hall)
    (place-in worktop kitchen) (place-in kitchen-sink kitchen) (place-in the-hob kitchen)
    (place-in low-cupboard kitchen) (place-in top-cupboard kitchen)
    (place-in the-dishwasher kitchen) (place-in dining-table dining-room)
    (place-in sideboard dining-room) (place-in coffee-table living-room) (place-in hall-table hall)
    (place-in bedside-table bedroom)
    (high top-cupboard) (ladder-in kitchen)
    (door-open kitchen-door) (door-open living-door) (door-open dining-door)
    (door-open sliding-door) (door-open bedroom-door)
    (shut low-cupboard) (shut top-cupboard) (shut the-dishwasher)
    (robot-in kitchen) (gripper-free)
    (person-in grace living-room) (awake grace)
    (on the-kettle the-hob) (on green-tea worktop) (in black-tea low-cupboard)
    (in mug low-cupboard) (clean mug) (in sugar top-cupboard)
    (in china-cup the-dishwasher) (on honey sideboard) (on newspaper dining-table)
    (on reading-glasses bedside-table) (on car-keys bedside-table))
  (:goal (has-tea grace)))

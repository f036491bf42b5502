; SPDX-License-Identifier: BSD-3-Clause
; The home as it is. The robot can't climb the stairs, but Grace comes down when it rings the bell.
(define (problem evening-tablets)
  (:domain home)
  (:objects kitchen hall living-room landing bedroom - room
            kitchen-door living-door bedroom-door - door
            worktop - counter
            kitchen-sink - sink
            kitchen-drawer medicine-cupboard - container
            hall-table coffee-table bedside-table - surface
            tablets eye-drops - medicine
            cupboard-key - key
            water-glass - dish
            plasters reading-glasses newspaper - keepsake
            grace - person)
  (:init
    (connects kitchen-door hall kitchen) (connects kitchen-door kitchen hall)
    (connects living-door hall living-room) (connects living-door living-room hall)
    (connects bedroom-door landing bedroom) (connects bedroom-door bedroom landing)
    (stairs hall landing) (stairs landing hall)
    (place-in worktop kitchen) (place-in kitchen-sink kitchen) (place-in kitchen-drawer kitchen)
    (place-in hall-table hall) (place-in medicine-cupboard hall)
    (place-in coffee-table living-room) (place-in bedside-table bedroom)
    (ladder-in kitchen)
    (door-open kitchen-door) (door-open living-door) (door-open bedroom-door)
    (shut kitchen-drawer) (shut medicine-cupboard)
    (locked medicine-cupboard) (key-of cupboard-key medicine-cupboard)
    (robot-in kitchen) (gripper-free)
    (person-in grace bedroom) (awake grace)
    (on water-glass worktop) (clean water-glass) (in cupboard-key kitchen-drawer)
    (in tablets medicine-cupboard) (in eye-drops medicine-cupboard) (in plasters medicine-cupboard)
    (on reading-glasses bedside-table) (on newspaper coffee-table)
    (bell-in hall))
  (:goal (measured-out tablets)))

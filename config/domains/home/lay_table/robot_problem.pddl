; SPDX-License-Identifier: BSD-3-Clause
; The kitchen before supper, as it is. The dining room door may jam; there is a way round.
(define (problem lay-table)
  (:domain home)
  (:objects kitchen dining-room living-room hall - room
            kitchen-door living-door dining-door sliding-door - door
            worktop - counter
            kitchen-drawer low-cupboard top-cupboard - container
            dining-table sideboard coffee-table hall-table - surface
            plain-plates crystal-glasses tumblers fruit-bowl - dish
            cutlery napkins candlestick newspaper - keepsake
            grace - person)
  (:init
    (connects kitchen-door hall kitchen) (connects kitchen-door kitchen hall)
    (connects living-door hall living-room) (connects living-door living-room hall)
    (connects dining-door kitchen dining-room) (connects dining-door dining-room kitchen)
    (connects sliding-door dining-room living-room) (connects sliding-door living-room dining-room)
    (place-in worktop kitchen) (place-in kitchen-drawer kitchen) (place-in low-cupboard kitchen)
    (place-in top-cupboard kitchen) (place-in dining-table dining-room)
    (place-in sideboard dining-room) (place-in coffee-table living-room) (place-in hall-table hall)
    (high top-cupboard) (ladder-in kitchen)
    (door-open kitchen-door) (door-open living-door) (door-open sliding-door)
    (shut kitchen-drawer) (shut low-cupboard) (shut top-cupboard)
    (robot-in kitchen) (gripper-free)
    (person-in grace living-room) (awake grace)
    (in cutlery kitchen-drawer) (in plain-plates low-cupboard) (in tumblers low-cupboard)
    (in crystal-glasses top-cupboard) (on napkins worktop) (on candlestick sideboard)
    (on fruit-bowl sideboard) (on newspaper coffee-table)
    (clean plain-plates) (clean crystal-glasses) (clean tumblers) (clean fruit-bowl))
  (:goal (and (on plain-plates dining-table) (on cutlery dining-table))))

; SPDX-License-Identifier: BSD-3-Clause
; The table after supper, as Ada sees it.
(define (problem clear-table)
  (:domain home)
  (:objects kitchen dining-room living-room hall - room
            kitchen-door living-door dining-door sliding-door - door
            worktop - counter
            kitchen-sink - sink
            low-cupboard - container
            the-dishwasher - dishwasher
            dining-table sideboard coffee-table bookshelf hall-table - surface
            soup-plate dinner-plate salad-bowl side-plate wine-glass - dish
            napkins candlestick fruit-bowl newspaper - keepsake
            grace - person)
  (:init
    (connects kitchen-door hall kitchen) (connects kitchen-door kitchen hall)
    (connects living-door hall living-room) (connects living-door living-room hall)
    (connects dining-door kitchen dining-room) (connects dining-door dining-room kitchen)
    (connects sliding-door dining-room living-room) (connects sliding-door living-room dining-room)
    (place-in worktop kitchen) (place-in kitchen-sink kitchen) (place-in low-cupboard kitchen)
    (place-in the-dishwasher kitchen) (place-in dining-table dining-room)
    (place-in sideboard dining-room) (place-in coffee-table living-room)
    (place-in bookshelf living-room) (place-in hall-table hall)
    (ladder-in kitchen)
    (door-open kitchen-door) (door-open sliding-door)
    (shut low-cupboard) (shut the-dishwasher)
    (robot-in living-room) (gripper-free)
    (person-in grace living-room) (awake grace)
    (on soup-plate dining-table) (on dinner-plate dining-table) (on salad-bowl dining-table)
    (on napkins dining-table) (on candlestick dining-table) (on fruit-bowl sideboard)
    (on newspaper coffee-table) (in side-plate low-cupboard) (in wine-glass low-cupboard)
    (clean side-plate) (clean wine-glass))
  (:goal (and (clean soup-plate) (clean dinner-plate) (clean salad-bowl))))

; SPDX-License-Identifier: BSD-3-Clause
; The living room at nap time, as Ada sees it.
(define (problem nap-time)
  (:domain home)
  (:objects kitchen utility-room hall living-room landing nursery - room
            kitchen-door living-door utility-door nursery-door - door
            worktop - counter
            low-cupboard toy-box - container
            utility-shelf hall-table rug bookshelf coffee-table - surface
            the-vacuum - vacuum
            the-broom - broom
            teddy picture-book building-blocks newspaper car-keys - keepsake
            leo grace - person)
  (:init
    (connects kitchen-door hall kitchen) (connects kitchen-door kitchen hall)
    (connects living-door hall living-room) (connects living-door living-room hall)
    (connects utility-door kitchen utility-room) (connects utility-door utility-room kitchen)
    (connects nursery-door landing nursery) (connects nursery-door nursery landing)
    (stairs hall landing) (stairs landing hall)
    (place-in worktop kitchen) (place-in low-cupboard kitchen)
    (place-in utility-shelf utility-room) (place-in hall-table hall) (place-in rug living-room)
    (place-in bookshelf living-room) (place-in coffee-table living-room)
    (place-in toy-box living-room)
    (ladder-in utility-room)
    (door-open kitchen-door) (door-open utility-door) (door-open nursery-door)
    (shut low-cupboard) (shut toy-box)
    (robot-in kitchen) (gripper-free)
    (person-in leo nursery) (person-in grace living-room) (awake grace)
    (on the-vacuum utility-shelf) (on the-broom utility-shelf) (on teddy rug) (on picture-book rug)
    (on building-blocks rug) (on newspaper coffee-table) (on car-keys hall-table))
  (:goal (floor-clean living-room)))

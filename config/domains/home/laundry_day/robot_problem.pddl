; SPDX-License-Identifier: BSD-3-Clause
; The utility room as it is: the clothes horse has room for two things more.
(define (problem laundry-day)
  (:domain home)
  (:objects hall kitchen utility-room - room
            kitchen-door utility-door - door
            hall-table utility-shelf - surface
            worktop - counter
            low-cupboard laundry-basket - container
            the-washing-machine - washing-machine
            bed-sheet school-shirt sports-shirt towel tablecloth - garment
            the-vacuum - vacuum
            the-broom - broom
            car-keys newspaper - keepsake
            ben - person
            clothes-horse - rack
            two-pegs one-peg no-peg - count)
  (:init
    (connects kitchen-door hall kitchen) (connects kitchen-door kitchen hall)
    (connects utility-door kitchen utility-room) (connects utility-door utility-room kitchen)
    (place-in hall-table hall) (place-in worktop kitchen) (place-in low-cupboard kitchen)
    (place-in utility-shelf utility-room) (place-in laundry-basket utility-room)
    (place-in the-washing-machine utility-room)
    (ladder-in utility-room)
    (door-open kitchen-door)
    (shut low-cupboard) (shut the-washing-machine)
    (rack-in clothes-horse utility-room)
    (robot-in hall) (gripper-free)
    (person-in ben hall) (awake ben)
    (in bed-sheet laundry-basket) (in school-shirt laundry-basket) (in sports-shirt laundry-basket)
    (in towel laundry-basket) (in tablecloth laundry-basket) (on the-vacuum utility-shelf)
    (on the-broom utility-shelf) (on car-keys hall-table) (on newspaper worktop)
    (one-more two-pegs one-peg) (one-more one-peg no-peg) (pegs-free clothes-horse two-pegs))
  (:goal (and (washed bed-sheet) (hung bed-sheet clothes-horse))))

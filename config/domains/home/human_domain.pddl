; SPDX-License-Identifier: BSD-3-Clause
; What the people of the home believe the robot can do: carry as much as it likes, reach every
; shelf, climb the stairs, and vacuum without waking anybody.
(define (domain home)
  (:requirements :adl)
  (:types room door place rack item person - object
          surface container - place
          counter sink hob - surface
          dishwasher washing-machine - container
          dish garment medicine tea sweetener kettle key tool keepsake - item
          cup - dish
          vacuum broom - tool)
  (:predicates
    ; the home
    (connects ?d - door ?a ?b - room)
    (stairs ?a ?b - room)
    (place-in ?p - place ?r - room)
    (rack-in ?k - rack ?r - room)
    (key-of ?k - key ?c - container)
    (high ?p - place)                    ; nothing that a ladder would not mend
    ; where things are
    (robot-in ?r - room)
    (ladder-in ?r - room)
    (on-ladder)
    (person-in ?p - person ?r - room)
    (on ?i - item ?p - surface)
    (in ?i - item ?c - container)
    (holding ?i - item)
    (gripper-free)                       ; always, they think
    (given ?i - item ?p - person)
    (hung ?l - garment ?k - rack)
    ; how things are
    (door-open ?d - door)
    (shut ?c - container)
    (locked ?c - container)
    (clean ?d - dish)
    (washed ?l - garment)
    (floor-clean ?r - room)
    (carpet-clean ?r - room)
    (awake ?p - person)
    (measured-out ?m - medicine)
    (taken ?m - medicine ?p - person)
    (filled ?k - kettle)
    (hot ?k - kettle)
    (tea-in ?c - cup ?t - tea)
    (sweetened-with ?c - cup ?s - sweetener)
    (has-tea ?p - person))

  ; Getting about.
  (:action go
    :parameters (?d - door ?from ?to - room)
    :precondition (and (robot-in ?from) (connects ?d ?from ?to) (door-open ?d) (not (on-ladder)))
    :effect (and (not (robot-in ?from)) (robot-in ?to)))

  (:action climb-stairs
    :parameters (?from ?to - room)
    :precondition (and (robot-in ?from) (stairs ?from ?to) (not (on-ladder)))
    :effect (and (not (robot-in ?from)) (robot-in ?to)))

  (:action carry-ladder
    :parameters (?d - door ?from ?to - room)
    :precondition (and (robot-in ?from) (ladder-in ?from) (connects ?d ?from ?to) (door-open ?d)
                       (not (on-ladder)))
    :effect (and (not (robot-in ?from)) (robot-in ?to) (not (ladder-in ?from)) (ladder-in ?to)))

  (:action climb-ladder
    :parameters (?r - room)
    :precondition (and (robot-in ?r) (ladder-in ?r) (not (on-ladder)))
    :effect (on-ladder))

  (:action leave-ladder
    :parameters ()
    :precondition (on-ladder)
    :effect (not (on-ladder)))

  (:action open-door
    :parameters (?d - door ?here ?there - room)
    :precondition (and (robot-in ?here) (connects ?d ?here ?there) (not (door-open ?d)))
    :effect (door-open ?d))

  (:action close-door
    :parameters (?d - door ?here ?there - room)
    :precondition (and (robot-in ?here) (connects ?d ?here ?there) (door-open ?d))
    :effect (not (door-open ?d)))

  ; Containers.
  (:action unlock
    :parameters (?c - container ?k - key ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (locked ?c) (key-of ?k ?c) (holding ?k))
    :effect (not (locked ?c)))

  (:action lock
    :parameters (?c - container ?k - key ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (shut ?c) (not (locked ?c)) (key-of ?k ?c)
                       (holding ?k))
    :effect (locked ?c))

  (:action open
    :parameters (?c - container ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (or (not (high ?c)) (on-ladder)) (shut ?c)
                       (not (locked ?c)))
    :effect (not (shut ?c)))

  (:action shut-up
    :parameters (?c - container ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (or (not (high ?c)) (on-ladder))
                       (not (shut ?c)))
    :effect (shut ?c))

  ; Things: as many at a time as there are.
  (:action take
    :parameters (?i - item ?p - surface ?r - room)
    :precondition (and (robot-in ?r) (place-in ?p ?r) (or (not (high ?p)) (on-ladder)) (on ?i ?p))
    :effect (and (not (on ?i ?p)) (holding ?i)))

  (:action take-out
    :parameters (?i - item ?c - container ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (or (not (high ?c)) (on-ladder)) (in ?i ?c)
                       (not (shut ?c)))
    :effect (and (not (in ?i ?c)) (holding ?i)))

  (:action put
    :parameters (?i - item ?p - surface ?r - room)
    :precondition (and (robot-in ?r) (place-in ?p ?r) (or (not (high ?p)) (on-ladder)) (holding ?i))
    :effect (and (not (holding ?i)) (on ?i ?p)))

  (:action put-in
    :parameters (?i - item ?c - container ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (or (not (high ?c)) (on-ladder)) (holding ?i)
                       (not (shut ?c)))
    :effect (and (not (holding ?i)) (in ?i ?c)))

  (:action hand-over
    :parameters (?i - item ?p - person ?r - room)
    :precondition (and (robot-in ?r) (person-in ?p ?r) (awake ?p) (holding ?i))
    :effect (and (not (holding ?i)) (given ?i ?p)))

  ; Dishes and laundry.
  (:action wash-up
    :parameters (?d - dish ?s - sink ?r - room)
    :precondition (and (robot-in ?r) (place-in ?s ?r) (holding ?d))
    :effect (clean ?d))

  (:action run-dishwasher
    :parameters (?c - dishwasher ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (shut ?c))
    :effect (forall (?d - dish) (when (in ?d ?c) (clean ?d))))

  (:action run-washing-machine
    :parameters (?c - washing-machine ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (shut ?c))
    :effect (forall (?l - garment) (when (in ?l ?c) (washed ?l))))

  (:action hang-up
    :parameters (?l - garment ?k - rack ?r - room)
    :precondition (and (robot-in ?r) (rack-in ?k ?r) (holding ?l) (washed ?l))
    :effect (and (not (holding ?l)) (hung ?l ?k)))

  ; Floors.
  (:action vacuum
    :parameters (?r - room ?v - vacuum)
    :precondition (and (robot-in ?r) (holding ?v))
    :effect (and (floor-clean ?r) (carpet-clean ?r)))

  (:action sweep
    :parameters (?r - room ?b - broom)
    :precondition (and (robot-in ?r) (holding ?b))
    :effect (floor-clean ?r))

  ; Medicine.
  (:action measure-out
    :parameters (?m - medicine)
    :precondition (holding ?m)
    :effect (measured-out ?m))

  (:action give-medicine
    :parameters (?m - medicine ?p - person ?r - room)
    :precondition (and (robot-in ?r) (person-in ?p ?r) (awake ?p) (holding ?m) (measured-out ?m))
    :effect (taken ?m ?p))

  ; Tea.
  (:action fill-kettle
    :parameters (?k - kettle ?s - sink ?r - room)
    :precondition (and (robot-in ?r) (place-in ?s ?r) (holding ?k))
    :effect (filled ?k))

  (:action boil
    :parameters (?k - kettle ?h - hob ?r - room)
    :precondition (and (robot-in ?r) (place-in ?h ?r) (on ?k ?h) (filled ?k))
    :effect (hot ?k))

  (:action brew
    :parameters (?t - tea ?c - cup ?p - counter ?k - kettle ?h - hob ?r - room)
    :precondition (and (robot-in ?r) (place-in ?h ?r) (on ?k ?h) (hot ?k) (place-in ?p ?r)
                       (on ?c ?p) (clean ?c) (holding ?t))
    :effect (and (tea-in ?c ?t) (not (clean ?c)) (not (filled ?k))))

  (:action sweeten
    :parameters (?c - cup ?t - tea ?s - sweetener ?p - surface ?r - room)
    :precondition (and (robot-in ?r) (place-in ?p ?r) (on ?c ?p) (tea-in ?c ?t) (holding ?s))
    :effect (sweetened-with ?c ?s))

  (:action serve
    :parameters (?c - cup ?t - tea ?p - person ?r - room)
    :precondition (and (robot-in ?r) (person-in ?p ?r) (awake ?p) (holding ?c) (tea-in ?c ?t))
    :effect (and (not (holding ?c)) (given ?c ?p) (has-tea ?p))))

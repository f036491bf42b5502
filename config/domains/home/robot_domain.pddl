; SPDX-License-Identifier: BSD-3-Clause
; What the robot can do in the home. It has one gripper, reaches neither the top shelves nor up the
; stairs, and has no use for a ladder. It knows what the people forget: that a vacuum cleaner wakes
; whoever sleeps, that the clothes horse has only so many pegs, and that a door may jam.
(define (domain home)
  (:requirements :adl)
  (:types room door place rack count item person - object
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
    (high ?p - place)                    ; out of the reach of the robot's arm
    (ladder-in ?r - room)                ; of no use to it
    (one-more ?many ?few - count)
    (bell-in ?r - room)
    ; where things are
    (robot-in ?r - room)
    (person-in ?p - person ?r - room)
    (on ?i - item ?p - surface)
    (in ?i - item ?c - container)
    (holding ?i - item)
    (gripper-free)
    (given ?i - item ?p - person)
    (hung ?l - garment ?k - rack)
    (pegs-free ?k - rack ?n - count)
    ; how things are
    (door-open ?d - door)
    (jammed ?d - door)
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
    :precondition (and (robot-in ?from) (connects ?d ?from ?to) (door-open ?d))
    :effect (and (not (robot-in ?from)) (robot-in ?to)))

  (:action open-door
    :parameters (?d - door ?here ?there - room)
    :precondition (and (robot-in ?here) (connects ?d ?here ?there) (not (door-open ?d))
                       (not (jammed ?d)) (gripper-free))
    :effect (door-open ?d))

  (:action close-door
    :parameters (?d - door ?here ?there - room)
    :precondition (and (robot-in ?here) (connects ?d ?here ?there) (door-open ?d)
                       (not (jammed ?d)) (gripper-free))
    :effect (not (door-open ?d)))

  ; Containers.
  (:action unlock
    :parameters (?c - container ?k - key ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (not (high ?c)) (locked ?c) (key-of ?k ?c)
                       (holding ?k))
    :effect (not (locked ?c)))

  (:action lock
    :parameters (?c - container ?k - key ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (not (high ?c)) (shut ?c) (not (locked ?c))
                       (key-of ?k ?c) (holding ?k))
    :effect (locked ?c))

  (:action open
    :parameters (?c - container ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (not (high ?c)) (shut ?c) (not (locked ?c))
                       (gripper-free))
    :effect (not (shut ?c)))

  (:action shut-up
    :parameters (?c - container ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (not (high ?c)) (not (shut ?c))
                       (gripper-free))
    :effect (shut ?c))

  ; Things: one at a time.
  (:action take
    :parameters (?i - item ?p - surface ?r - room)
    :precondition (and (robot-in ?r) (place-in ?p ?r) (not (high ?p)) (on ?i ?p) (gripper-free))
    :effect (and (not (on ?i ?p)) (holding ?i) (not (gripper-free))))

  (:action take-out
    :parameters (?i - item ?c - container ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (not (high ?c)) (in ?i ?c) (not (shut ?c))
                       (gripper-free))
    :effect (and (not (in ?i ?c)) (holding ?i) (not (gripper-free))))

  (:action put
    :parameters (?i - item ?p - surface ?r - room)
    :precondition (and (robot-in ?r) (place-in ?p ?r) (not (high ?p)) (holding ?i))
    :effect (and (not (holding ?i)) (on ?i ?p) (gripper-free)))

  (:action put-in
    :parameters (?i - item ?c - container ?r - room)
    :precondition (and (robot-in ?r) (place-in ?c ?r) (not (high ?c)) (holding ?i)
                       (not (shut ?c)))
    :effect (and (not (holding ?i)) (in ?i ?c) (gripper-free)))

  (:action hand-over
    :parameters (?i - item ?p - person ?r - room)
    :precondition (and (robot-in ?r) (person-in ?p ?r) (awake ?p) (holding ?i))
    :effect (and (not (holding ?i)) (given ?i ?p) (gripper-free)))

  ; Grace comes down when the bell rings. It can't help her up again.
  (:action ring-for
    :parameters (?p - person ?there ?landing ?here - room)
    :precondition (and (robot-in ?here) (bell-in ?here) (person-in ?p ?there) (awake ?p)
                       (stairs ?landing ?here) (gripper-free)
                       (exists (?d - door) (connects ?d ?there ?landing)))
    :effect (and (not (person-in ?p ?there)) (person-in ?p ?here)))

  ; Dishes and laundry.
  (:action wash-up
    :parameters (?d - dish ?s - sink ?r - room)
    :precondition (and (robot-in ?r) (place-in ?s ?r) (not (high ?s)) (holding ?d))
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
    :parameters (?l - garment ?k - rack ?n ?left - count ?r - room)
    :precondition (and (robot-in ?r) (rack-in ?k ?r) (pegs-free ?k ?n) (one-more ?n ?left)
                       (holding ?l) (washed ?l))
    :effect (and (not (holding ?l)) (gripper-free) (hung ?l ?k) (not (pegs-free ?k ?n))
                 (pegs-free ?k ?left)))

  (:action take-down
    :parameters (?l - garment ?k - rack ?n ?then - count ?r - room)
    :precondition (and (robot-in ?r) (rack-in ?k ?r) (pegs-free ?k ?n) (one-more ?then ?n)
                       (hung ?l ?k) (gripper-free))
    :effect (and (holding ?l) (not (gripper-free)) (not (hung ?l ?k)) (not (pegs-free ?k ?n))
                 (pegs-free ?k ?then)))

  ; Floors.
  (:action vacuum
    :parameters (?r - room ?v - vacuum)
    :precondition (and (robot-in ?r) (holding ?v))
    :effect (and (floor-clean ?r) (carpet-clean ?r) (forall (?p - person) (awake ?p))))

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
    :precondition (and (robot-in ?r) (place-in ?s ?r) (not (high ?s)) (holding ?k))
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
    :effect (and (not (holding ?c)) (gripper-free) (given ?c ?p) (has-tea ?p))))

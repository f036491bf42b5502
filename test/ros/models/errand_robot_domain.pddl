; SPDX-License-Identifier: BSD-3-Clause
; A letter is brought to the office: through the corridor, or over the lawn, which suffers. The robot
; knows that it makes a noise there, and that ways may be blocked, of which the person has no idea.
(define (domain errand)
  (:requirements :strips :negative-preconditions)
  (:predicates (at ?r) (path ?a ?b) (blocked ?a ?b) (lawn ?a ?b) (letter-at ?r) (has-letter) (office ?r)
               (delivered) (quiet ?r) (lawn-whole))
  (:action go
    :parameters (?from ?to)
    :precondition (and (at ?from) (path ?from ?to) (not (blocked ?from ?to)))
    :effect (and (at ?to) (not (at ?from))))
  (:action cross
    :parameters (?from ?to)
    :precondition (and (at ?from) (lawn ?from ?to))
    :effect (and (at ?to) (not (at ?from)) (not (lawn-whole))))
  (:action fetch
    :parameters (?room)
    :precondition (and (at ?room) (letter-at ?room))
    :effect (and (has-letter) (not (letter-at ?room))))
  (:action deliver
    :parameters (?room)
    :precondition (and (at ?room) (office ?room) (has-letter))
    :effect (and (delivered) (not (has-letter)) (not (quiet ?room)))))

// SPDX-License-Identifier: BSD-3-Clause
#include "home.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "drawing.h"
#include "families.h"
#include "goal_alignment/pddl/source_position.h"

namespace goal_alignment::benchmarks {
namespace {

DomainParts homeDomain(const std::string& side) {
  DomainParts domain;
  domain.name = "home";
  domain.whole = pddl::readFile(GOAL_ALIGNMENT_DOMAINS "/home/" + side + "_domain.pddl").text;
  return domain;
}

constexpr const char* kDishwasher = "the-dishwasher";
constexpr const char* kMachine = "the-washing-machine";
constexpr const char* kCupboard = "the-cupboard";
constexpr const char* kTopCupboard = "the-top-cupboard";
constexpr const char* kRack = "the-clothes-horse";

struct Room {
  std::string name;
  int floor;
  std::string door;  // to the floor's landing; empty: this is the landing
};

struct Place {
  std::string name;
  std::size_t room;
  bool container;
};

// A thing that lies about, where it is and where the person believes it to be.
struct Thing {
  std::string name;
  bool garment;
  std::size_t place;
  std::size_t believed;
};

// Draws the home and what is so in it.
class Drawing {
 public:
  Drawing(int size, RandomSource& random) : random_(random) {
    drawRooms(size < 4 ? 1 : 2 + size / 64, 2 + size / 12);
    furnish();
    drawThings(size);
  }

  // What both models say.
  ProblemParts shared() const { return problem_; }
  const std::vector<Room>& rooms() const { return rooms_; }
  const std::vector<Place>& places() const { return places_; }
  const std::vector<Thing>& things() const { return things_; }
  std::size_t kitchen() const { return kitchen_; }
  std::size_t utility() const { return utility_; }
  bool isShut(const std::string& name) const { return shut_.count(name) > 0; }
  bool isOpen(const std::string& door) const { return open_doors_.count(door) > 0; }

  bool robotGetsAt(const Thing& thing) const {
    const Place& place = places_[thing.place];
    return rooms_[place.room].floor == 0 && place.name != kTopCupboard;
  }

 private:
  void add(const std::string& name, const std::string& type) {
    problem_.objects.push_back({name, type});
  }
  void say(std::initializer_list<std::string_view> words) { problem_.init.push_back(atom(words)); }

  void drawRooms(int floors, int a_floor) {
    for (int floor = 0; floor < floors; ++floor) {
      const std::string landing = numbered("landing", floor);
      rooms_.push_back({landing, floor, ""});
      add(landing, "room");
      if (floor > 0) {
        const std::string below = numbered("landing", floor - 1);
        say({"stairs", below, landing});
        say({"stairs", landing, below});
      }
      for (int i = 0; i < a_floor; ++i)
        drawRoom(floor, landing);
    }
    kitchen_ = 1;
    utility_ = 2;
  }

  void drawRoom(int floor, const std::string& landing) {
    const int number = static_cast<int>(rooms_.size());
    const Room room = {numbered("room", number), floor, numbered("door", number)};
    rooms_.push_back(room);
    add(room.name, "room");
    add(room.door, "door");
    say({"connects", room.door, landing, room.name});
    say({"connects", room.door, room.name, landing});
    if (random_.below(3) == 0) return;
    say({"door-open", room.door});
    open_doors_.insert(room.door);
  }

  void addPlace(const std::string& name, const std::string& type, std::size_t room, bool shut) {
    places_.push_back({name, room, type != "surface" && type != "counter"});
    addFixture(name, type, room);
    if (!shut) return;
    say({"shut", name});
    shut_.insert(name);
  }

  void addFixture(const std::string& name, const std::string& type, std::size_t room) {
    add(name, type);
    say({"place-in", name, rooms_[room].name});
  }

  void furnish() {
    for (std::size_t room = 0; room < rooms_.size(); ++room) {
      const int number = static_cast<int>(room);
      addPlace(numbered("table", number), "surface", room, false);
      if (random_.below(2) == 0)
        addPlace(numbered("chest", number), "container", room, random_.below(2) == 0);
    }
    addPlace("the-worktop", "counter", kitchen_, false);
    addPlace(kTopCupboard, "container", kitchen_, true);
    say({"high", kTopCupboard});
    say({"ladder-in", rooms_[kitchen_].name});
    // Nothing lies about in these.
    addFixture("the-sink", "sink", kitchen_);
    for (const auto& [name, type, room] : {std::tuple{kCupboard, "container", kitchen_},
                                           std::tuple{kDishwasher, "dishwasher", kitchen_},
                                           std::tuple{kMachine, "washing-machine", utility_}}) {
      addFixture(name, type, room);
      say({"shut", name});
      shut_.insert(name);
    }
    add(kRack, "rack");
    say({"rack-in", kRack, rooms_[utility_].name});
    say({"robot-in", rooms_.front().name});
    say({"gripper-free"});
  }

  void drawThings(int size) {
    for (int i = 0; i < size; ++i) {
      const bool garment = i % 2 == 1;
      Thing thing = {numbered(garment ? "garment" : "dish", i), garment, 0, 0};
      do {
        thing.place = random_.below(places_.size());
      } while (i < 2 && !robotGetsAt(thing));  // something is to be done
      const bool wrong = !garment && random_.below(5) == 0;
      thing.believed = wrong ? random_.below(places_.size()) : thing.place;
      things_.push_back(thing);
      add(things_.back().name, garment ? "garment" : "dish");
    }
  }

  RandomSource& random_;
  ProblemParts problem_;
  std::vector<Room> rooms_;
  std::vector<Place> places_;  // where things may lie about
  std::vector<Thing> things_;
  std::set<std::string> shut_;
  std::set<std::string> open_doors_;
  std::size_t kitchen_ = 0;
  std::size_t utility_ = 0;
};

// Plans as the person would: gather everything, wash it, put it away.
class PersonsPlan {
 public:
  explicit PersonsPlan(const Drawing& home) : home_(home) {
    treat(false, kDishwasher, "run-dishwasher", home.kitchen());
    treat(true, kMachine, "run-washing-machine", home.utility());
  }
  std::vector<GroundName> steps() { return std::move(steps_); }

 private:
  void act(const std::string& name, const std::vector<std::string>& arguments) {
    steps_.push_back({name, arguments});
  }
  const Room& room() const { return home_.rooms()[room_]; }

  std::size_t landingOf(int floor) const {
    const auto& rooms = home_.rooms();
    return static_cast<std::size_t>(
        std::find_if(rooms.begin(), rooms.end(),
                     [&](const Room& room) { return room.floor == floor && room.door.empty(); }) -
        rooms.begin());
  }

  void pass(const std::string& door, std::size_t to) {
    const std::string& there = home_.rooms()[to].name;
    if (!home_.isOpen(door) && opened_.insert(door).second)
      act("open-door", {door, room().name, there});
    act("go", {door, room().name, there});
    room_ = to;
  }

  void goTo(std::size_t target) {
    if (room_ == target) return;
    const Room& there = home_.rooms()[target];
    if (!room().door.empty()) pass(room().door, landingOf(room().floor));
    while (room().floor != there.floor) {
      const std::size_t next = landingOf(room().floor + (room().floor < there.floor ? 1 : -1));
      act("climb-stairs", {room().name, home_.rooms()[next].name});
      room_ = next;
    }
    if (room_ != target) pass(there.door, target);
  }

  void open(const std::string& container) {
    if (home_.isShut(container) && opened_.insert(container).second)
      act("open", {container, room().name});
  }

  void gather(const Thing& thing) {
    const Place& place = home_.places()[thing.believed];
    goTo(place.room);
    const bool high = place.name == kTopCupboard;
    if (high) act("climb-ladder", {room().name});
    if (place.container) open(place.name);
    act(place.container ? "take-out" : "take", {thing.name, place.name, room().name});
    if (high) act("leave-ladder", {});
  }

  void treat(bool garments, const std::string& machine, const std::string& run, std::size_t where) {
    std::vector<std::string> names;
    for (const Thing& thing : home_.things()) {
      if (thing.garment != garments) continue;
      gather(thing);
      names.push_back(thing.name);
    }
    if (names.empty()) return;
    goTo(where);
    open(machine);
    for (const std::string& name : names)
      act("put-in", {name, machine, room().name});
    act("shut-up", {machine, room().name});
    act(run, {machine, room().name});
    act("open", {machine, room().name});
    if (!garments) open(kCupboard);
    for (const std::string& name : names) {
      act("take-out", {name, machine, room().name});
      if (garments) act("hang-up", {name, kRack, room().name});
      if (!garments) act("put-in", {name, kCupboard, room().name});
    }
  }

  const Drawing& home_;
  std::vector<GroundName> steps_;
  std::size_t room_ = 0;
  std::set<std::string> opened_;
};

std::string lying(const Thing& thing, const Place& place) {
  return atom({place.container ? "in" : "on", thing.name, place.name});
}

// As many pegs as there is laundry.
void addPegs(int garments, ProblemParts& problem) {
  const auto counts = problem.addObjects("count", garments + 1, "count");
  for (std::size_t i = 1; i < counts.size(); ++i)
    problem.init.push_back(atom({"one-more", counts[i], counts[i - 1]}));
  problem.init.push_back(atom({"pegs-free", kRack, counts.back()}));
}

}  // namespace

Home drawnHome(int size, RandomSource& random) {
  const Drawing drawing(size, random);
  Home home = {{homeDomain("robot"), drawing.shared()},
               {homeDomain("human"), drawing.shared()},
               PersonsPlan(drawing).steps()};
  for (const Thing& thing : drawing.things()) {
    home.robot.problem.init.push_back(lying(thing, drawing.places()[thing.place]));
    home.human.problem.init.push_back(lying(thing, drawing.places()[thing.believed]));
    if (!drawing.robotGetsAt(thing)) continue;
    std::vector<std::string>& goal = home.robot.problem.goal;
    goal.push_back(atom({thing.garment ? "washed" : "clean", thing.name}));
    goal.push_back(thing.garment ? atom({"hung", thing.name, kRack})
                                 : atom({"in", thing.name, kCupboard}));
  }
  home.human.problem.goal = home.robot.problem.goal;
  addPegs(size / 2, home.robot.problem);
  return home;
}

Models home(int size, RandomSource& random) {
  return drawnHome(size, random).robot;
}

}  // namespace goal_alignment::benchmarks

// SPDX-License-Identifier: MIT
#include "question.hpp"

#include <algorithm>
#include <utility>

#include "answer.hpp"

namespace stickslip_check {
namespace {

[[noreturn]] void refuse(const std::string& part, const std::string& problem) {
  throw Malformed{"the question", part, problem};
}

/// FORMAT.md §14, many coordinates.
[[noreturn]] void refuse_many(std::size_t dimension) {
  refuse("bodies", "found " + std::to_string(dimension) +
                       " coordinates of bodies and joints; expected at most " +
                       std::to_string(kMostCoordinates) +
                       ", but in a question of statics or the verdict about one grasp");
}

/// FORMAT.md §1: as many numbers as the grasp has.
void check_dimension(const Grasp& grasp, const Options& options) {
  const auto check = [&](const std::optional<Vector>& vector, const char* part) {
    if (!vector || vector->size() == grasp.dimension()) return;
    refuse(part, "found " + std::to_string(vector->size()) + " numbers, expected " +
                     std::to_string(grasp.dimension()) +
                     (grasp.several      ? ", one for each coordinate of its bodies and joints"
                      : grasp.in_space() ? ", as the grasp is in space"
                                         : ", as the grasp is planar"));
  };
  check(options.wrench, "wrench");
  check(options.direction, "direction");
  if (options.plane) {
    check((*options.plane)[0], "plane");
    check((*options.plane)[1], "plane");
  }
  const std::size_t dimension = grasp.dimension();
  if (grasp.several && !options.statics && dimension > kMostCoordinates &&
      (options.margin() || !options.uncertain.empty())) {
    refuse_many(dimension);
  }
  if (options.statics) return;
  if (grasp.several && (options.plane || options.inertia)) {
    refuse(options.plane ? "plane" : "inertia",
           "the grasp is of several bodies; expected a question about a wrench or a direction");
  }
  if (options.plane && grasp.in_space()) {
    refuse("plane", "the grasp is in space; a region is about a planar grasp");
  }
}

/// w: that of the options, or of the case that they name, or the file's unless a direction asks
/// about others.
Wrench wrench_asked(const Grasp& grasp, const Options& options) {
  if (options.wrench && options.case_name) {
    refuse("case", "a wrench is given as well; expected one of them");
  }
  if (options.wrench) return {options.wrench->begin(), options.wrench->end()};
  if (options.case_name) {
    const auto found = grasp.cases.find(*options.case_name);
    if (found != grasp.cases.end()) return found->second;
    refuse("case", "the grasp has no case " + quote(*options.case_name));
  }
  if (options.direction || options.plane) return Wrench(grasp.dimension());
  const bool may_be_none = grasp.several && grasp.several->has_loads;
  if (!grasp.cases.empty() && !may_be_none) {
    refuse("case", "the grasp has " + std::to_string(grasp.cases.size()) +
                       " cases, and none is chosen; expected the name of one, such as " +
                       quote(grasp.cases.begin()->first));
  }
  return grasp.wrench;
}

/// Of what is asked about many loads.
std::string kind_of(const Options& asked) {
  return asked.states    ? "the set of states"
         : asked.robustness ? "a robustness"
         : asked.statics ? "statics"
         : asked.plane   ? "a region"
         : asked.inertia ? "a class"
                         : "a margin";
}

/// The plane of a region has two directions that differ, and nothing else grows.
void check_plane(const Options& options) {
  if (!options.plane) return;
  if (options.margin()) refuse("plane", "a direction is given as well; expected one of them");
  const Vector& u = (*options.plane)[0];
  const Vector& v = (*options.plane)[1];
  // v is a multiple of u if it is where u is not 0.
  const auto first = std::find_if(u.begin(), u.end(), [](const Rational& x) { return x != 0; });
  for (std::size_t j = 0; first != u.end() && j < u.size(); ++j) {
    if (*first * v[j] != u[j] * v[static_cast<std::size_t>(first - u.begin())]) return;
  }
  refuse("plane", "its directions are multiples of one another; expected a plane");
}

/// FORMAT.md §16.
void check_statics(const Options& options) {
  if (!options.statics) return;
  if (*options.statics < 0) {
    refuse("statics", "found the factor " + show(*options.statics) + ", expected 0 or more");
  }
  if (options.inertia) refuse("statics", "an inertia is given as well; expected one of them");
  if (options.preload_direction) {
    refuse("statics", "a preload direction is given as well, but preloads play no part");
  }
}

/// FORMAT.md §18: with the numbers that were not given.
void check_robustness(const Grasp& grasp, Options& options) {
  const std::size_t m = grasp.contacts.size();
  if (!options.robustness) {
    if (!options.length && !options.max_force) return;
    refuse(options.length ? "length" : "max_force", "expected none without a robustness");
  }
  if (options.margin() || options.plane || options.inertia || options.statics ||
      options.preload || options.bilateral || !options.uncertain.empty()) {
    refuse("robustness", "another option is given as well; expected a load at most");
  }
  if (grasp.several) refuse("robustness", "the grasp is of several bodies; expected one");
  if (!options.length) options.length = 1;
  if (!options.max_force) options.max_force = {1};
  Vector& most = *options.max_force;
  if (most.size() == 1) most.resize(m, most[0]);
  if (*options.length <= 0) refuse("length", "found " + show(*options.length));
  if (most.size() != m ||
      std::any_of(most.begin(), most.end(), [](const Rational& f) { return f <= 0; })) {
    refuse("max_force", "found " + show(most) + ", expected a number above 0, or one for each "
                        "of " + std::to_string(m) + " contacts");
  }
}

/// FORMAT.md §18: what a robustness is not about.
void check_fingers(const Question& question, const Contacts& contacts,
                   const std::string& file) {
  if (!question.asked.robustness) return;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact contact = contacts[i];
    const std::string place = "contacts[" + std::to_string(i) + "].";
    if (contact.torsion != 0) {
      throw Malformed{file, place + "torsion", "a robustness is about contacts without it"};
    }
    if (exact_sqrt(dot(contact.normal, contact.normal))) continue;
    throw Malformed{file, place + "normal",
                    "its length is irrational; run stickslip snap GRASP -o FILE, and ask about "
                    "FILE"};
  }
}

/// FORMAT.md §13.
void check_inertia(const Grasp& grasp, const Options& options) {
  if (!options.inertia) return;
  const Vector& m = *options.inertia;
  if (options.margin() || options.plane) {
    refuse("inertia", "a direction or a plane is given as well; expected one of them");
  }
  const bool in_space = grasp.in_space();
  if (m.size() != (in_space ? 9 : 3)) {
    refuse("inertia", in_space ? "the grasp is in space; expected 6 or 9 numbers"
                               : "the grasp is in the plane; expected 3 numbers");
  }
  if (!in_space && m[2] <= 0) {
    refuse("inertia",
           "found the squared radius of gyration " + show(m[2]) + ", expected one above 0");
  }
  if (!in_space) return;
  const Rational& xx = m[3];
  const Rational minor = xx * m[4] - m[6] * m[6];
  const Rational determinant =
      m[5] * minor - xx * m[8] * m[8] - m[4] * m[7] * m[7] + 2 * m[6] * m[7] * m[8];
  if (xx <= 0 || minor <= 0 || determinant <= 0) {
    refuse("inertia", "the tensor is not positive definite");
  }
}

/// FORMAT.md §1, *max motion*: B, if motions are bounded.
std::optional<Vector> max_motion_asked(const Grasp& grasp, const Options& options) {
  const std::optional<Vector>& given = options.max_motion;
  if ((options.statics || options.robustness) && !given) return std::nullopt;
  const auto refuse_bound = [](const std::string& problem) { refuse("max_motion", problem); };
  std::optional<Vector> bound = given ? given : grasp.max_motion;
  if (!bound || bound->empty()) return std::nullopt;
  if (options.plane || options.inertia || options.statics || options.robustness) {
    refuse_bound("motions are bounded, but " + kind_of(options) + " is about all motions; " +
                 (given ? "expected one of the two"
                        : "to leave the bound of the grasp file out, give --max-motion none"));
  }
  for (const Rational& b : *bound) {
    if (b <= 0) refuse_bound("found " + show(b) + ", expected numbers above 0");
  }
  const std::size_t size = grasp.dimension();
  if (bound->size() == size) return bound;
  const bool has_joints = grasp.several && grasp.several->mechanism->joints() > 0;
  if (bound->size() != 2 || has_joints) {
    refuse_bound("found " + std::to_string(bound->size()) + " numbers, expected " +
                 std::to_string(size) + ", one for each coordinate of motions" +
                 (has_joints ? ", as there are joints" : ", or a length and an angle"));
  }
  return bound_of((*bound)[0], (*bound)[1], size, grasp.in_space());
}

/// The numbers of each kind, widened.
void widen(Bounds& bounds, const Tolerance& tolerance) {
  const auto by = [&](const Rational& end) {
    return tolerance.percent ? Rational(tolerance.size * abs(end) / 100) : tolerance.size;
  };
  bounds = Bounds(bounds.low - by(bounds.low), bounds.high + by(bounds.high));
}

void widen(Contact& contact, const std::string& kind, const Tolerance& tolerance) {
  if (kind == "stiffness") widen(contact.stiffness, tolerance);
  if (kind == "preload") widen(contact.preload, tolerance);
  if (!is_contact(contact.sight)) return;
  if (kind == "friction") widen(contact.friction, tolerance);
  if (kind == "normal") contact.slope += tolerance.size;
  if (kind != "position") return;
  for (Bounds& p : contact.position) widen(p, tolerance);
}

/// The loads of a ball, with the point that was left out.
Load load_of(Ball& ball, const Question& question, const std::string& found) {
  const auto require = [&found](bool good, const std::string& expected) {
    if (!good) refuse("uncertain", "found " + found + ", expected " + expected);
  };
  require(ball.radius > 0, "a radius above 0");
  require(ball.length > 0, "a length above 0");
  const std::size_t rows = question.in_space ? kSpatial : kPlanar;
  if (ball.about.empty()) ball.about.resize(coordinates(rows));
  require(ball.about.size() == coordinates(rows),
          question.in_space ? "a point of three coordinates, as the grasp is in space"
                            : "a point of two coordinates, as the grasp is planar");
  Vector w0;
  for (const Bounds& w : question.wrench) {
    require(w.certain(), "a load without intervals, but it has " + show(w));
    w0.push_back(w.low);
  }
  if (!question.several) {
    require(!ball.body, "no body, as the grasp has one only");
    return {std::move(w0), ball, unit_matrix(rows)};
  }
  const auto& bodies = question.several->names;
  const auto body = ball.body ? bodies.find(*ball.body) : bodies.end();
  require(body != bodies.end(),
          "the name of one of \"bodies\", such as body=" + quote(bodies.begin()->first));
  return {std::move(w0), ball, question.several->mechanism->motion(body->second)};
}

/// Replaces what is asked to be, and widens it; the wrench has been replaced.
void apply_uncertain(Question& question, Contacts& contacts) {
  Options& asked = question.asked;
  if (!asked.statics) question.load = Load(question.wrench);
  for (auto& [kind, tolerance] : asked.uncertain) {
    const std::string found = kind + "=" + show(tolerance);
    if (asked.family()) {
      refuse("uncertain", "found " + found + ", but " + kind_of(asked) +
                              " is about one grasp; expected no uncertainty");
    }
    if (tolerance.size < 0) refuse("uncertain", "found " + found + ", expected 0 or more");
    if (kind == "normal" && tolerance.percent) {
      refuse("uncertain", "found " + found + ", expected a slope, such as 0.01");
    }
    if (tolerance.ball) {
      question.load = load_of(*tolerance.ball, question, found);
    } else if (kind == "wrench") {
      Wrench wrench = question.wrench;
      for (Bounds& w : wrench) widen(w, tolerance);
      question.load = Load(std::move(wrench));
    }
  }
  for (std::size_t i = 0; i < contacts.size() && (asked.preload || !asked.uncertain.empty());
       ++i) {
    Contact contact = contacts[i];
    if (asked.preload && is_contact(contact.sight)) contact.preload = *asked.preload;
    for (const auto& [kind, tolerance] : asked.uncertain) widen(contact, kind, tolerance);
    contacts.set(i, contact);
  }
}

/// What FORMAT.md §6 does not allow; and whether the question is a box.
void check_uncertain(Question& question, const Contacts& contacts, const Vector& growth,
                     const std::string& file) {
  const auto check = [&](const Bounds& bounds, const auto& place) {
    if (bounds.certain()) return;
    question.is_box = true;
    const bool family = question.asked.family();
    if (!family && !question.large()) return;
    throw Malformed{file, place(),
                    "found the interval " + show(bounds) + ", but " +
                        (family ? kind_of(question.asked)
                                : "a verdict of more than " + std::to_string(kMostCoordinates) +
                                      " coordinates") +
                        " is about one grasp; expected a number"};
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Contact contact = contacts[i];
    const auto place = [i, &sight = contact.sight](const std::string& name) {
      if (is_contact(sight)) return "contacts[" + std::to_string(i) + "]." + name;
      return sight->place + "." + (name == "preload" ? sight->preload : name);
    };
    const auto require = [&](bool good, const char* name, const Rational& found,
                             const char* expected) {
      if (good) return;
      throw Malformed{file, place(name), "it may be " + show(found) + ", expected " + expected};
    };
    const bool spring = is_spring(contact.sight);
    require(contact.friction.low >= 0, "friction", contact.friction.low, "0 or more");
    require(contact.preload.low >= 0 || spring, "preload", contact.preload.low, "0 or more");
    require(contact.stiffness.low > 0 || (spring && contact.stiffness.low == 0), "stiffness",
            contact.stiffness.low, spring ? "0 or more" : "above 0");
    require(contact.slope < 1, "normal.slope", contact.slope, "a slope below 1");
    require(contact.slope == 0 || contact.torsion == 0, "normal.slope", contact.slope,
            "0, as the contact has torsion");
    check(contact.friction, [&] { return place("friction"); });
    check(contact.preload, [&] { return place("preload"); });
    check(contact.stiffness, [&] { return place("stiffness"); });
    for (const Bounds& p : contact.position) check(p, [&] { return place("position"); });
    if (contact.slope != 0) {
      check(Bounds(-contact.slope, contact.slope), [&] { return place("normal.slope"); });
    }
    const bool loaded = contact.preload.high != 0 || (!growth.empty() && growth[i] != 0);
    const bool has_length = is_contact(contact.sight);
    if (!loaded || !has_length || question.asked.statics ||
        exact_sqrt(dot(contact.normal, contact.normal)))
      continue;
    question.is_box = true;
    question.encloses_lengths = true;
    if ((question.asked.plane || question.asked.inertia) && !question.in_space) {
      throw Malformed{
          file, place("normal"),
          "the contact has a preload and a normal of irrational length, so there is "
          "no exact question; run stickslip snap GRASP -o FILE, and ask about FILE"};
    }
  }
  for (const Bounds& w : question.asked.statics ? question.wrench : question.load.numbers()) {
    check(w, [] { return std::string("wrench"); });
  }
}

/// FORMAT.md §17.
Question pose_states(Grasp grasp, const Options& options, const std::string& file) {
  if (options.margin() || options.plane || options.inertia || options.statics ||
      options.wrench || options.preload || options.bilateral || options.case_name ||
      options.robustness || !options.uncertain.empty() || options.max_motion) {
    refuse("states", "another option is given as well, but positions and normals alone count");
  }
  if (grasp.dimension() > kMostCoordinates) refuse_many(grasp.dimension());
  for (std::size_t i = 0; i < grasp.contacts.size(); ++i) {
    const Contact contact = grasp.contacts[i];
    if (!is_contact(contact.sight)) continue;
    const auto check = [&](const Bounds& bounds, const char* name) {
      if (bounds.certain()) return;
      throw Malformed{file, "contacts[" + std::to_string(i) + "]." + name,
                      "found the interval " + show(bounds) + ", but " + kind_of(options) +
                          " is that of one grasp; expected a number"};
    };
    for (const Bounds& p : contact.position) check(p, "position");
    check(Bounds(-contact.slope, contact.slope), "normal.slope");
  }
  Question question;
  question.asked = options;
  question.several = grasp.several;
  question.in_space = grasp.in_space();
  question.wrench = Wrench(grasp.dimension());
  question.contacts = Fixed<Contacts>(std::move(grasp.contacts));
  return question;
}

/// FORMAT.md §16, limits: their number.
std::size_t count_limits(const Grasp& grasp, const Options& options, const std::string& file) {
  std::size_t count = 0;
  for (std::size_t i = 0; grasp.several && i < grasp.contacts.size(); ++i) {
    const Contact contact = grasp.contacts[i];
    if (!contact.limit) continue;
    if (!options.statics) {
      throw Malformed{file,
                      is_contact(contact.sight)
                          ? "contacts[" + std::to_string(i) + "].max_force"
                          : contact.sight->place + ".max_torque",
                      "the force is limited; expected none, but in a question of statics"};
    }
    ++count;
  }
  return count;
}

}  // namespace

std::string show(const Tolerance& tolerance) {
  if (!tolerance.ball) return show(tolerance.size) + (tolerance.percent ? "%" : "");
  const Ball& ball = *tolerance.ball;
  std::string text = "ball:" + show(ball.radius) + ":length=" + show(ball.length);
  for (std::size_t j = 0; j < ball.about.size(); ++j) {
    text += (j == 0 ? ":about=" : ":") + show(ball.about[j]);
  }
  return text + (ball.body ? ":body=" + *ball.body : "");
}

ContactBox enlarged(const Contact& contact, const Rational& growth, unsigned bits) {
  const bool has_length = is_contact(contact.sight);
  const Rational square = has_length ? dot(contact.normal, contact.normal) : Rational(1);
  const Rational turned = contact.slope * contact.slope;
  const bool loaded = contact.preload.high != 0 || growth != 0;
  const Bounds inverse = loaded ? root_bounds(Rational(1 / square), bits) : Bounds(1);
  ContactBox box;
  box.sight = contact.sight;
  box.normal = contact.normal;
  const auto set = [&box](Parameter name, std::size_t after, Bounds bounds) {
    box.bounds[static_cast<std::size_t>(name) + after] = std::move(bounds);
  };
  const bool in_space = contact.normal.size() == 3;
  for (std::size_t j = 0; j < contact.position.size(); ++j) {
    set(Parameter::kX, j, contact.position[j]);
  }
  std::size_t k = 0;
  for (const Turn& turn : turns_of(contact.normal, contact.slope)) {
    set(in_space ? Parameter::kTurnU : Parameter::kTurn, k++, Bounds(-turn.most, turn.most));
  }
  set(Parameter::kFriction, 0, contact.friction);
  set(Parameter::kPreload, 0,
      Bounds(contact.preload.low * (1 - turned / 2) * inverse.low,
             contact.preload.high * inverse.high));
  set(Parameter::kStiffness, 0,
      Bounds(contact.stiffness.low * (1 - turned) / square, contact.stiffness.high / square));
  box.growth = Bounds(growth * inverse.low, growth * inverse.high);
  box.gamma = contact.torsion * contact.torsion / square;
  return box;
}

Question pose(Grasp grasp, const Options& given, const std::string& file) {
  Options options = given;
  check_robustness(grasp, options);
  const std::size_t limits = count_limits(grasp, options, file);
  if (options.states) return pose_states(std::move(grasp), options, file);
  Contacts& contacts = grasp.contacts;
  const std::size_t m = contacts.size();
  check_dimension(grasp, options);
  check_plane(options);
  check_inertia(grasp, options);
  check_statics(options);
  Question question;
  question.asked = options;
  question.limits = limits;
  question.asked.max_motion = max_motion_asked(grasp, options);
  question.several = grasp.several;
  question.in_space = grasp.in_space();
  if (options.preload && *options.preload < 0) {
    refuse("preload", "found " + show(*options.preload) + ", expected 0 or more");
  }
  question.wrench = wrench_asked(grasp, options);
  apply_uncertain(question, contacts);
  const bool scaled = options.preload_direction && options.preload_direction->scale;
  Vector growth;
  if (options.preload_direction && !scaled) {
    growth = options.preload_direction->values;
    bool good = growth.size() == m;
    for (std::size_t i = 0; good && i < m; ++i) {
      good = growth[i] >= 0 || is_spring(contacts[i].sight);
    }
    if (!good) {
      refuse("preload direction",
             "found " + show(growth) + ", expected " + std::to_string(m) +
                 " numbers of 0 or more, one for each contact" +
                 (grasp.several ? ", then ratchet, then spring, of which any number" : ""));
    }
  }
  check_uncertain(question, contacts, growth, file);
  check_fingers(question, contacts, file);
  for (std::size_t i = 0; scaled && i < m; ++i) {
    Contact contact = contacts[i];
    growth.push_back(contact.preload.low);
    contact.preload = Bounds(0);
    contacts.set(i, contact);
  }
  question.growth = options.direction.value_or(Vector(grasp.dimension()));
  if (options.margin() && question.growth == Vector(grasp.dimension()) &&
      std::all_of(growth.begin(), growth.end(), [](const Rational& p) { return p == 0; })) {
    refuse("direction",
           "neither the wrench nor a preload changes; expected a direction other "
           "than 0, or to scale preloads some of which are not 0");
  }
  question.contacts = Fixed<Contacts>(std::move(contacts));
  question.preload_growth = Fixed<Vector>(std::move(growth));
  if (!question.is_box && !options.statics && !question.large()) enlarge(question);
  return question;
}

void enlarge(Question& question, unsigned bits) {
  const auto make = [contacts = question.contacts, growth = question.preload_growth,
                     bits](std::size_t i) {
    return enlarged(contacts[i], growth.size() == 0 ? Rational(0) : growth[i], bits);
  };
  auto box = std::make_shared<Box>(question.contacts.size(), make, !question.is_box);
  box->load = question.load;
  box->growths = question.asked.plane.value_or(std::vector<Vector>{question.growth});
  question.box = std::move(box);
}

}  // namespace stickslip_check

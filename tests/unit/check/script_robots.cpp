#include "tests/unit/check/script_robots.hpp"

namespace rubicon::test {

namespace {

/// A model built body by body; only what script checks look at.
class Builder {
 public:
  explicit Builder(const std::string& name) { model_.name = name; }

  Builder& body(const std::string& name) {
    robot::Body body;
    body.name = name;
    body.parent = static_cast<int>(model_.bodies.size()) - 1;
    model_.bodies.push_back(body);
    return *this;
  }

  Builder& parameter(const std::string& name, double step) {
    robot::Parameter parameter;
    parameter.name = name;
    parameter.body = static_cast<int>(model_.bodies.size()) - 1;
    parameter.rotation = name == "psi" || name == "phi" || name == "theta";
    parameter.step = step;
    model_.bodies.back().parameters.push_back(static_cast<int>(model_.parameters.size()));
    model_.parameters.push_back(parameter);
    return *this;
  }

  Builder& range(double lower, double upper) {
    model_.parameters.back().lower = lower;
    model_.parameters.back().upper = upper;
    return *this;
  }

  Builder& cyclic() {
    model_.parameters.back().cyclic = true;
    return *this;
  }

  Builder& local() {
    model_.parameters.back().direct = false;
    return *this;
  }

  Builder& derived() {
    model_.parameters.back().derived = true;
    return *this;
  }

  Builder& sensor(double range) {
    model_.sensor = range;
    return *this;
  }

  robot::RobotModel build() {
    for (robot::Parameter& parameter : model_.parameters) {
      int same = 0;
      for (const robot::Parameter& other : model_.parameters) {
        if (other.name == parameter.name) ++same;
      }
      parameter.display_name =
          same == 1 ? parameter.name : model_.bodies[parameter.body].name + "." + parameter.name;
    }
    model_.tool_body = static_cast<int>(model_.bodies.size()) - 1;
    return model_;
  }

 private:
  robot::RobotModel model_;
};

}  // namespace

const std::map<std::string, robot::RobotModel>& script_robots() {
  static const std::map<std::string, robot::RobotModel> kRobots = {
      {"crane", Builder("crane")
                    .body("mast")
                    .body("jib")
                    .parameter("theta", 5)
                    .range(-180, 180)
                    .body("hook")
                    .parameter("x", 1)
                    .range(4, 50)
                    .parameter("z", 1)
                    .range(0, 42)
                    .build()},
      {"agent", Builder("agent")
                    .sensor(10)
                    .body("truck")
                    .parameter("x", 0.5)
                    .local()
                    .parameter("y", 0)
                    .local()
                    .parameter("z", 0)
                    .local()
                    .parameter("theta", 10)
                    .cyclic()
                    .build()},
      {"gantry", Builder("gantry")
                     .body("trolley")
                     .parameter("x", 1)
                     .range(-10, 60)
                     .parameter("y", 1)
                     .range(-30, 30)
                     .build()},
      {"finisher", Builder("finisher")
                       .body("base")
                       .parameter("x", 0.5)
                       .range(0, 40)
                       .body("carriage")
                       .parameter("z", 0.5)
                       .range(-20, 0)
                       .body("effector")
                       .parameter("x", 0.25)
                       .range(-1.5, 1.5)
                       .build()},
      {"arm", Builder("arm")
                  .body("boom")
                  .parameter("phi", 1)
                  .body("bucket")
                  .parameter("phi", 0)
                  .derived()
                  .parameter("x", 0.1)
                  .build()},
  };
  return kRobots;
}

}  // namespace rubicon::test

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "interpreter/check/check_number.hpp"
#include "interpreter/check/check_plan_parts.hpp"
#include "src/earth/soil/blocks.hpp"
#include "src/earth/soil/excavation.hpp"
#include "src/motion/geometry/above.hpp"
#include "src/motion/math/angles.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

using syntax::UnitKind;

constexpr double kLeastCell = 0.01;  // m
constexpr double kMostCell = 100;    // m
constexpr double kMostExtent = 1e5;  // m, of an earth along a side
/// Soil above the bottom of a pit, all over its earth, m3: sums of mm3 stay within 64 bits.
constexpr double kMostAbove = 4e9;
/// Boxes of which the ground and the soil of a plan are made, at most.
constexpr std::size_t kMostBlocks = 20'000;
/// Below the lowest of the ground there is so much of it still, mm.
constexpr soil::Millimetres kGroundBelow = 1000;
/// A round pit has so many corners at least and at most; up to the most its sides are no farther
/// inside the circle than this, m: cells are told apart by whole mm.
constexpr int kLeastRound = 64;
constexpr int kMostRound = 1024;
constexpr double kRoundGap = 0.5e-3;

soil::Millimetres in_mm(double metres) {
  return static_cast<soil::Millimetres>(std::llround(metres * 1e3));
}

class EarthCheck {
 public:
  EarthCheck(Subject& subject, const syntax::EarthItem& item)
      : subject_(subject), item_(item), who_("earth '" + item.name.text + "'") {}

  std::optional<EarthSpec> run() {
    const int errors = subject_.diagnostics.errors();
    earth_.name = item_.name.text;
    earth_.span = item_.name.span;
    for (const syntax::EarthItem::Clause& clause : item_.clauses) take(clause);
    need("grid", "how many cells it has", "grid 60, 40; columns and rows of cells");
    need("cell", "how wide its cells are", "cell 0.25 m;");
    need("height", "how high it is", "height 0 m; or height from \"site.csv\";");
    need("stands", "how steep it stands",
         "stands 60 deg; how steep a wall of it stands, 90 deg for upright ones");
    if (subject_.diagnostics.errors() != errors) return std::nullopt;
    if (columns_ * rows_ > soil::kMostCells) {
      wrong(given_["grid"],
            fmt::format("{} has {:.0f} cells; expected up to {}", who_, columns_ * rows_,
                        soil::kMostCells),
            "larger cells");
      return std::nullopt;
    }
    if (std::max(columns_, rows_) * static_cast<double>(cell_) * 1e-3 > kMostExtent) {
      wrong(given_["grid"], fmt::format("{} is more than {:g} m long", who_, kMostExtent));
      return std::nullopt;
    }
    const int columns = static_cast<int>(columns_);
    const int rows = static_cast<int>(rows_);
    if (file_ == nullptr) {
      earth_.before = soil::flat(columns, rows, cell_, height_);
    } else if (!read_heights(columns, rows)) {
      return std::nullopt;
    }
    earth_.after = earth_.before;
    return std::move(earth_);
  }

 private:
  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P56", span, std::move(message), std::move(hint));
  }

  void need(const char* key, const char* what, const char* hint) {
    if (given_.count(key) != 0) return;
    wrong(item_.name.span, fmt::format("{} does not say {}", who_, what), hint);
  }

  std::optional<double> number(const syntax::Number& value, UnitKind kind, double least,
                               double most, const std::string& key) {
    return bounded(
        subject_, value, kind,
        fmt::format("the {} of {}", key == "stands" || key == "repose" ? "slope" : key, who_),
        least, most);
  }

  void take(const syntax::EarthItem::Clause& clause) {
    const std::string& key = clause.key.text;
    const auto [first, is_new] = given_.emplace(key, clause.key.span);
    if (!is_new) {
      subject_.twice(clause.key.span, key + " is given twice", first->second);
      return;
    }
    if (clause.at) {
      earth_.X_WE = resolve_frame_or_identity(subject_, *clause.at);
      if (!geometry::stands_upright(earth_.X_WE))
        wrong(clause.at->span, who_ + " leans: heights are upright");
    } else if (clause.file) {
      file_ = &*clause.file;
    } else if (key == "grid") {
      columns_ = count(clause.numbers[0]);
      rows_ = count(clause.numbers[1]);
    } else {
      take_number(key, clause.numbers[0]);
    }
  }

  double count(const syntax::Number& value) {
    const auto cells = number(value, UnitKind::none, 1, soil::kMostCells, "grid");
    if (!cells) return 1;
    if (std::floor(*cells) != *cells) {
      wrong(value.span, fmt::format("expected a whole number of cells, found {:g}", *cells));
    }
    return std::floor(*cells);
  }

  void take_number(const std::string& key, const syntax::Number& value) {
    if (key == "cell") {
      const auto side = number(value, UnitKind::length, kLeastCell, kMostCell, key);
      if (!side) return;
      cell_ = in_mm(*side);
      if (std::fabs(static_cast<double>(cell_) - *side * 1e3) > 1e-6) {
        wrong(value.span, fmt::format("a cell is whole mm wide, found {:g} m", *side));
      }
    } else if (key == "height") {
      const double most = static_cast<double>(soil::kMostHeight) * 1e-3;
      height_ = in_mm(number(value, UnitKind::length, -most, most, key).value_or(0));
    } else if (key == "stands") {
      earth_.stands_deg = number(value, UnitKind::angle, 1, 90, key).value_or(90);
    } else if (key == "swell") {
      earth_.swell = number(value, UnitKind::none, 0, kMostSwell, key).value_or(0);
    } else if (key == "repose") {
      earth_.repose_deg = number(value, UnitKind::angle, 1, 89, key);
    } else {
      earth_.density = number(value, UnitKind::density, 1, kMostDensity, key);
    }
  }

  bool read_heights(int columns, int rows) {
    const std::string path = resolve_path(subject_.model.path, file_->text);
    std::variant<std::string, FileFailure> text = subject_.files.read_text(path);
    if (const auto* failure = std::get_if<FileFailure>(&text)) {
      subject_.error("F01", file_->span,
                     fmt::format("heights '{}': {}", file_->text, failure->message));
      return false;
    }
    auto terrain = soil::terrain_of(std::get<std::string>(text), columns, rows, cell_);
    subject_.sources.add(path, std::get<std::string>(std::move(text)));
    if (const auto* fault = std::get_if<std::string>(&terrain)) {
      wrong(file_->span, fmt::format("heights '{}': {}", file_->text, *fault),
            fmt::format("{} lines of {} heights in m, the first line the row with the largest y",
                        rows, columns));
      return false;
    }
    earth_.before = std::get<soil::Terrain>(std::move(terrain));
    return true;
  }

  Subject& subject_;
  const syntax::EarthItem& item_;
  std::string who_;
  EarthSpec earth_;
  std::map<std::string, Span> given_;
  double columns_ = 1, rows_ = 1;
  soil::Millimetres cell_ = 1000, height_ = 0;
  const syntax::String* file_ = nullptr;
};

/// The plan view of a pit and its bottom, in the frame of the shape; nothing for other solids.
struct PlanView {
  std::vector<Eigen::Vector2d> outline;
  double bottom = 0;
};
std::optional<PlanView> plan_view(const geometry::Solid& solid) {
  if (const auto* box = std::get_if<geometry::Box>(&solid)) {
    const math::Vec3& a = box->lower;
    const math::Vec3& b = box->upper;
    return PlanView{{{a.x(), a.y()}, {b.x(), a.y()}, {b.x(), b.y()}, {a.x(), b.y()}}, a.z()};
  }
  if (const auto* prism = std::get_if<geometry::Prism>(&solid)) {
    return PlanView{prism->polygon, std::min(prism->z0, prism->z1)};
  }
  const auto* cylinder = std::get_if<geometry::Cylinder>(&solid);
  if (cylinder == nullptr) return std::nullopt;
  PlanView round{{}, std::min(cylinder->z0, cylinder->z1)};
  // The middle of a side is r (1 - cos(pi / n)), about r pi^2 / (2 n^2), inside.
  const double corners = std::numbers::pi * std::sqrt(cylinder->radius / (2 * kRoundGap));
  const int count = std::clamp(static_cast<int>(std::ceil(std::min<double>(corners, kMostRound))),
                               kLeastRound, kMostRound);
  for (int i = 0; i < count; ++i) {
    const double angle = 360.0 * i / count;
    round.outline.emplace_back(cylinder->radius * math::cos_deg(angle),
                               cylinder->radius * math::sin_deg(angle));
  }
  return round;
}

/// Blocks as boxes in {E}, each a shape in a frame that X takes {E} to.
void add_boxes(const std::vector<soil::Block>& blocks, soil::Millimetres cell, const math::Pose& X,
               std::vector<geometry::Shape>& shapes) {
  const auto metres = [](soil::Millimetres value) { return static_cast<double>(value) * 1e-3; };
  for (const soil::Block& block : blocks) {
    geometry::Box box;
    box.lower = {metres(block.first_column * cell), metres(block.first_row * cell),
                 metres(block.bottom)};
    box.upper = {metres(block.end_column * cell), metres(block.end_row * cell), metres(block.top)};
    geometry::Shape& shape = shapes.emplace_back();
    shape.solid = box;
    shape.X_BS = X;
  }
}

class SoilTaker {
 public:
  SoilTaker(Subject& subject, const Scope& scope, const syntax::DigItem& item,
            const syntax::TaskItem& task)
      : subject_(subject), scope_(scope), item_(item), task_(task) {}

  std::optional<DugSoil> run() {
    const int index = subject_.find(subject_.earths, *item_.earth, "earth");
    if (index < 0) return std::nullopt;
    if (scope_.module != nullptr) {
      wrong(item_.earth->span, "an earth is dug by tasks of the plan itself, not of a module");
      return std::nullopt;
    }
    EarthSpec& earth = subject_.model.earths[at(index)];
    const auto pit = pit_in(earth);
    if (!pit) return std::nullopt;
    if (above(earth.after, pit->bottom) > kMostAbove) {
      wrong(item_.shape->span,
            fmt::format("more than {:g} m3 of earth '{}' lie above the bottom of this shape",
                        kMostAbove, earth.name),
            "a smaller earth, or a pit that is not so deep");
      return std::nullopt;
    }
    const soil::Excavation dug = excavate(earth.after, *pit, earth.stands_deg);
    if (dug.reaches_border) {
      wrong(item_.shape->span,
            fmt::format("the pit, with its slopes of {:g} deg, reaches the border of earth '{}': "
                        "what lies beyond would fall in",
                        earth.stands_deg, earth.name),
            "a larger grid");
      return std::nullopt;
    }
    if (dug.volume == 0) {
      wrong(
          item_.shape->span,
          fmt::format("there is no soil of earth '{}' above the bottom of this shape", earth.name),
          fmt::format("its cells are {} mm wide, and a pit takes those whose middle is in it",
                      earth.before.cell));
      return std::nullopt;
    }
    EarthWork& work = subject_.earth_works[at(index)];
    EarthWork::Dig& dig = work.digs.emplace_back();
    dig.task = &task_;
    earth.after.heights.for_each_difference(dug.after.heights, [&](std::size_t cell) {
      if (work.last_dig[cell] >= 0) dig.after.insert(work.last_dig[cell]);
      work.last_dig[cell] = static_cast<int>(work.digs.size()) - 1;
    });
    if (!work.now) work.now = std::make_shared<const soil::Terrain>(earth.after);
    DugSoil soil{index, add_component(earth, dug), dug.volume, work.now,
                 std::make_shared<const soil::Terrain>(dug.after)};
    work.now = soil.after;
    dig.before = soil.before;
    dig.below = soil.after;
    earth.after = dug.after;
    return soil;
  }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P56", span, std::move(message), std::move(hint));
  }

  /// m3, at most.
  static double above(const soil::Terrain& ground, soil::Millimetres bottom) {
    const soil::Millimetres highest = ground.heights.highest();
    const double side = static_cast<double>(ground.cell) * 1e-3;
    return static_cast<double>(ground.heights.size()) * side * side *
           static_cast<double>(std::max<soil::Millimetres>(highest - bottom, 0)) * 1e-3;
  }

  std::optional<soil::Pit> pit_in(const EarthSpec& earth) {
    const std::optional<geometry::Shape> shape = subject_.shapes.resolve(*item_.shape);
    if (!shape) return std::nullopt;
    const auto view = plan_view(shape->solid);
    const math::Pose X_ES = earth.X_WE.inverse() * scope_.X_WP * shape->X_BS;
    if (!view || !geometry::stands_upright(X_ES)) {
      wrong(item_.shape->span,
            view ? "a pit has an upright shape, and this one leans"
                 : "a pit is a box, a prism or a cylinder",
            "prism(-3.2, 0, 4, -1.3, 9, -1.3, 9, 1.3, 4, 1.3), from its bottom at -3.2");
      return std::nullopt;
    }
    soil::Pit pit;
    for (const Eigen::Vector2d& corner : view->outline) {
      const math::Vec3 p = X_ES * math::Vec3(corner.x(), corner.y(), view->bottom);
      pit.outline.emplace_back(p.x(), p.y());
      pit.bottom = in_mm(p.z());
    }
    return pit;
  }

  int add_component(const EarthSpec& earth, const soil::Excavation& dug) {
    ComponentSpec& soil = subject_.model.components.emplace_back();
    soil.name = task_.name.text + ".soil";
    soil.span = item_.earth->span;
    soil.X_WO = earth.X_WE;
    add_boxes(soil::blocks_between(dug.after, earth.after), earth.before.cell,
              math::Pose::Identity(), soil.shapes);
    if (earth.density) soil.mass = static_cast<double>(dug.volume) * 1e-9 * *earth.density;
    return static_cast<int>(subject_.model.components.size()) - 1;
  }

  Subject& subject_;
  const Scope& scope_;
  const syntax::DigItem& item_;
  const syntax::TaskItem& task_;
};

/// The tasks that are done before a task begins, by its links.
std::set<int> done_before(const PlanModel& model, int task) {
  std::set<int> found;
  std::vector<int> open = {task};
  while (!open.empty()) {
    const int each = open.back();
    open.pop_back();
    for (const LinkSpec& link : model.tasks[static_cast<std::size_t>(each)].after) {
      const bool is_done = link.type == LinkType::FS && link.lag >= 0;
      if (is_done && found.insert(link.task).second) open.push_back(link.task);
    }
  }
  return found;
}

/// A dig of an earth as a task of the plan.
struct LinkedDig {
  int task = -1;
  std::set<int> done;  ///< digs of the earth that are over before it begins, by the links
};

std::vector<LinkedDig> linked_digs(const Subject& subject, const EarthWork& work) {
  std::vector<LinkedDig> digs;
  for (const EarthWork::Dig& dig : work.digs) {
    digs.emplace_back().task = subject.tasks.at(dig.task->name.text);
  }
  for (LinkedDig& dig : digs) {
    const std::set<int> before = done_before(subject.model, dig.task);
    for (std::size_t i = 0; i < digs.size(); ++i) {
      if (before.contains(digs[i].task)) dig.done.insert(static_cast<int>(i));
    }
  }
  return digs;
}

/// Who digs deeper where another digs comes after it: the volumes are so.
void check_order(Subject& subject, const EarthWork& work, const std::vector<LinkedDig>& digs) {
  for (std::size_t i = 0; i < digs.size(); ++i) {
    const EarthWork::Dig& dig = work.digs[i];
    for (const int each : dig.after) {
      if (digs[i].done.contains(each)) continue;
      const std::string& other = work.digs[static_cast<std::size_t>(each)].task->name.text;
      subject.error("P56", dig.task->name.span,
                    fmt::format("'{}' digs where '{}' digs, and does not come after it",
                                dig.task->name.text, other),
                    fmt::format("after {};", other));
    }
  }
}

void dig_out(soil::Terrain& ground, const EarthWork::Dig& dig) {
  dig.before->heights.for_each_difference(dig.below->heights, [&](std::size_t cell) {
    ground.heights.set(cell, dig.below->heights[cell]);
  });
}

/// The ground in which robots dig. Soil stands for them until the links say that it is gone, in
/// whatever order the file has the tasks.
void set_grounds(PlanModel& model, const EarthSpec& earth, const EarthWork& work,
                 const std::vector<LinkedDig>& digs) {
  const auto count = [&](std::size_t dig) { return digs[dig].done.size(); };
  std::vector<std::size_t> order(digs.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return count(a) < count(b); });
  std::vector<std::shared_ptr<const soil::Terrain>> below(digs.size());
  for (const std::size_t i : order) {
    // All but a few of them are done before one of them, mostly.
    int last = -1;
    for (const int each : digs[i].done) {
      const auto number = static_cast<std::size_t>(each);
      if (!below[number]) continue;
      if (last < 0 || count(number) > count(static_cast<std::size_t>(last))) last = each;
    }
    soil::Terrain ground = last < 0 ? earth.before : *below[static_cast<std::size_t>(last)];
    for (const int each : digs[i].done) {
      const bool is_known =
          last >= 0 && (each == last || digs[static_cast<std::size_t>(last)].done.contains(each));
      if (!is_known) dig_out(ground, work.digs[static_cast<std::size_t>(each)]);
    }
    const auto before = std::make_shared<const soil::Terrain>(ground);
    dig_out(ground, work.digs[i]);
    below[i] = std::make_shared<const soil::Terrain>(std::move(ground));
    const auto set = [&](TaskSpec& task) {
      if (!task.motion_dig) return;
      task.motion_dig->before = before;
      task.motion_dig->after = below[i];
    };
    TaskSpec& task = model.tasks[static_cast<std::size_t>(digs[i].task)];
    set(task);
    for (TaskSpec& choice : task.choices) set(choice);
  }
}

}  // namespace

void check_earths(Subject& subject) {
  std::map<std::string, Span> names;
  for (const syntax::PlanItem& each : subject.plan.items) {
    const auto* item = std::get_if<syntax::EarthItem>(&each);
    if (item == nullptr) continue;
    const auto [first, is_new] = names.emplace(item->name.text, item->name.span);
    if (!is_new) {
      subject.twice(item->name.span, fmt::format("earth '{}' is declared twice", item->name.text),
                    first->second);
      continue;
    }
    auto earth = EarthCheck(subject, *item).run();
    subject.earths.emplace(item->name.text,
                           earth ? static_cast<int>(subject.model.earths.size()) : -1);
    if (!earth) continue;
    EarthWork& work = subject.earth_works.emplace_back();
    work.last_dig.assign(earth->before.heights.size(), -1);
    subject.model.earths.push_back(*std::move(earth));
  }
}

std::optional<DugSoil> take_soil(Subject& subject, const Scope& scope, const syntax::DigItem& item,
                                 const syntax::TaskItem& task) {
  if (!item.earth) return std::nullopt;
  const auto known = subject.dug.find(&item);
  if (known != subject.dug.end()) return known->second;
  auto soil = SoilTaker(subject, scope, item, task).run();
  subject.dug.emplace(&item, soil);
  return soil;
}

void finish_earths(Subject& subject) {
  PlanModel& model = subject.model;
  std::size_t blocks = 0;
  for (std::size_t i = 0; i < model.earths.size(); ++i) {
    const EarthSpec& earth = model.earths[i];
    const EarthWork& work = subject.earth_works[i];
    const std::vector<LinkedDig> digs = linked_digs(subject, work);
    check_order(subject, work, digs);
    set_grounds(model, earth, work, digs);
    const soil::Terrain under = soil::flat(earth.after.columns, earth.after.rows, earth.after.cell,
                                           earth.after.heights.lowest() - kGroundBelow);
    const auto ground = soil::blocks_between(under, earth.after);
    blocks += ground.size();
    model.site_names.resize(model.site.size());
    if (blocks > kMostBlocks) {
      subject.error("P56", earth.span,
                    fmt::format("earth '{}' is made of {} boxes of equal height; expected up to {}",
                                earth.name, blocks, kMostBlocks),
                    "larger cells, or heights rounded to 0.1 m");
      return;
    }
    add_boxes(ground, earth.before.cell, earth.X_WE, model.site);
    model.site_names.resize(model.site.size(), earth.name);
  }
}

}  // namespace rubicon::interpreter::plan_check

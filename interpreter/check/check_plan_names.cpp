#include <fmt/format.h>

#include "interpreter/check/check_plan_parts.hpp"
#include "interpreter/check/resolve_frame.hpp"

namespace rubicon::interpreter::plan_check {

namespace {

/// Files one name; P02 if it is there already.
bool declare(Subject& subject, std::map<std::string, int>& index,
             std::map<std::string, Span>& spans, const syntax::Name& name, const char* what,
             int value) {
  const auto [place, is_new] = spans.emplace(name.text, name.span);
  if (!is_new) {
    subject.twice(name.span, fmt::format("{} '{}' is declared twice", what, name.text),
                  place->second);
    return false;
  }
  index.emplace(name.text, value);
  return true;
}

/// First pass: what is declared once, wherever it stands.
class Declaration {
 public:
  explicit Declaration(Subject& subject) : subject_(subject) {}

  void run() {
    for (const syntax::PlanItem& item : subject_.plan.items) {
      if (const auto* module = std::get_if<syntax::ModuleItem>(&item)) declare_module(*module);
      if (const auto* import = std::get_if<syntax::ImportItem>(&item)) declare_import(*import);
    }
    // Elements keep the order of the file; a placed module's stand where it is placed.
    for (const syntax::PlanItem& item : subject_.plan.items) {
      if (const auto* component = std::get_if<syntax::ComponentItem>(&item)) {
        if (declare(subject_, subject_.components, subject_.component_spans, component->name,
                    "component", static_cast<int>(components_))) {
          ++components_;
        }
      } else if (const auto* task = std::get_if<syntax::TaskItem>(&item)) {
        if (declare(subject_, subject_.tasks, subject_.task_spans, task->name, "task",
                    static_cast<int>(tasks_))) {
          subject_.task_items.emplace(task->name.text, task);
          ++tasks_;
        }
      } else if (const auto* place = std::get_if<syntax::PlaceItem>(&item)) {
        declare_place(*place);
      }
    }
    subject_.model.components.resize(components_);
    subject_.model.tasks.resize(tasks_);
  }

 private:
  void declare_module(const syntax::ModuleItem& item) {
    if (!declare(subject_, subject_.modules, module_spans_, item.name, "module",
                 static_cast<int>(subject_.module_infos.size()))) {
      return;
    }
    ModuleInfo info;
    info.item = &item;
    std::map<std::string, Span> component_spans, task_spans;
    for (const auto& inner : item.items) {
      if (const auto* component = std::get_if<syntax::ComponentItem>(&inner)) {
        refuse_nodes(*component);
        if (declare(subject_, info.component_index, component_spans, component->name, "component",
                    static_cast<int>(info.components.size()))) {
          info.components.push_back(component);
        }
      } else if (const auto* task = std::get_if<syntax::TaskItem>(&inner)) {
        if (declare(subject_, info.task_index, task_spans, task->name, "task",
                    static_cast<int>(info.tasks.size()))) {
          info.tasks.push_back(task);
        }
      }
    }
    subject_.module_infos.push_back(std::move(info));
  }

  /// A module is placed, a node is where it is.
  void refuse_nodes(const syntax::ComponentItem& component) {
    for (const syntax::Frame& frame : component.at) {
      if (frame.elements.front().kind != syntax::FrameElement::Kind::node) continue;
      subject_.error("P50", frame.span,
                     fmt::format("component '{}' stands where its module is placed, not at a node",
                                 component.name.text),
                     "declare it in the plan itself");
    }
  }

  void declare_import(const syntax::ImportItem& item) {
    // What an imported schedule had and plans do not have; it changes nothing.
    const bool is_remainder = item.as && item.as->text == "schedule";
    subject_.use(is_remainder ? "schedule" : "import", item.span);
    if (item.file.text.empty()) {
      subject_.error("F03", item.file.span, "expected the name of a file to import");
    }
    if (!item.as) {
      subject_.has_open_import = true;
      return;
    }
    const auto [place, is_new] = subject_.import_spans.emplace(item.as->text, item.as->span);
    if (!is_new) {
      subject_.twice(item.as->span, fmt::format("import '{}' is declared twice", item.as->text),
                     place->second);
    }
    place_spans_.emplace(item.as->text, item.as->span);
  }

  void declare_place(const syntax::PlaceItem& item) {
    PlaceInfo info;
    info.item = &item;
    info.X_WP = resolve_frame_or_identity(subject_, item.at);
    info.X_WS = item.from ? resolve_frame_or_identity(subject_, *item.from) : info.X_WP;
    info.module = subject_.find(subject_.modules, item.module, "module");
    info.first_component = static_cast<int>(components_);
    info.first_task = static_cast<int>(tasks_);
    if (!declare(subject_, subject_.places, place_spans_, item.as, "place",
                 static_cast<int>(subject_.place_infos.size()))) {
      return;
    }
    if (info.module >= 0) {
      ModuleInfo& module = subject_.module_infos[static_cast<std::size_t>(info.module)];
      module.placed = true;
      if (components_ + module.components.size() > kMaxElements ||
          tasks_ + module.tasks.size() > kMaxElements) {
        subject_.error("P18", item.as.span,
                       fmt::format("with this place the plan has more than {} components or tasks",
                                   kMaxElements));
        info.module = -1;
      } else {
        components_ += module.components.size();
        tasks_ += module.tasks.size();
      }
    }
    subject_.place_infos.push_back(std::move(info));
  }

  Subject& subject_;
  std::map<std::string, Span> module_spans_, place_spans_;
  std::size_t components_ = 0;
  std::size_t tasks_ = 0;
};

using NameIndex = std::map<std::string, int>;

/// An element of the plan itself, of the module in `scope`, or of a placed module.
std::optional<int> find_element(Subject& subject, const Scope& scope,
                                const syntax::QualifiedName& name, const char* what,
                                NameIndex Subject::*own, NameIndex ModuleInfo::*of_module,
                                int PlaceInfo::*first_of_place, int first_of_scope) {
  if (name.body) {
    const auto imported = (subject.*own).find(name.text());
    if (imported != (subject.*own).end()) return imported->second;
    const std::string& place_name = name.body->text;
    if (subject.import_spans.count(place_name) != 0) return std::nullopt;
    const auto place = subject.places.find(place_name);
    const auto like = (subject.*own).lower_bound(place_name + ".");
    if (place == subject.places.end() && like != (subject.*own).end() &&
        like->first.starts_with(place_name + ".")) {
      subject.unknown(name.span, what, name.text(), {&(subject.*own)});
      return std::nullopt;
    }
    if (place == subject.places.end()) {
      subject.unknown(name.body->span, "place", place_name, {&subject.places});
      return std::nullopt;
    }
    const PlaceInfo& info = subject.place_infos[static_cast<std::size_t>(place->second)];
    if (info.module < 0) return std::nullopt;
    const ModuleInfo& module = subject.module_infos[static_cast<std::size_t>(info.module)];
    const auto found = (module.*of_module).find(name.name.text);
    if (found != (module.*of_module).end()) return info.*first_of_place + found->second;
    subject.unknown(name.name.span, what, name.name.text, {&(module.*of_module)},
                    fmt::format(" of module '{}'", module.item->name.text));
    return std::nullopt;
  }
  if (scope.module != nullptr) {
    const auto found = (scope.module->*of_module).find(name.name.text);
    if (found != (scope.module->*of_module).end()) return first_of_scope + found->second;
  }
  const auto found = (subject.*own).find(name.name.text);
  if (found != (subject.*own).end()) return found->second;
  if (scope.module != nullptr) {
    subject.unknown(name.span, what, name.name.text,
                    {&(scope.module->*of_module), &(subject.*own)});
  } else {
    subject.unknown(name.span, what, name.name.text, {&(subject.*own)});
  }
  return std::nullopt;
}

}  // namespace

void Subject::twice(Span second, std::string message, Span first) {
  Diagnostic diagnostic;
  diagnostic.code = "P02";
  diagnostic.span = second;
  diagnostic.message = std::move(message);
  diagnostic.notes.push_back({first, "first given here"});
  if (first.begin == second.begin && first.copy != second.copy) {
    diagnostic.hint =
        fmt::format("each copy needs a name of its own, such as {}[i]", sources.text(second));
  }
  diagnostics.add(std::move(diagnostic));
}

void Subject::unknown(Span span, const std::string& what, const std::string& name,
                      std::initializer_list<const std::map<std::string, int>*> candidates,
                      const std::string& where) {
  if (!judges_names()) return;
  const std::string ending = suggestions.ending(name, [&] {
    std::vector<std::string> all;
    for (const auto* index : candidates) {
      for (const auto& [each, i] : *index) all.push_back(each);
    }
    return all;
  });
  error("P01", span, fmt::format("unknown {} '{}'{}{}", what, name, where, ending));
}

int Subject::find(const std::map<std::string, int>& index, const syntax::Name& name,
                  const char* what) {
  const auto found = index.find(name.text);
  if (found != index.end()) return found->second;
  unknown(name.span, what, name.text, {&index});
  return -1;
}

void declare_names(Subject& subject) { Declaration(subject).run(); }

std::optional<int> find_task(Subject& subject, const Scope& scope,
                             const syntax::QualifiedName& name) {
  return find_element(subject, scope, name, "task", &Subject::tasks, &ModuleInfo::task_index,
                      &PlaceInfo::first_task, scope.first_task);
}

std::optional<int> find_component(Subject& subject, const Scope& scope,
                                  const syntax::QualifiedName& name) {
  return find_element(subject, scope, name, "component", &Subject::components,
                      &ModuleInfo::component_index, &PlaceInfo::first_component,
                      scope.first_component);
}

math::Pose resolve_frame_or_identity(Subject& subject, const syntax::Frame& frame) {
  const std::optional<math::Pose> X =
      resolve_constant_frame(frame, subject.names, subject.diagnostics);
  return X ? *X : math::Pose::Identity();
}

math::Pose resolve_placed_frame(Subject& subject, const syntax::Frame& frame,
                                const math::Pose& X_WP) {
  const math::Pose X = resolve_frame_or_identity(subject, frame);
  const bool is_node = frame.elements.front().kind == syntax::FrameElement::Kind::node;
  return is_node ? X : X_WP * X;
}

}  // namespace rubicon::interpreter::plan_check

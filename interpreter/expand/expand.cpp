#include "interpreter/expand/expand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include "interpreter/expand/evaluate.hpp"
#include "interpreter/expand/imports.hpp"
#include "interpreter/expand/parameters.hpp"
#include "interpreter/expand/plain_items.hpp"
#include "interpreter/expand/qualify.hpp"
#include "interpreter/parse/parse.hpp"

namespace rubicon::interpreter {

namespace {

using namespace expansion;

/// Passes of `for` that only hold others; they make no copies, but take time.
constexpr std::int64_t kMaxPasses = 1000000;

/// `import "file" as NAME;` rather than `import "file" { ... }`, which is for another program.
bool is_module(const syntax::ImportItem& item, const SourceMap& sources) {
  return item.as && sources.text(item.span).ends_with(';');
}

template <typename Item>
struct BlockOf;
template <>
struct BlockOf<syntax::TaskPart> {
  using Type = syntax::TaskBlock;
};
template <>
struct BlockOf<syntax::ModulePart> {
  using Type = syntax::ModuleBlock;
};
template <>
struct BlockOf<syntax::NetworkPart> {
  using Type = syntax::NetworkBlock;
};
template <>
struct BlockOf<syntax::PlanItem> {
  using Type = syntax::PlanBlock;
};
template <typename Item>
using BlockPtr = std::shared_ptr<const typename BlockOf<Item>::Type>;

class Expansion {
 public:
  Expansion(Scope& scope, SourceMap& sources, Diagnostics& diagnostics,
            std::deque<std::vector<syntax::PlanItem>> imported)
      : scope_(scope),
        sources_(sources),
        diagnostics_(diagnostics),
        plain_items_(scope, diagnostics),
        imported_(std::move(imported)) {}

  template <typename Item>
  std::vector<Item> expanded(std::vector<Item> items) {
    std::vector<Item> result;
    result.reserve(items.size());
    for (Item& item : items) append(std::move(item), result);
    return result;
  }

  bool failed() const { return failed_; }
  /// Too many copies: what was made of the file says nothing.
  bool full() const { return full_; }

 private:
  template <typename Item>
  void append(Item item, std::vector<Item>& to) {
    if (full_) return;
    if (const auto* block = std::get_if<BlockPtr<Item>>(&item)) {
      run(**block, to);
      return;
    }
    if constexpr (std::is_same_v<Item, syntax::PlanItem>) {
      if (const auto* parameter = std::get_if<syntax::PlanParameter>(&item)) {
        check_place(*parameter);
        return;
      }
      if (const auto* import = std::get_if<syntax::ImportItem>(&item);
          import && is_module(*import, sources_)) {
        add_imported(*import, to);
        return;
      }
    }
    const bool made = std::visit([this](auto& each) { return this->make_plain(each); }, item);
    failed_ = failed_ || !made;
    if (made) to.push_back(std::move(item));
  }

  template <typename Item>
  bool make_plain(Item& item) {
    return plain_items_.make_plain(item);
  }
  bool make_plain(syntax::TaskItem& item) {
    if (!plain_items_.make_plain(item)) return false;
    item.parts = expanded(std::move(item.parts));
    return true;
  }
  bool make_plain(syntax::ModuleItem& item) {
    if (!plain_items_.make_plain(item)) return false;
    item.items = expanded(std::move(item.items));
    return true;
  }
  bool make_plain(syntax::NetworkItem& item) {
    if (!plain_items_.make_plain(item)) return false;
    item.parts = expanded(std::move(item.parts));
    return true;
  }
  // Seen to before.
  bool make_plain(syntax::PlanParameter&) { return false; }
  template <typename Block>
  bool make_plain(std::shared_ptr<const Block>&) {
    return false;
  }

  /// The items of the next import.
  void add_imported(const syntax::ImportItem& import, std::vector<syntax::PlanItem>& to) {
    if (depth_ > 0) {
      failed_ = true;
      diagnostics_.error("P28", at(import.span),
                         "an import stands in the plan itself, not in a for or when");
      return;
    }
    if (imported_.empty()) return;
    for (syntax::PlanItem& item : imported_.front()) to.push_back(std::move(item));
    imported_.pop_front();
  }

  void check_place(const syntax::PlanParameter& parameter) {
    if (depth_ == 0) return;
    failed_ = true;
    diagnostics_.error(
        "P26", at(parameter.name.span),
        fmt::format("parameter '{}' stands in a for or when; parameters stand in the "
                    "plan itself",
                    parameter.name.text));
  }

  template <typename Block, typename Item>
  void run(const Block& block, std::vector<Item>& to) {
    ++depth_;
    if (block.head.variable) {
      repeat(block, to);
    } else {
      const auto holds = evaluate_condition(*block.head.condition, scope_, diagnostics_);
      failed_ = failed_ || !holds;
      if (holds && *holds) append_all(block, to);
    }
    --depth_;
  }

  template <typename Block, typename Item>
  void append_all(const Block& block, std::vector<Item>& to) {
    for (const Item& item : block.items) append(Item(item), to);
  }

  template <typename Block, typename Item>
  void repeat(const Block& block, std::vector<Item>& to) {
    const syntax::BlockHead& head = block.head;
    const std::string& name = head.variable->text;
    const auto first = bound(head.first, "the first number of a for");
    const auto last = bound(head.last, "the last number of a for");
    if (!is_new_name(*head.variable) || !first || !last) {
      failed_ = true;
      return;
    }
    if (*last < *first || !has_room(block, *last - *first + 1)) return;
    const std::uint32_t outer = scope_.copy;
    scope_.variables.push_back({name, 0, head.variable->span});
    for (std::int64_t i = *first; i <= *last && !full_; ++i) {
      scope_.variables.back().value = i;
      scope_.copy = sources_.add_copy(outer, name, i);
      append_all(block, to);
    }
    scope_.variables.pop_back();
    scope_.copy = outer;
  }

  std::optional<std::int64_t> bound(const syntax::Number& number, const char* what) {
    if (number.expression) {
      return evaluate_whole(*number.expression, what, scope_, diagnostics_);
    }
    syntax::Expression literal;
    literal.number = number;
    literal.span = number.span;
    return evaluate_whole(literal, what, scope_, diagnostics_);
  }

  bool is_new_name(const syntax::Name& name) {
    if (!is_own_name(scope_, name.text)) return true;
    Diagnostic diagnostic;
    diagnostic.code = "P26";
    diagnostic.span = at(name.span);
    diagnostic.message = fmt::format("'{}' is a name already; this for needs another", name.text);
    const auto parameter = scope_.parameters.find(name.text);
    Span first = parameter != scope_.parameters.end() ? parameter->second.span : Span{};
    for (const Scope::Variable& each : scope_.variables) {
      if (each.name == name.text) first = each.span;
    }
    diagnostic.notes.push_back({first, "first given here"});
    diagnostics_.add(std::move(diagnostic));
    return false;
  }

  /// Whether `passes` more passes of the block are within the limits; P25 if not, and nothing more
  /// is made of the file.
  template <typename Block>
  bool has_room(const Block& block, std::int64_t passes) {
    const bool only_nests = !block.items.empty() && holds_only_blocks(block);
    passes_ += passes;
    if (!only_nests) copies_ += passes;
    text_ += static_cast<double>(passes) * (block.span.end - block.span.begin);
    std::string what;
    if (copies_ > kMaxCopies) {
      what = fmt::format("the file has more than {} copies", kMaxCopies);
    } else if (passes_ > kMaxPasses) {
      what = fmt::format("the file has more than {} passes of its for", kMaxPasses);
    } else if (text_ > static_cast<double>(kMaxTextBytes)) {
      what = "the copies of this file would fill more than 256 MB of text";
    }
    if (what.empty()) return true;
    full_ = failed_ = true;
    diagnostics_.error("P25", at(block.head.keyword),
                       fmt::format("this for runs {} times: with it {}", passes, what));
    return false;
  }

  template <typename Block>
  static bool holds_only_blocks(const Block& block) {
    for (const auto& item : block.items) {
      const bool is_block = std::visit(
          [](const auto& each) {
            return std::is_same_v<std::decay_t<decltype(each)>, std::shared_ptr<const Block>> &&
                   is_for(each);
          },
          item);
      if (!is_block) return false;
    }
    return true;
  }
  template <typename Block>
  static bool is_for(const std::shared_ptr<const Block>& block) {
    return block->head.variable.has_value();
  }
  template <typename Item>
  static bool is_for(const Item&) {
    return false;
  }

  Span at(Span span) const {
    span.copy = scope_.copy;
    return span;
  }

  Scope& scope_;
  SourceMap& sources_;
  Diagnostics& diagnostics_;
  PlainItems plain_items_;
  int depth_ = 0;            ///< of blocks around
  std::int64_t copies_ = 0;  ///< so far, as are the next two
  std::int64_t passes_ = 0;
  double text_ = 0;                                     ///< bytes, written out
  std::deque<std::vector<syntax::PlanItem>> imported_;  ///< in the order of their imports
  bool failed_ = false;
  bool full_ = false;
};

/// The plan that `item` imports, read and made plain; nothing where that fails.
std::optional<syntax::Plan> imported_plan(const syntax::ImportItem& item, const ParameterTexts& set,
                                          Scope& scope, SourceMap& sources,
                                          Diagnostics& diagnostics, ImportFiles& imports);

void expand_in(syntax::Plan& plan, const ParameterTexts& set, Scope& scope, SourceMap& sources,
               Diagnostics& diagnostics, ImportFiles* imports) {
  const int errors_before = diagnostics.errors();
  scope.broken = plan.broken;
  std::deque<std::vector<syntax::PlanItem>> imported;
  evaluate_parameters(plan, set, scope, diagnostics,
                      [&](const syntax::ImportItem& item, const ParameterTexts& set_of_it) {
                        if (!is_module(item, sources)) return;
                        imported.emplace_back();
                        if (imports == nullptr) return;
                        auto read =
                            imported_plan(item, set_of_it, scope, sources, diagnostics, *imports);
                        plan.broken = plan.broken || !read || read->broken;
                        scope.broken = plan.broken;
                        if (read) imported.back() = std::move(read->items);
                      });
  Expansion expansion(scope, sources, diagnostics, std::move(imported));
  plan.items = expansion.expanded(std::move(plan.items));
  if (expansion.full()) plan.items.clear();
  plan.broken = plan.broken || expansion.failed() || diagnostics.errors() != errors_before;
}

std::optional<syntax::Plan> imported_plan(const syntax::ImportItem& item, const ParameterTexts& set,
                                          Scope& scope, SourceMap& sources,
                                          Diagnostics& diagnostics, ImportFiles& imports) {
  const std::string path = resolve_path(imports.open.back(), item.file.text);
  if (std::find(imports.open.begin(), imports.open.end(), path) != imports.open.end()) {
    diagnostics.error("P28", item.file.span, fmt::format("'{}' imports itself", item.file.text));
    return std::nullopt;
  }
  if (imports.left-- <= 0) {
    diagnostics.error("P28", item.file.span, "a plan imports at most 100 files, all in all");
    return std::nullopt;
  }
  std::variant<std::string, FileFailure> text = imports.files.read_text(path);
  if (const auto* failure = std::get_if<FileFailure>(&text)) {
    diagnostics.error("F01", item.file.span,
                      fmt::format("plan '{}': {}", item.file.text, failure->message));
    return std::nullopt;
  }
  const FileId file = sources.add(path, std::get<std::string>(std::move(text)));
  syntax::Plan plan = parse_plan(sources, file, diagnostics);
  Scope inner;
  inner.importer = &scope;
  inner.prefix = scope.prefix + item.as->text + ".";
  imports.open.push_back(path);
  expand_in(plan, set, inner, sources, diagnostics, &imports);
  imports.open.pop_back();
  qualify(plan, item.as->text, item.file.text, diagnostics);
  for (auto& [name, parameter] : inner.parameters) {
    scope.parameters.emplace(item.as->text + "." + name, std::move(parameter));
  }
  return plan;
}

}  // namespace

void expand_plan(syntax::Plan& plan, const ParameterTexts& set, SourceMap& sources,
                 Diagnostics& diagnostics) {
  Scope scope;
  expand_in(plan, set, scope, sources, diagnostics, nullptr);
}

void expand_plan(syntax::Plan& plan, const ParameterTexts& set, SourceMap& sources,
                 Diagnostics& diagnostics, ImportFiles& imports) {
  Scope scope;
  expand_in(plan, set, scope, sources, diagnostics, &imports);
}

}  // namespace rubicon::interpreter

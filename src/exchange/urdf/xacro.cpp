#include "src/exchange/urdf/xacro.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "src/exchange/project_io/decode_text.hpp"
#include "src/exchange/urdf/expression.hpp"
#include "src/exchange/urdf/fault.hpp"
#include "src/exchange/urdf/limits.hpp"
#include "src/exchange/urdf/number_text.hpp"
#include "src/exchange/urdf/read_xml.hpp"

namespace rubicon::urdf {

namespace {

using Elements = std::vector<Element>;
using interpreter::Span;

constexpr std::string_view kPrefix = "xacro:";

/// A parameter of a macro.
struct Parameter {
  enum class Kind { value, element, content };
  std::string name;
  Kind kind = Kind::value;            ///< `name`, `*name`, `**name`
  std::optional<std::string> preset;  ///< behind `:=`
  bool forwarded = false;             ///< `:=^`: what the caller knows by that name
};

struct Macro {
  std::vector<Parameter> parameters;
  Elements content;
  std::string path;  ///< of the file it stands in
};

/// What a name stands for; a text is evaluated when it is asked for.
struct Property {
  Value value;
  bool pending = false;
};

struct Scope {
  std::map<std::string, Property> properties;
  std::map<std::string, Elements> blocks;
  Scope* outer = nullptr;
};

std::string without_prefix(const std::string& name) {
  return name.starts_with(kPrefix) ? name.substr(kPrefix.size()) : name;
}

/// `a b:=1 c:='x y' d:=^|2 *block **content`
std::vector<Parameter> parameters_of(const std::string& text, Span span) {
  std::vector<Parameter> result;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(kBlanks, at)) != std::string::npos) {
    Parameter parameter;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n:=", at), text.size());
    parameter.name = text.substr(at, end - at);
    at = end;
    if (text.compare(at, 2, ":=") == 0 || text.compare(at, 1, "=") == 0) {
      at += text[at] == ':' ? 2 : 1;
      const std::size_t begin = at;
      while (at < text.size() && kBlanks.find(text[at]) == std::string_view::npos) {
        at = text[at] == '\'' ? std::min(text.find('\'', at + 1), text.size() - 1) + 1 : at + 1;
      }
      std::string preset = text.substr(begin, at - begin);
      if (preset.starts_with("^")) {
        parameter.forwarded = true;
        preset.erase(0, preset.starts_with("^|") ? 2 : 1);
        if (text.compare(begin, 2, "^|") == 0) parameter.preset = preset;
      } else {
        parameter.preset = preset;
      }
    } else if (at < text.size() && text[at] == ':') {
      fail("I22", span,
           fmt::format("expected := behind the parameter '{}', found ':'", parameter.name));
    }
    const std::size_t stars = parameter.name.find_first_not_of('*');
    if (stars == 1) parameter.kind = Parameter::Kind::element;
    if (stars == 2) parameter.kind = Parameter::Kind::content;
    if (stars == std::string::npos || stars > 2) {
      fail("I22", span,
           fmt::format("expected names of parameters in params, found '{}'", parameter.name));
    }
    parameter.name.erase(0, stars);
    result.push_back(std::move(parameter));
  }
  return result;
}

class Expander {
 public:
  explicit Expander(const XacroContext& context)
      : context_(context), arguments_(context.arguments), path_(context.path) {}

  Element run(const Element& root) {
    Element result;
    try {
      result = copy_head(root, global_);
      expand_all(root.children, global_, result.children, 1);
    } catch (Fault& fault) {
      if (!calls_.empty()) {
        fault.diagnostic.notes.push_back({calls_.front(), "for the macro that is called here"});
      }
      throw;
    }
    for (const auto& [name, value] : context_.arguments) {
      if (asked_.contains(name)) continue;
      context_.findings->warn("I28", "argument " + name, root.span,
                              fmt::format("the argument '{}' is not used", name));
    }
    return result;
  }

 private:
  // --- elements

  void expand_all(const Elements& elements, Scope& scope, Elements& out, int depth) {
    for (const Element& each : elements) expand(each, scope, out, depth);
  }

  // Recursion is bounded by kMaxDepth: of elements, whether written or called.
  void expand(const Element& element, Scope& scope, Elements& out, int depth) {
    if (depth > kMaxDepth) {
      fail("I21", element.span,
           fmt::format("expected elements at most {} deep in each other, found more", kMaxDepth));
    }
    count(element);
    if (!element.name.starts_with(kPrefix)) {
      Element copy = copy_head(element, scope);
      expand_all(element.children, scope, copy.children, depth + 1);
      out.push_back(std::move(copy));
      return;
    }
    const std::string name = without_prefix(element.name);
    if (name == "property") {
      define_property(element, scope);
    } else if (name == "macro") {
      define_macro(element);
    } else if (name == "arg") {
      define_argument(element, scope);
    } else if (name == "include") {
      include(element, scope, out, depth);
    } else if (name == "if" || name == "unless") {
      if (condition(element, scope) == (name == "if")) {
        expand_all(element.children, scope, out, depth + 1);
      }
    } else if (name == "insert_block") {
      insert_block(element, scope, out, depth);
    } else if (name == "element" || name == "attribute") {
      fail("I22", element.span, fmt::format("<{}> is not read here", element.name),
           "expand the file with xacro first, and import the URDF");
    } else {
      call_macro(element, name == "call" ? text(required(element, "macro"), element, scope) : name,
                 scope, out, depth);
    }
  }

  void count(const Element& element) {
    if (++elements_ > kMaxElements) {
      fail("I21", element.span,
           fmt::format("expected at most {} elements after expansion, found more", kMaxElements),
           "is this one machine?");
    }
  }

  /// Of what is copied whole.
  void count_tree(const Element& element) {
    count(element);
    for (const Element& each : element.children) count_tree(each);
  }

  void count_bytes(std::size_t bytes, const Element& element) {
    bytes_ += bytes;
    if (bytes_ > kMaxExpandedBytes) {
      fail("I21", element.span,
           fmt::format("expected at most {} MB after expansion, found more",
                       kMaxExpandedBytes >> 20));
    }
  }

  Element copy_head(const Element& element, Scope& scope) {
    Element copy;
    copy.name = element.name;
    copy.span = element.span;
    count_bytes(element.name.size(), element);
    for (const Attribute& each : element.attributes) {
      if (each.name.starts_with("xmlns")) continue;
      if (each.name.starts_with(kPrefix)) {
        context_.findings->note("I25", "attribute " + each.name, element.span,
                                fmt::format("'{}' is not taken over", each.name));
        continue;
      }
      copy.attributes.push_back({each.name, text(each.value, element, scope)});
      count_bytes(each.name.size() + copy.attributes.back().value.size(), element);
    }
    return copy;
  }

  static const std::string& required(const Element& element, std::string_view attribute) {
    const std::string* value = element.find(attribute);
    if (value == nullptr) {
      fail("I22", element.span,
           fmt::format("expected the attribute '{}' in <{}>, found none", attribute, element.name));
    }
    return *value;
  }

  static void know_attributes(const Element& element, const std::set<std::string_view>& known) {
    for (const Attribute& each : element.attributes) {
      if (!known.contains(each.name)) {
        fail("I22", element.span,
             fmt::format("the attribute '{}' of <{}> is not read here", each.name, element.name));
      }
    }
  }

  // --- definitions

  void define_property(const Element& element, Scope& scope) {
    know_attributes(element, {"name", "value", "default", "scope"});
    const std::string name = text(required(element, "name"), element, scope);
    Scope* target = &scope;
    if (const std::string* where = element.find("scope")) {
      if (*where == "global") {
        target = &global_;
      } else if (*where == "parent") {
        target = scope.outer != nullptr ? scope.outer : &global_;
      } else {
        fail("I22", element.span,
             fmt::format("expected scope=\"global\" or \"parent\", found '{}'", *where));
      }
    }
    const std::string* value = element.find("value");
    if (value == nullptr) {
      value = element.find("default");
      if (value != nullptr && find_property(name, scope) != nullptr) return;
    }
    if (value == nullptr) {
      count_tree(element);
      target->blocks[name] = element.children;
      return;
    }
    Property property{literal_value(*value), true};
    if (target != &scope) property = {evaluated(*value, element, scope), false};
    if (!std::holds_alternative<std::string>(property.value)) property.pending = false;
    target->properties[name] = std::move(property);
  }

  void define_macro(const Element& element) {
    know_attributes(element, {"name", "params"});
    auto macro = std::make_shared<Macro>();
    const std::string* parameters = element.find("params");
    if (parameters != nullptr) macro->parameters = parameters_of(*parameters, element.span);
    count_tree(element);
    macro->content = element.children;
    macro->path = path_;
    macros_[without_prefix(required(element, "name"))] = std::move(macro);
  }

  void define_argument(const Element& element, Scope& scope) {
    know_attributes(element, {"name", "default"});
    const std::string name = text(required(element, "name"), element, scope);
    const std::string* preset = element.find("default");
    if (preset != nullptr && !arguments_.contains(name)) {
      arguments_[name] = text(*preset, element, scope);
    }
  }

  bool condition(const Element& element, Scope& scope) {
    know_attributes(element, {"value"});
    try {
      return truth(evaluated(required(element, "value"), element, scope));
    } catch (const ExpressionError& error) {
      fail("I22", element.span, fmt::format("in <{}>: {}", element.name, error.message));
    }
  }

  // --- files

  void include(const Element& element, Scope& scope, Elements& out, int depth) {
    know_attributes(element, {"filename", "optional"});
    const std::string name = text(required(element, "filename"), element, scope);
    const std::string* optional = element.find("optional");
    auto found = context_.files->find(name, path_);
    if (const auto* failure = std::get_if<PackageFailure>(&found)) {
      if (optional != nullptr && truth(literal_value(*optional))) {
        context_.findings->note("I25", "optional " + name, element.span,
                                fmt::format("'{}' is optional and not there: left out", name));
        return;
      }
      fail("I23", element.span, "this file cannot be included: " + failure->message, failure->hint);
    }
    const FoundFile& file = std::get<FoundFile>(found);
    if (!file.note.empty()) context_.findings->note("I29", file.note, element.span, file.note);
    if (std::find(open_.begin(), open_.end(), file.path) != open_.end() ||
        file.path == context_.path) {
      fail("I22", element.span, fmt::format("'{}' includes itself", name),
           "take one include out of the ring");
    }
    if (++includes_ > kMaxIncludes || open_.size() == kMaxIncludeDepth) {
      fail("I21", element.span,
           fmt::format("expected at most {} included files, {} deep in each other, found more",
                       kMaxIncludes, kMaxIncludeDepth));
    }
    const Element root = read(element, file.path);
    open_.push_back(file.path);
    const std::string outer = std::exchange(path_, file.path);
    expand_all(root.children, scope, out, depth);
    path_ = outer;
    open_.pop_back();
  }

  Element read(const Element& element, const std::string& path) {
    auto file = files_.find(path);
    if (file == files_.end()) {
      auto text = context_.files->read_text(path);
      if (const auto* failure = std::get_if<PackageFailure>(&text)) {
        fail("I23", element.span, "this file cannot be included: " + failure->message);
      }
      project_io::DecodedText decoded = project_io::decode_text(std::get<std::string>(text));
      file = files_.emplace(path, context_.sources->add(path, std::move(decoded.text))).first;
    }
    read_bytes_ += context_.sources->file(file->second).text.size();
    if (read_bytes_ > kMaxFileBytes) {
      fail(
          "I21", element.span,
          fmt::format("expected at most {} MB of included files, found more", kMaxFileBytes >> 20));
    }
    return read_xml(*context_.sources, file->second);
  }

  // --- macros

  static const Elements* find_block(const std::string& name, const Scope& scope) {
    for (const Scope* at = &scope; at != nullptr; at = at->outer) {
      const auto found = at->blocks.find(name);
      if (found != at->blocks.end()) return &found->second;
    }
    return nullptr;
  }

  void insert_block(const Element& element, Scope& scope, Elements& out, int depth) {
    know_attributes(element, {"name"});
    const std::string name = text(required(element, "name"), element, scope);
    const Elements* block = find_block(name, scope);
    if (block == nullptr) {
      fail("I22", element.span, fmt::format("the block '{}' is not known", name));
    }
    for (const Element& each : *block) count_tree(each);
    const Elements copy = *block;  // what it expands to may define it anew
    expand_all(copy, scope, out, depth + 1);
  }

  void call_macro(const Element& element, const std::string& name, Scope& scope, Elements& out,
                  int depth) {
    const auto found = macros_.find(name);
    if (found == macros_.end()) {
      std::vector<std::string> names = {"property", "macro",  "include",     "arg",
                                        "if",       "unless", "insert_block"};
      for (const auto& [each, ignored] : macros_) names.push_back(each);
      const std::string nearest = interpreter::did_you_mean(name, names);
      fail("I22", element.span,
           fmt::format("the macro '{}' is not known{}", name,
                       nearest.empty() ? "" : "; did you mean " + nearest + "?"));
    }
    const std::shared_ptr<const Macro> macro = found->second;
    if (calls_.size() == kMaxCallDepth) {
      fail("I21", element.span,
           fmt::format("expected macros at most {} deep in each other, found more", kMaxCallDepth),
           "does the macro call itself without end?");
    }
    Scope inner;
    inner.outer = &scope;
    bind_values(element, *macro, scope, inner);
    bind_blocks(element, *macro, scope, inner, depth);
    calls_.push_back(element.span);
    const std::string outer = std::exchange(path_, macro->path);
    expand_all(macro->content, inner, out, depth + 1);
    path_ = outer;
    calls_.pop_back();
  }

  void bind_values(const Element& element, const Macro& macro, Scope& scope, Scope& inner) {
    for (const Attribute& each : element.attributes) {
      const bool known = std::any_of(
          macro.parameters.begin(), macro.parameters.end(), [&](const Parameter& parameter) {
            return parameter.kind == Parameter::Kind::value && parameter.name == each.name;
          });
      if (!known && !(element.name == "xacro:call" && each.name == "macro")) {
        fail("I22", element.span,
             fmt::format("the macro of <{}> has no parameter '{}'", element.name, each.name));
      }
      if (known) inner.properties[each.name] = {evaluated(each.value, element, scope), false};
    }
    for (const Parameter& each : macro.parameters) {
      if (each.kind != Parameter::Kind::value || inner.properties.contains(each.name)) continue;
      if (each.forwarded) {
        if (std::optional<Value> value = value_of(each.name, scope, element)) {
          inner.properties[each.name] = {*std::move(value), false};
          continue;
        }
      }
      if (!each.preset) {
        fail("I22", element.span,
             fmt::format("<{}> needs a value for its parameter '{}'", element.name, each.name));
      }
      inner.properties[each.name] = {evaluated(unquoted(*each.preset), element, inner), false};
    }
  }

  static std::string unquoted(const std::string& text) {
    const bool quoted = text.size() >= 2 && text.front() == '\'' && text.back() == '\'';
    return quoted ? text.substr(1, text.size() - 2) : text;
  }

  void bind_blocks(const Element& element, const Macro& macro, Scope& scope, Scope& inner,
                   int depth) {
    Elements blocks;
    expand_all(element.children, scope, blocks, depth + 1);
    std::size_t next = 0;
    for (const Parameter& each : macro.parameters) {
      if (each.kind == Parameter::Kind::value) continue;
      if (next == blocks.size()) {
        if (const Elements* given = each.forwarded ? find_block(each.name, scope) : nullptr) {
          inner.blocks[each.name] = *given;
          continue;
        }
        fail("I22", element.span,
             fmt::format("<{}> needs an element for its block '{}'", element.name, each.name));
      }
      Element& block = blocks[next++];
      if (each.kind == Parameter::Kind::content) {
        inner.blocks[each.name] = std::move(block.children);
      } else {
        inner.blocks[each.name] = {std::move(block)};
      }
    }
    if (next < blocks.size()) {
      fail("I22", blocks[next].span,
           fmt::format("<{}> takes {} elements, found one more", element.name, next));
    }
  }

  // --- values

  static Property* find_property(const std::string& name, Scope& scope, Scope** place = nullptr) {
    for (Scope* at = &scope; at != nullptr; at = at->outer) {
      const auto found = at->properties.find(name);
      if (found == at->properties.end()) continue;
      if (place != nullptr) *place = at;
      return &found->second;
    }
    return nullptr;
  }

  std::optional<Value> value_of(const std::string& name, Scope& scope, const Element& element) {
    Scope* place = nullptr;
    Property* property = find_property(name, scope, &place);
    if (property == nullptr) return std::nullopt;
    if (!property->pending) return property->value;
    if (resolving_.size() == kMaxExpressionDepth / 2 || !resolving_.insert(property).second) {
      throw ExpressionError{
          fmt::format("the property '{}' needs itself, or too many others", name)};
    }
    const std::string written = std::get<std::string>(property->value);
    Value value = evaluated(written, element, *place);
    resolving_.erase(property);
    property->value = std::move(value);
    property->pending = false;
    return property->value;
  }

  std::string text(const std::string& written, const Element& element, Scope& scope) {
    return text_of(raw(written, element, scope));
  }

  /// With a text that reads as a number being one.
  Value evaluated(const std::string& written, const Element& element, Scope& scope) {
    Value value = raw(written, element, scope);
    const auto* text = std::get_if<std::string>(&value);
    return text != nullptr ? literal_value(*text) : value;
  }

  Value raw(const std::string& written, const Element& element, Scope& scope) {
    if (written.find('$') == std::string::npos) return written;
    try {
      return substituted(written, element, scope);
    } catch (const ExpressionError& error) {
      fail("I22", element.span,
           fmt::format("in '{}' of <{}>: {}", shortened(written), element.name, error.message),
           "expand the file with xacro first, and import the URDF, if it is right");
    }
  }

  static std::string shortened(const std::string& text) {
    return text.size() <= 80 ? text : project_io::clean_text(text.substr(0, 77)) + "...";
  }

  /// A text with its ${...} and $(...); what is one ${...} from end to end keeps its type.
  Value substituted(const std::string& written, const Element& element, Scope& scope) {
    const Deeper deeper(substitutions_);
    std::string result;
    std::size_t at = 0;
    while (at < written.size()) {
      if (written.compare(at, 3, "$${") == 0 || written.compare(at, 3, "$$(") == 0) {
        result += written.substr(at + 1, 2);
        at += 3;
        continue;
      }
      const bool expression = written.compare(at, 2, "${") == 0;
      if (!expression && written.compare(at, 2, "$(") != 0) {
        result += written[at++];
        continue;
      }
      const std::size_t end = closing(written, at + 1);
      std::string inner = written.substr(at + 2, end - at - 2);
      // $(...) in an expression stands for its text.
      if (expression && inner.find("$(") != std::string::npos) inner = text(inner, element, scope);
      Value value =
          expression ? evaluate_in(inner, element, scope) : command(inner, element, scope);
      if (at == 0 && end + 1 == written.size()) return value;
      result += text_of(value);
      if (result.size() > kMaxTextBytes) throw ExpressionError{"the text becomes too long"};
      at = end + 1;
    }
    return result;
  }

  /// Where the bracket at `open` is closed.
  static std::size_t closing(const std::string& text, std::size_t open) {
    const char opens = text[open], closes = opens == '{' ? '}' : ')';
    int depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
      if (text[i] == opens) ++depth;
      if (text[i] == closes && --depth == 0) return i;
    }
    throw ExpressionError{fmt::format("expected '{}' before its end", closes)};
  }

  /// `knows_arguments`: a name that is no property may be an argument.
  Value evaluate_in(const std::string& expression, const Element& element, Scope& scope,
                    bool knows_arguments = false) {
    const NameLookup lookup = [&](const std::string& name) -> std::optional<Value> {
      if (auto value = value_of(name, scope, element)) return value;
      if (!knows_arguments || arguments_.count(name) == 0) return std::nullopt;
      return literal_value(argument(name));
    };
    Value value = evaluate(expression, lookup, steps_);
    const auto* text = std::get_if<std::string>(&value);
    if (text != nullptr) {
      if (text->size() / 64 >= steps_) throw ExpressionError{"the expressions take too many steps"};
      steps_ -= text->size() / 64;
    }
    return value;
  }

  const std::string& argument(const std::string& name) {
    const auto found = arguments_.find(name);
    if (found == arguments_.end()) {
      throw ExpressionError{
          fmt::format("the argument '{0}' has no value; give it: --arg {0}=VALUE", name)};
    }
    asked_.insert(name);
    return found->second;
  }

  /// The expression of $(eval ...) with the value of each arg('name') in its place.
  std::string with_arguments(const std::string& expression) {
    constexpr std::string_view kCall = "arg(";
    constexpr std::string_view kOfNames =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";
    std::string result;
    std::size_t done = 0;
    for (std::size_t at = expression.find(kCall); at != std::string::npos;
         at = expression.find(kCall, at + 1)) {
      if (at > 0 && kOfNames.find(expression[at - 1]) != std::string_view::npos) continue;
      const std::size_t close = expression.find(')', at);
      if (close == std::string::npos) break;
      std::string_view name(expression);
      name = name.substr(at + kCall.size(), close - at - kCall.size());
      name.remove_prefix(std::min(name.find_first_not_of(kBlanks), name.size()));
      name = name.substr(0, name.find_last_not_of(kBlanks) + 1);
      const bool quoted = name.size() > 2 && name.front() == name.back() &&
                          (name.front() == '\'' || name.front() == '"');
      if (!quoted) continue;
      const std::string& value = argument(std::string(name.substr(1, name.size() - 2)));
      const bool is_text = std::holds_alternative<std::string>(literal_value(value));
      if (is_text && value.find_first_of("'\\") != std::string::npos) {
        throw ExpressionError{
            fmt::format("the argument '{}' has a quote or a backslash, which cannot stand in an "
                        "expression",
                        shortened(std::string(name)))};
      }
      result += expression.substr(done, at - done);
      result += is_text ? "'" + value + "'" : "(" + value + ")";
      if (result.size() > kMaxTextBytes) throw ExpressionError{"the text becomes too long"};
      done = close + 1;
      at = close;
    }
    return result + expression.substr(done);
  }

  /// What stands in $(...).
  Value command(const std::string& written, const Element& element, Scope& scope) {
    const std::size_t blank = std::min(written.find_first_of(kBlanks), written.size());
    const std::string word = written.substr(0, blank);
    const std::size_t begin = std::min(written.find_first_not_of(kBlanks, blank), written.size());
    const std::string rest = text(written.substr(begin), element, scope);
    if (word == "eval") return evaluate_in(with_arguments(rest), element, scope, true);
    if (word == "find") return "package://" + rest;
    if (word == "dirname") {
      const std::size_t slash = path_.rfind('/');
      return slash == std::string::npos ? std::string(".") : path_.substr(0, slash);
    }
    if (word == "arg") return argument(rest);
    throw ExpressionError{
        fmt::format("$({}) is not read here; arg, find, dirname and eval are", shortened(word))};
  }

  const XacroContext& context_;
  std::map<std::string, std::string> arguments_;
  std::set<std::string> asked_;
  Scope global_;
  /// Wherever they are defined, all know them. Shared: a macro may define itself anew.
  std::map<std::string, std::shared_ptr<const Macro>> macros_;
  std::string path_;               ///< of the file that is being expanded
  std::vector<std::string> open_;  ///< files that are being included
  std::map<std::string, interpreter::FileId> files_;
  std::vector<Span> calls_;
  std::set<const Property*> resolving_;
  int substitutions_ = 0;  ///< that are in each other
  std::size_t includes_ = 0;
  std::size_t elements_ = 0;
  std::size_t bytes_ = 0;
  std::size_t read_bytes_ = 0;
  std::size_t steps_ = kMaxExpressionSteps;
};

}  // namespace

bool is_xacro(const Element& root, const std::string& path) {
  if (path.ends_with(".xacro")) return true;
  return root.find("xmlns:xacro") != nullptr;
}

Element expand_xacro(const Element& root, const XacroContext& context) {
  return Expander(context).run(root);
}

}  // namespace rubicon::urdf

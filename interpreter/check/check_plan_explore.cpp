#include "interpreter/check/check_plan_explore.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

namespace rubicon::interpreter::plan_check {

namespace {

constexpr double kMostExplorerSpeed = 1000;  // m/s
/// Robots that explore one network, each by itself.
constexpr std::size_t kMostExplorers = 1000;

class ExploreCheck {
 public:
  ExploreCheck(Subject& subject, const syntax::NetworkItem& item, const syntax::PolicyItem& policy)
      : subject_(subject), item_(item), policy_(policy) {}

  void run(bool is_whole) {
    const int errors = subject_.diagnostics.errors();
    const NetworkSpec& network = subject_.model.networks.back();
    subject_.use("policy " + policy_.name.text, policy_.span);
    if (subject_.plan.items.size() > 1) {
      wrong(policy_.span,
            fmt::format("a plan with policy {} has this network and nothing else: its robots go "
                        "from node to node, without bodies, tasks or loads",
                        policy_.name.text));
    }
    for (std::size_t i = 0; i < network.description.nodes.size(); ++i) {
      nodes_.emplace(network.description.nodes[i].name, static_cast<int>(i));
    }
    for (const syntax::NetworkPart& part : item_.parts) {
      if (const auto* explore = std::get_if<syntax::ExploreItem>(&part)) add(*explore);
    }
    if (spec_.explorers.empty() && !subject_.plan.broken &&
        subject_.diagnostics.errors() == errors) {
      subject_.diagnostics.warning("P61", item_.name.span,
                                   fmt::format("nobody explores network '{}'", item_.name.text),
                                   "write explore ROBOT from NODE;");
    }
    if (spec_.explorers.size() > kMostExplorers) {
      wrong(item_.name.span, fmt::format("{} robots explore this network; at most {} can",
                                         spec_.explorers.size(), kMostExplorers));
    }
    if (!is_whole || subject_.plan.broken || subject_.diagnostics.errors() != errors) return;
    spec_.network = static_cast<int>(subject_.model.networks.size()) - 1;
    spec_.rule = policy_.name.text == lanes::name_of(lanes::Exploration::kTarry)
                     ? lanes::Exploration::kTarry
                     : lanes::Exploration::kFraenkel;
    subject_.model.explore = std::move(spec_);
  }

 private:
  void wrong(Span span, std::string message, std::string hint = {}) {
    subject_.error("P61", span, std::move(message), std::move(hint));
  }

  void add(const syntax::ExploreItem& item) {
    const std::string who = "explore '" + item.name.text + "'";
    const auto [place, is_new] = names_.emplace(item.name.text, item.name.span);
    if (!is_new) {
      subject_.twice(item.name.span, who + " is declared twice", place->second);
      return;
    }
    ExploreSpec::Explorer explorer;
    explorer.name = item.name.text;
    const auto found = nodes_.find(item.from.text);
    if (found != nodes_.end()) {
      explorer.from = found->second;
    } else {
      subject_.unknown(item.from.span, "node", item.from.text, {&nodes_},
                       " of network '" + item_.name.text + "'");
    }
    for (const syntax::NumberItem& number : item.numbers) {
      if (number.name.text != "speed") {
        wrong(number.name.span,
              fmt::format("{} has a speed only, found '{}'", who, number.name.text));
        continue;
      }
      explorer.speed = bounded(subject_, number.value, syntax::UnitKind::speed,
                               "the speed of " + who, 1e-6, kMostExplorerSpeed)
                           .value_or(explorer.speed);
    }
    spec_.explorers.push_back(std::move(explorer));
  }

  Subject& subject_;
  const syntax::NetworkItem& item_;
  const syntax::PolicyItem& policy_;
  ExploreSpec spec_;
  std::map<std::string, int> nodes_;
  std::map<std::string, Span> names_;
};

}  // namespace

const syntax::PolicyItem* explore_policy(const syntax::NetworkItem& item) {
  for (const syntax::NetworkPart& part : item.parts) {
    const auto* policy = std::get_if<syntax::PolicyItem>(&part);
    if (policy == nullptr) continue;
    if (policy->name.text == "tarry" || policy->name.text == "fraenkel") return policy;
  }
  return nullptr;
}

void check_explore(Subject& subject, const syntax::NetworkItem& item, bool is_whole) {
  if (const syntax::PolicyItem* policy = explore_policy(item)) {
    ExploreCheck(subject, item, *policy).run(is_whole);
    return;
  }
  for (const syntax::NetworkPart& part : item.parts) {
    if (const auto* explore = std::get_if<syntax::ExploreItem>(&part)) {
      subject.error("P61", explore->span, "explore goes with policy tarry or fraenkel",
                    "write policy tarry;");
    }
  }
}

}  // namespace rubicon::interpreter::plan_check

#include "src/exchange/ifc/body_items.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

#include "src/exchange/ifc/step_values.hpp"

namespace rubicon::ifc {

namespace {

/// Representations that show something else than the body of a thing.
constexpr auto kNoBody =
    std::to_array<std::string_view>({"Annotation", "Axis", "Box", "Clearance", "CoG", "FootPrint",
                                     "Lighting", "Profile", "Reference"});

/// What a shape consists of that is not read.
constexpr auto kUnread = std::to_array<std::string_view>(
    {"IfcAdvancedBrep", "IfcAdvancedBrepWithVoids", "IfcBSplineCurve", "IfcBSplineCurveWithKnots",
     "IfcExtrudedAreaSolidTapered", "IfcFixedReferenceSweptAreaSolid",
     "IfcRationalBSplineCurveWithKnots", "IfcRevolvedAreaSolidTapered", "IfcSectionedSolid",
     "IfcSectionedSolidHorizontal", "IfcSectionedSpine", "IfcSurfaceCurveSweptAreaSolid"});

/// The usual spelling of a class that is not read; empty: it may be.
std::string_view unread_name(std::string_view keyword) {
  const auto same = [&](std::string_view name) {
    return std::equal(name.begin(), name.end(), keyword.begin(), keyword.end(), [](char a, char b) {
      return (a >= 'a' && a <= 'z' ? static_cast<char>(a - 'a' + 'A') : a) == b;
    });
  };
  const auto found = std::find_if(kUnread.begin(), kUnread.end(), same);
  return found == kUnread.end() ? std::string_view() : *found;
}

std::string_view identifier(const StepValues& values) { return values[1].text(); }

}  // namespace

std::vector<std::uint64_t> body_representations(const StepFile& file, std::uint64_t shape) {
  const StepRecord* record = file.find(shape);
  if (record == nullptr || record->keyword != "IFCPRODUCTDEFINITIONSHAPE") return {};
  const auto values = StepValues::read(record->arguments);
  if (!values) return {};
  constexpr std::size_t kRepresentations = 2;
  std::vector<std::uint64_t> bodies;
  std::vector<std::uint64_t> others;
  for (const StepItem each : (*values)[kRepresentations]) {
    const StepRecord* found = file.find(each.reference());
    if (found == nullptr || found->keyword != "IFCSHAPEREPRESENTATION") continue;
    const auto parts = StepValues::read(found->arguments);
    if (!parts) continue;
    const std::string_view name = identifier(*parts);
    if (name == "Body") {
      bodies.push_back(found->id);
    } else if (std::find(kNoBody.begin(), kNoBody.end(), name) == kNoBody.end()) {
      others.push_back(found->id);
    }
  }
  bodies.insert(bodies.end(), others.begin(), others.end());
  return bodies;
}

std::vector<std::uint64_t> representation_items(const StepFile& file, std::uint64_t id) {
  const StepRecord* record = file.find(id);
  if (record == nullptr || record->keyword != "IFCSHAPEREPRESENTATION") return {};
  const auto values = StepValues::read(record->arguments);
  if (!values) return {};
  constexpr std::size_t kItems = 3;
  std::vector<std::uint64_t> items;
  for (const StepItem item : (*values)[kItems]) items.push_back(item.reference());
  return items;
}

bool may_be_body(const StepFile& file, std::uint64_t item) {
  constexpr std::array<std::string_view, 5> kDrawings = {"IFCANNOTATIONFILLAREA", "IFCBOUNDINGBOX",
                                                         "IFCGEOMETRICCURVESET", "IFCGEOMETRICSET",
                                                         "IFCTEXTLITERALWITHEXTENT"};
  const StepRecord* record = file.find(item);
  return record == nullptr ||
         std::find(kDrawings.begin(), kDrawings.end(), record->keyword) == kDrawings.end();
}

std::vector<std::string> unread_classes(const StepFile& file, std::uint64_t shape) {
  constexpr std::size_t kMostRecords = 10'000;
  std::set<std::uint64_t> seen;
  std::set<std::string_view> found;
  std::vector<std::uint64_t> pending = body_representations(file, shape);
  while (!pending.empty() && seen.size() < kMostRecords) {
    const std::uint64_t id = pending.back();
    pending.pop_back();
    const StepRecord* record = file.find(id);
    if (record == nullptr || !seen.insert(id).second ||
        record->keyword.find("CONTEXT") != std::string_view::npos) {
      continue;
    }
    const std::string_view unread = unread_name(record->keyword);
    if (!unread.empty()) {
      found.insert(unread);
      continue;
    }
    const auto values = StepValues::read(record->arguments);
    if (!values) continue;
    for (const std::uint64_t child : values->references()) pending.push_back(child);
  }
  return {found.begin(), found.end()};
}

}  // namespace rubicon::ifc

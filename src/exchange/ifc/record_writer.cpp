#include "src/exchange/ifc/record_writer.hpp"

#include <fmt/format.h>

namespace rubicon::ifc {

std::uint64_t RecordWriter::add(std::string_view body) {
  put(next_, body);
  return next_++;
}

void RecordWriter::put(std::uint64_t id, std::string_view body) {
  fmt::format_to(std::back_inserter(text_), "#{}={};\n", id, body);
}

std::uint64_t RecordWriter::add_point(const math::Vec3& p, bool flat) {
  return add(flat ? fmt::format("IFCCARTESIANPOINT(({},{}))", real_text(p.x()), real_text(p.y()))
                  : fmt::format("IFCCARTESIANPOINT(({},{},{}))", real_text(p.x()), real_text(p.y()),
                                real_text(p.z())));
}

std::uint64_t RecordWriter::add_placement(const math::Pose& X) {
  const auto direction = [&](int column) {
    const math::Vec3 v = X.linear().col(column);
    return add(fmt::format("IFCDIRECTION(({},{},{}))", real_text(v.x()), real_text(v.y()),
                           real_text(v.z())));
  };
  const std::uint64_t origin = add_point(X.translation(), false);
  const std::uint64_t z = direction(2);
  const std::uint64_t x = direction(0);
  return add(fmt::format("IFCAXIS2PLACEMENT3D(#{},#{},#{})", origin, z, x));
}

std::string real_text(double value) { return fmt::format("{:#.17g}", value); }

std::string references_text(const std::vector<std::uint64_t>& ids) {
  std::string text;
  for (const std::uint64_t id : ids) text += fmt::format("{}#{}", text.empty() ? "" : ",", id);
  return text;
}

}  // namespace rubicon::ifc

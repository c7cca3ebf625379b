#include "src/exchange/files/result_owner_io.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "src/exchange/encoding/gzip.hpp"

namespace rubicon::files {

namespace {

/// So many bytes tell what a file is: the title of a page stands behind the licences of what it
/// contains.
constexpr std::size_t kLooked = std::size_t{1} << 16;

/// What a file of ours begins with, and what else stands in what is looked at: of a table, in its
/// first line.
struct Mark {
  std::string_view name;
  std::string_view begin;
  std::string_view within = {};
};

/// A kind of result: the files of which one at least is always there, which tell by themselves that
/// they are ours, and those that go with them.
struct Kind {
  std::vector<Mark> heads;
  std::vector<Mark> others;
};

constexpr std::string_view kPageTitle = " - RUBICON</title>";

const std::array<Kind, 6>& kinds() {
  static const std::array<Kind, 6> all = {{
      {{{"trace.jsonl", R"({"type":"header","format":"rubicon-trace")"},
        {"trace.jsonl.gz", R"({"type":"header","format":"rubicon-trace")"},
        {"schedule.json", "{\"tasks\":[\n{\"task\":\"", R"("result":)"},
        {"schedule.json", "{\"tasks\":[\n],\"process_time\":"}},
       {{"schedule.csv", "task,robot,crew,start,duration,"},
        {"loads.csv", "task,load,truck,by,"},
        {"report.html", "<!doctype html>", kPageTitle}}},
      {{{"study.json", R"({"study":")", R"("design":")"}},
       {{"study.html", "<!doctype html>", kPageTitle},
        {"runs.csv", "variant,", ",seed,run"},
        {"variants.csv", "variant,", ",runs,unfinished,fault"},
        {"drivers.csv", "variant,", ",duration,correlation,low,high"},
        {"progress.csv", "variant,", ",share,p10,p50,p90"}}},
      {{{"ways.json", "{", R"("format": "rubicon-grid")"}},
       {{"ways.csv", "agent,from_x,from_y,to_x,to_y,"}}},
      {{{"jobs.json", "{", R"("format": "rubicon-jobs")"}},
       {{"jobs.csv", "job,from_x,from_y,to_x,to_y,"}, {"agents.csv", "agent,jobs,ticks,"}}},
      {{{"charts.json", "{", R"("format": "rubicon-charts")"}},
       {{"charts.csv", "robot,place,arrival_s,departure_s,"},
        {"charts.svg", "<svg ", ": when robots are where</title>"},
        {"report.html", "<!DOCTYPE html>", "<title>Charts of network "}}},
      {{{"walk.json", "{", R"("format": "rubicon-walk")"}},
       {{"walk.csv", "robot,step,from,to,way,arrival_s"}}},
  }};
  return all;
}

/// The first bytes of a plain file, unpacked; "" of anything else.
std::string first_bytes(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) return {};
  struct stat status {};
  std::string bytes;
  if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode)) {
    bytes.resize(kLooked);
    const ssize_t count = ::read(file, bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  ::close(file);
  if (!encoding::is_gzip(bytes)) return bytes;
  std::string unpacked;
  try {
    encoding::GzipReader reader([&](std::string_view piece) {
      unpacked += piece.substr(0, kLooked - std::min(kLooked, unpacked.size()));
    });
    reader.read(bytes);
  } catch (const std::invalid_argument&) {
    return {};
  }
  return unpacked;
}

bool has_mark(const std::string& path, const Mark& mark) {
  std::string bytes = first_bytes(path);
  if (mark.name.ends_with(".csv")) bytes.resize(std::min(bytes.find('\n'), bytes.size()));
  return bytes.starts_with(mark.begin) && bytes.find(mark.within) != std::string::npos;
}

/// The places on the disk of files, whatever their names.
std::vector<std::pair<dev_t, ino_t>> places_of(const std::set<std::string>& files) {
  std::vector<std::pair<dev_t, ino_t>> places;
  for (const std::string& file : files) {
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0) places.emplace_back(status.st_dev, status.st_ino);
  }
  return places;
}

}  // namespace

std::set<std::string> own_names(const std::string& folder, const std::set<std::string>& read) {
  const auto places = places_of(read);
  const auto is_ours = [&](const Mark& mark) {
    const std::string path = folder + "/" + std::string(mark.name);
    struct stat status {};
    if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return false;
    const std::pair place{status.st_dev, status.st_ino};
    return std::find(places.begin(), places.end(), place) == places.end() && has_mark(path, mark);
  };
  std::set<std::string> names;
  for (const Kind& kind : kinds()) {
    const std::size_t before = names.size();
    for (const Mark& mark : kind.heads) {
      if (is_ours(mark)) names.emplace(mark.name);
    }
    if (names.size() == before) continue;
    for (const Mark& mark : kind.others) {
      if (is_ours(mark)) names.emplace(mark.name);
    }
  }
  return names;
}

bool is_own_page(const std::string& path) {
  for (const Kind& kind : kinds()) {
    for (const Mark& mark : kind.others) {
      if (mark.name.ends_with(".html") && has_mark(path, mark)) return true;
    }
  }
  return false;
}

}  // namespace rubicon::files

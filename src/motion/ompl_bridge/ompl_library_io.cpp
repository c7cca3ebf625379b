#include "src/motion/ompl_bridge/ompl_library_io.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <limits.h>
#include <unistd.h>

#include <array>

namespace rubicon::ompl_bridge {

namespace {

constexpr const char* kOmplFile = "rubicon-ompl.so";

std::string file_beside_command() {
  std::array<char, PATH_MAX> buffer{};
  const ssize_t length = ::readlink("/proc/self/exe", buffer.data(), buffer.size());
  const std::string command(buffer.data(), length > 0 ? static_cast<std::size_t>(length) : 0);
  const std::size_t slash = command.rfind('/');
  return (slash == std::string::npos ? std::string() : command.substr(0, slash + 1)) + kOmplFile;
}

struct LoadedOmpl {
  const OmplPlugin* plugin = nullptr;
  std::string fault;
};

LoadedOmpl load_ompl() {
  LoadedOmpl loaded;
  void* const file = ::dlopen(file_beside_command().c_str(), RTLD_NOW | RTLD_LOCAL);
  if (file == nullptr) {
    const char* const error = ::dlerror();
    loaded.fault = fmt::format("this build has no OMPL ({})", error ? error : kOmplFile);
    return loaded;
  }
  using Begin = const OmplPlugin* (*)(int);
  const auto begin = reinterpret_cast<Begin>(::dlsym(file, kOmplBegin));
  loaded.plugin = begin ? begin(kOmplPluginVersion) : nullptr;
  if (loaded.plugin == nullptr) {
    loaded.fault = fmt::format("'{}' is of another build", file_beside_command());
  }
  return loaded;
}

const LoadedOmpl& loaded_ompl() {
  static const LoadedOmpl loaded = load_ompl();
  return loaded;
}

}  // namespace

const OmplPlugin* ompl_library() { return loaded_ompl().plugin; }
const std::string& ompl_fault() { return loaded_ompl().fault; }

}  // namespace rubicon::ompl_bridge

#include "src/exchange/urdf/guarded_import_io.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <map>
#include <new>
#include <set>
#include <utility>
#include <vector>

#include "src/exchange/mesh_io/system_call_filter_io.hpp"
#include "src/exchange/urdf/number_text.hpp"

namespace rubicon::urdf {

namespace {

using Words = std::vector<std::string>;

/// Far beyond what the counted limits need.
constexpr rlim_t kMemory = rlim_t{3} << 30;
/// For faults of libraries only: what is read is counted.
constexpr rlim_t kSeconds = 120;
constexpr std::uint64_t kMostBytes = std::uint64_t{512} << 20;
constexpr std::uint64_t kMostWords = 100'000;

/// One end of a socket over which lists of words go.
class Channel {
 public:
  explicit Channel(int fd) : fd_(fd) {}
  ~Channel() { ::close(fd_); }
  Channel(const Channel&) = delete;
  Channel& operator=(const Channel&) = delete;

  bool put(const Words& words) {
    if (!put_number(words.size())) return false;
    return std::all_of(words.begin(), words.end(), [&](const std::string& each) {
      return put_number(each.size()) && put_bytes(each.data(), each.size());
    });
  }

  bool get(Words& words) {
    std::uint64_t count = 0, bytes = 0;
    if (!get_bytes(&count, sizeof count) || count > kMostWords) return false;
    words.assign(count, {});
    for (std::string& each : words) {
      std::uint64_t size = 0;
      if (!get_bytes(&size, sizeof size) || size > kMostBytes - bytes) return false;
      bytes += size;
      each.resize(size);
      if (!get_bytes(each.data(), size)) return false;
    }
    return true;
  }

 private:
  bool put_number(std::uint64_t number) { return put_bytes(&number, sizeof number); }

  bool put_bytes(const void* data, std::size_t size) {
    const char* at = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t written = ::write(fd_, at, size);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      at += written;
      size -= static_cast<std::size_t>(written);
    }
    return true;
  }

  bool get_bytes(void* data, std::size_t size) {
    char* at = static_cast<char*>(data);
    while (size > 0) {
      const ssize_t got = ::read(fd_, at, size);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) return false;
      at += got;
      size -= static_cast<std::size_t>(got);
    }
    return true;
  }

  int fd_;
};

/// In the child: files that the other side has.
class AskedFiles : public PackageFiles {
 public:
  explicit AskedFiles(Channel& channel) : channel_(channel) {}

  std::variant<FoundFile, PackageFailure> find(const std::string& reference,
                                               const std::string& from) override {
    const Words answer = ask({"find", reference, from}, 4);
    if (answer[0] != "found") return PackageFailure{answer[1], answer[2]};
    return FoundFile{answer[1], answer[2], answer[3]};
  }

  std::variant<std::string, PackageFailure> read_text(const std::string& path) override {
    Words answer = ask({"read", path}, 3);
    if (answer[0] != "text") return PackageFailure{answer[1], answer[2]};
    return std::move(answer[1]);
  }

 private:
  Words ask(const Words& question, std::size_t words) {
    Words answer;
    if (!channel_.put(question) || !channel_.get(answer)) ::_exit(1);
    answer.resize(words);
    return answer;
  }

  Channel& channel_;
};

bool limit(int resource, rlim_t value) {
  const rlimit both{value, value};
  return ::setrlimit(static_cast<__rlimit_resource>(resource), &both) == 0;
}

/// Nothing stays open but the socket, and nothing more can be opened.
bool shut_in(int socket, pid_t parent) {
  const int nothing = ::open("/dev/null", O_RDWR);
  if (nothing < 0 || ::dup2(socket, 3) != 3) return false;
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
  if (::close_range(4, ~0U, 0) != 0) return false;
  if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || ::getppid() != parent) return false;
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  if (!limit(RLIMIT_CORE, 1) || !limit(RLIMIT_FSIZE, 0) || !limit(RLIMIT_CPU, kSeconds)) {
    return false;
  }
  if (!kSanitized && !limit(RLIMIT_AS, kMemory)) return false;
  if (!kSanitized) mesh_io::filter_system_calls(mesh_io::FileAccess::kOpenFilesOnly);
  return true;
}

Words answer_of(const std::string& messages, const std::optional<MachineImport>& machine) {
  Words words = {"done", messages, machine ? "yes" : "no", machine ? machine->robot : ""};
  if (!machine) return words;
  for (const MeshCopy& each : machine->meshes) {
    std::string scale;
    if (each.scale) {
      for (const double factor : *each.scale) scale += text_of(factor) + " ";
    }
    words.insert(words.end(), {each.source, each.folder, each.target, scale});
  }
  return words;
}

[[noreturn]] void run_child(int socket, pid_t parent, const MachineTerms& terms,
                            const std::string& text, const Printer& print) {
  if (!shut_in(socket, parent)) ::_exit(1);
  Channel channel(3);
  AskedFiles files(channel);
  try {
    interpreter::SourceMap sources;
    interpreter::Diagnostics diagnostics;
    const interpreter::FileId file = sources.add(terms.path, text);
    const auto machine = import_machine(terms, sources, file, files, diagnostics);
    channel.put(answer_of(print(diagnostics, sources), machine));
  } catch (const std::bad_alloc&) {
    channel.put({"memory"});
  }
  ::_exit(0);
}

/// In the parent: what the child may have, and what it made.
class Served {
 public:
  Served(Channel& channel, PackageFiles& files, const MachineTerms& terms)
      : channel_(channel), files_(files), terms_(terms) {}

  std::variant<GuardedImport, std::string> run() {
    Words words;
    while (channel_.get(words)) {
      if (words.size() == 3 && words[0] == "find") {
        if (!channel_.put(find(words[1], words[2]))) break;
      } else if (words.size() == 2 && words[0] == "read") {
        if (!channel_.put(read(words[1]))) break;
      } else if (words.size() >= 4 && words[0] == "done") {
        return result(words);
      } else if (words.size() == 1 && words[0] == "memory") {
        return fmt::format("it needs more than {} MB of memory", kMemory >> 20);
      } else {
        break;
      }
    }
    return std::string("its reader ended without an answer: this is a fault of ours");
  }

 private:
  Words find(const std::string& reference, const std::string& from) {
    const auto found = files_.find(reference, from);
    if (const auto* failure = std::get_if<PackageFailure>(&found)) {
      return {"none", failure->message, failure->hint};
    }
    const FoundFile& file = std::get<FoundFile>(found);
    given_[file.path].insert(file.folder);
    return {"found", file.path, file.folder, file.note};
  }

  Words read(const std::string& path) {
    if (!given_.contains(path)) return {"none", "it was not found before", ""};
    auto text = files_.read_text(path);
    if (const auto* failure = std::get_if<PackageFailure>(&text)) {
      return {"none", failure->message, failure->hint};
    }
    return {"text", std::move(std::get<std::string>(text))};
  }

  std::variant<GuardedImport, std::string> result(Words& words) const {
    GuardedImport import;
    import.messages = std::move(words[1]);
    if (words[2] != "yes") return import;
    import.machine.emplace();
    import.machine->robot = std::move(words[3]);
    for (std::size_t i = 4; i + 3 < words.size(); i += 4) {
      MeshCopy copy{words[i], words[i + 1], words[i + 2], std::nullopt, {}};
      const auto given = given_.find(copy.source);
      const std::string start = terms_.meshes + "/";
      const bool fine = given != given_.end() && given->second.contains(copy.folder) &&
                        copy.target.starts_with(start) &&
                        copy.target.find('/', start.size()) == std::string::npos;
      if (!fine) return std::string("its reader answered wrongly: this is a fault of ours");
      if (const auto scale = numbers_of(words[i + 3]); scale && scale->size() == 3) {
        copy.scale = Triple{(*scale)[0], (*scale)[1], (*scale)[2]};
      }
      import.machine->meshes.push_back(std::move(copy));
    }
    return import;
  }

  Channel& channel_;
  PackageFiles& files_;
  const MachineTerms& terms_;
  std::map<std::string, std::set<std::string>> given_;  ///< found paths with their folders
};

}  // namespace

std::variant<GuardedImport, std::string> import_guarded(const MachineTerms& terms,
                                                        const std::string& text,
                                                        PackageFiles& files, const Printer& print) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    return std::string("its reader cannot be started");
  }
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child == 0) run_child(ends[1], parent, terms, text, print);
  ::close(ends[1]);
  Channel channel(ends[0]);
  if (child < 0) return std::string("its reader cannot be started");
  // Writing to a child that has ended is an answer, too.
  struct sigaction ignore {};
  struct sigaction before {};
  ignore.sa_handler = SIG_IGN;
  ::sigaction(SIGPIPE, &ignore, &before);
  auto result = Served(channel, files, terms).run();
  ::sigaction(SIGPIPE, &before, nullptr);
  ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return result;
}

}  // namespace rubicon::urdf

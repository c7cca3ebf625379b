#include "src/exchange/mesh_io/guarded_assimp_files_io.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <utility>
#include <variant>

namespace rubicon::mesh_io {

namespace {

/// Reads an open file at its own place; streams of one file do not disturb each other.
class ReadOnlyStream : public Assimp::IOStream {
 public:
  /// `owned` is closed with the stream, `fd` stays open (they may be the same file).
  ReadOnlyStream(int fd, std::uint64_t size, FileDescriptor owned)
      : fd_(fd), size_(size), owned_(std::move(owned)) {}

  std::size_t Read(void* buffer, std::size_t item, std::size_t count) override {
    if (item == 0 || count == 0 || place_ >= size_) return 0;
    const std::uint64_t items = std::min<std::uint64_t>(count, (size_ - place_) / item);
    const std::uint64_t done = read_at(fd_, place_, static_cast<char*>(buffer), items * item);
    const std::uint64_t whole = done / item;
    place_ += whole * item;
    return whole;
  }

  std::size_t Write(const void*, std::size_t, std::size_t) override { return 0; }

  aiReturn Seek(std::size_t offset, aiOrigin origin) override {
    std::uint64_t target = offset;
    if (origin == aiOrigin_CUR) target += place_;
    // As fseek does it: the offset from the end is a negative number in disguise.
    if (origin == aiOrigin_END) target += size_;
    if (target > size_) return aiReturn_FAILURE;
    place_ = target;
    return aiReturn_SUCCESS;
  }

  std::size_t Tell() const override { return place_; }
  std::size_t FileSize() const override { return size_; }
  void Flush() override {}

 private:
  int fd_;
  std::uint64_t size_;
  FileDescriptor owned_;
  std::uint64_t place_ = 0;
};

}  // namespace

GuardedAssimpFiles::GuardedAssimpFiles(GuardedFile mesh, std::string name, std::string folder,
                                       bool others, std::vector<std::string>& asked_for)
    : mesh_(std::move(mesh)),
      name_(std::move(name)),
      folder_(std::move(folder)),
      others_(others),
      asked_for_(asked_for) {}

bool GuardedAssimpFiles::Exists(const char* file) const {
  if (name_ == file) return true;
  if (!others_) return false;
  asked_for_.emplace_back(file);
  return std::holds_alternative<GuardedFile>(open_inside(folder_, file));
}

Assimp::IOStream* GuardedAssimpFiles::Open(const char* file, const char* mode) {
  if (std::strchr(mode, 'w') != nullptr || std::strchr(mode, 'a') != nullptr) return nullptr;
  if (name_ == file) {
    return new ReadOnlyStream(mesh_.descriptor.get(), mesh_.size, FileDescriptor());
  }
  if (!others_) return nullptr;
  asked_for_.emplace_back(file);
  std::variant<GuardedFile, GuardedFailure> opened = open_inside(folder_, file);
  auto* other = std::get_if<GuardedFile>(&opened);
  if (other == nullptr) return nullptr;
  const int fd = other->descriptor.get();
  return new ReadOnlyStream(fd, other->size, std::move(other->descriptor));
}

void GuardedAssimpFiles::Close(Assimp::IOStream* stream) { delete stream; }

}  // namespace rubicon::mesh_io

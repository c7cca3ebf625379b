#pragma once

#include <assimp/MemoryIOWrapper.h>

#include <assimp/IOSystem.hpp>
#include <cstdint>
#include <string>
#include <utility>

namespace rubicon::mesh_io {

/// The one file that assimp sees: a text in memory. Only the helper program includes this header.
class AssimpTextFile : public Assimp::IOSystem {
 public:
  /// `text` must outlive this object.
  AssimpTextFile(std::string name, const std::string& text) : name_(std::move(name)), text_(text) {}

  bool Exists(const char* file) const override { return name_ == file; }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char*) override {
    if (name_ != file) return nullptr;
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text_.data()),
                                      text_.size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  std::string name_;
  const std::string& text_;
};

}  // namespace rubicon::mesh_io
